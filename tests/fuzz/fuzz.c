/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Scripts that are wrong, and files that are damaged: none may crash the program, hang its check, fail without a word,
 * or leave a scene with numbers that are not finite. Each is tried in a process of its own, in an empty folder, with
 * little time: what takes longer once its check is done is cut off and counted. fuzz COUNT SEED SCRIPT...     COUNT
 * wrong scripts, completed, checked and run; then COUNT/4 damaged files What fails is left in fuzz.failed/. */
#include "mutate.h"

#include "base/alloc.h"
#include "command/commands.h"
#include "script/complete.h"
#include "script/interp.h"

#include <gsl/gsl_errno.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/resource.h>
#include <sys/stat.h>
#include <sys/wait.h>
#include <unistd.h>

enum { SECONDS_EACH = 10, COMPLETIONS_EACH = 4 };

/* How far a trial came: what its process tells through the pipe. */
typedef enum { STAGE_BEGUN, STAGE_CHECKED, STAGE_SILENT, STAGE_NOT_FINITE, STAGE_DONE } stage;

typedef struct trial {
    interp_host host;
    bool told; /* an error was */
    int pipe;
} trial;

static void on_error(void *self, const char *text) {
    ((trial *)self)->told |= *text != '\0';
}

static void ignore(void *self, const char *text) {
    (void)self, (void)text;
}

static void reach(const trial *t, stage s) {
    const char byte = (char)s;
    if (write(t->pipe, &byte, 1) != 1)
        _exit(1);
}

static bool is_finite(const interp *in) {
    const particle_columns *p = &interp_scene((interp *)in)->colony->particle;
    for (size_t i = 0; i < 3 * p->count; i++)
        if (!isfinite(p->x[i]) || !isfinite(p->v[i]))
            return false;
    return true;
}

static void complete_somewhere(interp *in, const char *text, gsl_rng *r) {
    for (int i = 0; i < COMPLETIONS_EACH; i++) {
        completions c = {0};
        complete_line(in, text, gsl_rng_uniform_int(r, strlen(text) + 1), &c);
        complete_free(&c);
    }
}

/* What a child does with a script; the pipe says how it went. */
static void run_trial(int pipe, const char *text, gsl_rng *r) {
    gsl_set_error_handler_off();
    trial t = {.pipe = pipe};
    units *u = units_create(NULL);
    command_table *commands = commands_create(u);
    t.host = (interp_host){.commands = commands,
                           .units = u,
                           .self = &t,
                           .screen = ignore,
                           .error = on_error,
                           .warning = ignore,
                           .forecast = true,
                           .safe = true};
    interp *in = interp_create(&t.host);
    complete_somewhere(in, text, r);
    size_t errors = interp_check_text(in, "wrong.in", text);
    if (errors && !t.told)
        reach(&t, STAGE_SILENT);
    reach(&t, STAGE_CHECKED);
    t.told = false;
    int status = interp_run_source(in, "wrong.in", text);
    if (status && !t.told)
        reach(&t, STAGE_SILENT);
    if (!is_finite(in))
        reach(&t, STAGE_NOT_FINITE);
    interp_free(in);
    command_table_free(commands);
    units_free(u);
    reach(&t, STAGE_DONE);
    _exit(0);
}

static void limit(void) {
    const struct rlimit time = {SECONDS_EACH, SECONDS_EACH + 1}, file = {64 << 20, 64 << 20};
    setrlimit(RLIMIT_CPU, &time);
    setrlimit(RLIMIT_FSIZE, &file);
#ifndef __SANITIZE_ADDRESS__
    const struct rlimit memory = {(rlim_t)4 << 30, (rlim_t)4 << 30};
    setrlimit(RLIMIT_AS, &memory);
#endif
}

typedef struct tally {
    size_t passed, failed, cut;
} tally;

static bool says(const char *file, const char *words) {
    char line[4096];
    bool found = false;
    FILE *f = fopen(file, "r");
    while (f && !found && fgets(line, sizeof line, f))
        found = strstr(line, words) != NULL;
    if (f)
        fclose(f);
    return found;
}

/* What is wrong with how a trial went; NULL: nothing. */
static const char *judge(int status, const bool reached[], bool *cut) {
    bool killed = WIFSIGNALED(status) && (WTERMSIG(status) == SIGXCPU || WTERMSIG(status) == SIGKILL);
    bool full = WIFSIGNALED(status) && says("stderr", "out of memory");
    *cut = killed || full || (WIFSIGNALED(status) && WTERMSIG(status) == SIGXFSZ);
    if (reached[STAGE_SILENT])
        return "fails without a word";
    if (reached[STAGE_NOT_FINITE])
        return "leaves numbers that are not finite";
    if (killed && !reached[STAGE_CHECKED])
        return "its check does not end";
    if (*cut)
        return NULL;
    return WIFEXITED(status) && WEXITSTATUS(status) == 0 && reached[STAGE_DONE] ? NULL : "crashes";
}

/* Tries a script in the folder `work`, which is left as it is. */
static void try_script(const char *name, const char *text, gsl_rng *r, tally *count) {
    int ends[2];
    if (pipe(ends) != 0)
        abort();
    pid_t child = fork();
    if (child == 0) {
        close(ends[0]);
        limit();
        if (!freopen("stderr", "w", stderr))
            _exit(1);
        run_trial(ends[1], text, r);
    }
    close(ends[1]);
    bool reached[STAGE_DONE + 1] = {true}, cut;
    for (char byte; read(ends[0], &byte, 1) == 1;)
        reached[(size_t)byte] = true;
    close(ends[0]);
    int status;
    waitpid(child, &status, 0);
    const char *wrong = judge(status, reached, &cut);
    count->cut += cut;
    count->passed += wrong == NULL;
    count->failed += wrong != NULL;
    if (wrong)
        printf("%s %s:\n----\n%s----\n", name, wrong, text);
    fflush(stdout);
    if (wrong && system("head -n 20 stderr") != 0)
        abort();
}

static void empty_folder(void) {
    if (system("rm -rf ./* && mkdir out") != 0)
        abort();
}

static char *read_whole(const char *path, size_t *n) {
    FILE *f = fopen(path, "rb");
    struct stat about;
    if (!f || fstat(fileno(f), &about) != 0) {
        fprintf(stderr, "fuzz: cannot read %s\n", path);
        exit(2);
    }
    char *bytes = alloc_zeroed((size_t)about.st_size + 1, 1);
    *n = fread(bytes, 1, (size_t)about.st_size, f);
    fclose(f);
    return bytes;
}

static void try_scripts(size_t count, const corpus *c, gsl_rng *r, tally *out) {
    for (size_t i = 0; i < count; i++) {
        char name[64], *text = mutate_script(c, r);
        snprintf(name, sizeof name, "script %zu", i);
        empty_folder();
        try_script(name, text, r, out);
        free(text);
    }
}

/* ---- files ---- */

static const char makes_files[] = "species rod rod diameter 0.75um\n"
                                  "species curl flexible diameter 0.4um coil 0.3um pitch 2um particles 7\n"
                                  "growth rod exponential rate 1/h sd 10%\n"
                                  "division rod midpoint mass 1.5e-15kg\n"
                                  "link internal * k 5e-11N/m\n"
                                  "link bend curl k 2e-18N.m\n"
                                  "link filial rod k 1e-11N/m break 1um\n"
                                  "force collision\n"
                                  "force damping\n"
                                  "create_cells rod single 0 0 0 orient x\n"
                                  "create_cells curl single 0 5um 0 orient x mass 1e-15kg\n"
                                  "group left where \"x < 1um\"\n"
                                  "run 30 grow 4min relax 0.1s\n"
                                  "write_restart kept.restart\n"
                                  "write_data kept.data\n";

/* What is read, and by which script. */
static const struct {
    const char *file, *script;
} readers[] = {
    {"kept.restart", "read_restart kept.restart\nrun 1 grow 1min relax 1ms\n"},
    {"kept.data", "species rod rod diameter 0.75um\n"
                  "species curl flexible diameter 0.4um coil 0.3um pitch 2um particles 7\n"
                  "link internal * k 5e-11N/m\nlink bend curl k 2e-18N.m\nlink filial rod k 1e-11N/m break 1um\n"
                  "force collision\nforce damping\ngroup left where \"x < 1um\"\n"
                  "read_data kept.data\nrun 1 relax 1ms\n"},
};

/* The files that are right, in the folder above. */
static bool make_files(gsl_rng *r) {
    tally made = {0};
    empty_folder();
    try_script("the script that makes files", makes_files, r, &made);
    return system("mv kept.restart kept.data ..") == 0;
}

static void try_files(size_t count, gsl_rng *r, tally *out) {
    if (!make_files(r)) {
        printf("there are no files to damage\n");
        out->failed++;
        return;
    }
    for (size_t i = 0; i < sizeof readers / sizeof *readers; i++) {
        char path[64], name[64];
        snprintf(path, sizeof path, "../%s", readers[i].file);
        size_t whole;
        char *bytes = read_whole(path, &whole);
        for (size_t k = 0; k < count; k++) {
            size_t n = whole;
            empty_folder();
            FILE *f = fopen(readers[i].file, "wb");
            unsigned char *damaged = mutate_bytes((unsigned char *)bytes, &n, r);
            if (!f || fwrite(damaged, 1, n, f) != n || fclose(f) != 0)
                abort();
            free(damaged);
            snprintf(name, sizeof name, "damaged %s %zu", readers[i].file, k);
            size_t before = out->failed;
            try_script(name, readers[i].script, r, out);
            char keep[256];
            snprintf(keep, sizeof keep, "cp %s ../%s.%zu", readers[i].file, readers[i].file, k);
            if (out->failed > before && system(keep) != 0)
                abort();
        }
        free(bytes);
    }
}

int main(int argc, char **argv) {
    if (argc < 4) {
        fprintf(stderr, "usage: fuzz COUNT SEED SCRIPT...\n");
        return 2;
    }
    size_t count = strtoul(argv[1], NULL, 10), n;
    gsl_rng *r = gsl_rng_alloc(gsl_rng_mt19937);
    gsl_rng_set(r, strtoul(argv[2], NULL, 10));
    corpus c = {0};
    for (int i = 3; i < argc; i++) {
        char *text = read_whole(argv[i], &n);
        corpus_add(&c, text);
        free(text);
    }
    char folder[] = "/tmp/sarcina-fuzz-XXXXXX";
    if (!mkdtemp(folder) || chdir(folder) != 0 || mkdir("work", 0755) != 0 || chdir("work") != 0)
        abort();
    tally out = {0};
    try_scripts(count, &c, r, &out);
    try_files(count / 4 / (sizeof readers / sizeof *readers), r, &out);
    printf("%zu cut off; kept in %s\n", out.cut, out.failed ? folder : "nothing: all is well");
    printf("%zu passed, %zu failed\n", out.passed, out.failed);
    char remove[64];
    snprintf(remove, sizeof remove, "rm -rf %s", folder);
    if (!out.failed && system(remove) != 0)
        abort();
    corpus_free(&c);
    gsl_rng_free(r);
    return out.failed || !out.passed;
}

/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The lines of a case are typed at a prompt. Before the last the state is kept.
 *
 * Where the case holds, every number of the state is finite and what the table asserts is true. Where it is refused,
 * the error names the cause, the scene is to the bit what it was (after `run`: what as many whole cycles alone lead
 * to), a restart file of it reads back, and the lines due after it run. */
#include "extremes/judge.h"

#include "script_host.h"

#include "engine/snapshot.h"

#include <math.h>
#include <signal.h>
#include <stdarg.h>
#include <stdio.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

typedef struct trial {
    const extreme *e;
    size_t preset;
    script_host host;
    interp *in;
    double energy, momentum; /* before the line that is judged: 1e-27 J; largest |m v|, pg um/s */
    verdict v;
} trial;

__attribute__((format(printf, 2, 3))) static bool fail(trial *t, const char *format, ...) {
    va_list list;
    va_start(list, format);
    vsnprintf(t->v.words, sizeof t->v.words, format, list);
    va_end(list);
    t->v.good = 0;
    return false;
}

/* ---- the state ---- */

static bool all_finite(const double *x, size_t n) {
    for (size_t i = 0; i < n; i++)
        if (!isfinite(x[i]))
            return false;
    return true;
}

static bool is_finite(const scene *s) {
    const colony *c = s->colony;
    return all_finite(c->particle.x, 3 * c->particle.count) && all_finite(c->particle.v, 3 * c->particle.count) &&
           all_finite(c->cell.mass, c->cell.count) && all_finite(c->cell.diameter, c->cell.count) &&
           all_finite(c->cell.rest, c->cell.count) && all_finite(c->spring.rest, c->spring.count) &&
           isfinite(s->time) && isfinite(s->relaxed);
}

static double energy_of(interp *in) {
    view v = scene_view(interp_scene(in));
    if (!v.mechanics || v.colony->particle.count == 0)
        return 0;
    double sum = mechanics_kinetic(v.mechanics);
    for (int i = 0; i < FORCE_COUNT; i++)
        sum += mechanics_energy(v.mechanics, (force_kind)i, NULL);
    return sum;
}

/* |sum of m v|, and the sum of |m v| to measure it by. */
static double momentum_of(interp *in, double *whole) {
    view v = scene_view(interp_scene(in));
    double sum[3] = {0};
    *whole = 0;
    for (size_t p = 0; v.mechanics && p < v.colony->particle.count; p++) {
        const double *u = v.colony->particle.v + 3 * p, mass = mechanics_mass(v.mechanics)[p];
        for (int k = 0; k < 3; k++)
            sum[k] += mass * u[k];
        *whole += mass * sqrt(u[0] * u[0] + u[1] * u[1] + u[2] * u[2]);
    }
    return sqrt(sum[0] * sum[0] + sum[1] * sum[1] + sum[2] * sum[2]);
}

static archive *state_of(interp *in) {
    archive *a = archive_create();
    snapshot_save(interp_scene(in), a);
    return a;
}

/* ---- the scene ---- */

/* file NAME ROW | ROW ...: a table for read_data. */
static int write_file(const char *text) {
    size_t name = strcspn(text, " ");
    char *path = alloc_format("%.*s", (int)name, text);
    FILE *f = fopen(path, "w");
    for (text += name; f && *text; text += strcspn(text, "|")) {
        text += strspn(text, " |");
        fprintf(f, "%.*s\n", (int)strcspn(text, "|"), text);
    }
    free(path);
    return f ? fclose(f) : SARCINA_ERROR;
}

static int run_line(trial *t, const char *line) {
    static const char file[] = "file ";
    return strncmp(line, file, strlen(file)) == 0 ? write_file(line + strlen(file)) : interp_run_line(t->in, line);
}

static bool open_scene(trial *t) {
    script_host_clear(&t->host);
    t->in = interp_create(&t->host.host);
    char *accuracy = alloc_format("accuracy %s", accuracy_presets[t->preset].name);
    int status = interp_run_line(t->in, accuracy);
    free(accuracy);
    for (size_t i = 0; i + 1 < t->e->nlines && !status; i++) {
        status = run_line(t, t->e->lines[i]);
        if (status)
            fail(t, "'%s' before the line judged: %s", t->e->lines[i], t->host.errors);
    }
    script_host_clear(&t->host);
    return status == SARCINA_OK;
}

/* ---- what holds ---- */

static bool holds(trial *t, const char *clause) {
    if (strcmp(clause, "finite") == 0)
        return true; /* asked of all */
    if (strcmp(clause, "energy") == 0) {
        double now = energy_of(t->in);
        return now <= t->energy * (1 + 1e-6) || fail(t, "energy has grown from %g to %g", t->energy, now);
    }
    if (strcmp(clause, "momentum") == 0) {
        double whole, now = momentum_of(t->in, &whole);
        return now <= 1e-8 * whole || fail(t, "momentum %g of %g", now, whole);
    }
    char *line = alloc_format("expect %s", clause);
    script_host_clear(&t->host);
    int status = interp_run_line(t->in, line);
    free(line);
    return status == SARCINA_OK || fail(t, "%s", t->host.errors);
}

static bool judge_held(trial *t, const due *d) {
    if (!is_finite(interp_scene(t->in)))
        return fail(t, "the state is not finite");
    for (int i = 0; i < d->nclauses; i++)
        if (!holds(t, d->clause[i]))
            return false;
    return true;
}

/* ---- what is refused ---- */

/* As many whole cycles as there were, in a scene of their own, lead to this state. */
static bool is_whole(trial *t, const archive *now, uint64_t cycles) {
    static const char run[] = "run ";
    const char *action = t->e->lines[t->e->nlines - 1];
    if (cycles == 0 || strncmp(action, run, strlen(run)) != 0)
        return true;
    interp *judged = t->in;
    const char *rest = action + strlen(run);
    char *line = alloc_format("run %llu%s", (unsigned long long)cycles, rest + strcspn(rest, " "));
    bool same = open_scene(t) && interp_run_line(t->in, line) == SARCINA_OK;
    archive *other = state_of(t->in);
    same = same && archive_share(other, now);
    free(line);
    archive_free(other);
    interp_free(t->in);
    t->in = judged;
    return same || fail(t, "the scene is not as after %llu whole cycles", (unsigned long long)cycles);
}

/* What a restart file of the scene holds is the scene. */
static bool restarts(trial *t, const archive *now) {
    interp *judged = t->in;
    if (interp_run_line(t->in, "write_restart after.rst"))
        return fail(t, "no restart file: %s", t->host.errors);
    t->in = interp_create(&t->host.host);
    bool same = interp_run_line(t->in, "read_restart after.rst") == SARCINA_OK;
    archive *other = state_of(t->in);
    same = same && archive_share(other, now);
    archive_free(other);
    interp_free(t->in);
    t->in = judged;
    return same || fail(t, "a restart file after the refusal does not read back: %s", t->host.errors);
}

static bool goes_on(trial *t) {
    for (size_t i = 0; i < t->e->nafter; i++) {
        script_host_clear(&t->host);
        if (interp_run_line(t->in, t->e->after[i]))
            return fail(t, "cannot go on by '%s': %s", t->e->after[i], t->host.errors);
    }
    return is_finite(interp_scene(t->in)) || fail(t, "what went on is not finite");
}

static bool judge_refused(trial *t, const due *d, archive *before) {
    for (int i = 0; i < d->nclauses; i++)
        if (!strstr(t->host.errors, d->clause[i]))
            return fail(t, "the error lacks '%s': %s", d->clause[i], t->host.errors);
    static const char mark[] = "error: ";
    const char *words = strstr(t->host.errors, mark);
    words = words ? words + strlen(mark) : t->host.errors;
    snprintf(t->v.words, sizeof t->v.words, "%.*s", (int)strcspn(words, "\n"), words);
    uint64_t cycles = interp_scene(t->in)->step;
    archive *now = state_of(t->in);
    bool good = (cycles > 0 || archive_share(now, before) || fail(t, "the scene has changed")) &&
                is_whole(t, now, cycles) && restarts(t, now) && goes_on(t);
    archive_free(now);
    return good;
}

/* What the line judged took. */
static void note_cost(trial *t, const scene_tally *before) {
    const scene_tally *now = &interp_scene(t->in)->tally;
    t->v.steps = now->steps - before->steps;
    t->v.rejected = now->rejected - before->rejected;
    t->v.evaluations = now->evaluations - before->evaluations;
    t->v.least_step = now->least_step;
}

static void run(trial *t) {
    script_host_open(&t->host);
    if (!open_scene(t))
        return;
    const due *d = &t->e->due[t->preset];
    t->energy = energy_of(t->in);
    archive *before = state_of(t->in);
    interp_scene(t->in)->tally.least_step = INFINITY;
    const scene_tally tally = interp_scene(t->in)->tally;
    t->v.refused = interp_run_line(t->in, t->e->lines[t->e->nlines - 1]);
    t->v.good = 1;
    note_cost(t, &tally);
    if (t->v.refused != d->refused)
        fail(t, "ended with %d, not %d: %.*s", t->v.refused, d->refused, (int)strcspn(t->host.errors, "\n"),
             t->host.errors);
    else if (d->refused)
        judge_refused(t, d, before);
    else
        judge_held(t, d);
    archive_free(before);
    interp_free(t->in);
    script_host_close(&t->host);
}

static void run_as_child(const extreme *e, size_t preset, unsigned seconds, int out) {
    setrlimit(RLIMIT_CPU, &(struct rlimit){seconds, seconds + 1});
    trial t = {.e = e, .preset = preset};
    run(&t);
    /* the error's text begins with its place, here that of a line of the prompt */
    _exit(write(out, &t.v, sizeof t.v) == sizeof t.v ? 0 : 1);
}

verdict judge(const extreme *e, size_t preset, unsigned seconds) {
    verdict v = {0};
    struct rusage usage;
    int ends[2], status = 0;
    fflush(NULL);
    if (pipe(ends))
        return v;
    pid_t child = fork();
    if (child == 0)
        run_as_child(e, preset, seconds, ends[1]);
    close(ends[1]);
    if (read(ends[0], &v, sizeof v) != sizeof v)
        v = (verdict){0};
    close(ends[0]);
    wait4(child, &status, 0, &usage);
    v.seconds = (double)(usage.ru_utime.tv_sec + usage.ru_stime.tv_sec) +
                1e-6 * (double)(usage.ru_utime.tv_usec + usage.ru_stime.tv_usec);
    if (WIFSIGNALED(status) || WEXITSTATUS(status)) {
        v.good = 0;
        snprintf(v.words, sizeof v.words,
                 WIFSIGNALED(status) && WTERMSIG(status) == SIGXCPU ? "no answer within %u s"
                                                                    : "the program has died (%d)",
                 WIFSIGNALED(status) && WTERMSIG(status) == SIGXCPU ? seconds : (unsigned)status);
    }
    return v;
}

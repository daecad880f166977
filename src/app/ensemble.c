/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "app/ensemble.h"

#include "app/lock.h"
#include "app/merge.h"
#include "app/plan.h"
#include "app/workers.h"
#include "app/workers_mpi.h"
#include "base/alloc.h"
#include "base/number.h"
#include "base/path.h"
#include "engine/scene.h"

#include <stdlib.h>
#include <string.h>
#include <unistd.h>

/* What is going on: passed to the workers' callbacks. */
typedef struct progress {
    plan *plan;
    const volatile sig_atomic_t *interrupt;
    int at_once;
    size_t total, ended, failed; /* of the runs that were missing */
    double seconds;              /* of those that ended well */
    double shown;                /* when the line was drawn last */
    bool terminal;
    diag trouble;
} progress;

/* ---- telling ---- */

static void clear_line(const progress *g) {
    if (g->terminal)
        fputs("\r\033[K", stderr);
}

/* "42 s", "3 min", "2.5 h" */
static void put_duration(double seconds, char *text, size_t room) {
    if (seconds < 99.5)
        snprintf(text, room, "%.0f s", seconds);
    else if (seconds < 99.5 * 60)
        snprintf(text, room, "%.0f min", seconds / 60);
    else
        snprintf(text, room, "%.1f h", seconds / 3600);
}

static void draw(void *self, size_t running) {
    progress *g = self;
    double now = scene_clock();
    if (!g->terminal || now - g->shown < 0.25)
        return;
    g->shown = now;
    char left[32] = "";
    size_t well = g->ended - g->failed;
    if (well) {
        char duration[24];
        put_duration(g->seconds / (double)well * (double)(g->total - g->ended) / g->at_once, duration, sizeof duration);
        snprintf(left, sizeof left, ", %s left", duration);
    }
    fprintf(stderr, "\r\033[K%zu of %zu done, %zu running, %zu failed%s", well, g->total, running, g->failed, left);
}

static void ended(void *self, size_t job, int code, double seconds) {
    progress *g = self;
    plan_run *r = &g->plan->runs[job];
    char duration[24];
    put_duration(seconds, duration, sizeof duration);
    r->code = code;
    r->seconds = seconds;
    bool stopped = code == SARCINA_INTERRUPTED || (program_ending() && code > 128);
    r->state = code == 0 ? RUN_DONE : stopped ? RUN_INTERRUPTED : RUN_FAILED;
    if (r->state == RUN_DONE && plan_mark_done(g->plan, r, &g->trouble))
        r->state = RUN_FAILED;
    g->ended++;
    g->failed += r->state != RUN_DONE;
    if (r->state == RUN_DONE)
        g->seconds += seconds;
    clear_line(g);
    printf("%s: %s, %s (%zu of %zu)\n", r->folder,
           r->state == RUN_DONE     ? "done"
           : r->state == RUN_FAILED ? "failed"
                                    : "interrupted",
           duration, g->ended, g->total);
    fflush(stdout);
}

static bool stopped(void *self) {
    const progress *g = self;
    return *g->interrupt || program_ending() || g->trouble.status;
}

static int ending(void *self) {
    (void)self;
    return program_ending();
}

/* The first line that a failed run wrote to its errors. */
static void put_first_error(const plan_run *r) {
    char *path = alloc_format("%s/errors.txt", r->folder), line[512] = "";
    FILE *f = fopen(path, "r");
    while (f && fgets(line, sizeof line, f) && !strstr(line, "error"))
        continue;
    if (f)
        fclose(f);
    line[strcspn(line, "\n")] = '\0';
    fprintf(stderr, "%s: exit %d: %s\n", r->folder, r->code, strstr(line, "error") ? line : "see errors.txt there");
    free(path);
}

/* ---- steps ---- */

/* Checks the script as its first run would read it, so that a slip is told once and not by every replicate. */
static int check_script(program *host, const options *o, plan *p, diag *d) {
    options first = *o;
    size_t n = 0, room = o->nvars + p->naxes + 1;
    first.names = alloc_zeroed(room, sizeof *first.names);
    first.texts = alloc_zeroed(room, sizeof *first.texts);
    for (char **word = p->runs[0].argv + 1; strcmp(*word, "-var") == 0; word += 3) {
        first.names[n] = word[1];
        first.texts[n++] = word[2];
    }
    first.nvars = n;
    interp *in = program_interp(host, &first, d);
    int status = in ? SARCINA_OK : SARCINA_USAGE;
    if (in && interp_check_file(in, o->file)) {
        status = diag_error(d, "the script does not pass its check, so no run was started");
        if (p->first_seed)
            diag_help(d, "-replicates sets the variable seed: 'variable seed default 1' and 'seed ${seed}' read it");
    }
    if (in)
        plan_set_tag(p, o, interp_fingerprint(in));
    interp_free(in);
    free(first.names);
    free(first.texts);
    return status;
}

static int make_folders(const plan *p, diag *d) {
    int status = SARCINA_OK;
    for (size_t i = 0; i < p->nruns && !status; i++) {
        char *inside = alloc_format("%s/done", p->runs[i].folder);
        status = path_make_folders(inside, d);
        free(inside);
    }
    return status;
}

static int cores(void) {
    long n = sysconf(_SC_NPROCESSORS_ONLN);
    return n < 1 ? 1 : n > 1024 ? 1024 : (int)n;
}

/* One ensemble at a time in NAME.runs. */
static int take_lock(lock *l, const plan *p, diag *d) {
    bool unlocked;
    char *folder = alloc_format("%s.runs", p->name);
    int status = lock_take(l, folder, &unlocked, d);
    if (!status && unlocked)
        fprintf(stderr,
                "warning: the file system of %s has no locks: nothing keeps another ensemble from working in it\n",
                folder);
    free(folder);
    return status;
}

static int prepare(program *host, const options *o, plan *p, lock *l, diag *d) {
    int status = check_script(host, o, p, d);
    if (!status)
        status = take_lock(l, p, d);
    if (!status)
        status = plan_look(p, d);
    return status ? status : make_folders(p, d);
}

/* Does what is missing (nothing after an error: ranks that wait for work are released). */
static void run_missing(progress *g, const options *o, const worker_job *jobs, bool prepared) {
    plan *p = g->plan;
    size_t *due = alloc_zeroed(p->nruns, sizeof *due);
    for (size_t i = 0; i < p->nruns && prepared; i++)
        if (p->runs[i].state != RUN_DONE)
            due[g->total++] = i;
    worker_host host = {g, ended, draw, stopped, ending};
    int ranks = workers_mpi_ranks();
    g->at_once = ranks > 1 ? ranks : o->workers ? o->workers : cores();
    if (ranks > 1)
        workers_mpi_run(jobs, due, g->total, &host);
    else
        workers_run(jobs, due, g->total, g->at_once, &host);
    clear_line(g);
    free(due);
}

static int conclude(const progress *g, diag *d) {
    const plan *p = g->plan;
    size_t done = 0, failed = 0;
    for (size_t i = 0; i < p->nruns; i++) {
        done += p->runs[i].state == RUN_DONE;
        failed += p->runs[i].state == RUN_FAILED;
        if (p->runs[i].state == RUN_FAILED)
            put_first_error(&p->runs[i]);
    }
    int status = done ? merge_tables(p, d) : SARCINA_OK;
    if (status)
        return status;
    printf("%zu %s: %zu done, %zu failed, %zu missing\n", p->nruns, number_noun(p->nruns, "run", "runs"), done, failed,
           p->nruns - done - failed);
    if (done)
        printf("of those that are done: %s.ensemble.csv, %s.scalars.csv, %s.summary.csv\n", p->name, p->name, p->name);
    if (program_ending())
        return 128 + program_ending();
    return *g->interrupt ? SARCINA_INTERRUPTED : done < p->nruns ? SARCINA_ERROR : SARCINA_OK;
}

static int lead(program *host, const options *o, plan *p, const worker_job *jobs, diag *d) {
    progress g = {.plan = p, .interrupt = host->host.interrupt, .terminal = isatty(STDERR_FILENO)};
    lock held = {.file = -1};
    int status = prepare(host, o, p, &held, d);
    run_missing(&g, o, jobs, status == SARCINA_OK);
    if (g.trouble.status)
        *d = g.trouble;
    if (!status)
        status = (int)g.trouble.status;
    if (!status)
        status = conclude(&g, d);
    lock_release(&held);
    return status;
}

int ensemble_main(program *host, const options *o) {
    diag d = {0};
    plan p;
    int status = plan_create(&p, o, &d);
    if (!status) {
        worker_job *jobs = alloc_zeroed(p.nruns, sizeof *jobs);
        for (size_t i = 0; i < p.nruns; i++)
            jobs[i] = (worker_job){p.runs[i].folder, p.runs[i].argv};
        program_catch_ending();
        workers_mpi_begin();
        if (workers_mpi_rank() == 0)
            status = lead(host, o, &p, jobs, &d);
        else
            workers_mpi_serve(jobs, program_ending);
        workers_mpi_end();
        free(jobs);
        plan_free(&p);
    }
    if (d.status)
        program_complain(&d);
    return status;
}

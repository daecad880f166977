/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "app/plan.h"

#include "base/alloc.h"
#include "base/hash.h"
#include "base/path.h"

#include <inttypes.h>
#include <limits.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

enum { RUNS_MAX = 1000000 };

/* ---- reading the command line ---- */

/* "10" is 1..10; "5..20" itself. */
static int read_seeds(plan *p, const char *text, diag *d) {
    char *end;
    long a = strtol(text, &end, 10), b = a;
    bool range = strncmp(end, "..", 2) == 0;
    if (range)
        b = strtol(end + 2, &end, 10);
    else
        a = 1;
    if (*end || end == text || a < 1 || b < a || b - a >= RUNS_MAX) {
        diag_fail(d, SARCINA_USAGE, "-replicates takes a number or a range of seeds, not '%s'", text);
        return diag_help(d, "-replicates 10 runs the seeds 1 to 10, -replicates 11..20 the next ten");
    }
    p->first_seed = a;
    p->last_seed = b;
    return SARCINA_OK;
}

/* The values of an axis: texts parted by commas. */
static int read_axis(plan *p, const char *name, const char *list, diag *d) {
    for (size_t i = 0; i < p->naxes; i++)
        if (strcmp(p->axes[i].name, name) == 0)
            return diag_fail(d, SARCINA_USAGE, "-sweep %s is given twice", name);
    p->axes = alloc_resize(p->axes, p->naxes + 1, sizeof *p->axes);
    plan_axis *axis = &p->axes[p->naxes++];
    *axis = (plan_axis){.name = alloc_copy(name)};
    for (const char *at = list;; at++) {
        size_t n = strcspn(at, ",");
        axis->values = alloc_resize(axis->values, axis->n + 1, sizeof *axis->values);
        axis->values[axis->n++] = alloc_copy_n(at, n);
        if (n == 0) {
            diag_fail(d, SARCINA_USAGE, "-sweep %s has an empty value in '%s'", name, list);
            return diag_help(d, "-sweep %s 0.5um,1um,2um", name);
        }
        at += n;
        if (!*at)
            return SARCINA_OK;
    }
}

const char *plan_value(const plan *p, size_t axis, size_t point) {
    for (size_t i = p->naxes - 1; i > axis; i--)
        point /= p->axes[i].n;
    return p->axes[axis].values[point % p->axes[axis].n];
}

/* ---- the runs ---- */

/* A value as part of a folder's name: what a path or a shell would trip over becomes an underscore. */
static char *folder_word(const char *value) {
    char *word = alloc_copy(value);
    for (char *c = word; *c; c++)
        if (strchr("/ \t\n'\"$\\*?", *c))
            *c = '_';
    return word;
}

static char *folder_of(const plan *p, const plan_run *r) {
    char *folder = alloc_format("%s.runs", p->name);
    for (size_t i = 0; i < p->naxes; i++) {
        char *word = folder_word(plan_value(p, i, r->point));
        char *longer = alloc_format("%s/%s=%s", folder, p->axes[i].name, word);
        free(word);
        free(folder);
        folder = longer;
    }
    if (r->seed) {
        char *longer = alloc_format("%s/seed=%ld", folder, r->seed);
        free(folder);
        folder = longer;
    }
    return folder;
}

typedef struct words {
    char **list;
    size_t n, capacity;
} words;

static void add_word(words *w, const char *text) {
    w->list = alloc_grow(w->list, &w->capacity, w->n + 2, sizeof *w->list);
    w->list[w->n++] = alloc_copy(text);
    w->list[w->n] = NULL;
}

static void add_variable(words *w, const char *name, const char *text) {
    add_word(w, "-var");
    add_word(w, name);
    add_word(w, text);
}

/* The command line of one run: one that a user could type in its folder. */
static char **argv_of(const plan *p, const plan_run *r, const options *o, const char *script) {
    words w = {0};
    char seed[32], threads[32];
    snprintf(seed, sizeof seed, "%ld", r->seed);
    snprintf(threads, sizeof threads, "%d", o->threads ? o->threads : 1);
    add_word(&w, "sarcina");
    for (size_t i = 0; i < o->nvars; i++)
        add_variable(&w, o->names[i], o->texts[i]);
    for (size_t i = 0; i < p->naxes; i++)
        add_variable(&w, p->axes[i].name, plan_value(p, i, r->point));
    if (r->seed)
        add_variable(&w, "seed", seed);
    add_word(&w, "-threads");
    add_word(&w, threads);
    add_word(&w, "-log");
    add_word(&w, "log.sarcina");
    if (o->safe)
        add_word(&w, "-safe");
    add_word(&w, "-results");
    add_word(&w, script);
    return w.list;
}

static int compare_folders(const void *a, const void *b) {
    return strcmp((*(const plan_run *const *)a)->folder, (*(const plan_run *const *)b)->folder);
}

/* Two values that make the same folder's name. */
static int check_folders(const plan *p, diag *d) {
    const plan_run **sorted = alloc_zeroed(p->nruns, sizeof *sorted);
    int status = SARCINA_OK;
    for (size_t i = 0; i < p->nruns; i++)
        sorted[i] = &p->runs[i];
    qsort(sorted, p->nruns, sizeof *sorted, compare_folders);
    for (size_t i = 1; i < p->nruns && !status; i++)
        if (strcmp(sorted[i - 1]->folder, sorted[i]->folder) == 0)
            status = diag_fail(d, SARCINA_USAGE, "two runs of the sweep would share the folder %s", sorted[i]->folder);
    free(sorted);
    return status;
}

/* A variable has one source. */
static int check_names(const plan *p, const options *o, diag *d) {
    for (size_t i = 0; i < o->nvars; i++) {
        bool seeded = p->first_seed && strcmp(o->names[i], "seed") == 0;
        for (size_t k = 0; k < p->naxes; k++)
            if (strcmp(p->axes[k].name, o->names[i]) == 0)
                return diag_fail(d, SARCINA_USAGE, "-var and -sweep both set '%s'", o->names[i]);
        if (seeded)
            return diag_fail(d, SARCINA_USAGE, "-var and -replicates both set 'seed'");
    }
    for (size_t k = 0; k < p->naxes; k++)
        if (p->first_seed && strcmp(p->axes[k].name, "seed") == 0)
            return diag_fail(d, SARCINA_USAGE, "-sweep and -replicates both set 'seed'");
    return SARCINA_OK;
}

static int make_runs(plan *p, const options *o, diag *d) {
    size_t seeds = (size_t)(p->last_seed - p->first_seed + 1);
    double wanted = (double)seeds;
    p->npoints = 1;
    for (size_t i = 0; i < p->naxes; i++) {
        p->npoints *= p->axes[i].n;
        wanted *= (double)p->axes[i].n;
    }
    if (wanted > RUNS_MAX)
        return diag_fail(d, SARCINA_USAGE, "%g runs are more than %d", wanted, RUNS_MAX);
    char *script = realpath(o->file, NULL);
    if (!script)
        return diag_fail(d, SARCINA_USAGE, "no script '%s'", o->file);
    p->nruns = p->npoints * seeds;
    p->runs = alloc_zeroed(p->nruns, sizeof *p->runs);
    for (size_t i = 0; i < p->nruns; i++) {
        plan_run *r = &p->runs[i];
        r->point = i / seeds;
        r->seed = p->first_seed + (long)(i % seeds);
        r->folder = folder_of(p, r);
        r->argv = argv_of(p, r, o, script);
    }
    free(script);
    return check_folders(p, d);
}

/* "examples/ecoli/default.in" is called "default". */
static char *name_of(const char *file) {
    const char *slash = strrchr(file, '/'), *base = slash ? slash + 1 : file, *dot = strrchr(base, '.');
    return dot && dot > base ? alloc_copy_n(base, (size_t)(dot - base)) : alloc_copy(base);
}

int plan_create(plan *p, const options *o, diag *d) {
    if (!o->file)
        return diag_fail(d, SARCINA_USAGE, "-replicates and -sweep need a script to run");
    *p = (plan){.name = name_of(o->file)};
    int status = o->replicates ? read_seeds(p, o->replicates, d) : SARCINA_OK;
    for (size_t i = 0; i < o->nsweeps && !status; i++)
        status = read_axis(p, o->sweeps[i].name, o->sweeps[i].text, d);
    if (!status)
        status = check_names(p, o, d);
    if (!status)
        status = make_runs(p, o, d);
    if (status)
        plan_free(p);
    return status;
}

void plan_free(plan *p) {
    for (size_t i = 0; i < p->naxes; i++) {
        for (size_t k = 0; k < p->axes[i].n; k++)
            free(p->axes[i].values[k]);
        free(p->axes[i].values);
        free(p->axes[i].name);
    }
    for (size_t i = 0; i < p->nruns; i++) {
        for (char **word = p->runs[i].argv; word && *word; word++)
            free(*word);
        free(p->runs[i].argv);
        free(p->runs[i].folder);
    }
    free(p->axes);
    free(p->runs);
    free(p->name);
    free(p->tag);
    *p = (plan){0};
}

/* ---- what is done ---- */

/* The end of the text counts. */
static uint64_t hash_text(uint64_t h, const char *text) {
    return hash_bytes(h, text, strlen(text) + 1);
}

void plan_set_tag(plan *p, const options *o, uint64_t fingerprint) {
    for (size_t i = 0; i < o->nvars; i++)
        fingerprint = hash_text(hash_text(fingerprint, o->names[i]), o->texts[i]);
    free(p->tag);
    p->tag = alloc_format("sarcina %s, script %016" PRIx64, SARCINA_VERSION, fingerprint);
}

/* A `done` file: the tag of what made it, and the seconds it took. */
static int look_at(plan *p, plan_run *r, diag *d) {
    char *path = alloc_format("%s/done", r->folder), line[256] = "";
    FILE *f = fopen(path, "r");
    free(path);
    if (!f)
        return SARCINA_OK;
    bool read = fgets(line, sizeof line, f) && fscanf(f, "seconds %lf", &r->seconds) == 1;
    fclose(f);
    line[strcspn(line, "\n")] = '\0';
    if (read && strcmp(line, p->tag) == 0) {
        r->state = RUN_DONE;
        return SARCINA_OK;
    }
    diag_error(d, "%s holds results of another text of the script, other -var or another version", r->folder);
    return diag_help(d, "take %s.runs out of the way to begin anew; here: %s", p->name, p->tag);
}

int plan_look(plan *p, diag *d) {
    int status = SARCINA_OK;
    for (size_t i = 0; i < p->nruns && !status; i++)
        status = look_at(p, &p->runs[i], d);
    return status;
}

int plan_mark_done(const plan *p, const plan_run *r, diag *d) {
    char *path = alloc_format("%s/done", r->folder), *beside = alloc_format("%s/done.new", r->folder);
    FILE *f = path_open(beside, "w", d);
    int status = f ? SARCINA_OK : SARCINA_ERROR;
    if (f) {
        fprintf(f, "%s\nseconds %.3f\n", p->tag, r->seconds);
        status = path_close(f, beside, d);
        if (!status && rename(beside, path))
            status = path_error(path, d);
    }
    free(path);
    free(beside);
    return status;
}

/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "app/study_ensemble.h"

#include "base/alloc.h"
#include "base/csv.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

/* ---- reading ---- */

char *study_run_folder(const study *s, const study_case *c, long seed) {
    return alloc_format("%s/%s/%s.runs/seed=%ld", s->folder, c->name, strrchr(c->script, '/') + 1, seed);
}

static int read_run(study_ensemble *e, const char *folder, long seed, diag *d) {
    char *results = alloc_format("%s/results.csv", folder), *scalars = alloc_format("%s/scalars.csv", folder);
    e->seeds = alloc_resize(e->seeds, e->n + 1, sizeof *e->seeds);
    e->series = alloc_resize(e->series, e->n + 1, sizeof *e->series);
    e->scalars = alloc_resize(e->scalars, e->n + 1, sizeof *e->scalars);
    e->seeds[e->n] = seed;
    int status = study_table_read_results(&e->series[e->n], results, d);
    if (!status && (status = study_table_read_scalars(&e->scalars[e->n], scalars, d)))
        study_table_free(&e->series[e->n]);
    e->n += !status;
    free(results);
    free(scalars);
    return status;
}

static int read_ensemble(const study *s, const study_case *c, study_ensemble *e, long seeds, diag *d) {
    int status = SARCINA_OK;
    for (long seed = 1; seed <= seeds && !status; seed++) {
        char *folder = study_run_folder(s, c, seed), *done = alloc_format("%s/done", folder);
        if (access(done, R_OK) == 0)
            status = read_run(e, folder, seed, d);
        free(done);
        free(folder);
    }
    return status;
}

int study_open(study *s, const char *folder, const char *data, long seeds, diag *d) {
    *s = (study){folder, data, alloc_zeroed(study_case_count, sizeof *s->cases)};
    int status = SARCINA_OK;
    for (size_t i = 0; i < study_case_count && !status; i++)
        status = read_ensemble(s, &study_cases[i], &s->cases[i], seeds, d);
    return status;
}

void study_close(study *s) {
    for (size_t i = 0; i < study_case_count; i++) {
        study_ensemble *e = &s->cases[i];
        for (size_t k = 0; k < e->n; k++) {
            study_table_free(&e->series[k]);
            study_table_free(&e->scalars[k]);
        }
        free(e->seeds);
        free(e->series);
        free(e->scalars);
    }
    free(s->cases);
}

/* ---- ours ---- */

const study_ensemble *study_find(const study *s, const char *name) {
    const study_case *c = study_case_find(name);
    return c && s->cases[c - study_cases].n ? &s->cases[c - study_cases] : NULL;
}

void study_values(const study_ensemble *e, const study_quantity *q, double *x) {
    for (size_t i = 0; i < e->n; i++) {
        const study_table *t = &e->series[i];
        x[i] = q->place == STUDY_SCALAR ? study_table_number(&e->scalars[i], 0, q->column)
               : q->place == STUDY_END  ? study_table_number(t, t->nrows - 1, q->column)
                                        : study_table_at_cells(t, "cells", q->column, q->cells);
        x[i] *= q->scale;
    }
}

inference_sample study_sample(const study *s, const char *name, const char *quantity) {
    const study_ensemble *e = study_find(s, name);
    if (!e)
        return (inference_sample){NAN, NAN, 0};
    double *x = alloc_zeroed(e->n, sizeof *x);
    study_values(e, study_quantity_find(quantity), x);
    inference_sample sample = inference_sample_of(x, e->n);
    free(x);
    return sample;
}

/* ---- the original's ---- */

static const inference_sample nothing = {(double)NAN, (double)NAN, 0};

int study_read_series(const study *s, const study_case *c, study_table *t, diag *d) {
    char *path = alloc_format("%s/ecoli/series_2015k_%s.csv", s->data, c->reference);
    int status = study_table_read(t, path, d);
    free(path);
    return status;
}

static inference_sample reference_stacking(const study *s, const study_case *c, const study_quantity *q) {
    study_original_stackings theirs;
    char *folder = alloc_format("%s/ecoli", s->data);
    int status = study_original_read(&theirs, folder, c->reference, NULL);
    free(folder);
    if (status)
        return nothing;
    return strcmp(q->reference, "hours") == 0  ? theirs.hours
           : strcmp(q->reference, "area") == 0 ? theirs.area
                                               : theirs.cells;
}

static inference_sample reference_series(const study *s, const study_case *c, const study_quantity *q) {
    study_table t;
    if (study_read_series(s, c, &t, NULL))
        return nothing;
    double found[2];
    static const char *const suffix[2] = {"mean", "ci95"};
    for (int i = 0; i < 2; i++) {
        char *column = alloc_format("%s_%s", q->reference, suffix[i]);
        found[i] = q->place == STUDY_CELLS ? study_table_at_cells(&t, "n_cells_mean", column, q->cells)
                                           : study_table_number(&t, t.nrows - 1, column);
        free(column);
    }
    study_table_free(&t);
    return inference_sample_behind(found[0], found[1], ORIGINAL_SEEDS);
}

static double field_of(const csv *t, char *const *header, size_t n, const char *stem, const char *suffix) {
    char *name = alloc_format("%s_%s", stem, suffix);
    double x = NAN;
    for (size_t i = 0; i < n && i < t->n; i++)
        if (strcmp(header[i], name) == 0)
            x = strtod(t->fields[i], NULL);
    free(name);
    return x;
}

/* case,iter,t_h,n_seeds,seeds,NAME_mean,NAME_ci95 ...; the last row of the case with enough seeds counts. A quotient of
 * two means has no interval here. */
static inference_sample read_floc(csv *t, const study_case *c, const study_quantity *q, size_t seeds, long *step) {
    inference_sample found = nothing;
    if (!csv_next(t))
        return found;
    size_t n = t->n;
    char **header = alloc_zeroed(n, sizeof *header);
    for (size_t i = 0; i < n; i++)
        header[i] = alloc_copy(t->fields[i]);
    while (csv_next(t)) {
        size_t here = t->n > 3 ? strtoul(t->fields[3], NULL, 10) : 0;
        if (here < seeds || strcmp(t->fields[0], c->reference) != 0)
            continue;
        *step = strtol(t->fields[1], NULL, 10);
        double mean = field_of(t, header, n, q->reference, "mean"), ci95 = field_of(t, header, n, q->reference, "ci95");
        if (q->over) {
            mean /= field_of(t, header, n, q->over, "mean");
            ci95 = NAN;
        }
        found = inference_sample_behind(mean, ci95, here);
    }
    for (size_t i = 0; i < n; i++)
        free(header[i]);
    free(header);
    return found;
}

inference_sample study_reference(const study *s, const study_case *c, const study_quantity *q, size_t seeds,
                                 long *step) {
    *step = 0;
    if (!c->reference || !q->reference)
        return nothing;
    if (c->family == STUDY_ECOLI)
        return q->place == STUDY_SCALAR ? reference_stacking(s, c, q) : reference_series(s, c, q);
    char *path = alloc_format("%s/floc/summary.csv", s->data);
    csv t;
    inference_sample found = nothing;
    if (csv_open(&t, path, NULL) == SARCINA_OK) {
        found = read_floc(&t, c, q, seeds, step);
        csv_close(&t);
    }
    free(path);
    return found;
}

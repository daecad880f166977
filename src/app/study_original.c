/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "app/study_original.h"

#include "base/alloc.h"
#include "base/csv.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

/* A quantity in our tables and in the original's. */
typedef struct column_pair {
    const char *name, *unit;
    double our_scale; /* to that unit */
    const char *mean, *ci95;
} column_pair;

static const column_pair curves[ORIGINAL_CURVES] = {
    {"C", "", 1, "C_mean", "C_ci95"},
    {"thickness", "um", 1e6, "max_z_um_mean", "max_z_um_ci95"},
};

bool study_original_agrees(inference_difference d, double level) {
    return fabs(d.value) <= inference_width(d, level);
}

static inference_sample ours_at(const column_pair *p, const study_table *const *ours, size_t n, double cells) {
    double *x = alloc_zeroed(n, sizeof *x);
    for (size_t i = 0; i < n; i++)
        x[i] = p->our_scale * study_table_at_cells(ours[i], "cells", p->name, cells);
    inference_sample s = inference_sample_of(x, n);
    free(x);
    return s;
}

study_original_curve study_original_compare(int curve, const study_table *const *ours, size_t n,
                                            const study_table *series) {
    const column_pair *p = &curves[curve];
    study_original_curve c = {.name = p->name, .unit = p->unit};
    for (int cells = 10; cells <= 400; cells = cells < 20 ? 20 : cells + 20) {
        double mean = study_table_at_cells(series, "n_cells_mean", p->mean, cells);
        double ci95 = study_table_at_cells(series, "n_cells_mean", p->ci95, cells);
        study_original_point at = {.cells = cells, .ours = ours_at(p, ours, n, cells)};
        if (isnan(mean) || at.ours.n < 3)
            continue;
        at.theirs = inference_sample_behind(mean, ci95, ORIGINAL_SEEDS);
        at.difference = inference_compare(at.ours, at.theirs);
        at.agrees = study_original_agrees(at.difference, 0.95);
        c.nagree += at.agrees;
        c.points[c.npoints++] = at;
    }
    c.agrees = c.npoints >= 10 && (double)c.nagree >= 0.8 * (double)c.npoints;
    return c;
}

/* version,case,seed,stack_iter,stack_sub,t_stack_h,t_stack_any_substep_h,n_cells_at_stack,area_mvee_um2,... */
int study_original_read(study_original_stackings *s, const char *folder, const char *name, diag *d) {
    enum { VERSION, CASE, HOURS = 5, CELLS = 7, AREA = 8, NEEDED, ROOM = 64 };
    double hours[ROOM], area[ROOM], cells[ROOM];
    char *path = alloc_format("%s/stacking_per_seed.csv", folder);
    csv t;
    int status = csv_open(&t, path, d);
    free(path);
    if (status)
        return status;
    size_t n = 0;
    while (csv_next(&t) && n < ROOM) {
        if (t.n < NEEDED || strcmp(t.fields[VERSION], "2015k") != 0 || strcmp(t.fields[CASE], name) != 0)
            continue;
        hours[n] = strtod(t.fields[HOURS], NULL);
        area[n] = strtod(t.fields[AREA], NULL);
        cells[n++] = strtod(t.fields[CELLS], NULL);
    }
    csv_close(&t);
    *s = (study_original_stackings){inference_sample_of(hours, n), inference_sample_of(area, n),
                                    inference_sample_of(cells, n)};
    return SARCINA_OK;
}

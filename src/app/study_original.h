/* SPDX-License-Identifier: GPL-3.0-or-later */
/* E. coli colonies against the original authors' program, at equal cell number: the times of the two cannot agree,
 * since its generator makes founders grow too fast. The rule: C(t) and thickness at N = 10, 20, 40 ... 400 cells, where
 * the 95 % interval of the difference (Welch) must hold 0 at 80 % of the points; cell number and enclosing area at
 * first stacking, where the 99 % interval must. */
#ifndef SARCINA_APP_STUDY_ORIGINAL_H
#define SARCINA_APP_STUDY_ORIGINAL_H

#include "app/study_table.h"
#include "base/inference.h"

enum { ORIGINAL_CURVES = 2, ORIGINAL_POINTS = 21, ORIGINAL_SEEDS = 10 };

typedef struct study_original_point {
    double cells;
    inference_sample ours, theirs; /* in the unit of the report */
    inference_difference difference;
    bool agrees;
} study_original_point;

typedef struct study_original_curve {
    const char *name, *unit; /* "thickness", "um" */
    study_original_point points[ORIGINAL_POINTS];
    size_t npoints, nagree;
    bool agrees;
} study_original_curve;

/* The curve (0 ... ORIGINAL_CURVES - 1) of our colonies (n tables of step, cells, C, thickness in SI) beside that of
 * the series of the original; points that fewer than three colonies reach are left out. */
study_original_curve study_original_compare(int curve, const study_table *const *ours, size_t n,
                                            const study_table *series);

/* First stackings of the original. */
typedef struct study_original_stackings {
    inference_sample hours, area, cells; /* area in um2 */
} study_original_stackings;

/* From FOLDER/stacking_per_seed.csv, those of a case ("default", "anchor" ...) of version 2015k. */
int study_original_read(study_original_stackings *s, const char *folder, const char *name, diag *d);

/* Whether the difference's interval at this level holds 0. */
bool study_original_agrees(inference_difference d, double level);

#endif

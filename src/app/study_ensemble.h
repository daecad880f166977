/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The ensembles of the study as scripts/reproduce leaves them, FOLDER/CASE/SCRIPT.runs/seed=N, and the original
 * program's data beside them. */
#ifndef SARCINA_APP_STUDY_ENSEMBLE_H
#define SARCINA_APP_STUDY_ENSEMBLE_H

#include "app/study_cases.h"
#include "app/study_original.h"
#include "app/study_table.h"
#include "base/inference.h"

typedef struct study_ensemble {
    size_t n;             /* replicates that are done; 0: not run */
    long *seeds;          /* (n), ascending */
    study_table *series;  /* (n) results.csv: step, time and what was recorded, SI */
    study_table *scalars; /* (n) */
} study_ensemble;

typedef struct study {
    const char *folder;    /* of the runs */
    const char *data;      /* tests/data, with ecoli and floc */
    study_ensemble *cases; /* (study_case_count) */
} study;

/* Reads seeds 1 ... seeds of every case that has been run. */
int study_open(study *s, const char *folder, const char *data, long seeds, diag *d);
void study_close(study *s);

/* NULL where the case has not been run. */
const study_ensemble *study_find(const study *s, const char *name);

/* Folder of a replicate; the caller frees. */
char *study_run_folder(const study *s, const study_case *c, long seed);

/* The quantity of each replicate in its unit, to x (n); NaN where it has none. */
void study_values(const study_ensemble *e, const study_quantity *q, double *x);

/* Of the replicates that have it; n = 0 where the case has not been run. */
inference_sample study_sample(const study *s, const char *name, const char *quantity);

/* The original's tables: series_2015k_CASE.csv; the caller frees the table. */
int study_read_series(const study *s, const study_case *c, study_table *t, diag *d);

/* The same quantity of the original, n = 0 where it was not measured. E. coli: version 2015k. Flocs: the last step
 * that `seeds` or more of them reached, which goes to *step. */
inference_sample study_reference(const study *s, const study_case *c, const study_quantity *q, size_t seeds,
                                 long *step);

#endif

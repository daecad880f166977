/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The plan of an ensemble: every seed at every point of a sweep, each a run with a folder of its own. */
#ifndef SARCINA_APP_PLAN_H
#define SARCINA_APP_PLAN_H

#include "app/options.h"

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

typedef enum { RUN_MISSING, RUN_DONE, RUN_FAILED, RUN_INTERRUPTED } run_state;

typedef struct plan_run {
    char *folder; /* below the working folder */
    char **argv;  /* of the program that does it, ended by NULL */
    size_t point; /* of the sweep */
    long seed;    /* 0: the script's own */
    run_state state;
    int code;       /* its exit code */
    double seconds; /* it took */
} plan_run;

typedef struct plan_axis {
    char *name;
    char **values;
    size_t n;
} plan_axis;

typedef struct plan {
    char *name;      /* of the script, without folder and .in */
    plan_axis *axes; /* the last turns fastest */
    size_t naxes, npoints;
    long first_seed, last_seed; /* 0 and 0: no -replicates */
    plan_run *runs;             /* by point, then seed (nruns) */
    size_t nruns;
    char *tag; /* what a `done` file must say */
} plan;

/* From the command line. On an error there is nothing to free. */
int plan_create(plan *p, const options *o, diag *d);
void plan_free(plan *p);

/* What results must come from to count: this version, this text of the script (fingerprint: of it and all it
 * includes), these -var. */
void plan_set_tag(plan *p, const options *o, uint64_t fingerprint);

/* The text of an axis at a point. */
const char *plan_value(const plan *p, size_t axis, size_t point);

/* Reads from the folders which runs are done. An error where a folder holds results of another script or version. */
int plan_look(plan *p, diag *d);

/* Says in the run's folder that it is done; by way of a file beside it, so that it is there whole or not at all. */
int plan_mark_done(const plan *p, const plan_run *r, diag *d);

#endif

/* SPDX-License-Identifier: GPL-3.0-or-later */
/* What a script will take, told by -check: cells at the end, time, memory; and what in it can never act or is at odds
 * with itself. Commands note what they would do as they are checked; at the end a sample of the cells is relaxed as the
 * script says, and the growth laws do the rest. An estimate: right to a factor of about 3. */
#ifndef SARCINA_COMMAND_FORECAST_H
#define SARCINA_COMMAND_FORECAST_H

#include "engine/scene.h"
#include "script/command.h"

enum { FORECAST_SPECIES = 64, FORECAST_RUNS = 256 };

typedef struct forecast_run {
    double cycles, grow, relax; /* s */
    double until;               /* it ends with so many cells; infinite: no such bound */
    bool upto, force;           /* force: it may rest before `relax` is over */
} forecast_run;

typedef struct forecast {
    double cells[FORECAST_SPECIES], mass[FORECAST_SPECIES]; /* created, and their sum, pg */
    bool filament[FORECAST_SPECIES];                        /* some linked filially from the beginning */
    double least_gap; /* of the lowest cell above the substratum, um; infinite: none is known */
    bool unknown;     /* cells come from files, or what the check cannot know */
    size_t nruns;
    forecast_run runs[FORECAST_RUNS];
    double scale; /* how often all this happens: from a clear on in loops */
    double cycles, relaxations, cell_relaxations, relaxed, most; /* of what went before the last clear */
} forecast;

/* What a checked command would do; times: how often (interp_check_passes). */
void forecast_create(interp *in, const placement *p, double n, double z);
void forecast_note_run(interp *in, const forecast_run *r);
void forecast_unknown(interp *in);
void forecast_clear(interp *in);

/* Behind a check without errors: prints the estimate, and warns. */
void forecast_report(interp *in);

/* Cells of each species at the end, in their sum; *cycles done. cell_relaxations (NULL or): the sum over cycles that
 * relax of the cells then and, of relaxations alone, their number. */
typedef struct forecast_end {
    double cells, cycles, relaxations, cell_relaxations, relaxed;
    double of[FORECAST_SPECIES];
} forecast_end;
forecast_end forecast_project(const forecast *f, const scene *s);

/* forecast_warn.c */
void forecast_warn(interp *in, const forecast *f, const forecast_end *end);

#endif

/* SPDX-License-Identifier: GPL-3.0-or-later */
/* What `tradeoff` found, as tables: on the screen and in the log, and as a CSV file. */
#ifndef SARCINA_COMMAND_TRADEOFF_TABLE_H
#define SARCINA_COMMAND_TRADEOFF_TABLE_H

#include "engine/tradeoff.h"
#include "engine/column.h"
#include "script/interp.h"

#include <stdio.h>

/* What was measured, for the writers; none of it is owned. */
typedef struct tradeoff_result {
    tradeoff_plan plan;
    const tradeoff_method *methods; /* (n) */
    const tradeoff_row *rows;       /* (n) */
    size_t n;
    tradeoff_reference reference;
    /* of many cycles; cycles 0: none of it */
    uint64_t cycles;
    double margin;
    tradeoff_runs runs;
    size_t base;                           /* row of the method that the others are compared with */
    output_column *observed;               /* (runs.nobserved) */
    const tradeoff_comparison *comparison; /* (n x nobserved) */
} tradeoff_result;

/* Each as soon as it is known: the cycles may take long. */
void tradeoff_table_relaxation(interp *in, const tradeoff_result *r);
void tradeoff_table_cycles(interp *in, const tradeoff_result *r);

/* One row a preset, then one a run and quantity, and one a comparison; SI units, empty where there is nothing. */
void tradeoff_table_write(FILE *f, const tradeoff_result *r);

/* Diagrams: errors against evaluations; and, of cycles, the differences against evaluations, in a file whose name has
 * .cycles before its ending. */
int tradeoff_plot_draw(const char *path, const tradeoff_result *r, diag *d);

#endif

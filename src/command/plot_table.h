/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Curves of a diagram from tables on disk: those of ensembles (NAME.ensemble.csv, NAME.summary.csv, as app/merge.h
 * writes them), and any table with one column a quantity. */
#ifndef SARCINA_COMMAND_PLOT_TABLE_H
#define SARCINA_COMMAND_PLOT_TABLE_H

#include "base/units.h"
#include "output/plot.h"

enum { PLOT_TABLE_CURVES = 16 };

typedef enum { PLOT_TABLE_CI95, PLOT_TABLE_SD, PLOT_TABLE_RANGE, PLOT_TABLE_NONE } plot_table_band;

typedef struct plot_table_request {
    units *units;
    const char *const *files;
    const char *const *y;
    size_t nfiles, ny;
    const char *x;
    plot_table_band band;
    double step; /* of histograms and profiles; NaN: the last */
} plot_table_request;

/* The curves: every y of every file at every point of its sweep, in the order of the tables. A histogram is one curve
 * against `ID.low`. The caller frees, also after an error. */
typedef struct plot_table {
    plot_diagram diagram;
    plot_curve curves[PLOT_TABLE_CURVES];
    struct plot_table_memory *memory;
} plot_table;

int plot_table_read(const plot_table_request *r, plot_table *out, diag *d);
void plot_table_free(plot_table *t);

#endif

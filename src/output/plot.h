/* SPDX-License-Identifier: GPL-3.0-or-later */
/* A diagram of numbers against one other, drawn by gnuplot in the style of a paper. */
#ifndef SARCINA_OUTPUT_PLOT_H
#define SARCINA_OUTPUT_PLOT_H

#include "base/diag.h"
#include "base/dim.h"

#include <stdbool.h>
#include <stddef.h>

/* One column of numbers; owned by the caller. */
typedef struct plot_series {
    const char *name; /* as the axis and legend show it */
    const char *unit; /* "" : none */
    dim d;
    const double *values; /* (rows); NaN: a gap */
} plot_series;

/* Can gnuplot be started? The error says what to install. */
int plot_ready(diag *d);

/* The kind of picture a file's name asks for, as gnuplot's `set terminal` has it: of .svg, .png and .pdf; NULL: none.
 */
const char *plot_terminal(const char *path);

/* What gnuplot is told, in units people read (readable.h); the caller frees. Numbers of another dimension than the
 * first y stand on the right axis. */
char *plot_script(const plot_series *x, const plot_series *y, size_t count, size_t rows, const char *path);

/* Draws it. */
int plot_draw(const plot_series *x, const plot_series *y, size_t count, size_t rows, const char *path, diag *d);

#endif

/* SPDX-License-Identifier: GPL-3.0-or-later */
/* A diagram of numbers against numbers, drawn by gnuplot in the style of a paper: curves with shaded bands, points with
 * bars, histograms. */
#ifndef SARCINA_OUTPUT_PLOT_H
#define SARCINA_OUTPUT_PLOT_H

#include "base/diag.h"
#include "base/dim.h"

#include <stdbool.h>
#include <stddef.h>

typedef enum {
    PLOT_LINE,   /* through the points, or the middles of the bins; the band is shaded */
    PLOT_POINTS, /* each with a bar from low to high, joined by a thin line */
    PLOT_BOXES   /* a bin each, bars on top */
} plot_shape;

/* Numbers of the caller, SI, (n) each; NaN: a gap. */
typedef struct plot_curve {
    const char *name; /* as the legend shows it */
    const char *axis; /* as the axis does where all on it are called so */
    dim d;            /* of y, low and high */
    size_t n;
    const double *x, *y;
    const double *low, *high; /* NULL: no band */
    const double *x_end;      /* upper ends of bins that begin at x; NULL: no bins */
    bool guide;               /* a dashed grey line through its points: a margin, a front */
} plot_curve;

/* A word that stands upright over a place of the x axis. */
typedef struct plot_note {
    const char *text;
    double x;
} plot_note;

typedef struct plot_diagram {
    const char *x_name; /* as its axis shows it, with the unit */
    dim x_dim;
    const char *x_label, *y_label; /* whole labels in place of those; NULL: none */
    plot_shape shape;
    bool log_x, log_y;
    const plot_curve *curves; /* guides are the last */
    size_t count;
    const plot_note *notes;
    size_t nnotes;
} plot_diagram;

/* Can gnuplot be started? The error says what to install. */
int plot_ready(diag *d);

/* The kind of picture a file's name asks for, as gnuplot's `set terminal` has it: of .svg, .png and .pdf; NULL: none.
 */
const char *plot_terminal(const char *path);

/* What gnuplot is told, in units people read (readable.h); the caller frees. Numbers of another dimension than the
 * first curve's stand on the right axis. */
char *plot_script(const plot_diagram *p, const char *path);

/* Draws it. */
int plot_draw(const plot_diagram *p, const char *path, diag *d);

#endif

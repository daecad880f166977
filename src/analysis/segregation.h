/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Whether neighbours are alike. */
#ifndef SARCINA_ANALYSIS_SEGREGATION_H
#define SARCINA_ANALYSIS_SEGREGATION_H

#include "analysis/view.h"

/* Moran's I (P. A. P. Moran, Biometrika 37:17, 1950) of a number x of each cell, N of them, over P pairs of neighbours:
 *
 *     I = (N / P) (sum over pairs of (x_a - m) (x_b - m)) / (sum over cells of (x - m)^2),   m the mean of x
 *
 * Neighbours touch, or with view.radius have their centres at most so far apart. x is view.of, else the generation.
 * out: I; P; -1/(N - 1), which I is on average when the same numbers are dealt to the cells at random. NaN where nobody
 * has neighbours, or all numbers are the same; cells whose number is NaN are left out. */
int segregation_measure(const view *v, const bool *members, double *out, diag *d);

#endif

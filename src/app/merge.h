/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The tables of an ensemble, merged from the folders of its runs in the order of the plan. */
#ifndef SARCINA_APP_MERGE_H
#define SARCINA_APP_MERGE_H

#include "app/plan.h"

/* NAME.ensemble.csv: for every point of the sweep, step and quantity, over the runs that are done: runs (that reached
 * the step), n (of which it is defined), mean, ci95 (half-width of the 95 % Student-t interval), sd, min, max.
 * NAME.scalars.csv: a row a run, a column a scalar (first_time analyses, equal variables); `never`: did not happen.
 * NAME.summary.csv: for every point and scalar: runs, n, never, mean, ci95, sd, min, max. SI units. */
int merge_tables(const plan *p, diag *d);

#endif

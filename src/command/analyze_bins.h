/* SPDX-License-Identifier: GPL-3.0-or-later */
/* analyze ID GROUP histogram|profile VALUE: how a number of the cells is spread, and how it goes along a direction. */
#ifndef SARCINA_COMMAND_ANALYZE_BINS_H
#define SARCINA_COMMAND_ANALYZE_BINS_H

#include "command/output_list.h"

/* The forms, and their parameters: for command_analyze. */
extern const command_form analyze_bins_forms[];
extern const size_t analyze_bins_form_count;

/* ID (how many cells were counted) or ID.FIELD[bin]; si NULL: only the dimension is asked. */
int analyze_bins_value(interp *in, const output_analysis *p, const char *field, double index, dim *dimension,
                       double *si, diag *d);

/* How many bins; whether they lie along a direction (a profile). */
size_t analyze_bins_count(const output_analysis *p);
bool analyze_bins_is_profile(const output_analysis *p);

/* What lies along the bins: the value, or the direction. */
const char *analyze_bins_along(const output_analysis *p);

/* Its ends as given, SI; NaN: from the least to the largest of the cells. */
void analyze_bins_ends(const output_analysis *p, double *low, double *high);

/* Every field of every bin of the present scene, SI, by the name it has in expressions: "lengths.count[3]". */
typedef void analyze_bins_visit(void *self, const char *name, dim d, double si);
int analyze_bins_each(interp *in, const output_analysis *p, analyze_bins_visit *visit, void *self, diag *d);

/* Opens the file of many steps, if there is one; writes the present step. */
int analyze_bins_open(output_analysis *p, diag *d);
int analyze_bins_write(outputs *o, output_analysis *p, diag *d);

void analyze_bins_free(output_bins *b); /* NULL is allowed */

#endif

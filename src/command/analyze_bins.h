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

/* Opens the file of many steps, if there is one; writes the present step. */
int analyze_bins_open(output_analysis *p, diag *d);
int analyze_bins_write(outputs *o, output_analysis *p, diag *d);

void analyze_bins_free(output_bins *b); /* NULL is allowed */

#endif

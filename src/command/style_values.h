/* SPDX-License-Identifier: GPL-3.0-or-later */
/* From checked arguments to the parameter values of a style, in the order of its param records. */
#ifndef SARCINA_COMMAND_STYLE_VALUES_H
#define SARCINA_COMMAND_STYLE_VALUES_H

#include "script/command.h"

/* The name at the head of a param's specification. */
void style_values_name(const param *p, char name[64]);

/* values[i] for each of n params: what was given; and, unless amending, the defaults of the others (NaN without). */
void style_values(const args *a, const param *params, size_t n, bool amending, spread *values);

/* The same for a force term, whose parameters are numbers. */
void style_values_read(const args *a, const param *params, size_t n, bool amending, double *values);

#endif

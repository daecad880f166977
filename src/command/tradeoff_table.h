/* SPDX-License-Identifier: GPL-3.0-or-later */
/* What `tradeoff` found, as tables: on the screen and in the log, and as a CSV file. */
#ifndef SARCINA_COMMAND_TRADEOFF_TABLE_H
#define SARCINA_COMMAND_TRADEOFF_TABLE_H

#include "engine/tradeoff.h"
#include "script/interp.h"

#include <stdio.h>

/* What was measured, for the writers; none of it is owned. */
typedef struct tradeoff_result {
    tradeoff_plan plan;
    const tradeoff_method *methods; /* (n) */
    const tradeoff_row *rows;       /* (n) */
    size_t n;
    tradeoff_reference reference;
} tradeoff_result;

void tradeoff_table_print(interp *in, const tradeoff_result *r);

/* One row a preset; SI units, empty fields where there is nothing. */
void tradeoff_table_write(FILE *f, const tradeoff_result *r);

#endif

/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Compares a CSV table with its reference, number by number within tolerances. */
#ifndef SARCINA_APP_TABLE_DIFF_H
#define SARCINA_APP_TABLE_DIFF_H

#include "base/diag.h"

#include <stdbool.h>
#include <stddef.h>

/* Numbers may differ by the larger of rel times the reference's size and abs. */
typedef struct table_tolerance {
    char column[64]; /* "" : of all columns without their own */
    double rel, abs;
} table_tolerance;

/* SARCINA_OK when the tables have the same columns and rows, texts are equal and numbers near; else an error that
 * names the first place where they differ. tolerances[0] is that of all columns. */
int table_diff(const char *path, const char *reference, const table_tolerance *tolerances, size_t n, diag *d);

#endif

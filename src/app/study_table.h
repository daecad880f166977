/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Tables of numbers with named columns: what runs and the original program have left behind. */
#ifndef SARCINA_APP_STUDY_TABLE_H
#define SARCINA_APP_STUDY_TABLE_H

#include "base/diag.h"

#include <stdbool.h>
#include <stddef.h>

typedef struct study_table {
    char **names; /* (ncolumns) */
    double *at;   /* (nrows x ncolumns); NaN where a field holds no number */
    size_t ncolumns, nrows;
} study_table;

/* A CSV file with a header. After an error there is nothing to free. */
int study_table_read(study_table *t, const char *path, diag *d);

/* results.csv of a run (step, time, quantity, unit, value): a row a step, a column a quantity, and one for the step. */
int study_table_read_results(study_table *t, const char *path, diag *d);

/* scalars.csv of a run (quantity, unit, value): one row. What never happened is NaN. */
int study_table_read_scalars(study_table *t, const char *path, diag *d);

void study_table_free(study_table *t);

/* The column called name; -1 when there is none. */
ptrdiff_t study_table_column(const study_table *t, const char *name);

/* A number; NaN without such a row or column. */
double study_table_number(const study_table *t, size_t row, const char *column);

/* The column's value when the column `cells` first reaches so many: linear in the logarithm of cells between the rows
 * around that. NaN where it never does. */
double study_table_at_cells(const study_table *t, const char *cells_column, const char *column, double cells);

#endif

/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The thermo table: values of the whole scene, one row a step, on the screen and log as LAMMPS prints them and in a
 * CSV file.
 *
 * The CSV has a header of column names and SI numbers that read back to the bit; undefined is `nan`. When `step` is not
 * among the columns it comes first, so that a restart knows which rows to keep. */
#ifndef SARCINA_OUTPUT_THERMO_H
#define SARCINA_OUTPUT_THERMO_H

#include "engine/column.h"

#include <stdbool.h>
#include <stddef.h>

typedef struct thermo thermo;

/* Lines of the table, without their line ends, go to this. */
typedef void thermo_put(void *self, const char *line);

thermo *thermo_create(void);
void thermo_free(thermo *t); /* NULL is allowed */

/* Takes n columns (the array is copied; the columns are released by the table), with default formats. The CSV file
 * begins anew when it had been opened. */
void thermo_set_columns(thermo *t, const output_column *columns, size_t n);
size_t thermo_count(const thermo *t);
const output_column *thermo_column(const thermo *t, size_t i);

/* The i-th column on the screen: divided by `unit` (of the script, in SI). */
void thermo_set_unit(thermo *t, size_t i, double unit);

/* Header with units behind the names, `length[m]`, on screen and in the CSV. suffix of column i ("" : none). */
void thermo_set_suffix(thermo *t, size_t i, const char *suffix);

/* Format of the column of this name on the screen: one %-format of d, i, e, f or g; `d` rounds. */
int thermo_set_format(thermo *t, const char *column, const char *format, diag *d);

/* Writes every row also to this CSV file; NULL: no longer. See path_check. */
void thermo_set_file(thermo *t, const char *path);
const char *thermo_file(const thermo *t); /* NULL: none */

/* Opens the CSV file, if any: before the first cycle, so that it fails before and not after the work. */
int thermo_open(thermo *t, diag *d);

void thermo_header(const thermo *t, thermo_put *put, void *self);

/* The row of the scene as it stands: to put, and to the file unless it holds this step. */
int thermo_row(thermo *t, uint64_t step, thermo_put *put, void *self, diag *d);

/* The scene has gone back to this step: the file loses what came after. */
int thermo_rewind(thermo *t, uint64_t step, diag *d);

/* Numbers of column i at every step it has had a row for since the columns were chosen, SI, in the order of steps; of a
 * text: NaN. thermo_rows: how many. They belong to the table and hold until its next row. */
size_t thermo_rows(const thermo *t);
const double *thermo_history(const thermo *t, size_t i);

/* The history as bytes, for restart files (the caller frees), and back: false when it is of other columns. */
char *thermo_save(const thermo *t, size_t *n);
bool thermo_load(thermo *t, const char *bytes, size_t n);

/* The number in column i of the row written last, SI; NaN before the first. */
double thermo_last(const thermo *t, size_t i);

#endif

/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "app/study_table.h"

#include "base/alloc.h"
#include "base/csv.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

static size_t add_column(study_table *t, const char *name) {
    t->names = alloc_resize(t->names, t->ncolumns + 1, sizeof *t->names);
    t->names[t->ncolumns] = alloc_copy(name);
    return t->ncolumns++;
}

static double *add_row(study_table *t) {
    t->at = alloc_resize(t->at, (t->nrows + 1) * t->ncolumns, sizeof *t->at);
    double *row = t->at + t->nrows++ * t->ncolumns;
    for (size_t i = 0; i < t->ncolumns; i++)
        row[i] = NAN;
    return row;
}

static double number_of(const char *text) {
    char *end;
    double x = strtod(text, &end);
    return end == text || *end ? (double)NAN : x;
}

int study_table_read(study_table *t, const char *path, diag *d) {
    csv file;
    *t = (study_table){0};
    int status = csv_open(&file, path, d);
    if (status)
        return status;
    if (csv_next(&file))
        for (size_t i = 0; i < file.n; i++)
            add_column(t, file.fields[i]);
    while (csv_next(&file)) {
        double *row = add_row(t);
        for (size_t i = 0; i < file.n && i < t->ncolumns; i++)
            row[i] = number_of(file.fields[i]);
    }
    csv_close(&file);
    return SARCINA_OK;
}

/* The columns of a table with a row a number: their names stand in field `at`. */
static int read_columns(study_table *t, const char *path, size_t at, diag *d) {
    csv file;
    int status = csv_open(&file, path, d);
    if (status)
        return status;
    csv_next(&file); /* the header */
    while (csv_next(&file))
        if (file.n > at && study_table_column(t, file.fields[at]) < 0)
            add_column(t, file.fields[at]);
    csv_close(&file);
    return SARCINA_OK;
}

int study_table_read_results(study_table *t, const char *path, diag *d) {
    *t = (study_table){0};
    add_column(t, "step");
    csv file;
    int status = read_columns(t, path, 2, d);
    if (!status)
        status = csv_open(&file, path, d);
    if (status) {
        study_table_free(t);
        return status;
    }
    csv_next(&file);
    while (csv_next(&file)) {
        if (file.n != 5)
            continue;
        double step = number_of(file.fields[0]);
        double *row = t->nrows ? t->at + (t->nrows - 1) * t->ncolumns : NULL;
        if (!row || row[0] != step)
            row = add_row(t);
        row[0] = step;
        row[study_table_column(t, file.fields[2])] = number_of(file.fields[4]);
    }
    csv_close(&file);
    return SARCINA_OK;
}

int study_table_read_scalars(study_table *t, const char *path, diag *d) {
    *t = (study_table){0};
    csv file;
    int status = read_columns(t, path, 0, d);
    if (!status)
        status = csv_open(&file, path, d);
    if (status) {
        study_table_free(t);
        return status;
    }
    double *row = add_row(t);
    csv_next(&file);
    while (csv_next(&file))
        if (file.n == 3)
            row[study_table_column(t, file.fields[0])] = number_of(file.fields[2]);
    csv_close(&file);
    return SARCINA_OK;
}

void study_table_free(study_table *t) {
    for (size_t i = 0; i < t->ncolumns; i++)
        free(t->names[i]);
    free(t->names);
    free(t->at);
    *t = (study_table){0};
}

ptrdiff_t study_table_column(const study_table *t, const char *name) {
    for (size_t i = 0; i < t->ncolumns; i++)
        if (strcmp(t->names[i], name) == 0)
            return (ptrdiff_t)i;
    return -1;
}

double study_table_number(const study_table *t, size_t row, const char *column) {
    ptrdiff_t i = study_table_column(t, column);
    return i < 0 || row >= t->nrows ? (double)NAN : t->at[row * t->ncolumns + (size_t)i];
}

double study_table_at_cells(const study_table *t, const char *cells_column, const char *column, double cells) {
    ptrdiff_t count = study_table_column(t, cells_column), value = study_table_column(t, column);
    if (count < 0 || value < 0)
        return NAN;
    for (size_t i = 1; i < t->nrows; i++) {
        const double *before = t->at + (i - 1) * t->ncolumns, *after = before + t->ncolumns;
        if (after[count] < cells || before[count] >= cells)
            continue;
        double w = log(cells / before[count]) / log(after[count] / before[count]);
        return before[value] + w * (after[value] - before[value]);
    }
    return NAN;
}

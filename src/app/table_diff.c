/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "app/table_diff.h"

#include "base/alloc.h"
#include "base/csv.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

static const table_tolerance *tolerance_of(const char *column, const table_tolerance *list, size_t n) {
    for (size_t i = 1; i < n; i++)
        if (strcmp(list[i].column, column) == 0)
            return &list[i];
    return &list[0];
}

static bool is_near(const char *got, const char *wanted, const table_tolerance *t) {
    char *got_end, *wanted_end;
    double x = strtod(got, &got_end), y = strtod(wanted, &wanted_end);
    if (got_end == got || wanted_end == wanted || *got_end || *wanted_end)
        return strcmp(got, wanted) == 0;
    if (isnan(x) || isnan(y))
        return isnan(x) && isnan(y);
    return fabs(x - y) <= fmax(t->abs, t->rel * fabs(y));
}

static int compare_headers(const csv *got, const csv *wanted, diag *d) {
    for (size_t i = 0; i < got->n || i < wanted->n; i++) {
        const char *a = i < got->n ? got->fields[i] : "nothing", *b = i < wanted->n ? wanted->fields[i] : "nothing";
        if (strcmp(a, b) != 0)
            return diag_fail(d, SARCINA_EXPECT, "%s: column %zu is %s, not %s", got->path, i + 1, a, b);
    }
    return SARCINA_OK;
}

static int compare_rows(csv *got, csv *wanted, char *const *columns, size_t ncolumns, const table_tolerance *list,
                        size_t n, diag *d) {
    for (size_t row = 1;; row++) {
        bool more = csv_next(got), due = csv_next(wanted);
        if (!more && !due)
            return SARCINA_OK;
        if (more != due || got->n != ncolumns || wanted->n != ncolumns)
            return diag_fail(d, SARCINA_EXPECT, "%s: row %zu is %s", got->path, row,
                             !more  ? "missing"
                             : !due ? "too many"
                                    : "of another length");
        for (size_t i = 0; i < ncolumns; i++)
            if (!is_near(got->fields[i], wanted->fields[i], tolerance_of(columns[i], list, n)))
                return diag_fail(d, SARCINA_EXPECT, "%s: row %zu, %s is %s, not %s", got->path, row, columns[i],
                                 got->fields[i], wanted->fields[i]);
    }
}

static int compare(csv *got, csv *wanted, const table_tolerance *tolerances, size_t n, diag *d) {
    if (!csv_next(got) || !csv_next(wanted))
        return diag_fail(d, SARCINA_EXPECT, "%s: the table or its reference is empty", got->path);
    int status = compare_headers(got, wanted, d);
    size_t count = wanted->n;
    char **columns = alloc_zeroed(count, sizeof *columns);
    for (size_t i = 0; i < count; i++)
        columns[i] = alloc_copy(wanted->fields[i]);
    if (!status)
        status = compare_rows(got, wanted, columns, count, tolerances, n, d);
    for (size_t i = 0; i < count; i++)
        free(columns[i]);
    free(columns);
    return status;
}

int table_diff(const char *path, const char *reference, const table_tolerance *tolerances, size_t n, diag *d) {
    csv got = {0}, wanted = {0};
    int status = csv_open(&got, path, d);
    if (!status)
        status = csv_open(&wanted, reference, d);
    if (!status)
        status = compare(&got, &wanted, tolerances, n, d);
    csv_close(&got);
    csv_close(&wanted);
    return status;
}

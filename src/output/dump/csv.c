/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Comma-separated values: a header of column names, then one row a cell in the order of ids, in SI. */
#include "output/dump/styles.h"

#include "output/field.h"

#include <inttypes.h>
#include <stdlib.h>

static void put_header(const dump_frame *f, FILE *out) {
    if (f->many)
        fputs("step,", out);
    for (size_t i = 0; i < f->ncolumns; i++) {
        if (i)
            fputc(',', out);
        field_put_csv(out, f->columns[i].name);
    }
    fputc('\n', out);
}

static int put_row(const dump_frame *f, uint32_t row, FILE *out, diag *d) {
    if (f->many)
        fprintf(out, "%" PRIu64 ",", f->view->step);
    for (size_t i = 0; i < f->ncolumns; i++) {
        char text[64];
        if (dump_text(f, i, row, text, d))
            return SARCINA_ERROR;
        if (i)
            fputc(',', out);
        field_put_csv(out, text);
    }
    fputc('\n', out);
    return SARCINA_OK;
}

static int write(const dump_frame *f, FILE *out, diag *d) {
    int status = SARCINA_OK;
    size_t n;
    uint32_t *rows = dump_rows(f, &n);
    if (f->fresh)
        put_header(f, out);
    for (size_t i = 0; i < n && !status; i++)
        status = put_row(f, rows[i], out, d);
    free(rows);
    return status;
}

const dump_style dump_csv = {
    .name = "csv",
    .summary = "a table of the cells, comma-separated, in SI units",
    .details = "The header names the columns; one row a cell, in the order of ids; undefined values are nan. Without * "
               "in FILE all steps go to one file and the first column is the step.",
    .example = "dump cells all csv 5 cells.*.csv id species x y z length",
    .now_example = "write_dump all csv now.csv id x y z -z length/1um",
    .takes = DUMP_COLUMNS,
    .many = true,
    .blocks = STREAM_CSV,
    .write = write,
};

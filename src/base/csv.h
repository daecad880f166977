/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Reads tables with commas, row by row (RFC 4180: quoted fields may hold commas and doubled quotes, but no line ends).
 */
#ifndef SARCINA_BASE_CSV_H
#define SARCINA_BASE_CSV_H

#include "base/diag.h"

#include <stdbool.h>
#include <stddef.h>
#include <stdio.h>

typedef struct csv {
    FILE *file;
    const char *path; /* the caller's */
    size_t row;       /* lines read so far */
    char **fields;    /* of the present row (n), unquoted; hold until the next */
    size_t n;
    char *line;
    size_t line_room, field_room;
} csv;

/* Opens a table; after an error there is nothing to close. */
int csv_open(csv *t, const char *path, diag *d);
void csv_close(csv *t);

/* The next row that is neither empty nor a comment (#); false at the end. */
bool csv_next(csv *t);

#endif

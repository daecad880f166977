/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Diagnostics: what went wrong, where in the script, and what to write instead.
 *
 * A function that can fail returns a status and takes a diag as its last argument; a NULL diag is allowed.
 * The function that finds the error fills the message; the interpreter adds the place. */
#ifndef SARCINA_BASE_DIAG_H
#define SARCINA_BASE_DIAG_H

#include "sarcina/status.h"

#include <stdint.h>

/* A stretch of one line of a script; lines and columns from 1, columns in bytes. */
typedef struct span {
    const struct source *source; /* NULL: no place known */
    uint32_t line, column, length;
} span;

typedef struct diag {
    sarcina_status status;
    span at;
    char message[1024];
    char help[1024]; /* "" or what to write instead; lines parted by \n, each shown after "help: " */
} diag;

/* Every error message of the program is made by one of these two, so a test can list them all.
 * Both return the status; d may be NULL. */
int diag_error(diag *d, const char *format, ...) __attribute__((format(printf, 2, 3)));
int diag_fail(diag *d, sarcina_status status, const char *format, ...) __attribute__((format(printf, 3, 4)));

/* Adds a line of help to an error; returns d's status (SARCINA_ERROR when d is NULL). */
int diag_help(diag *d, const char *format, ...) __attribute__((format(printf, 2, 3)));

/* Sets the place of an error that has none yet. */
void diag_place(diag *d, span at);

void diag_clear(diag *d);

#endif

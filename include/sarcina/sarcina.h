/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Sarcina as a library: its command language in a program of one's own, from C, C++, or whatever calls C.
 *
 *     sarcina *s = sarcina_create(NULL);
 *     if (sarcina_run_file(s, "colony.in") != SARCINA_OK)
 *         fputs(sarcina_error(s), stderr);
 *     double gyration;
 *     sarcina_value(s, "gyration/1um", &gyration);
 *     sarcina_free(s);
 *
 * Calls return a sarcina_status. One that fails leaves the scene as it was, says why in sarcina_error, and the scene
 * can be used on. A handle is for one thread at a time; several handles know nothing of each other. The library prints
 * nothing, never exits and reads no environment. `shell`, `edit` and log files are the program's and not to be had
 * here. */
#ifndef SARCINA_SARCINA_H
#define SARCINA_SARCINA_H

#include "sarcina/status.h"

#include <stddef.h>

#ifdef __cplusplus
extern "C" {
#endif

#if defined(__GNUC__)
#define SARCINA_API __attribute__((visibility("default")))
#else
#define SARCINA_API
#endif

/* A scene and the interpreter of its commands. */
typedef struct sarcina sarcina;

/* Who wants what the program would print: whole lines, with their ends, while the call runs. A callback may call
 * sarcina_interrupt, and nothing else, with the handle. */
typedef struct sarcina_output {
    void *self;
    void (*screen)(void *self, const char *text);   /* what commands print; NULL: dropped */
    void (*warnings)(void *self, const char *text); /* and what they warn of; NULL: dropped */
} sarcina_output;

/* "0.1.0". */
SARCINA_API const char *sarcina_version(void);

/* An empty scene; out is copied and may be NULL. NULL: the tables of units (UDUNITS-2) are not where they should be.
 * GSL's error handler, which ends programs, is turned off for the process. */
SARCINA_API sarcina *sarcina_create(const sarcina_output *out);
SARCINA_API void sarcina_free(sarcina *s); /* NULL is allowed */

/* Sets a variable as `-var NAME TEXT` does: scripts that give it a default keep this text. */
SARCINA_API int sarcina_set_variable(sarcina *s, const char *name, const char *text);

/* Checks a script whole on a scene of its own, and changes nothing: SARCINA_ERROR, and every mistake in sarcina_error.
 */
SARCINA_API int sarcina_check_file(sarcina *s, const char *path);

/* Runs the commands and blocks of a file, or of a text of one or more lines, one after the other. The first that fails
 * ends it; those before it stand. Places in messages are those of a file called "text". */
SARCINA_API int sarcina_run_file(sarcina *s, const char *path);
SARCINA_API int sarcina_run(sarcina *s, const char *text);

/* What the last failed call found, with place and help, as the program shows it; "" if the last call went well. Stands
 * until the next call. */
SARCINA_API const char *sarcina_error(const sarcina *s);

/* The value of an expression on the scene as it stands, such as "cells" or "quantile(0.99, overlap)/1nm": in SI units
 * unless divided by another. NaN where it is undefined. */
SARCINA_API int sarcina_value(sarcina *s, const char *expression, double *value);

SARCINA_API size_t sarcina_cells(const sarcina *s);

/* The value of an expression for each cell, such as "x/1um" or "id", in the order of their ids: values
 * (sarcina_cells(s)), which the caller owns. */
SARCINA_API int sarcina_cell_values(sarcina *s, const char *expression, double *values);

/* Lets the run that goes on stop at its last whole cycle with SARCINA_INTERRUPTED; nothing if none does. May be called
 * from a signal handler or another thread. */
SARCINA_API void sarcina_interrupt(sarcina *s);

#ifdef __cplusplus
}
#endif

#endif

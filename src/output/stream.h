/* SPDX-License-Identifier: GPL-3.0-or-later */
/* A text file that holds one block of lines a step, each step once, in rising order: thermo tables, dumps of many
 * steps. Going on from a restart file, it loses the blocks after that step and goes on behind the rest. */
#ifndef SARCINA_OUTPUT_STREAM_H
#define SARCINA_OUTPUT_STREAM_H

#include "base/diag.h"

#include <stdbool.h>
#include <stdint.h>
#include <stdio.h>

typedef enum {
    STREAM_CSV,  /* a header, then lines one of whose columns is the step */
    STREAM_DUMP, /* blocks that begin with the lines "ITEM: TIMESTEP" and the step */
    STREAM_XYZ   /* blocks that begin with a number of lines, and one that has " step=STEP" */
} stream_kind;

typedef struct stream stream;

/* Touches no file yet. step_column: of a CSV, from 0. */
stream *stream_create(const char *path, stream_kind kind, int step_column);
void stream_free(stream *s); /* closes; NULL is allowed */

const char *stream_path(const stream *s);

/* Opens the file unless it is open: emptied, or, after stream_rewind, shortened (a file that is not there is begun). */
int stream_open(stream *s, diag *d);

/* Of an open file: nothing is in it yet, so it wants its header. */
bool stream_is_empty(const stream *s);

/* Whether this step (or a later one) has been written already. */
bool stream_has(const stream *s, uint64_t step);

/* The open file, to write to; stream_end marks the end of a step's block, stream_flush that of a header. Both find out
 * what went wrong. */
FILE *stream_file(const stream *s);
int stream_end(stream *s, uint64_t step, diag *d);
int stream_flush(stream *s, diag *d);

/* Drops the blocks after a step from an open stream; one not yet open does so when it opens. */
int stream_rewind(stream *s, uint64_t step, diag *d);

#endif

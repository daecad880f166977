/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Dumps: the cells at one step, written to a file. A style is one record and one file of src/output/dump; to add one:
 * its file, and one line in dump.c. */
#ifndef SARCINA_OUTPUT_DUMP_H
#define SARCINA_OUTPUT_DUMP_H

#include "analysis/view.h"
#include "base/param.h"
#include "engine/column.h"
#include "output/stream.h"

#include <stdio.h>

/* What is written: the state, which cells, and what of them. Owned by the caller. */
typedef struct dump_frame {
    const view *view;
    const bool *members;          /* by cell row; NULL: all */
    const output_column *columns; /* per cell; of a picture the one that colours */
    size_t ncolumns;
    const void *options; /* of the style: image_options */
    bool many;           /* the file holds several steps: each row says its own */
    bool fresh;          /* the file is empty: begin with the header */
    int threads;
} dump_frame;

/* What stands behind FILE in the command. */
typedef enum {
    DUMP_NOTHING,
    DUMP_COLUMNS,     /* one column or more */
    DUMP_ANY_COLUMNS, /* none or more */
    DUMP_COLOR,       /* one column or colour, then the keywords */
    DUMP_FILM         /* the same, and frames a second */
} dump_takes;

/* How one file of many frames is written that is no text. */
typedef struct dump_film {
    int (*ready)(diag *d);                                                     /* what it needs is there */
    int (*frame)(void **film, const char *path, const dump_frame *f, diag *d); /* *film NULL: the first */
    int (*end)(void *film, diag *d);                                           /* frees; NULL is allowed */
} dump_film;

typedef struct dump_style {
    const char *name, *summary;
    const char *details;               /* what the file holds, by whom it is read; for help */
    const char *example, *now_example; /* script lines, for dump and write_dump */
    dump_takes takes;
    const param *params; /* keywords */
    size_t nparams;
    bool many;           /* without * in its file's name, steps follow one another in one file */
    stream_kind blocks;  /* how such a file tells the steps apart */
    bool indexed;        /* a series of files has an index (collection.h) */
    const char *missing; /* what the build lacks to write it, with what to do; NULL: nothing */
    /* one of three */
    int (*write)(const dump_frame *f, FILE *out, diag *d);       /* text */
    int (*draw)(const dump_frame *f, const char *path, diag *d); /* writes the file itself */
    const dump_film *film;                                       /* many frames in one file that is no text */
    /* a second file, NAME.beside.EXTENSION: optional */
    const char *beside;
    bool (*has_beside)(const dump_frame *f);
    int (*write_beside)(const dump_frame *f, FILE *out, diag *d);
} dump_style;

extern const dump_style *const dump_styles[];
extern const size_t dump_style_count;
int dump_find(const char *name); /* row; -1 */

/* A file, or one a step. */
typedef struct dump dump;

/* Can a dump of this style be written to this place? Touches nothing. Fails when the style wants a `*` in the pattern
 * that is not there, or the place cannot be written. now: for dump_write_now. */
int dump_check(int style, const char *pattern, bool now, diag *d);

/* Of a style's row; `*` in the pattern is the step. */
dump *dump_create(int style, const char *pattern);
void dump_free(dump *p);             /* NULL is allowed */
void dump_set_pad(dump *p, int pad); /* the step in a name has at least so many digits */
int dump_style_of(const dump *p);
const char *dump_pattern(const dump *p);

/* Opens what stays open (a file of many steps): before the first cycle. */
int dump_open(dump *p, diag *d);

/* Writes the frame (many, fresh and step are filled in) unless this step has been written, or the build cannot write
 * the style. */
int dump_write(dump *p, const dump_frame *f, diag *d);

/* Writes one frame to one file at once: write_dump. A style missing from the build is an error. */
int dump_write_now(int style, const char *path, const dump_frame *f, diag *d);

/* The scene has gone back to this step: a file of many steps loses what came after. */
int dump_rewind(dump *p, uint64_t step, diag *d);

/* Step written last (UINT64_MAX: none); a dump that goes on is told. */
uint64_t dump_last(const dump *p);
void dump_set_last(dump *p, uint64_t step);

/* The name with every * replaced by the step; the caller frees. */
char *dump_file_name(const char *pattern, uint64_t step, int pad);

/* For the styles: rows of the frame's cells in the order of their ids; the caller frees. *n: how many. */
uint32_t *dump_rows(const dump_frame *f, size_t *n);

/* For the styles: column i of a row as text; numbers with all their digits. */
int dump_text(const dump_frame *f, size_t i, uint32_t row, char text[64], diag *d);

#endif

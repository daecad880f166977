/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Texts that commands come from: files, standard input, what was typed. Spans of errors point into them. */
#ifndef SARCINA_SCRIPT_SOURCE_H
#define SARCINA_SCRIPT_SOURCE_H

#include "base/diag.h"

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

typedef struct source {
    char *name;   /* as errors show it; "" at the prompt */
    char *folder; /* of the file, "" for none: ${here} */
    char *text;
    size_t length;
} source;

/* A file's text; NULL with an error when it cannot be read. */
source *source_read(const char *path, diag *d);
/* Copies text. */
source *source_of_text(const char *name, const char *text);
void source_free(source *s);

/* The folder of what scripts include, from the path of the program or library: scripts/lib of the checkout that it was
 * built in, share/sarcina/lib of where it is installed. NULL: there is none. The caller frees. */
char *source_library(const char *program);

/* Line number `line` (from 1) without its end; *length its bytes; NULL: there is no such line. */
const char *source_line(const source *s, uint32_t line, size_t *length);

#endif

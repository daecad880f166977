/* SPDX-License-Identifier: GPL-3.0-or-later */
/* What may stand at the cursor: found from the records of the commands and the names of the scene.
 *
 * The line is read up to the cursor as the reader of commands would, but nothing is replaced, run or changed, and text
 * that is wrong only has no completions. What is offered depends on the place: commands, the words and keywords of
 * their forms not given yet, names by class, values and functions in expressions (also in $( ) within texts), units
 * behind a number by the argument's dimension, files, the words of blocks. */
#ifndef SARCINA_SCRIPT_COMPLETE_H
#define SARCINA_SCRIPT_COMPLETE_H

#include "script/interp.h"

typedef struct completion {
    char *text;
    bool open; /* what follows stands directly behind it ("mean(", "folder/"): no blank */
} completion;

typedef struct completions {
    size_t from; /* byte of the text: each candidate takes the place of [from, cursor), which it begins with */
    completion *list;
    size_t n, capacity;
} completions;

/* The candidates at byte `cursor` of text (one command or a block over several lines, as far as it is typed), in the
 * order of the tables, each once. The caller frees with complete_free. */
void complete_line(interp *in, const char *text, size_t cursor, completions *out);
void complete_free(completions *c);

#endif

/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The words that the interpreter reads itself, as data for help, the manual and completion: blocks and loops. */
#ifndef SARCINA_SCRIPT_CONTROL_H
#define SARCINA_SCRIPT_CONTROL_H

#include <stddef.h>

typedef struct control_word {
    const char *name;
    const char *usage;   /* lines parted by \n */
    const char *summary; /* one line, no full stop */
    const char *details;
    const char *example; /* lines that run as a test */
} control_word;

extern const control_word control_words[];
extern const size_t control_word_count;

/* The record called name; NULL. */
const control_word *control_find(const char *name);

#endif

/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Reads one logical line from left to right, replacing each $ as it reaches it, once and in place, so that whatever
 * looks ahead looks at replaced text.
 *
 *     replaced = "$" LETTER | "${" NAME "}" | "$(" expr [ ":" FORMAT ] ")" | "$$"
 *
 * In a check some texts are unknown until the script runs. They stand in the line as one character whose note says
 * what is known of them. */
#ifndef SARCINA_SCRIPT_READER_H
#define SARCINA_SCRIPT_READER_H

#include "base/dim.h"
#include "script/interp.h"
#include "script/piece.h"

/* What a replacement put into the line. */
typedef struct replacement {
    bool unknown; /* the text is not known in this check */
    bool number;  /* unknown, but one number: of dimension d unless wild */
    bool wild;
    dim d;
    bool quantity; /* known, and one number of dimension d with the unit that format_quantity gives it */
} replacement;

typedef struct reader {
    interp *in;
    piece text;
    size_t at;             /* next character */
    size_t tail;           /* characters at the end that are not to be read: the quote around a quoted expression */
    replacement *replaced; /* by serial - 1 */
    size_t count, capacity;
    char **pool; /* texts of words, freed with the reader */
    size_t pooled, pool_capacity;
} reader;

/* Takes a copy of the line. */
void reader_open(reader *r, interp *in, const piece *line);
void reader_close(reader *r);

/* A word as read: text without quotes. */
typedef struct word {
    size_t from, to; /* in r->text, with the quotes; the text is at [from + quote, to - quote) */
    const char *text;
    size_t n;
    size_t quote;               /* length of the quotes: 0, 1, 3 */
    const replacement *unknown; /* the word holds an unknown text */
    bool only_unknown;          /* and is nothing else */
} word;

/* Skips blanks; whether the line is at its end. */
bool reader_at_end(reader *r);

/* The next word, $ replaced; reader_take then moves behind it. At the end of the line w->text is NULL. */
int reader_peek(reader *r, word *w, diag *d);
void reader_take(reader *r, const word *w);

/* The next word with its $ left alone: commands run later. */
int reader_peek_raw(reader *r, word *w, diag *d);

/* Replaces the $ at character i. */
int reader_replace(reader *r, size_t i, diag *d);

/* Everything to the end of the line as one word, $ replaced outside and inside quotes. */
int reader_rest(reader *r, word *w, diag *d);

size_t reader_end(const reader *r); /* index of the end */
span reader_span(const reader *r, size_t from, size_t to);
span reader_word_span(const reader *r, const word *w);

/* A copy of n characters that lives as long as the reader. */
const char *reader_keep(reader *r, const char *text, size_t n);

/* The characters that may stand outside quotes: ASCII and what numbers with units use. */
int reader_check_ascii(const reader *r, size_t from, size_t to, diag *d);

/* The line as the journal keeps it: $ replaced, but those of commands run later; the caller frees. */
char *reader_text(const reader *r);

#endif

/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Logical lines: physical lines joined by `&`, without comments; quotes respected.
 *
 *     line    = { physical line whose last character before a comment is "&" } physical line
 *     quoted  = '"' ... '"' | "'" ... "'" | triple-quoted, which alone may span lines
 *
 * A quote opens one where a word or an operand begins, so the apostrophe of don't opens none. */
#ifndef SARCINA_SCRIPT_LINE_H
#define SARCINA_SCRIPT_LINE_H

#include "script/piece.h"

typedef struct line_notes {
    bool commented; /* a comment stood behind an `&` */
    bool cut;       /* the text ended behind an `&` */
    bool open;      /* a quote that may go over lines was open at the end of the text */
} line_notes;

/* Reads the next logical line at *at into line (an empty piece; blank lines are skipped) and moves *at behind it.
 * SARCINA_OK with line->n == 0: there is none left. On an error *at is behind the faulty line. */
int line_next(const piece *script, size_t *at, piece *line, line_notes *notes, diag *d);

/* Length of the quote that opens at chars[i] (1 or 3); 0: none opens here. start: where the text begins. */
size_t line_quote(const char *chars, size_t start, size_t i);

/* Index behind the quoted stretch that opens at i with a quote of the given length; (size_t)-1: not closed. Replaced
 * characters close nothing. */
size_t line_quote_end(const piece *p, size_t i, size_t quote);

bool line_is_blank(char c);

#endif

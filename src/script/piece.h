/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Stretches of text whose every character remembers its place.
 *
 * A logical line, a block's body or a quoted command is a piece: characters, each with the line and column it came
 * from; where a $ was replaced, the new characters carry the place and length of the $. So an error in a command run
 * from a quoted text inside an include still points at the right word. */
#ifndef SARCINA_SCRIPT_PIECE_H
#define SARCINA_SCRIPT_PIECE_H

#include "script/source.h"

/* Where a character came from. */
typedef struct mark {
    uint32_t line, column;
    uint32_t length; /* 1; replaced: of the whole $... */
    uint32_t serial; /* 0: as written; else which replacement of this piece put it there, from 1 */
} mark;

typedef struct piece {
    const source *source;
    char *chars; /* n of them and a NUL */
    mark *marks; /* n, and one for the end */
    size_t n, capacity;
} piece;

piece piece_of_source(const source *s);
piece piece_slice(const piece *p, size_t from, size_t to);
void piece_free(piece *p);

/* Appends characters [from, to) of another piece, or one character with a mark. */
void piece_append(piece *p, const piece *other, size_t from, size_t to);
void piece_push(piece *p, char c, mark m);

/* Replaces characters [from, to) by n others, which all carry the mark m. */
void piece_splice(piece *p, size_t from, size_t to, const char *chars, size_t n, mark m);

/* Where the stretch [from, to) stands in its source. An empty stretch has length 1. */
span piece_span(const piece *p, size_t from, size_t to);

bool piece_is_replaced(const piece *p, size_t i);

#endif

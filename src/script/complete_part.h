/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The parts of completion: see complete.h. */
#ifndef SARCINA_SCRIPT_COMPLETE_PART_H
#define SARCINA_SCRIPT_COMPLETE_PART_H

#include "script/complete.h"
#include "script/names.h"
#include "script/signature.h"

/* Where candidates are wanted. */
typedef struct completing {
    interp *in;
    const char *text; /* ends at the cursor */
    size_t from;      /* of the word there, then of the part of it that a candidate takes the place of */
    char quote;       /* the quote that is open around it; 0: none */
    completions *out;
} completing;

/* Adds a candidate if it begins with what is typed and is not there yet. */
void complete_part_offer(completing *c, const char *candidate, bool open);

/* complete.c: a command or block that begins at c->from. */
void complete_part_text(completing *c);

/* The words of one command before the cursor, quotes kept; words[0] is the command. */
typedef struct complete_words {
    char **list;
    size_t n, capacity;
} complete_words;

/* complete_place.c: what the records allow behind these words. */
void complete_part_place(completing *c, const complete_words *w);
void complete_part_commands(completing *c);

/* complete_kind.c: an argument's word number `part`, of the kinds of several words. */
void complete_part_argument(completing *c, const slot *s, size_t part);
void complete_part_topics(completing *c, const complete_words *w);
void complete_part_number(completing *c, const slot *s);
enum { COMPLETE_SD = 10 }; /* part: behind the number of a spread, where sd may stand */

/* complete_expr.c: in an expression that begins at c->from; per_cell: values of cells may stand in it as they are. */
void complete_part_expression(completing *c, bool per_cell);

/* In a $, ${ or $( that is not closed at the cursor: true, and what may stand there has been offered. */
bool complete_part_dollar(completing *c);

/* complete_file.c: files of the folder that is typed. */
void complete_part_file(completing *c);

#endif

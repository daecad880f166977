/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The structure of a script, found before anything runs: commands and the blocks around them.
 *
 *     block = "if" expr NL body { "elif" expr NL body } [ "else" NL body ] "end" [ "if" ]
 *           | "for" NAME "in" ... NL body "end" [ "for" ]  |  "while" expr NL body "end" [ "while" ]
 *           | "repeat" INTEGER NL body "end" [ "repeat" ]
 *
 * An `if` with a word behind its `then` is the one-line form, an ordinary command. */
#ifndef SARCINA_SCRIPT_BLOCK_H
#define SARCINA_SCRIPT_BLOCK_H

#include "script/piece.h"

typedef enum { STATEMENT_COMMAND, STATEMENT_IF, STATEMENT_FOR, STATEMENT_WHILE, STATEMENT_REPEAT } statement_kind;

typedef struct block {
    struct statement *list;
    size_t count, capacity;
} block;

typedef struct statement {
    statement_kind kind;
    piece line;             /* the command, or the block's first line */
    bool commented;         /* a comment stood behind an `&` of it */
    block body;             /* of the loop, or of the `if` when its condition holds */
    struct statement *next; /* if: the elif or else that follows it; its line is "elif ..." or "else" */
} statement;

/* What is wrong with the structure is given to `report`, one call an error; what can be read is read all the same.
 * Returns the number of errors. The caller frees with block_free. */
typedef void (*block_report)(void *self, const diag *d);
size_t block_parse(const piece *script, block *out, block_report report, void *self);
void block_free(block *b);

/* Whether text ends inside a quote, behind an `&` or inside a block, so that a prompt must ask for more. */
bool block_is_open(const char *text);

#endif

/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Runs statements: commands by their records, blocks by their conditions. In a check every statement is gone through
 * once, errors are reported one by one, and the next is taken. */
#ifndef SARCINA_SCRIPT_EXECUTE_H
#define SARCINA_SCRIPT_EXECUTE_H

#include "script/block.h"
#include "script/interp.h"
#include "script/reader.h"

int execute_block(interp *in, const block *b, diag *d);

/* Parses and runs a source that the interpreter keeps. kind: of the frame ("include"), or NULL for none. */
int execute_source(interp *in, source *s, const char *kind, diag *d);

/* One command's line. */
int execute_command(interp *in, const piece *line, diag *d);

/* Whether a line may begin with this word. */
bool execute_is_command(const interp *in, const char *name);

/* if EXPR then ... on one line, behind its first word. */
int execute_one_line_if(interp *in, reader *r, diag *d);

/* Remembers for the report what the reader saw; the first call for an error counts. */
void execute_note(interp *in, const reader *r, const diag *d);

/* In a check: reports an error and counts it. */
void execute_report(interp *in, const diag *d);

/* What is going on, for the stack below an error; an error when it is too deep. */
int execute_push(interp *in, const char *kind, span at, const source *running, diag *d);
void execute_pop(interp *in);

#endif

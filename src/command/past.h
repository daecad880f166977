/* SPDX-License-Identifier: GPL-3.0-or-later */
/* What a prompt has run: the state before each line that changed it, for `undo`, and the lines themselves, for `save`.
 *
 * A line counts when the state (all that a restart file holds, and the settings) is another behind it. States share
 * what they have in common; the oldest are dropped when all of them occupy more than interp_undo_bytes; the last one
 * stays. Files are no part of it: what was written stays, and tables go on behind the step that the scene has gone back
 * to. */
#ifndef SARCINA_COMMAND_PAST_H
#define SARCINA_COMMAND_PAST_H

#include "script/interp.h"

typedef struct past past;

/* Before the first line: keeps the state as it is. Later calls do nothing. */
void past_begin(interp *in);
void past_free(past *p); /* NULL is allowed */

/* After a line or block has run, or failed with this status. */
void past_ran(interp *in, const char *text, int status);

/* What has run before the prompt: a command (-e), a script, a variable of the command line. `save` writes it, `undo`
 * does not go behind it. */
void past_given(interp *in, const char *text, int status);
void past_given_file(interp *in, const char *path, int status);
void past_given_variable(interp *in, const char *name, const char *text);

/* Takes back the last n lines that changed anything. Errors: there are not so many, or their states were dropped. */
int past_undo(interp *in, size_t n, diag *d);

/* Writes a script that leads to the present state. Where a line was broken off half-way, a restart file beside the
 * script takes the place of all before it. *lines: how many commands it has. */
int past_save(interp *in, const char *path, size_t *lines, diag *d);

/* The line before the one that is running, whatever it did; NULL: there is none. */
const char *past_last(interp *in);

/* A line to be run next, as if it had been typed; past_take_next gives it to whoever types (who frees it); NULL: none.
 */
void past_set_next(interp *in, const char *text);
char *past_take_next(interp *in);

#endif

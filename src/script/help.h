/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Help, made from the tables of commands, topics, values and functions. */
#ifndef SARCINA_SCRIPT_HELP_H
#define SARCINA_SCRIPT_HELP_H

#include "script/interp.h"
#include "script/page.h"
#include "script/signature.h"

enum { HELP_WIDTH = 100, HELP_FORMS_MAX = 64 };

/* What there is to say about something: "" (the commands), "dump", "dump image", "thickness", "mean", "if",
 * "expressions". NULL with an error when there is no such topic; the caller frees. The text has no line end at its
 * end. */
char *help_text(interp *in, const char *asked, diag *d);

/* Everything whose name, summary, details or arguments have the word, best first; NULL with an error when nothing
 * has. */
char *help_search(interp *in, const char *text, diag *d);

/* All records as members of a JSON object, without its braces; the caller frees. */
char *help_json(const command_table *t);

/* A text as JSON (NULL: null), and "NAME": TEXT with a comma before it where the object has begun. */
void help_json_text(page *p, const char *text);
void help_json_member(page *p, const char *name, const char *text);

/* ---- for the files of help ---- */

/* Pages of one command: its forms in short or whole (help_command.c). */
void help_put_command(page *p, const command_table *t, const char *name, const char *style);

#endif

/* SPDX-License-Identifier: GPL-3.0-or-later */
/* One line from whoever types: edited with readline on a terminal, plain from a pipe. */
#ifndef SARCINA_APP_REPL_LINE_H
#define SARCINA_APP_REPL_LINE_H

#include "script/interp.h"

typedef enum { REPL_LINE, REPL_LINE_END, REPL_LINE_INTERRUPTED } repl_line_status;

/* Tab completes for this interpreter from here on. */
void repl_line_open(interp *in);

/* The next line, without its end; the caller frees it. before: what was typed of the same command, NULL: nothing, so
 * the line begins one. REPL_LINE_INTERRUPTED: Ctrl-C, which the terminal has answered. */
repl_line_status repl_line_edit(const char *before, char **line);

/* The same from a pipe. */
repl_line_status repl_line_read(char **line);

#endif

/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The prompt. An error does not end it; blocks, quotes and `&` are read on until they are whole. On a terminal GNU
 * readline edits the line; from a pipe the same lines run the same way, without prompts. */
#ifndef SARCINA_APP_REPL_H
#define SARCINA_APP_REPL_H

#include "app/options.h"
#include "script/interp.h"

/* Reads commands from standard input until quit or its end; returns the exit code. */
int repl_run(const options *o, interp *in);

/* Whether there will be a prompt: asked for, or a terminal and nothing else to do. */
bool repl_is_wanted(const options *o);

#endif

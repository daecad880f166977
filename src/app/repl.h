/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The prompt. An error does not end it; blocks, quotes and `&` are read on until they are whole. On a terminal GNU
 * readline edits the line; from a pipe the same lines run the same way, without prompts. */
#ifndef SARCINA_APP_REPL_H
#define SARCINA_APP_REPL_H

#include "app/options.h"
#include "app/program.h"
#include "script/interp.h"

/* Reads commands from standard input until quit or its end; returns the exit code. */
int repl_run(program *p, const options *o, interp *in);

#endif

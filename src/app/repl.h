/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The prompt. An error does not end it; blocks, quotes and `&` are read on until they are whole. */
#ifndef SARCINA_APP_REPL_H
#define SARCINA_APP_REPL_H

#include "script/interp.h"

/* Reads lines from the terminal until quit or the end of the input; returns the exit code. */
int repl_run(interp *in);

#endif

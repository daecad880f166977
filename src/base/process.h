/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Another program that we feed with bytes: ffmpeg, gnuplot. It is found in PATH and started without a shell, with an
 * environment of its own that holds PATH and LC_ALL=C.UTF-8 only, in a process group of its own, so that Ctrl-C reaches
 * us alone. Its standard output goes nowhere, its errors where ours go. */
#ifndef SARCINA_BASE_PROCESS_H
#define SARCINA_BASE_PROCESS_H

#include "base/diag.h"

#include <stddef.h>

typedef struct process process;

/* Whether the program `name` can be started; the error says which Debian package has it. */
int process_check(const char *name, const char *package, diag *d);

/* Starts it with these words (the first its name, NULL behind the last). NULL: the error says why. */
process *process_open(const char *const *words, diag *d);

/* Bytes for its standard input. An error when it has ended. */
int process_write(process *p, const void *bytes, size_t n, diag *d);

/* The end of its input: waits for it, and frees. An error when it failed; NULL is allowed. */
int process_close(process *p, diag *d);

/* All three: starts it, gives it these bytes and waits for its end. */
int process_run(const char *const *words, const void *bytes, size_t n, diag *d);

#endif

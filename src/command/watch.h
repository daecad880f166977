/* SPDX-License-Identifier: GPL-3.0-or-later */
/* What `watch` adds to the progress of a run (show.c). */
#ifndef SARCINA_COMMAND_WATCH_H
#define SARCINA_COMMAND_WATCH_H

#include "script/interp.h"

typedef struct watch watch;
void watch_free(watch *w); /* NULL is allowed */

/* The progress line with what is watched before it: values on the line, a picture on lines of its own above. A value
 * that cannot be computed is "?". The caller frees. */
char *watch_text(interp *in, const char *line);

#endif

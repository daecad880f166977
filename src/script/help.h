/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Help, made from the tables of commands, values and functions. */
#ifndef SARCINA_SCRIPT_HELP_H
#define SARCINA_SCRIPT_HELP_H

#include "script/interp.h"

/* What there is to say about a topic: "" (the commands), "dump", "dump image", "thickness", "mean", "if". NULL with an
 * error when there is no such topic; the caller frees. The text has no line end at its end. */
char *help_text(interp *in, const char *topic, diag *d);

#endif

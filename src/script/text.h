/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Commands given as text and run later, perhaps many times: their structure is found once. */
#ifndef SARCINA_SCRIPT_TEXT_H
#define SARCINA_SCRIPT_TEXT_H

#include "script/block.h"
#include "script/interp.h"

/* Takes over the piece. */
command_text *text_create(piece *text);

/* In a check: every error in it, as far as can be said now. Errors are reported; SARCINA_OK returns. */
int text_check(interp *in, command_text *t, diag *d);

#endif

/* SPDX-License-Identifier: GPL-3.0-or-later */
/* A text in the user's editor: $VISUAL, else $EDITOR, else vi, on a file of its own. */
#ifndef SARCINA_APP_EDITOR_H
#define SARCINA_APP_EDITOR_H

#include "base/diag.h"

/* *text (in memory of its own) is replaced by what the editor leaves. Errors: no file, or the editor's own. */
int editor_run(char **text, diag *d);

#endif

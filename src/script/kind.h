/* SPDX-License-Identifier: GPL-3.0-or-later */
/* What stands for an argument, in words: for help, the manual and -help-json. */
#ifndef SARCINA_SCRIPT_KIND_H
#define SARCINA_SCRIPT_KIND_H

#include "script/page.h"
#include "script/signature.h"

/* "length (um, nm)", "one of in, out", "a species", "a whole number". */
void kind_put(page *p, const command_table *t, const slot *s);

/* Sentences: what the argument means, what may stand there, its range, its default or that it is required. */
void kind_explain(page *p, const command_table *t, const slot *s);

/* Whether its summary says all that kind_put would. */
int kind_is_obvious(const slot *s);

/* "more than 0, at most 1"; puts nothing where there is no bound. Returns whether there is one. */
int kind_put_range(page *p, const slot *s);

#endif

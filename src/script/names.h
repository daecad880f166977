/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Who owns a name: variables, values, functions, the classes of commands (species, regions, groups ...), the language.
 * All share one namespace but the free classes (dump IDs). */
#ifndef SARCINA_SCRIPT_NAMES_H
#define SARCINA_SCRIPT_NAMES_H

#include "script/command.h"

/* The class called so; NULL. */
const name_class *names_class(const interp *in, const char *name);

/* Row of a name in a class; -1. */
ptrdiff_t names_row(interp *in, const name_class *c, const char *name);

/* The class that knows this name, and its row; NULL. Free classes are left out. */
const name_class *names_owner(interp *in, const char *name, ptrdiff_t *row);

/* Whether a check should not report this name as missing: its definition failed, or may stand in a restart file. */
bool names_is_doubtful(const interp *in, const char *name);
void names_doubt(interp *in, const char *name);

/* Whether name may be defined in class c (NULL: as a variable); an error says what it is already. */
int names_check_new(interp *in, const name_class *c, const char *name, diag *d);

/* An error about a name that expressions do not know, with what may have been meant. */
int names_refuse_value(interp *in, const char *name, diag *d);

/* An error about a name that class c does not know. */
int names_refuse(interp *in, const name_class *c, const char *name, diag *d);

/* Names to suggest from. */
enum { NAMES_MAX = 512 };
typedef struct name_list {
    const char *list[NAMES_MAX];
    size_t n;
} name_list;

void names_add(name_list *l, const char *name);

/* The name nearest to what was typed; NULL when none is near. */
const char *names_nearest(const name_list *l, const char *typed);

/* Adds help to an error: "did you mean 'x'?", else the choices when there are at most 12. what: "species". */
void names_suggest(const name_list *l, const char *typed, const char *what, diag *d);

/* Everything an expression may name. */
void names_of_values(interp *in, name_list *l);

#endif

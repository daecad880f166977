/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Variables: texts (`default`, `string`, `getenv`, loops, -var), formulas (`equal`) and lists. */
#ifndef SARCINA_SCRIPT_VARIABLES_H
#define SARCINA_SCRIPT_VARIABLES_H

#include "script/interp.h"
#include "script/reader.h"

typedef enum { VARIABLE_TEXT, VARIABLE_FORMULA, VARIABLE_LIST } variable_kind;

typedef struct variable {
    char *name; /* first: table_find looks it up */
    variable_kind kind;
    bool command_line; /* set by -var: nothing but a loop may change it */
    bool read;         /* something looked at it */
    bool unknown;      /* in a check: its text or list is not known */
    replacement note;  /* and what is known of it */
    char *text;        /* VARIABLE_TEXT; of a formula: as written */
    expr *formula;
    char **list;
    size_t count, capacity;
} variable;

typedef struct variables {
    variable *list;
    size_t count, capacity;
} variables;

void variables_free(variables *v);

/* The variable, or NULL. It moves when another is added. */
variable *variables_find(variables *v, const char *name);

/* The variable, made when there is none; whatever it held is dropped. */
variable *variables_reset(variables *v, const char *name, variable_kind kind);
void variables_set_text(variables *v, const char *name, const char *text);
void variables_append(variable *v, const char *text);
void variables_set_formula(variables *v, const char *name, expr *formula);

/* The interpreter's own. */
variables *variables_of(interp *in);

/* Adds the value an expression has now to a list. */
int variables_append_value(interp *in, const char *name, expr *e, diag *d);
void variables_remove(variables *v, const char *name);

/* A copy of all of them (formulas shared). */
void variables_copy(variables *to, const variables *from);

/* The text $ puts in place of the variable; the caller frees. *note says what a check does not know. Errors: no such
 * variable (with what may have been meant), a formula that has no one value. */
int variables_expand(interp *in, const char *name, char **text, replacement *note, diag *d);

#endif

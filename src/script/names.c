/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "script/names.h"

#include "analysis/value.h"
#include "base/alloc.h"
#include "base/table.h"
#include "script/function.h"
#include "script/reduction.h"
#include "script/signature.h"
#include "script/state.h"

#include <ctype.h>
#include <stdio.h>
#include <string.h>

/* Words no name may take. */
static const char *const reserved[] = {"all",    "now",  "off", "where", "vs",  "file", "every", "until",
                                       "approx", "then", "yes", "no",    "INF", "pi",   "here"};

const name_class *names_class(const interp *in, const char *name) {
    const command_table *t = in->host->commands;
    for (size_t i = 0; i < t->nclasses; i++)
        if (strcmp(t->classes[i]->name, name) == 0)
            return t->classes[i];
    return NULL;
}

ptrdiff_t names_row(interp *in, const name_class *c, const char *name) {
    size_t n = c->count(in);
    for (size_t i = 0; i < n; i++)
        if (strcmp(c->get(in, i), name) == 0)
            return (ptrdiff_t)i;
    return -1;
}

const name_class *names_owner(interp *in, const char *name, ptrdiff_t *row) {
    const command_table *t = in->host->commands;
    for (size_t i = 0; i < t->nclasses; i++)
        if (!t->classes[i]->free && (*row = names_row(in, t->classes[i], name)) >= 0)
            return t->classes[i];
    return NULL;
}

bool names_is_doubtful(const interp *in, const char *name) {
    if (!in->check.on)
        return false;
    for (size_t i = 0; i < in->check.ndoubtful; i++)
        if (strcmp(in->check.doubtful[i], name) == 0)
            return true;
    return in->check.open_world;
}

void names_doubt(interp *in, const char *name) {
    checking *c = &in->check;
    c->doubtful = alloc_grow(c->doubtful, &c->doubtful_capacity, c->ndoubtful + 1, sizeof *c->doubtful);
    c->doubtful[c->ndoubtful++] = alloc_copy(name);
}

/* ---- new names ---- */

static bool is_reserved(const char *name) {
    for (size_t i = 0; i < TABLE_COUNT(reserved); i++)
        if (strcmp(reserved[i], name) == 0)
            return true;
    return function_find(name) || reduction_find(name);
}

static int check_form(const char *name, diag *d) {
    size_t n = strlen(name);
    for (size_t i = 0; i < n; i++)
        if (!isalnum((unsigned char)name[i]) && name[i] != '_')
            return diag_error(d, "a name is letters, digits and _, not '%s'", name);
    if (n == 0 || n > 60)
        return diag_error(d, "a name has 1 to 60 characters");
    if (isdigit((unsigned char)name[0]))
        return diag_error(d, "a name begins with a letter: use a%s", name);
    return SARCINA_OK;
}

int names_check_new(interp *in, const name_class *c, const char *name, diag *d) {
    if (c && c->free)
        return SARCINA_OK;
    if (check_form(name, d) != SARCINA_OK)
        return SARCINA_ERROR;
    if (is_reserved(name))
        return diag_error(d, "'%s' is a word of the language", name);
    const value_style *s = value_find(name);
    if (s)
        return diag_error(d, "'%s' is a value of the %s already", name, s->scope == VALUE_CELL ? "cells" : "program");
    /* while a journal is replayed, variables are there already that came later */
    if (c && !in->replaying && variables_find(&in->variables, name))
        return diag_error(d, "'%s' is already a variable", name);
    ptrdiff_t row = c ? names_row(in, c, name) : -1;
    const name_class *owner = row >= 0 ? c : names_owner(in, name, &row);
    if (!owner || (owner == c && c->redefine))
        return SARCINA_OK;
    if (owner == c) {
        diag_error(d, "'%s' is already %s", name, owner->noun);
        return diag_help(d, "'off' in the place of its arguments removes it");
    }
    bool group_of_species = c && strcmp(c->name, "+group") == 0 && strcmp(owner->name, "species") == 0;
    return diag_error(d, "'%s' is already %s%s", name, owner->noun,
                      group_of_species ? "; a species is a group of its cells" : "");
}

/* ---- suggestions ---- */

void names_add(name_list *l, const char *name) {
    for (size_t i = 0; i < l->n; i++)
        if (strcmp(l->list[i], name) == 0)
            return;
    if (l->n < NAMES_MAX)
        l->list[l->n++] = name;
}

/* name_list holds pointers to names: records of one member. */
const char *names_nearest(const name_list *l, const char *typed) {
    return table_nearest(l->list, l->n, sizeof *l->list, typed);
}

void names_suggest(const name_list *l, const char *typed, const char *what, diag *d) {
    const char *near = typed ? names_nearest(l, typed) : NULL;
    if (near) {
        diag_help(d, "did you mean '%s'?", near);
        return;
    }
    if (l->n == 0 || l->n > 12)
        return;
    char text[900] = "";
    for (size_t i = 0, used = 0; i < l->n && used + 70 < sizeof text; i++)
        used += (size_t)snprintf(text + used, sizeof text - used, "%s%s", i ? ", " : "", l->list[i]);
    diag_help(d, "%s: %s", what, text);
}

void names_of_values(interp *in, name_list *l) {
    for (size_t i = 0; i < value_style_count; i++)
        names_add(l, value_styles[i].name);
    for (size_t i = 0; i < in->variables.count; i++)
        names_add(l, in->variables.list[i].name);
    const command_table *t = in->host->commands;
    for (size_t c = 0; c < t->nclasses; c++)
        for (size_t i = 0; !t->classes[c]->free && i < t->classes[c]->count(in); i++)
            names_add(l, t->classes[c]->get(in, i));
    names_add(l, "pi");
}

int names_refuse_value(interp *in, const char *name, diag *d) {
    name_list l = {0};
    names_of_values(in, &l);
    const char *near = names_nearest(&l, name);
    const function_style *f = function_find(name);
    const reduction_style *r = reduction_find(name);
    if (f || r)
        return diag_error(d, "'%s' is a function: %s", name, f ? f->signature : r->signature);
    if (strcmp(name, "PI") == 0)
        return diag_error(d, "no value 'PI'; the constant is pi");
    if (!units_is_name(in->host->units, name)) {
        diag_error(d, "no value '%s'", name);
        if (near)
            diag_help(d, "did you mean '%s'?", near);
        return SARCINA_ERROR;
    }
    diag_error(d, "no value '%s'; a unit stands on a number: 1%s", name, name);
    return diag_help(d, "1.23/%s is 1.23/1%s in an expression", name, name);
}

int names_refuse(interp *in, const name_class *c, const char *name, diag *d) {
    name_list l = {0};
    for (size_t i = 0; i < c->count(in); i++)
        names_add(&l, c->get(in, i));
    diag_error(d, "no %s '%s'", c->name, name);
    names_suggest(&l, name, "there are", d);
    return SARCINA_ERROR;
}

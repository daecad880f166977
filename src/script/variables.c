/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "script/variables.h"

#include "analysis/value.h"
#include "base/alloc.h"
#include "base/table.h"
#include "script/names.h"
#include "script/state.h"

#include <ctype.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

static void drop(variable *v) {
    free(v->text);
    expr_free(v->formula);
    for (size_t i = 0; i < v->count; i++)
        free(v->list[i]);
    free(v->list);
    v->text = NULL;
    v->formula = NULL;
    v->list = NULL;
    v->count = v->capacity = 0;
    v->unknown = false;
}

void variables_free(variables *v) {
    for (size_t i = 0; i < v->count; i++) {
        drop(&v->list[i]);
        free(v->list[i].name);
    }
    free(v->list);
    *v = (variables){0};
}

variable *variables_find(variables *v, const char *name) {
    ptrdiff_t i = table_find(v->list, v->count, sizeof *v->list, name);
    return i < 0 ? NULL : &v->list[i];
}

variable *variables_reset(variables *v, const char *name, variable_kind kind) {
    variable *var = variables_find(v, name);
    if (!var) {
        v->list = alloc_grow(v->list, &v->capacity, v->count + 1, sizeof *v->list);
        var = &v->list[v->count++];
        *var = (variable){.name = alloc_copy(name)};
    }
    drop(var);
    var->kind = kind;
    return var;
}

void variables_set_text(variables *v, const char *name, const char *text) {
    char *copy = alloc_copy(text); /* it may be the old text */
    variables_reset(v, name, VARIABLE_TEXT)->text = copy;
}

void variables_append(variable *v, const char *text) {
    v->list = alloc_grow(v->list, &v->capacity, v->count + 1, sizeof *v->list);
    v->list[v->count++] = alloc_copy(text);
}

void variables_set_formula(variables *v, const char *name, expr *formula) {
    expr_keep(formula);
    variable *var = variables_reset(v, name, VARIABLE_FORMULA);
    var->formula = formula;
    var->text = alloc_copy(expr_text(formula));
}

variables *variables_of(interp *in) {
    return &in->variables;
}

int variables_append_value(interp *in, const char *name, expr *e, diag *d) {
    replacement note;
    char *text = expr_print(in, e, NULL, &note, d);
    variable *v = variables_find(&in->variables, name);
    if (text && v && note.unknown)
        v->unknown = true;
    else if (text && v)
        variables_append(v, text);
    int status = text ? SARCINA_OK : SARCINA_ERROR;
    free(text);
    return status;
}

void variables_remove(variables *v, const char *name) {
    variable *var = variables_find(v, name);
    if (!var)
        return;
    drop(var);
    free(var->name);
    size_t row = (size_t)(var - v->list);
    memmove(var, var + 1, (--v->count - row) * sizeof *var);
}

void variables_copy(variables *to, const variables *from) {
    for (size_t i = 0; i < from->count; i++) {
        const variable *old = &from->list[i];
        variable *copy = variables_reset(to, old->name, old->kind);
        copy->command_line = old->command_line;
        copy->unknown = old->unknown;
        copy->note = old->note;
        copy->text = old->text ? alloc_copy(old->text) : NULL;
        copy->formula = expr_keep(old->formula);
        for (size_t k = 0; k < old->count; k++)
            variables_append(copy, old->list[k]);
    }
}

/* ---- as text ---- */

static int no_variable(interp *in, const char *name, diag *d) {
    name_list l = {0};
    for (size_t i = 0; i < in->variables.count; i++)
        names_add(&l, in->variables.list[i].name); /* NOLINT: a NULL list has count 0 */
    ptrdiff_t row;
    if (value_find(name) || names_owner(in, name, &row)) {
        diag_error(d, "no variable '%s'; it is a value: write $(%s)", name, name);
        return SARCINA_ERROR;
    }
    diag_error(d, "no variable '%s'", name);
    names_suggest(&l, name, "variables", d);
    return SARCINA_ERROR;
}

/* The elements with blanks between. */
static char *join(const variable *v) {
    size_t n = 1;
    for (size_t i = 0; i < v->count; i++)
        n += strlen(v->list[i]) + 1;
    char *text = alloc_zeroed(n, 1), *end = text;
    for (size_t i = 0; i < v->count; i++) {
        if (i)
            *end++ = ' ';
        end = stpcpy(end, v->list[i]);
    }
    return text;
}

int variables_expand(interp *in, const char *name, char **text, replacement *note, diag *d) {
    *note = (replacement){0};
    if (strcmp(name, "here") == 0) {
        const char *here = interp_here(in);
        *text = alloc_copy(*here ? here : ".");
        return SARCINA_OK;
    }
    variable *v = variables_find(&in->variables, name);
    if (!v && names_is_doubtful(in, name)) {
        *note = (replacement){.unknown = true, .wild = true};
        *text = alloc_copy("");
        return SARCINA_OK;
    }
    if (!v)
        return no_variable(in, name, d);
    v->read = true;
    if (v->kind == VARIABLE_FORMULA) {
        expr *formula = expr_keep(v->formula);
        *text = expr_print(in, formula, NULL, note, d);
        expr_free(formula);
        return *text ? SARCINA_OK : SARCINA_ERROR;
    }
    if (v->unknown)
        *note = v->note;
    note->unknown = v->unknown;
    *text = v->kind == VARIABLE_LIST ? join(v) : alloc_copy(v->text);
    return SARCINA_OK;
}

/* ---- save and load ---- */

/* A text as one line: control characters, % and blanks as %XX. */
static void encode(const char *text, char **out, size_t *n, size_t *capacity) {
    for (; *text; text++) {
        unsigned char c = (unsigned char)*text;
        *out = alloc_grow(*out, capacity, *n + 4, 1);
        if (c > ' ' && c != '%')
            (*out)[(*n)++] = (char)c;
        else
            *n += (size_t)sprintf(*out + *n, "%%%02X", c);
    }
}

static void put(const char *text, char **out, size_t *n, size_t *capacity) {
    size_t length = strlen(text);
    *out = alloc_grow(*out, capacity, *n + length + 1, 1);
    memcpy(*out + *n, text, length + 1);
    *n += length;
}

static char *decode(const char *text, size_t n) {
    char *out = alloc_zeroed(n + 1, 1), *end = out;
    for (size_t i = 0; i < n; i++) {
        unsigned code;
        if (text[i] == '%' && i + 2 < n && sscanf(text + i + 1, "%2x", &code) == 1) {
            *end++ = (char)code;
            i += 2;
        } else {
            *end++ = text[i];
        }
    }
    return out;
}

char *interp_variables_save(const interp *in) {
    char *out = NULL;
    size_t n = 0, capacity = 0;
    char *draws = alloc_format("draws %llu\n", (unsigned long long)in->draws);
    put(draws, &out, &n, &capacity);
    free(draws);
    for (size_t i = 0; i < in->variables.count; i++) {
        const variable *v = &in->variables.list[i];
        static const char *const kinds[] = {"text ", "formula ", "list "};
        put(kinds[v->kind], &out, &n, &capacity);
        put(v->name, &out, &n, &capacity);
        if (v->text) {
            put(" =", &out, &n, &capacity);
            encode(v->text, &out, &n, &capacity);
        }
        for (size_t k = 0; k < v->count; k++) {
            put(" =", &out, &n, &capacity);
            encode(v->list[k], &out, &n, &capacity);
        }
        put("\n", &out, &n, &capacity);
    }
    return out;
}

char *interp_variables_list(const interp *in) {
    char *out = NULL;
    size_t n = 0, capacity = 0;
    put("", &out, &n, &capacity);
    for (size_t i = 0; i < in->variables.count; i++) {
        const variable *v = &in->variables.list[i];
        put(v->name, &out, &n, &capacity);
        put(v->kind == VARIABLE_FORMULA ? " equal " : v->kind == VARIABLE_LIST ? " list" : " = ", &out, &n, &capacity);
        put(v->text ? v->text : "", &out, &n, &capacity);
        for (size_t k = 0; k < v->count; k++) {
            put(" ", &out, &n, &capacity);
            put(v->list[k], &out, &n, &capacity);
        }
        put("\n", &out, &n, &capacity);
    }
    return out;
}

/* Sets one variable from the words behind its kind. */
static int load_line(interp *in, variable_kind kind, char *words, diag *d) {
    char *save, *name = strtok_r(words, " ", &save), *item;
    if (!name)
        return diag_error(d, "the restart file's variables are damaged");
    variable *old = variables_find(&in->variables, name);
    if (old && old->command_line)
        return SARCINA_OK;
    variable *v = variables_reset(&in->variables, name, kind);
    while ((item = strtok_r(NULL, " ", &save))) {
        char *text = decode(item + 1, strlen(item + 1));
        if (kind == VARIABLE_LIST)
            variables_append(v, text);
        else
            v->text = alloc_copy(text);
        free(text);
    }
    if (kind != VARIABLE_LIST && !v->text)
        v->text = alloc_copy("");
    if (kind != VARIABLE_FORMULA)
        return SARCINA_OK;
    v->formula = expr_of_text(in, v->text, d);
    return v->formula ? SARCINA_OK : SARCINA_ERROR;
}

int interp_variables_load(interp *in, const char *text, diag *d) {
    char *copy = alloc_copy(text), *save, *line = strtok_r(copy, "\n", &save);
    int status = SARCINA_OK;
    for (; line && !status; line = strtok_r(NULL, "\n", &save)) {
        if (strncmp(line, "draws ", 6) == 0)
            in->draws = strtoull(line + 6, NULL, 10);
        else if (strncmp(line, "text ", 5) == 0)
            status = load_line(in, VARIABLE_TEXT, line + 5, d);
        else if (strncmp(line, "formula ", 8) == 0)
            status = load_line(in, VARIABLE_FORMULA, line + 8, d);
        else if (strncmp(line, "list ", 5) == 0)
            status = load_line(in, VARIABLE_LIST, line + 5, d);
        else
            status = diag_error(d, "the restart file's variables are damaged");
    }
    free(copy);
    return status;
}

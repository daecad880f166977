/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Candidates in expressions, and in what $ begins. */
#include "script/complete_part.h"

#include "analysis/value.h"
#include "base/alloc.h"
#include "base/number.h"
#include "base/table.h"
#include "script/function.h"
#include "script/line.h"
#include "script/reduction.h"
#include "script/state.h"

#include <ctype.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

/* What the expression up to the cursor is in. */
typedef struct context {
    size_t depth;     /* parentheses */
    size_t quote;     /* where an open quote begins + 1; 0: in none */
    size_t name, end; /* the function whose parenthesis opened last: [name, end) */
} context;

static bool is_name(char c) {
    return isalnum((unsigned char)c) || c == '_';
}

static context look(const char *text, size_t from) {
    context x = {0};
    for (size_t i = from; text[i]; i++) {
        if (x.quote) {
            x.quote = text[i] == text[x.quote - 1] ? 0 : x.quote;
        } else if (line_quote(text, from, i)) {
            x.quote = i + 1;
        } else if (text[i] == '(') {
            x.depth++;
            x.end = x.name = i;
            while (x.name > from && is_name(text[x.name - 1]))
                x.name--;
        } else if (text[i] == ')' && x.depth) {
            x.depth--;
        }
    }
    return x;
}

/* ---- names ------------------------------------------------------------------------------------------------------- */

static void offer_values(completing *c, bool per_cell) {
    for (size_t i = 0; i < value_style_count; i++)
        if (per_cell || value_styles[i].scope != VALUE_CELL)
            complete_part_offer(c, value_styles[i].name, true);
    for (size_t i = 0; i < c->in->variables.count; i++)
        complete_part_offer(c, c->in->variables.list[i].name, true);
    const command_table *t = c->in->host->commands;
    for (size_t k = 0; k < t->nclasses; k++) {
        const name_class *of = t->classes[k];
        bool fits = of->value || (of->members && per_cell);
        for (size_t i = 0; fits && i < of->count(c->in); i++)
            complete_part_offer(c, of->get(c->in, i), true);
    }
    complete_part_offer(c, "pi", true);
}

static void offer_function(completing *c, const char *name) {
    char *call = alloc_format("%s(", name);
    complete_part_offer(c, call, true);
    free(call);
}

static void offer_functions(completing *c) {
    for (size_t i = 0; i < function_style_count; i++)
        offer_function(c, function_styles[i].name);
    for (size_t i = 0; i < reduction_style_count; i++)
        offer_function(c, reduction_styles[i].name);
}

static void offer_field(completing *c, const char *of, const char *field) {
    char *name = alloc_format("%s.%s", of, field);
    complete_part_offer(c, name, true);
    free(name);
}

/* Fields of a value; of a name that commands own, those of all values that it answers to. */
static void offer_fields(completing *c, const char *of) {
    static const char *const more[] = {"step", "time", "kept"};
    const value_style *own = value_find(of);
    ptrdiff_t row = -1;
    const name_class *class = own ? NULL : names_owner(c->in, of, &row);
    bool asks = class && class->value;
    dim d;
    for (size_t i = 0; (own || asks) && i < value_style_count; i++)
        for (size_t k = 0; k < value_field_count(&value_styles[i]); k++) {
            char field[32];
            value_field(&value_styles[i], k, field, &d);
            if (own == &value_styles[i] || (asks && !class->value(c->in, (size_t)row, field, NAN, &d, NULL, NULL)))
                offer_field(c, of, field);
        }
    for (size_t i = 0; asks && i < TABLE_COUNT(more); i++)
        if (!class->value(c->in, (size_t)row, more[i], NAN, &d, NULL, NULL))
            offer_field(c, of, more[i]);
}

/* ---- the last word of an expression ------------------------------------------------------------------------------ */

/* A number: the units that are one factor, as expressions take them. */
static void offer_unit(completing *c) {
    static const char *const kinds[] = {"length", "time", "mass", "force", "energy", "angle", "area", "volume"};
    const char *typed = c->text + c->from, *suffix[32];
    size_t digits = number_length(typed, strlen(typed), true);
    for (size_t k = 0; digits && k < TABLE_COUNT(kinds); k++) {
        dim d = DIM_NONE;
        dim_by_name(kinds[k], &d);
        size_t n = units_usual(d, suffix, TABLE_COUNT(suffix));
        for (size_t i = 0; i < n; i++) {
            char *number = alloc_format("%.*s%s", (int)digits, typed, suffix[i]);
            if (!strpbrk(suffix[i], "./"))
                complete_part_offer(c, number, true);
            free(number);
        }
    }
}

/* In a quote: the argument of is_file or defined. */
static void offer_quoted(completing *c, const context *x) {
    size_t n = x->end - x->name;
    c->from = x->quote;
    c->quote = c->text[x->quote - 1];
    if (n == 7 && strncmp(c->text + x->name, "is_file", n) == 0)
        complete_part_file(c);
    if (n == 7 && strncmp(c->text + x->name, "defined", n) == 0)
        for (size_t i = 0; i < c->in->variables.count; i++)
            complete_part_offer(c, c->in->variables.list[i].name, true);
}

/* Whether an operand stands before the blanks before `at`. */
static bool follows_operand(const char *text, size_t from, size_t at) {
    size_t i = at;
    while (i > from && line_is_blank(text[i - 1]))
        i--;
    return i < at && i > from && (is_name(text[i - 1]) || strchr(")]\"'.", text[i - 1]));
}

void complete_part_expression(completing *c, bool per_cell) {
    size_t from = c->from, at = strlen(c->text);
    context x = look(c->text, from);
    if (x.quote) {
        offer_quoted(c, &x);
        return;
    }
    while (at > from && (is_name(c->text[at - 1]) || c->text[at - 1] == '.'))
        at--;
    c->from = at;
    const char *typed = c->text + at, *point = strchr(typed, '.');
    if (follows_operand(c->text, from, at)) {
        if (x.depth)
            complete_part_offer(c, "where", false);
    } else if (isdigit((unsigned char)*typed) || *typed == '.') {
        offer_unit(c);
    } else if (point) {
        char *of = alloc_copy_n(typed, (size_t)(point - typed));
        offer_fields(c, of);
        free(of);
    } else {
        offer_values(c, per_cell || x.depth);
        offer_functions(c);
    }
}

/* ---- $ ----------------------------------------------------------------------------------------------------------- */

/* Behind what $( or ${ at i begins; 0: it is open at the cursor. */
static size_t behind_dollar(const char *text, size_t i) {
    size_t depth = 0;
    for (size_t k = i + 1; text[k]; k++) {
        depth += text[k] == '(' || text[k] == '{';
        depth -= (text[k] == ')' || text[k] == '}') && depth;
        if (depth == 0)
            return k + 1;
    }
    return 0;
}

static void offer_variables(completing *c) {
    for (size_t i = 0; i <= c->in->variables.count; i++) {
        bool last = i == c->in->variables.count;
        char *name = alloc_format("${%s}", last ? "here" : c->in->variables.list[i].name);
        complete_part_offer(c, name, true);
        free(name);
    }
}

bool complete_part_dollar(completing *c) {
    const char *text = c->text;
    size_t open = (size_t)-1;
    for (size_t i = c->from; text[i] && open == (size_t)-1; i++) {
        if (text[i] != '$')
            continue;
        size_t end = text[i + 1] == '$' ? i + 2 : strchr("({", text[i + 1]) ? behind_dollar(text, i) : i + 2;
        if (!end)
            open = i;
        else
            i = end - 1;
        if (text[i] == '\0')
            break;
    }
    if (open == (size_t)-1)
        return false;
    c->from = open;
    if (text[open + 1] != '(') {
        offer_variables(c);
        return true;
    }
    c->from = open + 2;
    complete_part_expression(c, false);
    return true;
}

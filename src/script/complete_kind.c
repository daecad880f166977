/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Candidates by the kind of an argument. */
#include "script/complete_part.h"

#include "analysis/value.h"
#include "base/alloc.h"
#include "base/color_code.h"
#include "base/number.h"
#include "base/table.h"
#include "script/function.h"
#include "script/reduction.h"
#include "script/state.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

enum { UNITS_MAX = 64 };

static void offer_all(completing *c, const char *const *words, size_t n) {
    for (size_t i = 0; i < n; i++)
        complete_part_offer(c, words[i], false);
}

/* ---- numbers ----------------------------------------------------------------------------------------------------- */

/* The number that is typed, with each unit of a dimension behind it. */
static void offer_units(completing *c, dim d) {
    const char *typed = c->text + c->from, *suffix[UNITS_MAX];
    size_t digits = number_length(typed, strlen(typed), true), n = units_usual(d, suffix, UNITS_MAX);
    for (size_t i = 0; digits && i < n; i++) {
        char *number = alloc_format("%.*s%s", (int)digits, typed, suffix[i]);
        complete_part_offer(c, number, false);
        free(number);
    }
}

static void offer_percent(completing *c) {
    const char *typed = c->text + c->from;
    size_t digits = number_length(typed, strlen(typed), true);
    char *number = alloc_format("%.*s%%", (int)digits, typed);
    if (digits)
        complete_part_offer(c, number, false);
    free(number);
}

/* Of a record: where nothing is typed yet, its default. */
void complete_part_number(completing *c, const slot *s) {
    bool number = s->initial && number_length(s->initial, strlen(s->initial), true) && !strchr(s->initial, ',');
    if (number)
        complete_part_offer(c, s->initial, false);
    bool angle = strcmp(s->kind_name, "angle") == 0;
    if (angle || !dim_is_none(s->d))
        offer_units(c, s->d);
    if (s->percent)
        offer_percent(c);
}

static void offer_quantity(completing *c) {
    static const char *const kinds[] = {"length", "time", "mass", "rate", "velocity", "force", "energy", "angle"};
    for (size_t i = 0; i < TABLE_COUNT(kinds); i++) {
        dim d;
        dim_by_name(kinds[i], &d);
        offer_units(c, d);
    }
}

static void offer_spread(completing *c, const slot *s, size_t part) {
    static const char *const laws[] = {"uniform", "normal", "lognormal"};
    if (part == COMPLETE_SD) {
        complete_part_offer(c, "sd", false);
        return;
    }
    complete_part_number(c, s);
    if (part == 0)
        offer_all(c, laws, TABLE_COUNT(laws));
    else
        offer_percent(c);
}

static void offer_relaxation(completing *c, size_t part) {
    if (part == 0)
        complete_part_offer(c, "to", false);
    if (part == 2)
        complete_part_offer(c, "within", false);
    else
        offer_units(c, part == 1 ? DIM_FORCE : DIM_TIME);
}

/* ---- names ------------------------------------------------------------------------------------------------------- */

static void offer_class(completing *c, const slot *s) {
    interp *in = c->in;
    if (strcmp(s->kind_name, "variable") == 0) {
        for (size_t i = 0; i < in->variables.count; i++)
            complete_part_offer(c, in->variables.list[i].name, false);
        return;
    }
    const name_class *of = names_class(in, s->kind_name);
    for (size_t i = 0; of && i < of->count(in); i++)
        complete_part_offer(c, of->get(in, i), false);
    if (s->star)
        complete_part_offer(c, "*", false);
}

/* A name that is defined here: those that stand, where a command may amend them. */
static void offer_new(completing *c, const slot *s) {
    const name_class *of = names_class(c->in, s->kind_name);
    if (!of || of->redefine)
        offer_class(c, s);
}

static void offer_analyses(completing *c) {
    for (size_t i = 0; i < value_style_count; i++)
        if (value_styles[i].scope == VALUE_ANALYSIS)
            complete_part_offer(c, value_styles[i].name, false);
}

static void offer_colors(completing *c) {
    complete_part_offer(c, "auto", false);
    for (size_t i = 0; color_code_name(i); i++)
        complete_part_offer(c, color_code_name(i), false);
}

/* ---- the kinds --------------------------------------------------------------------------------------------------- */

static void offer_cellcolor(completing *c) {
    size_t from = c->from;
    complete_part_expression(c, true);
    if (c->from == from)
        offer_colors(c);
}

/* Kinds of which one word is like another. */
static void offer_word(completing *c, const slot *s) {
    static const char *const flags[] = {"yes", "no"}, *const infinite[] = {"INF", "-INF"};
    switch (s->kind) {
    case SLOT_BOUND:
        offer_all(c, infinite, 2);
        complete_part_number(c, s);
        return;
    case SLOT_NUMBER:
    case SLOT_LENGTH3:
        complete_part_number(c, s);
        return;
    case SLOT_CYCLES:
        offer_units(c, DIM_TIME);
        return;
    case SLOT_QUANTITY:
    case SLOT_RANGE2:
        offer_quantity(c);
        return;
    case SLOT_FLAG:
        offer_all(c, flags, 2);
        return;
    case SLOT_CHOICE:
        offer_all(c, (const char *const *)s->choices, s->nchoices);
        return;
    case SLOT_NEW:
        offer_new(c, s);
        return;
    case SLOT_NAME:
        offer_class(c, s);
        return;
    case SLOT_ANALYSIS:
        offer_analyses(c);
        return;
    case SLOT_COLOR:
        offer_colors(c);
        return;
    default:
        return;
    }
}

void complete_part_argument(completing *c, const slot *s, size_t part) {
    static const char *const directions[] = {"x", "y", "z", "xy", "random"};
    static const char *const views[] = {"top", "side", "front", "iso"};
    if (s->spread) {
        offer_spread(c, s, part);
        return;
    }
    switch (s->kind) {
    case SLOT_RELAXATION:
        offer_relaxation(c, part);
        return;
    case SLOT_ORIENT:
        offer_all(c, directions, part ? 0 : TABLE_COUNT(directions));
        return;
    case SLOT_VIEW:
        offer_all(c, views, part ? 0 : TABLE_COUNT(views));
        offer_units(c, DIM_NONE);
        return;
    case SLOT_FILEOFF:
        complete_part_offer(c, "off", false);
        complete_part_file(c);
        return;
    case SLOT_FILE:
    case SLOT_REST:
        complete_part_file(c);
        return;
    case SLOT_COMMAND:
    case SLOT_EVERY:
        if (s->kind == SLOT_EVERY && part == 0)
            offer_units(c, DIM_TIME);
        else if (c->quote)
            complete_part_text(c);
        return;
    case SLOT_EXPR:
    case SLOT_CELLEXPR:
    case SLOT_FORMULA:
        if (part == 0)
            complete_part_expression(c, s->kind != SLOT_EXPR);
        return;
    case SLOT_VALUE:
    case SLOT_CELL:
        complete_part_expression(c, s->kind == SLOT_CELL);
        return;
    case SLOT_CELLCOLOR:
        offer_cellcolor(c);
        return;
    case SLOT_COLUMNFORMAT:
        if (part == 0)
            complete_part_expression(c, false);
        return;
    default:
        offer_word(c, s);
    }
}

/* ---- topics of help ---------------------------------------------------------------------------------------------- */

static void offer_topics(completing *c) {
    complete_part_commands(c);
    for (size_t i = 0; i < value_style_count; i++)
        complete_part_offer(c, value_styles[i].name, false);
    for (size_t i = 0; i < function_style_count; i++)
        complete_part_offer(c, function_styles[i].name, false);
    for (size_t i = 0; i < reduction_style_count; i++)
        complete_part_offer(c, reduction_styles[i].name, false);
    complete_part_offer(c, "values", false);
    complete_part_offer(c, "functions", false);
}

/* help COMMAND WORD: the words of its forms. */
void complete_part_topics(completing *c, const complete_words *w) {
    if (strcmp(w->list[0], "help") != 0 && *w->list[0] != '?')
        return;
    if (w->n == 1)
        offer_topics(c);
    const command_table *t = c->in->host->commands;
    for (size_t i = 0; w->n > 1 && i < t->count; i++)
        for (size_t k = 1; strcmp(t->list[i].head[0].name, w->list[1]) == 0 && k < t->list[i].nhead; k++)
            if (t->list[i].head[k].kind == SLOT_LITERAL)
                complete_part_offer(c, t->list[i].head[k].name, false);
}

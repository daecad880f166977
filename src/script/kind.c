/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "script/kind.h"

#include "base/table.h"

#include <stdlib.h>
#include <string.h>

static const struct {
    slot_kind kind;
    const char *text;
} texts[] = {
    {SLOT_INT, "a whole number"},
    {SLOT_FLAG, "yes or no"},
    {SLOT_NOTHING, "stands alone"},
    {SLOT_WORD, "a word"},
    {SLOT_TEXT, "one word, or one quoted text"},
    {SLOT_FILE, "a file"},
    {SLOT_FILEOFF, "a file, or off"},
    {SLOT_REST, "the rest of the line"},
    {SLOT_ANALYSIS, "an analysis that takes no arguments"},
    {SLOT_EXPR, "an expression"},
    {SLOT_CELLEXPR, "an expression, judged for each cell"},
    {SLOT_VALUE, "an expression of one word"},
    {SLOT_CELL, "an expression of one word, with a value for each cell"},
    {SLOT_FORMULA, "an expression, to the end of the line"},
    {SLOT_COMMAND, "a quoted command"},
    {SLOT_EVERY, "cycles or a time, then one quoted command or more; it may be repeated"},
    {SLOT_CYCLES, "a number of cycles, or a time"},
    {SLOT_RELAXATION, "a time; or: to FORCE [within TIME]"},
    {SLOT_ORIENT, "x, y, z, xy, random, or three numbers"},
    {SLOT_BOUND, "a length, INF or -INF"},
    {SLOT_LENGTH3, "three lengths"},
    {SLOT_SIZE, "two whole numbers"},
    {SLOT_VIEW, "top, side, front, iso, or two angles"},
    {SLOT_RANGE2, "two numbers"},
    {SLOT_QUANTITY, "a number of any dimension"},
    {SLOT_COLOR, "a colour"},
    {SLOT_CELLCOLOR, "a colour, or an expression of one word with a value for each cell"},
    {SLOT_COLUMNFORMAT, "a column's heading, and a format such as %.3f"},
    {SLOT_WORDS, "any number of words"},
};

static void put_number(page *p, const slot *s) {
    const char *usual[2];
    bool pure = dim_is_none(s->d) && strcmp(s->kind_name, "angle") != 0;
    size_t n = pure ? 0 : units_usual(s->d, usual, TABLE_COUNT(usual));
    page_put(p, "%s", strcmp(s->kind_name, "number") == 0 ? "pure number" : s->kind_name);
    for (size_t i = 0; i < n; i++)
        page_put(p, "%s%s%s", i ? ", " : " (", usual[i], i + 1 < n ? "" : ")");
    if (s->percent)
        page_put(p, ", or a percentage");
    if (s->spread)
        page_put(p, ", or a distribution");
}

static void put_class(page *p, const command_table *t, const slot *s) {
    const char *noun = s->kind_name;
    for (size_t i = 0; i < t->nclasses; i++)
        if (strcmp(t->classes[i]->name, s->kind_name) == 0)
            noun = t->classes[i]->noun;
    if (s->kind == SLOT_NEW)
        page_put(p, "a name");
    else
        page_put(p, "the name of %s%s", noun, s->star ? ", or * for all" : "");
}

void kind_put(page *p, const command_table *t, const slot *s) {
    if (s->nchoices) {
        for (size_t i = 0; i < s->nchoices; i++)
            page_put(p, "%s%s", i == 0 ? "one of " : i + 1 < s->nchoices ? ", " : " or ", s->choices[i]);
        return;
    }
    if (s->kind == SLOT_NUMBER)
        put_number(p, s);
    else if (s->kind == SLOT_NEW || s->kind == SLOT_NAME)
        put_class(p, t, s);
    for (size_t i = 0; i < TABLE_COUNT(texts); i++)
        if (texts[i].kind == s->kind)
            page_put(p, "%s", texts[i].text);
    if (s->many && s->kind != SLOT_WORDS)
        page_put(p, "; %s", s->optional ? "any number of them" : "one or more");
}

int kind_is_obvious(const slot *s) {
    switch (s->kind) {
    case SLOT_NEW:
    case SLOT_FILE:
    case SLOT_FILEOFF:
    case SLOT_VIEW:
    case SLOT_ORIENT:
    case SLOT_COLOR:
    case SLOT_CELLCOLOR:
    case SLOT_CYCLES:
    case SLOT_RELAXATION:
        return s->summary != NULL;
    default:
        return 0;
    }
}

int kind_put_range(page *p, const slot *s) {
    if (s->lo_text)
        page_put(p, "%s %s", s->lo_open ? "more than" : "at least", s->lo_text);
    if (s->hi_text)
        page_put(p, "%s%s %s", s->lo_text ? ", " : "", s->hi_open ? "less than" : "at most", s->hi_text);
    return s->lo_text || s->hi_text;
}

void kind_explain(page *p, const command_table *t, const slot *s) {
    page kind = {0};
    page_sentence(p, s->summary);
    if (!kind_is_obvious(s))
        kind_put(&kind, t, s);
    if (kind.n && (s->lo_text || s->hi_text))
        page_put(&kind, ", ");
    kind_put_range(&kind, s);
    page_sentence(p, kind.chars);
    free(kind.chars);
    if (s->initial)
        page_put(p, " Default: %s.", s->initial);
    else if (s->required)
        page_put(p, " Required.");
    else if (s->group)
        page_put(p, " This, or another that can take its place, is required.");
}

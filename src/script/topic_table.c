/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The tables that topics of help show, row by row, from the tables of the program. */
#include "script/topic.h"

#include "analysis/value.h"
#include "base/color_code.h"
#include "base/table.h"
#include "base/units.h"
#include "mechanics/force_style.h"
#include "relax/integrator.h"
#include "relax/relax.h"
#include "script/control.h"
#include "script/function.h"
#include "script/reduction.h"

#include <string.h>

/* Dimensions that an argument may take, by the names errors use. */
bool topic_row_dimension(size_t i, page *name, page *text) {
    static const char *const pure[] = {"pure number", "number", "fraction"};
    dim d;
    const char *dimension;
    for (size_t row = 0; (dimension = dim_listed(row, &d)); row++) {
        bool has_unit = true;
        for (size_t k = 0; k < TABLE_COUNT(pure); k++)
            has_unit = has_unit && strcmp(dimension, pure[k]) != 0;
        if (has_unit && i-- == 0)
            break;
    }
    if (!dimension)
        return false;
    const char *usual[8];
    size_t n = units_usual(d, usual, TABLE_COUNT(usual));
    if (strcmp(dimension, "angle") != 0 && dim_is_none(d))
        n = 0;
    char suffix[48];
    page_put(name, "%s", dimension);
    if (n == 0)
        page_put(text, "%s", dim_suffix(d, suffix));
    for (size_t k = 0; k < n; k++)
        page_put(text, "%s%s", k ? ", " : "", usual[k]);
    return true;
}

static const char *const scopes[] = {"of each cell", "of the scene",
                                     "a measure of all cells; with analyze, of a group"};

bool topic_row_value(size_t i, page *name, page *text) {
    /* values of the scene first, then measures, then those of cells */
    static const value_scope order[] = {VALUE_STATE, VALUE_ANALYSIS, VALUE_CELL};
    const value_style *s = NULL;
    for (size_t k = 0; k < TABLE_COUNT(order) && !s; k++)
        for (size_t row = 0; row < value_style_count && !s; row++)
            if (value_styles[row].scope == order[k] && i-- == 0)
                s = &value_styles[row];
    if (!s)
        return false;
    page_put(name, "%s", s->name);
    page_put(text, "%s (%s, %s)", s->summary, s->dimension, scopes[s->scope]);
    for (size_t k = 0; k < value_field_count(s); k++) {
        char field[32], buffer[48];
        dim d;
        value_field(s, k, field, &d);
        page_put(text, "%s.%s (%s)", k ? ", " : "; ", field, dim_name(d, buffer));
    }
    return true;
}

bool topic_row_function(size_t i, page *name, page *text) {
    if (i >= function_style_count + reduction_style_count)
        return false;
    bool reduces = i >= function_style_count;
    const reduction_style *r = reduces ? &reduction_styles[i - function_style_count] : NULL;
    page_put(name, "%s", reduces ? r->signature : function_styles[i].signature);
    page_put(text, "%s", reduces ? r->summary : function_styles[i].summary);
    return true;
}

bool topic_row_block(size_t i, page *name, page *text) {
    if (i >= control_word_count)
        return false;
    page_put(name, "%s", control_words[i].name);
    page_put(text, "%s", control_words[i].summary);
    return true;
}

bool topic_row_color(size_t i, page *name, page *text) {
    uint32_t code;
    const char *color = color_code_name(i);
    if (!color || !color_code_read(color, &code))
        return false;
    page_put(name, "%s", color);
    page_put(text, "#%06x", (unsigned)code);
    return true;
}

bool topic_row_accuracy(size_t i, page *name, page *text) {
    if (i >= accuracy_preset_count)
        return false;
    page_put(name, "%s", accuracy_presets[i].name);
    page_put(text, "%s. Validated up to %zu cells: %s", accuracy_presets[i].summary, accuracy_presets[i].validated_to,
             accuracy_presets[i].validated);
    return true;
}

bool topic_row_trade(size_t i, page *name, page *text) {
    static const struct {
        const char *name, *text;
    } measured[] = {
#include "script/topic_trade.def"
    };
    if (i >= TABLE_COUNT(measured))
        return false;
    page_put(name, "%s", measured[i].name);
    page_put(text, "%s", measured[i].text);
    return true;
}

bool topic_row_integrator(size_t i, page *name, page *text) {
    if (i >= INTEGRATOR_COUNT)
        return false;
    const integrator_style *s = integrator_styles[i];
    page_put(name, "%s", s->name);
    if (s->caps & INTEGRATOR_MINIMISES)
        page_put(text, "%s; step from the stiffness of the scene and from the descent. Source: %s", s->summary,
                 s->source);
    else
        page_put(text, "%s; order %d, %s. Source: %s", s->summary, s->order,
                 s->caps & INTEGRATOR_ADAPTIVE ? "step by error control" : "step from the stiffness of the scene",
                 s->source);
    return true;
}

bool topic_row_method(size_t i, page *name, page *text) {
    static const struct {
        const char *name, *text;
    } measured[] = {
#include "script/topic_methods.def"
    };
    if (i >= TABLE_COUNT(measured))
        return false;
    page_put(name, "%s", measured[i].name);
    page_put(text, "%s", measured[i].text);
    return true;
}

bool topic_row_force(size_t i, page *name, page *text) {
    if (i >= FORCE_COUNT)
        return false;
    const force_style *s = force_styles[i];
    page_put(name, "%s", s->name);
    page_put(text, "%s: %s", s->summary, s->formula);
    return true;
}

bool topic_row_exit(size_t i, page *name, page *text) {
    static const struct {
        const char *code, *text;
    } codes[] = {
        {"0", "done"},
        {"1", "an error in the script or while it ran"},
        {"2", "a wrong command line"},
        {"3", "the mechanics could not go on: a numerical failure"},
        {"4", "an expect failed"},
        {"130", "interrupted (Ctrl-C)"},
        {"other", "what the script's own quit gives"},
    };
    if (i >= TABLE_COUNT(codes))
        return false;
    page_put(name, "%s", codes[i].code);
    page_put(text, "%s", codes[i].text);
    return true;
}

/* ---- examples ---- */

void topic_example_value(page *p, const struct value_style *s) {
    if (s->scope == VALUE_CELL) {
        page_put(p, s->text ? "print \"$(%s[1])\"" : "print \"$(mean(%s))\"", s->name);
        return;
    }
    page_put(p, "print \"$(%s)", s->name);
    for (size_t i = 0; i < value_field_count(s); i++) {
        char field[32];
        dim d;
        value_field(s, i, field, &d);
        page_put(p, " $(%s.%s)", s->name, field);
    }
    page_put(p, "\"");
}

void topic_example_function(page *p, const struct function_style *s) {
    static const struct {
        function_rule rule;
        const char *arguments;
    } special[] = {
        {FUNCTION_CHOICE, "cells > 1, 1um, 2um"},
        {FUNCTION_FILE, "'cells.csv'"},
        {FUNCTION_DEFINED, "'ecoli'"},
    };
    if (s->rule == FUNCTION_DESCENDS) {
        page_put(p, "print \"$(count(%s(1)))\"", s->name);
        return;
    }
    page_put(p, "print \"$(%s(", s->name);
    bool done = false;
    for (size_t i = 0; i < TABLE_COUNT(special) && !done; i++)
        if (special[i].rule == s->rule) {
            page_put(p, "%s", special[i].arguments);
            done = true;
        }
    for (int i = 0; i < s->least && !done; i++)
        page_put(p, "%s%s", i ? ", " : "", i ? "1" : "0.5");
    page_put(p, "))\"");
}

void topic_example_reduction(page *p, const struct reduction_style *s) {
    const char *arguments = s->rule == REDUCTION_COUNT || s->rule == REDUCTION_FRACTION ? "ecoli && z > 0"
                            : s->rule == REDUCTION_QUANTILE                             ? "0.5, length where z > 0"
                                                                                        : "length where z > 0";
    page_put(p, "print \"$(%s(%s))\"", s->name, arguments);
}

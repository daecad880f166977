/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The kinds of arguments: one reader each. */
#include "script/argument.h"

#include "analysis/value.h"
#include "base/alloc.h"
#include "base/color_code.h"
#include "base/table.h"
#include "script/format.h"
#include "script/line.h"
#include "script/names.h"
#include "script/state.h"
#include "script/text.h"

#include <assert.h>
#include <ctype.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

void argument_free(argument *v) {
    free(v->text);
    for (size_t i = 0; v->texts && i < v->n; i++)
        free(v->texts[i]);
    for (size_t i = 0; v->exprs && i < v->n; i++)
        expr_free(v->exprs[i]);
    for (size_t i = 0; i < v->nevery; i++) {
        for (size_t k = 0; k < v->every[i].n; k++)
            interp_free_text(v->every[i].commands[k]);
        free(v->every[i].commands);
    }
    free(v->texts);
    free(v->spans);
    free(v->exprs);
    free(v->every);
    interp_free_text(v->command);
    *v = (argument){0};
}

/* A kind as people call it. */
static const char *noun_of(const char *kind) {
    static const struct {
        const char *kind, *noun;
    } nouns[] = {{"int", "whole number"},
                 {"expr", "expression"},
                 {"cellexpr", "expression of the cells"},
                 {"cell", "value of the cells"},
                 {"file", "file name"},
                 {"fileoff", "file name, or off"},
                 {"cycles", "number of cycles, or a time"},
                 {"everycmd", "number of cycles, or a time"},
                 {"flag", "yes or no"}};
    for (size_t i = 0; i < TABLE_COUNT(nouns); i++)
        if (strcmp(kind, nouns[i].kind) == 0)
            return nouns[i].noun;
    return kind;
}

static void expected(const slot *s, diag *d) {
    const char *noun = noun_of(s->kind_name);
    const char *article = strncmp(noun, "yes", 3) == 0 ? "" : strchr("aeiou", *noun) ? "an " : "a ";
    diag_error(d, "%s: expected %s%s", s->name, article, noun);
}

int argument_next_word(args *a, const slot *s, reader *r, word *w, diag *d) {
    int status = reader_peek(r, w, d);
    if (status || w->text)
        return status;
    if (isupper((unsigned char)*s->name))
        diag_error(d, "%s needs %s", a->form->head[0].name, s->name);
    else
        expected(s, d);
    if (s->kind == SLOT_COLOR)
        diag_help(d, "# begins a comment: a colour code stands in quotes, \"#ff8800\"");
    size_t end = reader_end(r);
    diag_place(d, reader_span(r, end, end));
    return SARCINA_ERROR;
}

/* Places an error at the word and fails. */
static int refuse(const reader *r, const word *w, diag *d) {
    diag_place(d, reader_word_span(r, w));
    return SARCINA_ERROR;
}

/* ---- words ---- */

static int read_choice(const slot *s, const word *w, argument *out, diag *d) {
    if (w->unknown)
        return SARCINA_OK;
    name_list l = {0};
    for (size_t i = 0; i < s->nchoices; i++) {
        names_add(&l, s->choices[i]);
        if (strcmp(s->choices[i], w->text) == 0) {
            out->number = (double)i;
            return SARCINA_OK;
        }
    }
    char all[256] = "";
    for (size_t i = 0, used = 0; i < s->nchoices && used + 60 < sizeof all; i++)
        used += (size_t)snprintf(all + used, sizeof all - used, "%s%s", i ? " | " : "", s->choices[i]);
    diag_error(d, "%s: expected %s, not '%s'", s->name, all, w->text);
    const char *near = names_nearest(&l, w->text);
    if (near)
        diag_help(d, "did you mean '%s'?", near);
    return SARCINA_ERROR;
}

static int read_flag(const slot *s, const word *w, argument *out, diag *d) {
    out->number = strcmp(w->text, "yes") == 0;
    if (w->unknown || out->number != 0 || strcmp(w->text, "no") == 0)
        return SARCINA_OK;
    return diag_error(d, "%s: expected yes or no, not '%s'", s->name, w->text);
}

static int read_analysis(const slot *s, const word *w, diag *d) {
    name_list l = {0};
    for (size_t i = 0; i < value_style_count; i++)
        if (value_styles[i].scope == VALUE_ANALYSIS)
            names_add(&l, value_styles[i].name);
    for (size_t i = 0; i < l.n; i++)
        if (strcmp(l.list[i], w->text) == 0)
            return SARCINA_OK;
    if (w->unknown)
        return SARCINA_OK;
    diag_error(d, "%s: no analysis '%s'", s->name, w->text);
    names_suggest(&l, w->text, "analyses", d);
    return SARCINA_ERROR;
}

/* A name that is defined here. */
static int read_new(args *a, const slot *s, const word *w, diag *d) {
    /* where other names stand for one too (groups), those that can be defined are a class of their own */
    char own[sizeof s->kind_name + 1];
    snprintf(own, sizeof own, "+%s", s->kind_name);
    const name_class *c = names_class(a->in, own);
    c = c ? c : names_class(a->in, s->kind_name);
    if (w->unknown) {
        a->nameless = true;
        return SARCINA_OK;
    }
    free(a->defines);
    a->defines = alloc_copy(w->text);
    a->defines_in = c;
    bool there = c && names_row(a->in, c, w->text) >= 0;
    a->redefines = a->in->check.branch > 0 && there && !c->redefine;
    return a->redefines ? SARCINA_OK : names_check_new(a->in, c, w->text, d);
}

/* A name that stands already. */
static int read_name(args *a, const slot *s, const word *w, argument *out, diag *d) {
    out->number = -1;
    out->all = s->star && strcmp(w->text, "*") == 0;
    a->nameless = a->nameless || w->unknown;
    if (out->all || w->unknown)
        return SARCINA_OK;
    if (strcmp(s->kind_name, "variable") == 0) {
        if (variables_find(&a->in->variables, w->text) || a->in->replaying)
            return SARCINA_OK;
        return names_is_doubtful(a->in, w->text) ? SARCINA_OK : diag_error(d, "no variable '%s'", w->text);
    }
    const name_class *c = names_class(a->in, s->kind_name);
    assert(c && "a record names a class that no command has added");
    out->number = (double)names_row(a->in, c, w->text);
    if (out->number >= 0)
        return SARCINA_OK;
    if (names_is_doubtful(a->in, w->text)) {
        a->nameless = true;
        return SARCINA_OK;
    }
    return names_refuse(a->in, c, w->text, d);
}

/* ---- colours ---- */

static bool is_color(const char *text) {
    uint32_t code;
    return strcmp(text, "auto") == 0 || color_code_read(text, &code);
}

static int read_color(const slot *s, const word *w, diag *d) {
    if (w->unknown || is_color(w->text))
        return SARCINA_OK;
    diag_error(d, "%s: expected a color, not '%s'", s->name, w->text);
    return diag_help(d, "red, white, black, ... or a code in quotes: \"#ff8800\"");
}

/* ---- expressions ---- */

static void keep_expr(argument *out, expr *e) {
    size_t capacity = out->capacity;
    out->exprs = alloc_grow(out->exprs, &capacity, out->n + 1, sizeof *out->exprs);
    out->texts = alloc_resize(out->texts, capacity, sizeof *out->texts);
    out->spans = alloc_resize(out->spans, capacity, sizeof *out->spans);
    out->capacity = capacity;
    out->exprs[out->n] = e;
    out->texts[out->n] = alloc_copy(expr_text(e));
    out->spans[out->n++] = e->at;
}

/* `until` must be able to become true. */
static int check_condition(const slot *s, const expr *e, diag *d) {
    if (strcmp(s->name, "until") != 0 || expr_can_change(e) || !e->replaced)
        return SARCINA_OK;
    diag_error(d, "this never changes: a $ is replaced when the line is read; write the bare name");
    diag_place(d, e->at);
    return SARCINA_ERROR;
}

/* A test of cells is true or false; a length is not. */
static int check_truth(const slot *s, const expr *e, const expr_type *type, diag *d) {
    char name[48];
    if (type->wild || (!type->is_text && dim_is_none(type->d)))
        return SARCINA_OK;
    diag_error(d, "%s takes a truth per cell, not a %s", s->name, type->is_text ? "text" : dim_name(type->d, name));
    diag_help(d, "compare it: z > 1um, species == 'ff'");
    diag_place(d, e->at);
    return SARCINA_ERROR;
}

static int read_expr(args *a, const slot *s, argument *out, reader *r, diag *d) {
    bool oneword = s->kind == SLOT_VALUE || s->kind == SLOT_CELL || s->kind == SLOT_CELLCOLOR;
    bool per_cell = s->kind == SLOT_CELL || s->kind == SLOT_CELLEXPR || s->kind == SLOT_CELLCOLOR;
    bool column = oneword && (s->kind != SLOT_CELL || s->many);
    if (reader_at_end(r)) {
        word w;
        return argument_next_word(a, s, r, &w, d);
    }
    expr *e = expr_read(r, oneword ? EXPR_ONEWORD : EXPR_LONGEST, d);
    if (!e)
        return SARCINA_ERROR;
    expr_type type;
    int status = expr_check(a->in, e, per_cell, column || strcmp(s->name, "until") == 0, &type, d);
    if (!status && s->kind == SLOT_CELLEXPR)
        status = check_truth(s, e, &type, d);
    if (!status)
        status = check_condition(s, e, d);
    if (!status && oneword && r->at < reader_end(r) && !line_is_blank(r->text.chars[r->at])) {
        diag_error(d, "unexpected '%c' behind '%s'", r->text.chars[r->at], e->text);
        diag_place(d, reader_span(r, r->at, r->at + 1));
        status = SARCINA_ERROR;
    }
    keep_expr(out, e);
    return status;
}

static int read_cellcolor(args *a, const slot *s, argument *out, reader *r, diag *d) {
    word w;
    int status = argument_next_word(a, s, r, &w, d);
    if (status)
        return status;
    if (!is_color(w.text))
        return read_expr(a, s, out, r, d);
    out->text = alloc_copy(w.text);
    reader_take(r, &w);
    return SARCINA_OK;
}

/* The rest of the line. Names that are not there yet are no error: it is read when used. */
static int read_formula(args *a, const slot *s, argument *out, reader *r, diag *d) {
    word w;
    if (reader_at_end(r))
        return argument_next_word(a, s, r, &w, d);
    expr *e = expr_read(r, EXPR_LONGEST, d);
    if (!e)
        return SARCINA_ERROR;
    keep_expr(out, e);
    if (reader_at_end(r))
        return expr_check_formula(a->in, e, d);
    int status = reader_peek(r, &w, d);
    if (!status)
        diag_error(d, "unexpected '%s' behind the expression", w.text);
    return refuse(r, &w, d);
}

/* ---- commands run later ---- */

static int read_command(args *a, const slot *s, command_text **out, reader *r, diag *d) {
    word w;
    int status = reader_peek_raw(r, &w, d);
    if (!status && !w.text)
        status = argument_next_word(a, s, r, &w, d);
    if (status)
        return status;
    size_t from = w.from + w.quote, to = w.to - w.quote;
    piece text = piece_slice(&r->text, from, to);
    *out = text_create(&text);
    reader_take(r, &w);
    bool meant_to_fail = a->form->form.flags & COMMAND_MEANT_TO_FAIL;
    return a->in->check.on && !meant_to_fail ? text_check(a->in, *out, d) : SARCINA_OK;
}

static int read_every(args *a, const slot *s, argument *out, reader *r, diag *d) {
    word w;
    argument_every one = {0};
    size_t capacity = 0;
    int status = argument_next_word(a, s, r, &w, d);
    if (!status && argument_read_cycles(a, s, &w, &one.cycles, d) != SARCINA_OK)
        status = refuse(r, &w, d);
    if (!status)
        reader_take(r, &w);
    do {
        command_text *t = NULL;
        if (!status)
            status = read_command(a, s, &t, r, d);
        one.commands = alloc_grow(one.commands, &capacity, one.n + 1, sizeof(command_text *));
        if (t)
            one.commands[one.n++] = t;
    } while (!status && !reader_at_end(r) && line_quote(r->text.chars, r->at, r->at));
    out->every = alloc_resize(out->every, out->nevery + 1, sizeof *out->every);
    out->every[out->nevery++] = one;
    return status;
}

/* ---- several expressions ---- */

/* Expressions up to the end of the line or the next keyword. */
static int read_exprs(args *a, const slot *s, argument *out, reader *r, diag *d) {
    word w;
    int status = SARCINA_OK;
    if (!s->optional && reader_at_end(r))
        return argument_next_word(a, s, r, &w, d);
    while (!status && !reader_at_end(r)) {
        size_t index, n = 0;
        const char *at = r->text.chars + r->at;
        while (r->at + n < reader_end(r) && !line_is_blank(at[n]))
            n++;
        char *name = alloc_copy_n(at, n);
        bool key = signature_find(a->form, name, &index) && index >= a->form->nhead;
        free(name);
        if (key)
            return out->n || s->optional ? SARCINA_OK : diag_error(d, "%s needs %s", a->form->head[0].name, s->name);
        size_t start = r->at;
        status = read_expr(a, s, out, r, d);
        if (status) /* who sees that it is no value looks whether it was to be a keyword */
            r->at = start;
    }
    return status;
}

/* ---- the kinds ---- */

static bool is_lower_end(const slot *s) {
    size_t n = strlen(s->name);
    return n >= 2 && strcmp(s->name + n - 2, "LO") == 0;
}

/* Kinds that are one word, already read. */
static int read_word(args *a, const slot *s, const word *w, argument *out, diag *d) {
    switch (s->kind) {
    case SLOT_NUMBER:
        return argument_read_number(a, s, w, &out->number, &out->percent, d);
    case SLOT_BOUND:
        if (strcmp(w->text + strspn(w->text, "+-"), "INF") == 0) {
            /* as in LAMMPS, INF INF is all of space */
            out->number = *w->text == '-' || is_lower_end(s) ? -INFINITY : INFINITY;
            return SARCINA_OK;
        }
        return argument_read_number(a, s, w, &out->number, &out->percent, d);
    case SLOT_INT:
        return argument_read_int(a, s, w, &out->number, d);
    case SLOT_CYCLES:
        return argument_read_cycles(a, s, w, &out->cycles, d);
    case SLOT_QUANTITY:
        return argument_read_quantity(a, s, w, &out->quantity, d);
    case SLOT_CHOICE:
        return read_choice(s, w, out, d);
    case SLOT_FLAG:
        return read_flag(s, w, out, d);
    case SLOT_NEW:
        return read_new(a, s, w, d);
    case SLOT_NAME:
        return read_name(a, s, w, out, d);
    case SLOT_ANALYSIS:
        return read_analysis(s, w, d);
    case SLOT_COLOR:
        return read_color(s, w, d);
    default:
        return SARCINA_OK;
    }
}

static int read_one_word(args *a, const slot *s, argument *out, reader *r, diag *d) {
    word w;
    int status = argument_next_word(a, s, r, &w, d);
    if (status)
        return status;
    out->at = reader_word_span(r, &w);
    free(out->text);
    bool off = s->kind == SLOT_FILEOFF && !w.quote && strcmp(w.text, "off") == 0;
    out->text = off ? NULL : alloc_copy(w.text);
    if (w.unknown) {
        out->note = *w.unknown;
        out->note.number = out->note.number && w.only_unknown;
        out->note.wild = out->note.wild || !w.only_unknown;
        a->guessed = true;
    }
    if (read_word(a, s, &w, out, d) != SARCINA_OK)
        return refuse(r, &w, d);
    reader_take(r, &w);
    return SARCINA_OK;
}

static int read_rest(args *a, const slot *s, argument *out, reader *r, diag *d) {
    word w;
    int status = reader_rest(r, &w, d);
    if (!status && !w.text)
        return argument_next_word(a, s, r, &w, d);
    if (status)
        return status;
    out->text = alloc_copy(w.text);
    reader_take(r, &w);
    return SARCINA_OK;
}

static int read_kind(args *a, const slot *s, argument *out, reader *r, diag *d) {
    if (s->spread)
        return argument_read_spread(a, s, out, r, d);
    switch (s->kind) {
    case SLOT_NOTHING:
        return SARCINA_OK;
    case SLOT_REST:
        return read_rest(a, s, out, r, d);
    case SLOT_EXPR:
    case SLOT_CELLEXPR:
        return read_expr(a, s, out, r, d);
    case SLOT_VALUE:
    case SLOT_CELL:
        return s->many || s->optional ? read_exprs(a, s, out, r, d) : read_expr(a, s, out, r, d);
    case SLOT_CELLCOLOR:
        return read_cellcolor(a, s, out, r, d);
    case SLOT_FORMULA:
        return read_formula(a, s, out, r, d);
    case SLOT_COMMAND:
        return read_command(a, s, &out->command, r, d);
    case SLOT_EVERY:
        return read_every(a, s, out, r, d);
    case SLOT_RELAXATION:
        return argument_read_relaxation(a, s, out, r, d);
    case SLOT_ORIENT:
        return argument_read_orient(a, s, out, r, d);
    case SLOT_VIEW:
        return argument_read_view(a, s, out, r, d);
    case SLOT_LENGTH3:
        return argument_read_numbers(a, s, 3, out, r, d);
    case SLOT_SIZE:
    case SLOT_RANGE2:
        return argument_read_numbers(a, s, 2, out, r, d);
    case SLOT_COLUMNFORMAT:
        return argument_read_column_format(a, s, out, r, d);
    default:
        break;
    }
    bool words = s->kind == SLOT_WORDS || (s->many && s->kind == SLOT_WORD);
    return words ? argument_read_words(a, s, out, r, d) : read_one_word(a, s, out, r, d);
}

int argument_read(args *a, const slot *s, argument *out, reader *r, diag *d) {
    reader_at_end(r);
    size_t from = r->at;
    int status = read_kind(a, s, out, r, d);
    if (!out->at.source)
        out->at = reader_span(r, from, r->at > from ? r->at : from);
    out->given = status == SARCINA_OK;
    diag_place(status ? d : NULL, out->at);
    return status;
}

/* The default goes through the same readers as a text of its own. */
void argument_set_default(args *a, const slot *s, argument *out) {
    out->number = (double)NAN;
    out->range = spread_fixed((double)NAN);
    if (s->kind == SLOT_FLAG || s->kind == SLOT_CHOICE || s->kind == SLOT_INT)
        out->number = 0;
    if (s->kind == SLOT_NAME)
        out->number = -1;
    if (!s->initial || strcmp(s->initial, "auto") == 0 || strcmp(s->initial, "fit") == 0 ||
        strcmp(s->initial, "shape") == 0) {
        if (s->initial && (s->kind == SLOT_COLOR || s->kind == SLOT_WORD))
            out->text = alloc_copy(s->initial);
        if (s->kind != SLOT_CHOICE || !s->initial)
            return;
    }
    source *text = source_of_text("", s->initial);
    for (char *c = text->text; *c; c++)
        if (*c == ',')
            *c = ' ';
    piece p = piece_of_source(text);
    reader r;
    unit_system units_before = a->in->units;
    a->in->units = UNITS_SI;
    reader_open(&r, a->in, &p);
    argument_read(a, s, out, &r, NULL);
    reader_close(&r);
    a->in->units = units_before;
    out->given = false;
    out->at = (span){0};
    piece_free(&p);
    source_free(text);
}

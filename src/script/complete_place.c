/* SPDX-License-Identifier: GPL-3.0-or-later */
/* What the records of a command allow at the cursor: its forms are walked word by word, as args_read.c reads them. */
#include "script/complete_part.h"

#include "base/alloc.h"
#include "script/state.h"

#include <ctype.h>
#include <stdlib.h>
#include <string.h>

/* One form on its way through the words. */
typedef struct walk {
    const signature *form;
    const complete_words *words;
    size_t at;   /* the next word */
    bool *given; /* keywords (nkey) */
    /* where the cursor is */
    const slot *slot; /* an argument of which it is word number `part`, or a literal; NULL */
    size_t part;
    bool may_end; /* and what follows that argument may stand there too */
    bool off;
} walk;

static const char *word_of(const walk *w) {
    return w->words->list[w->at];
}

static bool is_word(const walk *w, const char *text) {
    return w->at < w->words->n && strcmp(word_of(w), text) == 0;
}

static bool at_cursor(const walk *w) {
    return w->at == w->words->n;
}

static bool is_keyword(const walk *w, const char *text) {
    size_t i;
    return signature_find(w->form, text, &i) && i >= w->form->nhead;
}

/* The cursor is in this argument. */
static bool stop(walk *w, const slot *s, size_t part, bool may_end) {
    w->slot = s;
    w->part = part;
    w->may_end = may_end;
    return true;
}

/* ---- arguments: each takes its words, and says whether the cursor is among them -----------------------------------
 */

static bool take_fixed(walk *w, const slot *s, size_t first, size_t count) {
    for (size_t i = 0; i < count; i++, w->at++)
        if (at_cursor(w))
            return stop(w, s, first + i, i == 0 && s->optional);
    return false;
}

static bool take_list(walk *w, const slot *s) {
    size_t n = 0;
    for (; !at_cursor(w) && !is_keyword(w, word_of(w)); w->at++)
        n++;
    return at_cursor(w) && stop(w, s, n, n > 0 || s->optional);
}

static bool take_spread(walk *w, const slot *s) {
    if (at_cursor(w))
        return stop(w, s, 0, false);
    bool number = !isalpha((unsigned char)*word_of(w));
    if (!number)
        return w->at++, take_fixed(w, s, 1, 2);
    w->at++;
    if (at_cursor(w))
        return stop(w, s, COMPLETE_SD, true);
    return is_word(w, "sd") && (w->at++, take_fixed(w, s, 1, 1));
}

/* T, or to F [within T]. */
static bool take_relaxation(walk *w, const slot *s) {
    if (!is_word(w, "to"))
        return take_fixed(w, s, 0, 1);
    w->at++;
    if (take_fixed(w, s, 1, 1))
        return true;
    if (at_cursor(w))
        return stop(w, s, 2, true);
    return is_word(w, "within") && (w->at++, take_fixed(w, s, 3, 1));
}

/* A name, or so many numbers. */
static bool take_name_or_numbers(walk *w, const slot *s, size_t count) {
    bool name = !at_cursor(w) && isalpha((unsigned char)*word_of(w));
    return take_fixed(w, s, 0, name ? 1 : count);
}

/* CYCLES, then commands in quotes. */
static bool take_every(walk *w, const slot *s) {
    if (take_fixed(w, s, 0, 1) || take_fixed(w, s, 1, 1))
        return true;
    while (!at_cursor(w) && (*word_of(w) == '"' || *word_of(w) == '\''))
        w->at++;
    return at_cursor(w) && stop(w, s, 2, true);
}

/* An expression goes on up to a keyword behind an operand. */
static bool take_expression(walk *w, const slot *s) {
    bool operand = false;
    for (; !at_cursor(w); w->at++) {
        const char *text = word_of(w);
        if (operand && is_keyword(w, text))
            return false;
        operand = !strchr("+-*/%^<>=!&|(,", text[strlen(text) - 1]);
    }
    return stop(w, s, operand, operand);
}

static bool take(walk *w, const slot *s) {
    if (s->spread)
        return take_spread(w, s);
    switch (s->kind) {
    case SLOT_NOTHING:
        return false;
    case SLOT_EXPR:
    case SLOT_CELLEXPR:
    case SLOT_FORMULA:
        return take_expression(w, s);
    case SLOT_REST:
        w->at = w->words->n;
        return stop(w, s, 0, false);
    case SLOT_EVERY:
        return take_every(w, s);
    case SLOT_RELAXATION:
        return take_relaxation(w, s);
    case SLOT_ORIENT:
        return take_name_or_numbers(w, s, 3);
    case SLOT_VIEW:
        return take_name_or_numbers(w, s, 2);
    case SLOT_LENGTH3:
        return take_fixed(w, s, 0, 3);
    case SLOT_SIZE:
    case SLOT_RANGE2:
    case SLOT_COLUMNFORMAT:
        return take_fixed(w, s, 0, 2);
    case SLOT_WORDS:
        return take_list(w, s);
    default:
        return s->many ? take_list(w, s) : take_fixed(w, s, 0, 1);
    }
}

/* ---- a form -------------------------------------------------------------------------------------------------------
 */

/* The head; true: the cursor is in it, or what stands there does not fit the form. */
static bool walk_head(walk *w) {
    const signature *f = w->form;
    for (size_t i = 1; i < f->nhead; i++) {
        const slot *s = &f->head[i];
        if (f->off_at == i && is_word(w, "off"))
            return true;
        w->off = f->off_at == i && at_cursor(w);
        if (s->kind == SLOT_LITERAL && at_cursor(w))
            return stop(w, s, 0, false);
        if (s->kind == SLOT_LITERAL && !is_word(w, s->name))
            return true;
        if (s->kind == SLOT_LITERAL)
            w->at++;
        else if (take(w, s))
            return !w->may_end;
    }
    if (f->off_at == f->nhead && is_word(w, "off"))
        return true;
    w->off = w->off || (f->off_at == f->nhead && at_cursor(w));
    return false;
}

/* Keywords; returns with the cursor in an argument of one, or where the next may stand. Unknown words are passed by. */
static void walk_keywords(walk *w) {
    while (!at_cursor(w)) {
        size_t i;
        const slot *s = signature_find(w->form, word_of(w), &i);
        w->at++;
        if (!s || i < w->form->nhead)
            continue;
        w->given[i - w->form->nhead] = s->kind != SLOT_EVERY;
        if (take(w, s))
            return;
    }
    w->may_end = true;
}

static void offer_form(completing *c, const signature *form, const complete_words *words) {
    walk w = {.form = form, .words = words, .at = 1};
    w.given = alloc_zeroed(form->nkey, sizeof *w.given);
    bool inside = walk_head(&w);
    if (!inside && !w.may_end)
        walk_keywords(&w);
    size_t from = c->from; /* an expression moves it to its last name */
    if (w.slot && w.slot->kind == SLOT_LITERAL)
        complete_part_offer(c, w.slot->name, false);
    else if (w.slot)
        complete_part_argument(c, w.slot, w.part);
    if (w.off && c->from == from)
        complete_part_offer(c, "off", false);
    for (size_t i = 0; w.may_end && !c->quote && c->from == from && i < form->nkey; i++)
        if (!w.given[i])
            complete_part_offer(c, form->key[i].name, false);
    free(w.given);
}

/* ---- the forms of a command ---------------------------------------------------------------------------------------
 */

static bool is_literal(const signature *s, size_t i, const char *text) {
    return i < s->nhead && s->head[i].kind == SLOT_LITERAL && strcmp(s->head[i].name, text) == 0;
}

/* Where forms have a literal that stands there, the others are out (args_read.c narrows so too). */
static bool is_excluded(const command_table *t, const signature *form, const complete_words *w) {
    for (size_t k = 0; k < t->count; k++) {
        const signature *other = &t->list[k];
        size_t i = 0;
        while (i < w->n && i < other->nhead &&
               (other->head[i].kind != SLOT_LITERAL || is_literal(other, i, w->list[i])))
            i++;
        bool fits = i == w->n || i == other->nhead;
        for (size_t at = 1; fits && at < i; at++)
            if (is_literal(other, at, w->list[at]) && !is_literal(form, at, w->list[at]))
                return true;
    }
    return false;
}

void complete_part_place(completing *c, const complete_words *w) {
    const command_table *t = c->in->host->commands;
    size_t from = c->from, moved = from;
    for (size_t i = 0; i < t->count; i++) {
        if (!is_literal(&t->list[i], 0, w->list[0]) || is_excluded(t, &t->list[i], w))
            continue;
        c->from = moved;
        if (moved == from)
            offer_form(c, &t->list[i], w);
        /* candidates of one place go to one place: the first form that has any says where */
        if (c->out->n)
            moved = c->from;
    }
    c->from = moved;
    complete_part_topics(c, w);
}

void complete_part_commands(completing *c) {
    const command_table *t = c->in->host->commands;
    for (size_t i = 0; i < t->count; i++)
        complete_part_offer(c, t->list[i].head[0].name, false);
}

/* SPDX-License-Identifier: GPL-3.0-or-later */
/* A command's line against the records of its forms: which form, then every argument in place, then the keywords. */
#include "script/argument.h"

#include "base/alloc.h"
#include "base/table.h"
#include "script/foreign.h"
#include "script/line.h"
#include "script/names.h"
#include "script/state.h"

#include <ctype.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

/* ---- which form ---- */

enum { FORMS_MAX = 64 };

typedef struct candidates {
    const signature *list[FORMS_MAX];
    size_t n;
} candidates;

static void find_forms(const command_table *t, const char *name, candidates *c) {
    c->n = 0;
    for (size_t i = 0; i < t->count && c->n < FORMS_MAX; i++)
        if (strcmp(t->list[i].head[0].name, name) == 0)
            c->list[c->n++] = &t->list[i];
}

static bool is_literal(const signature *s, size_t i) {
    return i < s->nhead && s->head[i].kind == SLOT_LITERAL;
}

/* Keeps the candidates that have this word at place i, or, when none has, those that take an argument there. */
static void narrow(candidates *c, size_t i, const word *w) {
    candidates literal = {.n = 0}, other = {.n = 0};
    for (size_t k = 0; k < c->n; k++) {
        const signature *s = c->list[k];
        if (is_literal(s, i) && w->text && !w->quote && strcmp(s->head[i].name, w->text) == 0)
            literal.list[literal.n++] = s;
        else if (!is_literal(s, i))
            other.list[other.n++] = s;
    }
    *c = literal.n ? literal : other;
}

static int by_name(const void *a, const void *b) {
    return strcmp(*(const char *const *)a, *(const char *const *)b);
}

static int refuse_form(const candidates *before, size_t i, reader *r, const word *w, diag *d) {
    if (foreign_explain_form(r->text.chars, d)) {
        diag_place(d, reader_word_span(r, w));
        return SARCINA_ERROR;
    }
    name_list l = {0};
    char all[512] = "";
    for (size_t k = 0; k < before->n; k++)
        if (is_literal(before->list[k], i))
            names_add(&l, before->list[k]->head[i].name);
    qsort(l.list, l.n, sizeof *l.list, by_name);
    for (size_t k = 0, used = 0; k < l.n && used + 60 < sizeof all; k++)
        used += (size_t)snprintf(all + used, sizeof all - used, "%s%s", k ? " | " : "", l.list[k]);
    if (w->text)
        diag_error(d, "%s: expected %s, not '%s'", before->list[0]->head[0].name, all, w->text);
    else
        diag_error(d, "%s: expected %s", before->list[0]->head[0].name, all);
    const char *near = w->text ? names_nearest(&l, w->text) : NULL;
    if (near)
        diag_help(d, "did you mean '%s'?", near);
    diag_place(d, reader_word_span(r, w));
    return SARCINA_ERROR;
}

/* Whether a literal at place i or behind it tells candidates apart. */
static bool needs_word(const candidates *c, size_t i) {
    for (size_t k = 0; k < c->n; k++)
        for (size_t at = i; at < c->list[k]->nhead; at++)
            if (is_literal(c->list[k], at))
                return true;
    return false;
}

static const signature *choose_form(candidates *c, reader *r, bool *unknown, diag *d) {
    for (size_t i = 1; needs_word(c, i); i++) {
        word w;
        if (reader_peek(r, &w, d) != SARCINA_OK)
            return NULL;
        if (w.only_unknown && !w.unknown->number) {
            *unknown = true;
            return NULL;
        }
        candidates before = *c;
        narrow(c, i, &w);
        if (c->n == 0) {
            refuse_form(&before, i, r, &w, d);
            return NULL;
        }
        if (!w.text)
            break;
        reader_take(r, &w);
    }
    return c->list[0];
}

/* A check goes on behind a command whose form is wrong: the name it would have defined is not reported as missing. */
static void doubt_names(interp *in, const candidates *c, reader *r) {
    word w;
    for (size_t i = 1; reader_peek(r, &w, NULL) == SARCINA_OK && w.text; i++) {
        bool defines = false;
        for (size_t k = 0; k < c->n; k++)
            defines = defines || (i < c->list[k]->nhead && c->list[k]->head[i].kind == SLOT_NEW);
        if (defines)
            names_doubt(in, w.text);
        reader_take(r, &w);
    }
}

const signature *args_read_form(interp *in, reader *r, bool *unknown, diag *d) {
    word w;
    candidates c = {.n = 0};
    *unknown = false;
    if (reader_peek(r, &w, d) != SARCINA_OK)
        return NULL;
    find_forms(in->host->commands, w.text, &c);
    reader_take(r, &w);
    size_t at = r->at;
    candidates all = c;
    const signature *form = choose_form(&c, r, unknown, d);
    r->at = at;
    if (!form && in->check.on)
        doubt_names(in, &all, r);
    return form;
}

/* ---- reading a line ---- */

/* `off` in the place of the arguments. */
static int read_off(args *a, reader *r, bool *off, diag *d) {
    word w;
    int status = reader_peek(r, &w, d);
    *off = !status && w.text && !w.quote && strcmp(w.text, "off") == 0;
    if (!*off)
        return status;
    reader_take(r, &w);
    a->off = true;
    status = reader_peek(r, &w, d);
    if (status || !w.text)
        return status;
    diag_error(d, "off ends the command; unexpected '%s'", w.text);
    diag_place(d, reader_word_span(r, &w));
    return SARCINA_ERROR;
}

/* Whether a check cannot go on: the next word is a text it does not know. */
static bool is_lost(args *a, reader *r) {
    word w;
    if (!a->in->check.on || reader_peek(r, &w, NULL) != SARCINA_OK || !w.text)
        return false;
    a->unknown = w.only_unknown && !w.quote && !w.unknown->number;
    return a->unknown;
}

/* A keyword that must still come: what was typed in its place may have meant it. */
static const char *missing_keyword(const args *a) {
    for (size_t i = 0; i < a->form->nkey; i++)
        if (a->form->key[i].required && !a->values[a->form->nhead + i].given)
            return a->form->key[i].name;
    return NULL;
}

/* A keyword that takes any words, where no other does: what was typed without it may be for it. */
static const char *keyword_of_words(const signature *f) {
    const char *found = NULL;
    size_t n = 0;
    for (size_t i = 0; i < f->nkey; i++)
        if (f->key[i].kind == SLOT_WORD && f->key[i].many) {
            found = f->key[i].name;
            n++;
        }
    return n == 1 ? found : NULL;
}

/* Does a number without its unit stand before the word? */
static bool follows_number(const reader *r, const word *w) {
    size_t i = w->from;
    while (i > 0 && line_is_blank(r->text.chars[i - 1]))
        i--;
    return i > 0 && isdigit((unsigned char)r->text.chars[i - 1]);
}

static int refuse_keyword(args *a, reader *r, const word *w, diag *d) {
    const signature *f = a->form;
    name_list l = {0};
    for (size_t i = 0; i < f->nkey; i++)
        names_add(&l, f->key[i].name);
    diag_error(d, "%s has no keyword '%s'", f->head[0].name, w->text);
    unit u;
    if (w->n && follows_number(r, w) && units_find(a->in->host->units, w->text, w->n, &u, NULL) == SARCINA_OK)
        diag_help(d, "a unit follows its number without a blank");
    else if (w->n == 1 && strchr("+-*/%^<>=!", *w->text))
        diag_help(d, "blanks stand in a one-word expression only inside ( ) or quotes");
    const char *missing = missing_keyword(a), *words = keyword_of_words(f);
    bool number = isdigit((unsigned char)*w->text);
    if (missing && !number && !names_nearest(&l, w->text))
        diag_help(d, "did you mean '%s'?", missing);
    else if ((missing || words) && !names_nearest(&l, w->text))
        diag_help(d, "did you mean '%s %s'?", missing ? missing : words, w->text);
    else
        names_suggest(&l, w->text, "keywords", d);
    diag_place(d, reader_word_span(r, w));
    return SARCINA_ERROR;
}

/* A word of a list that is no value, and nothing but a name near that of a keyword: those end the list. */
static int refuse_in_list(args *a, reader *r, diag *d) {
    word w;
    name_list l = {0};
    for (size_t i = 0; i < a->form->nkey; i++)
        names_add(&l, a->form->key[i].name);
    bool name = reader_peek(r, &w, NULL) == SARCINA_OK && w.text && !w.quote;
    for (size_t i = 0; name && i < w.n; i++)
        name = isalpha((unsigned char)w.text[i]);
    if (!name || !names_nearest(&l, w.text))
        return SARCINA_ERROR;
    if (d)
        *d = (diag){0};
    return refuse_keyword(a, r, &w, d);
}

static int read_head(args *a, reader *r, diag *d) {
    const signature *f = a->form;
    for (size_t i = 1; i < f->nhead; i++) {
        const slot *s = &f->head[i];
        bool off = false;
        if (f->off_at == i && read_off(a, r, &off, d) != SARCINA_OK)
            return SARCINA_ERROR;
        if (off || is_lost(a, r))
            return SARCINA_OK;
        if (s->kind == SLOT_LITERAL) {
            word w;
            if (argument_next_word(a, s, r, &w, d) != SARCINA_OK)
                return SARCINA_ERROR;
            reader_take(r, &w);
        } else if (!(s->optional && reader_at_end(r)) && argument_read(a, s, &a->values[i], r, d) != SARCINA_OK) {
            return s->many && f->nkey ? refuse_in_list(a, r, d) : SARCINA_ERROR;
        }
    }
    bool off = false;
    return f->off_at == f->nhead ? read_off(a, r, &off, d) : SARCINA_OK;
}

static int read_keyword(args *a, reader *r, diag *d) {
    word w;
    if (reader_peek(r, &w, d) != SARCINA_OK)
        return SARCINA_ERROR;
    if (!w.text)
        return SARCINA_OK;
    size_t index;
    const slot *s = w.quote ? NULL : signature_find(a->form, w.text, &index);
    if (!s || index < a->form->nhead)
        return refuse_keyword(a, r, &w, d);
    if (a->values[index].given && s->kind != SLOT_EVERY) {
        diag_error(d, "%s is given twice", s->name);
        diag_place(d, reader_word_span(r, &w));
        return SARCINA_ERROR;
    }
    reader_take(r, &w);
    if (is_lost(a, r))
        return SARCINA_OK;
    return argument_read(a, s, &a->values[index], r, d);
}

/* ---- what must be there ---- */

static bool has_group(const args *a, int group) {
    for (size_t i = 0; i < a->form->nkey; i++)
        if (a->form->key[i].group == group && a->values[a->form->nhead + i].given)
            return true;
    return false;
}

/* Bare words take whatever comes: of a misspelt keyword among them a missing one tells. */
static bool refuse_swallowed(const args *a, diag *d) {
    name_list l = {0};
    for (size_t i = 0; i < a->form->nkey; i++)
        names_add(&l, a->form->key[i].name);
    for (size_t i = 1; i < a->form->nhead; i++) {
        const argument *v = &a->values[i];
        bool words = a->form->head[i].kind == SLOT_WORD && a->form->head[i].many;
        for (size_t k = 1; words && k < v->n; k++) {
            if (!names_nearest(&l, v->texts[k]))
                continue;
            diag_error(d, "%s has no keyword '%s'", a->form->head[0].name, v->texts[k]);
            names_suggest(&l, v->texts[k], "keywords", d);
            diag_place(d, v->spans[k]);
            return true;
        }
    }
    return false;
}

/* "accuracy auto": the words that a form begins with. */
static void first_words(const signature *f, char out[128]) {
    size_t used = (size_t)snprintf(out, 128, "%s", f->head[0].name);
    for (size_t i = 1; i < f->nhead && f->head[i].kind == SLOT_LITERAL && used + 50 < 128; i++)
        used += (size_t)snprintf(out + used, 128 - used, " %s", f->head[i].name);
}

static int refuse_missing(const args *a, const slot *s, reader *r, diag *d) {
    char names[256];
    if (refuse_swallowed(a, d))
        return SARCINA_ERROR;
    size_t used = (size_t)snprintf(names, sizeof names, "%s", s->name);
    for (size_t i = 0; s->group && i < a->form->nkey && used + 60 < sizeof names; i++) {
        const slot *other = &a->form->key[i];
        if (other->group == s->group && other != s)
            used += (size_t)snprintf(names + used, sizeof names - used, " or %s", other->name);
    }
    char form[128];
    first_words(a->form, form);
    diag_error(d, "%s needs %s", form, names);
    size_t end = reader_end(r);
    diag_place(d, reader_span(r, end, end));
    return SARCINA_ERROR;
}

static int check_required(args *a, reader *r, diag *d) {
    const signature *f = a->form;
    bool amends = a->nameless || (f->form.exists && f->form.exists(a->in, a));
    for (size_t i = 0; i < f->nkey && !amends && !a->off; i++) {
        const slot *s = &f->key[i];
        bool given = a->values[f->nhead + i].given;
        if ((s->required && !given) || (s->group && !has_group(a, s->group)))
            return refuse_missing(a, s, r, d);
    }
    return SARCINA_OK;
}

int args_read(interp *in, const signature *form, reader *r, args *out, diag *d) {
    *out = (args){.in = in, .form = form};
    out->values = alloc_zeroed(form->nhead + form->nkey, sizeof *out->values);
    int status = read_head(out, r, d);
    while (!status && !out->off && !out->unknown && !reader_at_end(r))
        status = read_keyword(out, r, d);
    if (status || out->unknown)
        return status;
    for (size_t i = 1; i < form->nhead + form->nkey; i++) {
        const slot *s = i < form->nhead ? &form->head[i] : &form->key[i - form->nhead];
        if (s->kind != SLOT_LITERAL && !out->values[i].given)
            argument_set_default(out, s, &out->values[i]);
    }
    return check_required(out, r, d);
}

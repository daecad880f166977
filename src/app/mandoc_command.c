/* SPDX-License-Identifier: GPL-3.0-or-later */
/* One page a command, sarcina-COMMAND(7), from its record and those of its forms. What all forms share is said once. */
#include "app/mandoc.h"

#include "base/alloc.h"
#include "script/kind.h"

#include <stdlib.h>
#include <string.h>

enum { FORMS_MAX = 64 };

/* The forms of one command. */
typedef struct forms {
    const command_table *table;
    const signature *list[FORMS_MAX];
    size_t n;
} forms;

static bool is_off(const signature *s) {
    return s->nkey == 0 && strcmp(s->head[s->nhead - 1].name, "off") == 0;
}

/* Words of a text that are all capitals are arguments; brackets and bars stand for themselves. */
static void put_synopsis_words(page *p, const char *usage) {
    char *copy = alloc_copy(usage), *save;
    for (char *w = strtok_r(copy, " ", &save); w; w = strtok_r(NULL, " ", &save)) {
        page_put(p, "%s", *w == '.' ? "\\&" : "");
        mandoc_escape(p, w);
        page_put(p, "\n");
    }
    free(copy);
}

static void put_synopsis(page *p, const forms *f) {
    page_put(p, ".Sh SYNOPSIS\n.Bl -tag -width %s -compact\n", f->list[0]->head[0].name);
    for (size_t i = 0; i < f->n; i++) {
        char *usage = signature_usage(f->list[i]);
        const char *rest = usage + strlen(f->list[i]->head[0].name);
        page_put(p, ".It Ic %s\n", f->list[i]->head[0].name);
        put_synopsis_words(p, rest);
        free(usage);
    }
    page_put(p, ".El\n");
}

/* ---- arguments ---- */

static bool same_text(const char *a, const char *b) {
    return a == b || (a && b && strcmp(a, b) == 0);
}

static bool same_slot(const slot *a, const slot *b) {
    return a->kind == b->kind && strcmp(a->name, b->name) == 0 && strcmp(a->kind_name, b->kind_name) == 0 &&
           same_text(a->summary, b->summary) && same_text(a->initial, b->initial) && a->nchoices == b->nchoices &&
           same_text(a->lo_text, b->lo_text) && same_text(a->hi_text, b->hi_text) && a->required == b->required;
}

static const slot *slot_at(const signature *s, size_t i) {
    return i < s->nhead ? &s->head[i] : &s->key[i - s->nhead];
}

static bool has_slot(const signature *s, const slot *wanted) {
    for (size_t i = 1; i < s->nhead + s->nkey; i++)
        if (slot_at(s, i)->kind != SLOT_LITERAL && same_slot(slot_at(s, i), wanted))
            return true;
    return false;
}

/* Whether every form has this argument; those that only take something away are not asked. */
static bool is_shared(const forms *f, const slot *s) {
    size_t asked = 0;
    for (size_t i = 0; i < f->n; i++) {
        if (is_off(f->list[i]))
            continue;
        asked++;
        if (!has_slot(f->list[i], s))
            return false;
    }
    return asked > 1;
}

static void put_choices(page *p, const signature *form, const slot *s) {
    bool open = false;
    for (size_t i = 0; i < s->nchoices; i++) {
        const char *text = signature_choice(form, s->choices[i]);
        if (!text)
            continue;
        page_put(p, "%s.It Cm %s\n", open ? "" : ".Bl -tag -width dopri5xx -compact\n", s->choices[i]);
        mandoc_text(p, text);
        open = true;
    }
    page_put(p, "%s", open ? ".El\n" : "");
}

static void put_summary(page *p, const char *text) {
    page sentence = {0};
    page_sentence(&sentence, text);
    mandoc_text(p, sentence.chars);
    free(sentence.chars);
}

static void put_slot(page *p, const forms *f, const signature *form, const slot *s, bool keyword) {
    page text = {0};
    page_put(p, ".It %s ", keyword ? "Cm" : "Ar");
    mandoc_escape(p, s->name);
    kind_explain(&text, f->table, s);
    page_put(p, "\n");
    mandoc_text(p, text.chars);
    free(text.chars);
    put_choices(p, form, s);
}

/* Arguments of a form, those that all forms share or the others. */
static size_t put_slots(page *p, const forms *f, const signature *form, bool shared) {
    size_t put = 0;
    for (size_t i = 1; i < form->nhead + form->nkey; i++) {
        const slot *s = slot_at(form, i);
        if (s->kind == SLOT_LITERAL || is_shared(f, s) != shared)
            continue;
        if (put++ == 0)
            page_put(p, ".Bl -tag -width Ds\n");
        put_slot(p, f, form, s, i >= form->nhead);
    }
    page_put(p, "%s", put ? ".El\n" : "");
    return put;
}

/* ---- the body ---- */

static void put_form_title(page *p, const signature *s) {
    page_put(p, ".Ss %s", s->head[0].name);
    for (size_t i = 1; i < s->nhead; i++) {
        page_put(p, " ");
        if (s->head[i].kind == SLOT_CHOICE)
            page_put(p, "%s", s->head[i].name);
        else
            mandoc_escape(p, s->head[i].name);
    }
    page_put(p, "\n");
}

static void put_form(page *p, const forms *f, const signature *s) {
    if (f->n > 1) {
        put_form_title(p, s);
        put_summary(p, s->form.summary);
    }
    if (s->form.details) {
        page_put(p, ".Pp\n");
        mandoc_text(p, s->form.details);
    }
    if (s->formula) {
        page_put(p, ".Bd -filled -offset indent\n");
        mandoc_text(p, s->formula);
        page_put(p, ".Ed\n");
    }
    put_slots(p, f, s, false);
    if (s->source) {
        page_put(p, ".Pp\nSource: ");
        mandoc_text(p, s->source);
    }
}

static void put_examples(page *p, const forms *f) {
    page_put(p, ".Sh EXAMPLES\nThey run after the prelude of\n.Xr sarcina-script 7 .\n");
    for (size_t i = 0; i < f->n; i++)
        if (f->list[i]->form.example)
            mandoc_literal(p, f->list[i]->form.example);
}

static void write_command(mandoc *m, const forms *f) {
    page p = {0};
    const char *name = f->list[0]->head[0].name;
    const command_page *about = signature_page(f->table, name);
    char *full = alloc_format("sarcina-%s", name), *path = alloc_format("man/%s.7", full);
    mandoc_begin(&p, full, 7, about ? about->summary : f->list[0]->form.summary);
    put_synopsis(&p, f);
    page_put(&p, ".Sh DESCRIPTION\n");
    if (about && about->details)
        mandoc_text(&p, about->details);
    else if (f->n == 1)
        put_summary(&p, f->list[0]->form.summary);
    const signature *first = f->list[0];
    if (f->n > 1)
        put_slots(&p, f, first, true);
    for (size_t i = 0; i < f->n; i++)
        put_form(&p, f, f->list[i]);
    put_examples(&p, f);
    mandoc_see(&p, f->table, about ? about->see : NULL);
    mandoc_write(m, path, &p);
    free(p.chars);
    free(full);
    free(path);
}

void mandoc_commands(mandoc *m) {
    const char *name;
    for (size_t i = 0; (name = signature_command(m->commands, i)); i++) {
        forms f = {.table = m->commands};
        f.n = signature_forms(m->commands, name, f.list, FORMS_MAX);
        write_command(m, &f);
    }
}

/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "script/help.h"

#include "analysis/value.h"
#include "base/alloc.h"
#include "base/table.h"
#include "script/function.h"
#include "script/names.h"
#include "script/reduction.h"
#include "script/signature.h"
#include "script/state.h"

#include <stdarg.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

typedef struct page {
    char *chars;
    size_t n, capacity;
} page;

static void put(page *p, const char *format, ...) __attribute__((format(printf, 2, 3)));

static void put(page *p, const char *format, ...) {
    char *text = NULL;
    va_list list;
    va_start(list, format);
    int n = vasprintf(&text, format, list);
    va_end(list);
    if (n < 0)
        return;
    p->chars = alloc_grow(p->chars, &p->capacity, p->n + (size_t)n + 1, 1);
    memcpy(p->chars + p->n, text, (size_t)n + 1);
    p->n += (size_t)n;
    free(text);
}

/* The words that the interpreter itself reads. */
static const struct {
    const char *name, *usage, *summary, *example;
} words[] = {
    {"if", "if EXPR, lines, [elif EXPR, lines ...] [else, lines], end; or if EXPR then \"COMMAND\" [else \"COMMAND\"]",
     "Runs commands when a condition holds", "if cells > 1 then \"print 'many'\" else \"print 'one'\""},
    {"for", "for NAME in A..B[..STEP] | WORD ..., lines, end", "Runs commands for each value", "for i in 1..3 ... end"},
    {"while", "while EXPR, lines, end", "Runs commands as long as a condition holds",
     "while max(overlap) > 1nm ... end"},
    {"repeat", "repeat N, lines, end", "Runs commands several times", "repeat 2 ... end"},
    {"break", "break", "Ends the innermost loop", "break"},
    {"continue", "continue", "Goes on with the next pass of the innermost loop", "continue"},
    {"end", "end [if|for|while|repeat]", "Closes a block", "end for"},
};

static void put_overview(page *p, const command_table *t) {
    put(p, "Commands ('help COMMAND' explains one):\n");
    for (size_t i = 0; i < t->count; i++) {
        const char *name = t->list[i].head[0].name;
        if (i && strcmp(t->list[i - 1].head[0].name, name) == 0)
            continue;
        put(p, "  %-14s %s\n", name, t->list[i].form.summary ? t->list[i].form.summary : "");
    }
    for (size_t i = 0; i < TABLE_COUNT(words); i++)
        put(p, "  %-14s %s\n", words[i].name, words[i].summary);
    put(p, "'help values' lists what expressions may name, 'help functions' what they may call.");
}

static void put_slot(page *p, const slot *s) {
    put(p, "  %-12s %s", s->name, s->summary ? s->summary : "");
    if (s->initial)
        put(p, " (default %s)", s->initial);
    if (s->lo_text)
        put(p, "; %s %s", s->lo_open ? "more than" : "at least", s->lo_text);
    if (s->hi_text)
        put(p, "; %s %s", s->hi_open ? "less than" : "at most", s->hi_text);
    put(p, "\n");
}

static void put_form(page *p, const signature *s) {
    char *usage = signature_usage(s);
    put(p, "%s\n  %s.\n", usage, s->form.summary ? s->form.summary : "");
    free(usage);
    for (size_t i = 1; i < s->nhead; i++)
        if (s->head[i].kind != SLOT_LITERAL)
            put_slot(p, &s->head[i]);
    for (size_t i = 0; i < s->nkey; i++)
        put_slot(p, &s->key[i]);
    if (s->form.details)
        put(p, "  %s\n", s->form.details);
    if (s->form.example)
        put(p, "  Example: %s\n", s->form.example);
}

/* Whether the words of the topic are among the form's words, the first one first. */
static bool fits(const signature *s, const char *topic) {
    char copy[256], *save;
    snprintf(copy, sizeof copy, "%s", topic);
    char *word_of = strtok_r(copy, " ", &save);
    if (!word_of || strcmp(word_of, s->head[0].name) != 0)
        return false;
    while ((word_of = strtok_r(NULL, " ", &save))) {
        bool found = false;
        for (size_t i = 1; i < s->nhead; i++)
            found = found || (s->head[i].kind == SLOT_LITERAL && strcmp(s->head[i].name, word_of) == 0);
        if (!found)
            return false;
    }
    return true;
}

static void put_value(page *p, const value_style *s) {
    static const char *const scopes[] = {"per cell", "of the scene", "a measure of all cells, or of a group"};
    put(p, "%s: %s (%s, %s)\n", s->name, s->summary, s->dimension, scopes[s->scope]);
    for (size_t i = 0; i < value_field_count(s); i++) {
        char name[32], buffer[48];
        dim d;
        value_field(s, i, name, &d);
        put(p, "  %s.%s (%s)\n", s->name, name, dim_name(d, buffer));
    }
}

static void put_lists(page *p, const char *topic) {
    for (size_t i = 0; strcmp(topic, "values") == 0 && i < value_style_count; i++)
        put_value(p, &value_styles[i]);
    for (size_t i = 0; strcmp(topic, "functions") == 0 && i < function_style_count; i++)
        put(p, "%-24s %s\n", function_styles[i].signature, function_styles[i].summary);
    for (size_t i = 0; strcmp(topic, "functions") == 0 && i < reduction_style_count; i++)
        put(p, "%-24s %s\n", reduction_styles[i].signature, reduction_styles[i].summary);
}

static void put_topic(page *p, const command_table *t, const char *topic) {
    for (size_t i = 0; i < t->count; i++)
        if (fits(&t->list[i], topic))
            put_form(p, &t->list[i]);
    for (size_t i = 0; i < TABLE_COUNT(words); i++)
        if (strcmp(words[i].name, topic) == 0)
            put(p, "%s\n  %s.\n  Example: %s\n", words[i].usage, words[i].summary, words[i].example);
    const value_style *v = value_find(topic);
    if (v)
        put_value(p, v);
    const function_style *f = function_find(topic);
    if (f)
        put(p, "%s: %s\n", f->signature, f->summary);
    const reduction_style *r = reduction_find(topic);
    if (r)
        put(p, "%s: %s\n", r->signature, r->summary);
    put_lists(p, topic);
}

char *help_text(interp *in, const char *topic, diag *d) {
    const command_table *t = in->host->commands;
    page p = {0};
    if (*topic)
        put_topic(&p, t, topic);
    else
        put_overview(&p, t);
    if (p.n) {
        if (p.chars[p.n - 1] == '\n')
            p.chars[p.n - 1] = '\0';
        return p.chars;
    }
    name_list l = {0};
    for (size_t i = 0; i < t->count; i++)
        names_add(&l, t->list[i].head[0].name);
    for (size_t i = 0; i < value_style_count; i++)
        names_add(&l, value_styles[i].name);
    diag_error(d, "no help about '%s'", topic);
    names_suggest(&l, topic, "topics", d);
    return NULL;
}

/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Errors as they are shown: GNU form, the source line, a caret under the word, what to write instead, the stack. */
#include "base/alloc.h"
#include "script/interp.h"
#include "script/state.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

typedef struct text {
    char *chars;
    size_t n, capacity;
} text;

static void put_n(text *t, const char *chars, size_t n) {
    t->chars = alloc_grow(t->chars, &t->capacity, t->n + n + 1, 1);
    memcpy(t->chars + t->n, chars, n);
    t->n += n;
    t->chars[t->n] = '\0';
}

static void put(text *t, const char *chars) {
    put_n(t, chars, strlen(chars));
}

static bool is_continuation(char c) {
    return ((unsigned char)c & 0xc0) == 0x80;
}

/* Blanks up to a column, as wide as the line shows them: tabs stay tabs, a letter of several bytes is one. */
static void put_indent(text *t, const char *line, size_t length, uint32_t column) {
    for (size_t i = 0; i + 1 < column; i++)
        if (i >= length || !is_continuation(line[i]))
            put(t, i < length && line[i] == '\t' ? "\t" : " ");
}

static void put_caret(text *t, const char *line, size_t length, const span *at) {
    put_indent(t, line, length, at->column);
    put(t, "^");
    for (size_t i = at->column; i + 1 < (size_t)at->column + at->length && i < length; i++)
        if (!is_continuation(line[i]))
            put(t, "~");
    put(t, "\n");
}

/* The line with its caret; number: behind its number and a bar. */
static void put_source(text *t, const span *at, bool number) {
    size_t length;
    const char *line = source_line(at->source, at->line, &length);
    if (!line)
        return;
    char margin[32] = "", blank[32] = "";
    if (number) {
        int n = snprintf(margin, sizeof margin, "%5u | ", at->line);
        snprintf(blank, sizeof blank, "%*s | ", n - 3, "");
    }
    put(t, margin);
    put_n(t, line, length);
    put(t, "\n");
    put(t, blank);
    put_caret(t, line, length, at);
}

static void put_help(text *t, const char *help) {
    while (*help) {
        size_t n = strcspn(help, "\n");
        put(t, "help: ");
        put_n(t, help, n);
        put(t, "\n");
        help += n + (help[n] == '\n');
    }
}

char *interp_explain(interp *in, const diag *d) {
    text t = {0};
    const source *s = d->at.source;
    bool prompt = s && !*s->name;
    if (prompt)
        put_source(&t, &d->at, false);
    if (s && !prompt) {
        char place[64];
        snprintf(place, sizeof place, ":%u:%u: ", d->at.line, d->at.column);
        put(&t, s->name);
        put(&t, place);
    }
    put(&t, "error: ");
    put(&t, d->message);
    put(&t, "\n");
    if (s && !prompt)
        put_source(&t, &d->at, true);
    if (in->noted && in->expanded) {
        put(&t, "expanded: ");
        put(&t, in->expanded);
        put(&t, "\n");
    }
    put_help(&t, d->help);
    if (in->noted && in->trace)
        put(&t, in->trace);
    return t.chars;
}

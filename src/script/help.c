/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "script/help.h"

#include "analysis/value.h"
#include "base/alloc.h"
#include "base/table.h"
#include "script/control.h"
#include "script/function.h"
#include "script/names.h"
#include "script/reduction.h"
#include "script/state.h"
#include "script/topic.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

/* ---- everything, a line each ---- */

static void put_line(page *p, const char *name, const char *summary) {
    page_put(p, "  %-15s ", name);
    page_wrap(p, 18, HELP_WIDTH, summary ? summary : "");
}

/* Commands under the headings of their pages; those that have none come last. */
static void put_commands(page *p, const command_table *t) {
    const signature *first;
    const char *name;
    for (size_t i = 0; i < t->npages; i++) {
        if (i == 0 || strcmp(t->pages[i].topic, t->pages[i - 1].topic) != 0)
            page_put(p, "%s\n", t->pages[i].topic);
        if (signature_forms(t, t->pages[i].name, &first, 1))
            put_line(p, t->pages[i].name, t->pages[i].summary);
    }
    for (size_t i = 0; (name = signature_command(t, i)); i++)
        if (!signature_page(t, name) && signature_forms(t, name, &first, 1))
            put_line(p, name, first->form.summary);
}

static void put_overview(page *p, const command_table *t) {
    put_commands(p, t);
    page_put(p, "Blocks\n");
    for (size_t i = 0; i < control_word_count; i++)
        put_line(p, control_words[i].name, control_words[i].summary);
    page_put(p, "Topics\n");
    for (size_t i = 0; i < topic_count; i++)
        put_line(p, topic_list[i].name, topic_list[i].title);
    page_put(p, "'help NAME' explains a command, topic, value or function; 'help dump image' one form of a command; "
                "'apropos WORD' searches all of it.");
}

/* ---- one thing ---- */

static void put_control(page *p, const control_word *w) {
    page_put(p, "%s: %s\n\n", w->name, w->summary);
    page_lines(p, 2, w->usage);
    if (w->details) {
        page_put(p, "\n    ");
        page_wrap(p, 4, HELP_WIDTH, w->details);
    }
    page_put(p, "\n    Example:\n");
    page_lines(p, 6, w->example);
}

/* Rows as a table whose left column is as wide as its names, within reason. */
static void put_rows(page *p, topic_row *rows) {
    page name = {0}, text = {0};
    for (size_t i = 0; rows(i, &name, &text); i++) {
        page_put(p, "  %-15s ", name.chars ? name.chars : "");
        if (name.n > 15)
            page_put(p, "\n%18s", "");
        page_wrap(p, 18, HELP_WIDTH, text.chars ? text.chars : "");
        name.n = text.n = 0;
    }
    free(name.chars);
    free(text.chars);
}

static void put_topic(page *p, const topic *t) {
    page_put(p, "%s: %s\n\n", t->name, t->title);
    for (size_t i = 0; i < t->nparts; i++) {
        page_put(p, "  ");
        page_wrap(p, 2, HELP_WIDTH, t->parts[i].text);
        if (t->parts[i].example) {
            page_put(p, "\n");
            page_lines(p, 6, t->parts[i].example);
            page_put(p, "\n");
        }
    }
    if (t->rows)
        put_rows(p, t->rows);
}

static void put_value(page *p, const value_style *s) {
    page name = {0}, text = {0};
    for (size_t i = 0; topic_row_value(i, &name, &text); i++) {
        if (strcmp(name.chars, s->name) == 0) {
            page_put(p, "%s: ", name.chars);
            page_wrap(p, 2, HELP_WIDTH, text.chars);
        }
        name.n = text.n = 0;
    }
    if (s->source)
        page_put(p, "  Source: %s\n", s->source);
    page_put(p, "  Example: ");
    topic_example_value(p, s);
    page_put(p, "\n");
    free(name.chars);
    free(text.chars);
}

/* Forms that have the word as a style or keyword: help sphere, help gap. */
static void put_forms_with(page *p, const command_table *t, const char *style) {
    const char *name;
    for (size_t i = 0; (name = signature_command(t, i)); i++)
        if (strcmp(name, style) != 0)
            help_put_command(p, t, name, style);
}

static void put_named(page *p, const command_table *t, const char *name) {
    const control_word *w = control_find(name);
    const topic *about = topic_find(name);
    const value_style *v = value_find(name);
    const function_style *f = function_find(name);
    const reduction_style *r = reduction_find(name);
    help_put_command(p, t, name, NULL);
    if (w)
        put_control(p, w);
    if (about)
        put_topic(p, about);
    if (v)
        put_value(p, v);
    if (f) {
        page_put(p, "%s: %s\n  Example: ", f->signature, f->summary);
        topic_example_function(p, f);
    }
    if (r) {
        page_put(p, "%s: %s\n  Example: ", r->signature, r->summary);
        topic_example_reduction(p, r);
    }
}

/* "dump image" is a command and words of one of its forms. */
static void put_any(page *p, const command_table *t, const char *asked) {
    const char *blank = strchr(asked, ' ');
    if (blank) {
        char *name = alloc_copy_n(asked, (size_t)(blank - asked));
        help_put_command(p, t, name, blank + 1);
        free(name);
        return;
    }
    put_named(p, t, asked);
    if (!p->n)
        put_forms_with(p, t, asked);
}

static char *refuse(const command_table *t, const char *asked, diag *d) {
    name_list l = {0};
    const char *name;
    for (size_t i = 0; (name = signature_command(t, i)); i++)
        names_add(&l, name);
    for (size_t i = 0; i < control_word_count; i++)
        names_add(&l, control_words[i].name);
    for (size_t i = 0; i < topic_count; i++)
        names_add(&l, topic_list[i].name);
    for (size_t i = 0; i < value_style_count; i++)
        names_add(&l, value_styles[i].name);
    for (size_t i = 0; i < function_style_count; i++)
        names_add(&l, function_styles[i].name);
    for (size_t i = 0; i < reduction_style_count; i++)
        names_add(&l, reduction_styles[i].name);
    diag_error(d, "no help about '%s'", asked);
    names_suggest(&l, asked, "topics", d);
    diag_help(d, "'help' lists commands and topics; 'apropos WORD' searches all texts");
    return NULL;
}

char *help_text(interp *in, const char *asked, diag *d) {
    const command_table *t = in->host->commands;
    page p = {0};
    if (*asked)
        put_any(&p, t, asked);
    else
        put_overview(&p, t);
    if (!p.n)
        return refuse(t, asked, d);
    while (p.n && p.chars[p.n - 1] == '\n')
        p.chars[--p.n] = '\0';
    return p.chars;
}

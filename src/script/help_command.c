/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Help on a command: all of it where it has few forms, else a line on each form and the whole of those asked for. */
#include "script/help.h"

#include "base/alloc.h"
#include "script/kind.h"

#include <stdlib.h>
#include <string.h>

enum { WHOLE_AT_MOST = 2 }; /* forms shown whole without being asked for */

static void put_choices(page *p, const signature *form, const slot *s) {
    for (size_t i = 0; i < s->nchoices; i++) {
        const char *text = signature_choice(form, s->choices[i]);
        if (!text)
            continue;
        page_put(p, "%20s%-12s", "", s->choices[i]);
        page_wrap(p, 34, HELP_WIDTH, text);
    }
}

static void put_slot(page *p, const command_table *t, const signature *form, const slot *s) {
    page text = {0};
    kind_explain(&text, t, s);
    page_put(p, "    %-14s", s->name);
    page_put(p, "%s", strlen(s->name) < 14 ? "" : " ");
    page_wrap(p, 18, HELP_WIDTH, text.chars ? text.chars : "");
    put_choices(p, form, s);
    free(text.chars);
}

/* A usage line is broken between its arguments, not within brackets. */
static void put_usage(page *p, const signature *s) {
    char *usage = signature_usage(s);
    int depth = 0;
    for (char *c = usage; *c; c++) {
        depth += (*c == '[' || *c == '(') - (*c == ']' || *c == ')');
        if (*c == ' ' && depth > 0)
            *c = '\x1f';
    }
    page_put(p, "  ");
    size_t from = p->n;
    page_wrap(p, 6, HELP_WIDTH, usage);
    for (size_t i = from; i < p->n; i++)
        if (p->chars[i] == '\x1f')
            p->chars[i] = ' ';
    free(usage);
}

static void put_paragraph(page *p, const char *text) {
    if (!text)
        return;
    page_put(p, "    ");
    page_wrap(p, 4, HELP_WIDTH, text);
}

static void put_form(page *p, const command_table *t, const signature *s) {
    page summary = {0};
    put_usage(p, s);
    page_sentence(&summary, s->form.summary);
    put_paragraph(p, summary.chars);
    free(summary.chars);
    put_paragraph(p, s->form.details);
    put_paragraph(p, s->formula);
    for (size_t i = 1; i < s->nhead; i++)
        if (s->head[i].kind != SLOT_LITERAL)
            put_slot(p, t, s, &s->head[i]);
    for (size_t i = 0; i < s->nkey; i++)
        put_slot(p, t, s, &s->key[i]);
    if (s->source)
        page_put(p, "    Source: %s\n", s->source);
    if (s->form.example) {
        page_put(p, "    Example:\n");
        page_lines(p, 6, s->form.example);
    }
    page_put(p, "\n");
}

/* Whether every word of `style` (NULL: none) stands in the form's head, as a word or a choice. */
static bool fits(const signature *s, const char *style) {
    char *copy = alloc_copy(style ? style : ""), *save;
    bool all = true;
    for (char *w = strtok_r(copy, " ", &save); w; w = strtok_r(NULL, " ", &save)) {
        bool found = false;
        for (size_t i = 1; i < s->nhead; i++) {
            const slot *h = &s->head[i];
            found = found || (h->kind == SLOT_LITERAL && strcmp(h->name, w) == 0);
            for (size_t k = 0; k < h->nchoices; k++)
                found = found || strcmp(h->choices[k], w) == 0;
        }
        for (size_t i = 0; i < s->nkey; i++)
            found = found || strcmp(s->key[i].name, w) == 0;
        all = all && found;
    }
    free(copy);
    return all;
}

static void put_short(page *p, const signature *s) {
    put_usage(p, s);
    page_put(p, "      ");
    page_wrap(p, 6, HELP_WIDTH, s->form.summary);
}

static void put_see(page *p, const command_page *about) {
    if (about && about->see)
        page_put(p, "See also: %s; man sarcina-%s\n", about->see, about->name);
}

void help_put_command(page *p, const command_table *t, const char *name, const char *style) {
    const signature *all[HELP_FORMS_MAX], *list[HELP_FORMS_MAX];
    size_t total = signature_forms(t, name, all, HELP_FORMS_MAX), n = 0;
    for (size_t i = 0; i < total; i++)
        if (fits(all[i], style))
            list[n++] = all[i];
    if (n == 0)
        return;
    const command_page *about = signature_page(t, name);
    page_put(p, "%s: %s\n", name, about ? about->summary : list[0]->form.summary);
    if (!style && about && about->details) {
        page_put(p, "  ");
        page_wrap(p, 2, HELP_WIDTH, about->details);
    }
    page_put(p, "\n");
    bool whole = style || n <= WHOLE_AT_MOST;
    for (size_t i = 0; i < n; i++)
        if (whole || !*signature_style(list[i])) /* what no word asks for */
            put_form(p, t, list[i]);
        else
            put_short(p, list[i]);
    if (!whole)
        page_put(p, "\n'help %s STYLE' explains one of them, such as 'help %s %s'.\n", name, name,
                 signature_style(list[n - 1]));
    put_see(p, about);
}

/* SPDX-License-Identifier: GPL-3.0-or-later */
/* apropos: a word looked for in names, summaries, details and arguments of everything there is help on. What has it in
 * its name comes first, then in its one line, then in the rest. */
#include "script/help.h"

#include "analysis/value.h"
#include "base/alloc.h"
#include "script/control.h"
#include "script/function.h"
#include "script/reduction.h"
#include "script/state.h"
#include "script/topic.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

enum { RANKS = 3 };

typedef struct search {
    const char *word;
    page found[RANKS];
} search;

static bool has(const char *text, const search *s) {
    return text && strcasestr(text, s->word);
}

/* Notes one thing; rest: all that is said of it beside its name and summary. */
static void look(search *s, const char *name, const char *summary, const char *rest) {
    int rank = has(name, s) ? 0 : has(summary, s) ? 1 : has(rest, s) ? 2 : RANKS;
    if (rank == RANKS)
        return;
    page_put(&s->found[rank], "  %-24s ", name);
    if (strlen(name) > 24)
        page_put(&s->found[rank], "\n%27s", "");
    page_wrap(&s->found[rank], 27, HELP_WIDTH, summary ? summary : "");
}

/* All texts of a form, one after the other. */
static void put_all(page *p, const signature *s) {
    const char *const texts[] = {s->form.summary, s->form.details, s->formula, s->source};
    for (size_t i = 0; i < sizeof texts / sizeof *texts; i++)
        page_put(p, "%s ", texts[i] ? texts[i] : "");
    for (size_t i = 0; i < s->nhead + s->nkey; i++) {
        const slot *one = i < s->nhead ? &s->head[i] : &s->key[i - s->nhead];
        page_put(p, "%s %s ", one->name, one->summary ? one->summary : "");
        for (size_t k = 0; k < one->nchoices; k++)
            page_put(p, "%s ", one->choices[k]);
    }
    for (size_t i = 0; i < s->nchoices; i++)
        page_put(p, "%s ", s->choices[i].summary);
}

/* A command of few forms is one find; of many, each form is: "dump image". */
static void look_at_command(search *s, const command_table *t, const char *name) {
    const signature *list[HELP_FORMS_MAX];
    size_t n = signature_forms(t, name, list, HELP_FORMS_MAX);
    const command_page *about = signature_page(t, name);
    page rest = {0};
    page_put(&rest, "%s ", about && about->details ? about->details : "");
    for (size_t i = 0; i < n; i++) {
        page form = {0};
        const char *style = signature_style(list[i]);
        put_all(&form, list[i]);
        char *full = *style ? alloc_format("%s %s", name, style) : alloc_copy(name);
        if (*style)
            look(s, full, list[i]->form.summary, form.chars);
        else
            page_put(&rest, "%s", form.chars);
        free(full);
        free(form.chars);
    }
    look(s, name, about ? about->summary : list[0]->form.summary, rest.chars);
    free(rest.chars);
}

static void look_at_topic(search *s, const topic *t) {
    page rest = {0};
    for (size_t i = 0; i < t->nparts; i++)
        page_put(&rest, "%s %s ", t->parts[i].text, t->parts[i].example ? t->parts[i].example : "");
    for (const char *const *w = t->words; w && *w; w++)
        page_put(&rest, "%s ", *w);
    look(s, t->name, t->title, rest.chars);
    free(rest.chars);
}

static void look_everywhere(search *s, const command_table *t) {
    const char *name;
    for (size_t i = 0; (name = signature_command(t, i)); i++)
        look_at_command(s, t, name);
    for (size_t i = 0; i < control_word_count; i++)
        look(s, control_words[i].name, control_words[i].summary, control_words[i].details);
    for (size_t i = 0; i < topic_count; i++)
        look_at_topic(s, &topic_list[i]);
    for (size_t i = 0; i < value_style_count; i++)
        look(s, value_styles[i].name, value_styles[i].summary, value_styles[i].fields);
    for (size_t i = 0; i < function_style_count; i++)
        look(s, function_styles[i].signature, function_styles[i].summary, NULL);
    for (size_t i = 0; i < reduction_style_count; i++)
        look(s, reduction_styles[i].signature, reduction_styles[i].summary, NULL);
}

char *help_search(interp *in, const char *text, diag *d) {
    search s = {.word = text};
    page all = {0};
    look_everywhere(&s, in->host->commands);
    for (int i = 0; i < RANKS; i++) {
        page_put(&all, "%s", s.found[i].chars ? s.found[i].chars : "");
        free(s.found[i].chars);
    }
    if (!all.n) {
        free(all.chars);
        diag_error(d, "nothing has to do with '%s'", text);
        diag_help(d, "a part of a word is enough; 'help' lists commands and topics");
        return NULL;
    }
    all.chars[all.n - 1] = '\0'; /* the last line end */
    return all.chars;
}

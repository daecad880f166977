/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Every record as JSON (RFC 8259), for programs that edit, colour or check scripts. The schema is in sarcina(1). */
#include "script/help.h"

#include "analysis/value.h"
#include "script/control.h"
#include "script/function.h"
#include "script/kind.h"
#include "script/reduction.h"
#include "script/topic.h"

#include <stdlib.h>
#include <string.h>

void help_json_text(page *p, const char *text) {
    if (!text) {
        page_put(p, "null");
        return;
    }
    page_put(p, "\"");
    for (const char *c = text; *c; c++)
        if (*c == '"' || *c == '\\')
            page_put(p, "\\%c", *c);
        else if (*c == '\n')
            page_put(p, "\\n");
        else if ((unsigned char)*c < ' ')
            page_put(p, "\\u%04x", (unsigned)*c);
        else
            page_put_n(p, c, 1);
    page_put(p, "\"");
}

void help_json_member(page *p, const char *name, const char *text) {
    char last = p->n ? p->chars[p->n - 1] : '{';
    page_put(p, "%s\"%s\": ", last == '{' ? "" : ", ", name);
    help_json_text(p, text);
}

static void put_choices(page *p, const signature *form, const slot *s) {
    page_put(p, ", \"choices\": [");
    for (size_t i = 0; i < s->nchoices; i++) {
        page_put(p, "%s{", i ? ", " : "");
        help_json_member(p, "name", s->choices[i]);
        help_json_member(p, "summary", signature_choice(form, s->choices[i]));
        page_put(p, "}");
    }
    page_put(p, "]");
}

static void put_slot(page *p, const command_table *t, const signature *form, const slot *s) {
    page kind = {0};
    page_put(p, "{");
    help_json_member(p, "name", s->name);
    if (s->kind == SLOT_LITERAL) {
        page_put(p, ", \"literal\": true}");
        return;
    }
    kind_put(&kind, t, s);
    help_json_member(p, "kind", s->nchoices ? "choice" : s->kind_name);
    help_json_member(p, "takes", kind.chars);
    help_json_member(p, "summary", s->summary);
    help_json_member(p, "default", s->initial);
    help_json_member(p, "least", s->lo_text);
    help_json_member(p, "most", s->hi_text);
    page_put(p, ", \"above_least\": %s, \"below_most\": %s", s->lo_open ? "true" : "false",
             s->hi_open ? "true" : "false");
    page_put(p, ", \"required\": %s, \"group\": %d, \"optional\": %s, \"many\": %s, \"defines\": %s",
             s->required ? "true" : "false", s->group, s->optional ? "true" : "false", s->many ? "true" : "false",
             s->kind == SLOT_NEW ? "true" : "false");
    page_put(p, ", \"distribution\": %s, \"percent\": %s, \"all\": %s", s->spread ? "true" : "false",
             s->percent ? "true" : "false", s->star ? "true" : "false");
    put_choices(p, form, s);
    page_put(p, "}");
    free(kind.chars);
}

static void put_form(page *p, const command_table *t, const signature *s) {
    char *usage = signature_usage(s);
    page_put(p, "{");
    help_json_member(p, "usage", usage);
    help_json_member(p, "summary", s->form.summary);
    help_json_member(p, "details", s->form.details);
    help_json_member(p, "formula", s->formula);
    help_json_member(p, "source", s->source);
    help_json_member(p, "example", s->form.example);
    page_put(p, ", \"off\": %s, \"head\": [", s->off_at ? "true" : "false");
    for (size_t i = 0; i < s->nhead; i++) {
        page_put(p, "%s", i ? ", " : "");
        put_slot(p, t, s, &s->head[i]);
    }
    page_put(p, "], \"keywords\": [");
    for (size_t i = 0; i < s->nkey; i++) {
        page_put(p, "%s", i ? ", " : "");
        put_slot(p, t, s, &s->key[i]);
    }
    page_put(p, "]}");
    free(usage);
}

static void put_command(page *p, const command_table *t, const char *name) {
    const signature *list[HELP_FORMS_MAX];
    size_t n = signature_forms(t, name, list, HELP_FORMS_MAX);
    const command_page *about = signature_page(t, name);
    page_put(p, "{");
    help_json_member(p, "name", name);
    help_json_member(p, "topic", about ? about->topic : NULL);
    help_json_member(p, "summary", about ? about->summary : NULL);
    help_json_member(p, "details", about ? about->details : NULL);
    help_json_member(p, "see", about ? about->see : NULL);
    page_put(p, ", \"forms\": [");
    for (size_t i = 0; i < n; i++) {
        page_put(p, "%s\n    ", i ? "," : "");
        put_form(p, t, list[i]);
    }
    page_put(p, "]}");
}

static void put_values(page *p) {
    static const char *const scopes[] = {"cell", "scene", "analysis"};
    page_put(p, ",\n\"values\": [");
    for (size_t i = 0; i < value_style_count; i++) {
        const value_style *s = &value_styles[i];
        page_put(p, "%s\n  {", i ? "," : "");
        help_json_member(p, "name", s->name);
        help_json_member(p, "scope", scopes[s->scope]);
        help_json_member(p, "dimension", s->dimension);
        help_json_member(p, "summary", s->summary);
        help_json_member(p, "source", s->source);
        page_put(p, ", \"fields\": [");
        for (size_t k = 0; k < value_field_count(s); k++) {
            char field[32], buffer[48];
            dim d;
            value_field(s, k, field, &d);
            page_put(p, "%s{", k ? ", " : "");
            help_json_member(p, "name", field);
            help_json_member(p, "dimension", dim_name(d, buffer));
            page_put(p, "}");
        }
        page_put(p, "]}");
    }
    page_put(p, "]");
}

static void put_entry(page *p, bool first, const char *name, const char *usage, const char *summary) {
    page_put(p, "%s\n  {", first ? "" : ",");
    help_json_member(p, "name", name);
    help_json_member(p, "usage", usage);
    help_json_member(p, "summary", summary);
    page_put(p, "}");
}

char *help_json(const command_table *t) {
    page p = {0};
    const char *name;
    page_put(&p, "\"commands\": [");
    for (size_t i = 0; (name = signature_command(t, i)); i++) {
        page_put(&p, "%s\n  ", i ? "," : "");
        put_command(&p, t, name);
    }
    page_put(&p, "]");
    put_values(&p);
    page_put(&p, ",\n\"functions\": [");
    for (size_t i = 0; i < function_style_count; i++)
        put_entry(&p, i == 0, function_styles[i].name, function_styles[i].signature, function_styles[i].summary);
    page_put(&p, "],\n\"reductions\": [");
    for (size_t i = 0; i < reduction_style_count; i++)
        put_entry(&p, i == 0, reduction_styles[i].name, reduction_styles[i].signature, reduction_styles[i].summary);
    page_put(&p, "],\n\"blocks\": [");
    for (size_t i = 0; i < control_word_count; i++)
        put_entry(&p, i == 0, control_words[i].name, control_words[i].usage, control_words[i].summary);
    page_put(&p, "],\n\"topics\": [");
    for (size_t i = 0; i < topic_count; i++)
        put_entry(&p, i == 0, topic_list[i].name, NULL, topic_list[i].title);
    page_put(&p, "]");
    return p.chars;
}

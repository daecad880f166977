/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "script/signature.h"

#include "base/alloc.h"
#include "base/table.h"

#include <assert.h>
#include <ctype.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

static const struct {
    const char *name;
    slot_kind kind;
} kinds[] = {
    {"int", SLOT_INT},
    {"flag", SLOT_FLAG},
    {"nothing", SLOT_NOTHING},
    {"word", SLOT_WORD},
    {"text", SLOT_TEXT},
    {"file", SLOT_FILE},
    {"fileoff", SLOT_FILEOFF},
    {"rest", SLOT_REST},
    {"analysis0", SLOT_ANALYSIS},
    {"expr", SLOT_EXPR},
    {"cellexpr", SLOT_CELLEXPR},
    {"value", SLOT_VALUE},
    {"cell", SLOT_CELL},
    {"cell0", SLOT_CELL},
    {"formula", SLOT_FORMULA},
    {"command", SLOT_COMMAND},
    {"everycmd", SLOT_EVERY},
    {"cycles", SLOT_CYCLES},
    {"relaxation", SLOT_RELAXATION},
    {"orient", SLOT_ORIENT},
    {"bound", SLOT_BOUND},
    {"length3", SLOT_LENGTH3},
    {"size", SLOT_SIZE},
    {"view", SLOT_VIEW},
    {"range2", SLOT_RANGE2},
    {"any", SLOT_QUANTITY},
    {"quantity", SLOT_QUANTITY},
    {"color", SLOT_COLOR},
    {"cellcolor", SLOT_CELLCOLOR},
    {"columnformat", SLOT_COLUMNFORMAT},
    {"values", SLOT_WORDS},
    {"words", SLOT_WORDS},
};

/* Dimension of kinds that are numbers under another name. */
static void set_kind(slot *s) {
    ptrdiff_t row = table_find(kinds, TABLE_COUNT(kinds), sizeof *kinds, s->kind_name);
    if (row >= 0)
        s->kind = kinds[row].kind;
    else
        s->kind = dim_by_name(s->kind_name, &s->d) ? SLOT_NUMBER : SLOT_NAME;
    if (s->kind == SLOT_BOUND || s->kind == SLOT_LENGTH3)
        s->d = DIM_LENGTH;
    if (s->kind == SLOT_WORDS)
        s->many = s->optional = true;
    if (strcmp(s->kind_name, "cell0") == 0)
        s->optional = true;
    if (strcmp(s->kind_name, "cell0") == 0 || strcmp(s->kind_name, "analysis0") == 0)
        s->kind_name[strlen(s->kind_name) - 1] = '\0';
}

/* Copies up to a character of `stops` into a fixed room; returns behind it. */
static const char *copy_until(const char *text, const char *stops, char *out, size_t room) {
    size_t n = strcspn(text, stops);
    snprintf(out, room, "%.*s", (int)n, text);
    return text + n;
}

/* {a|b|c} at text; returns behind the brace. */
static const char *parse_choices(const char *text, slot *s) {
    s->kind = SLOT_CHOICE;
    size_t n = strcspn(text, "}");
    char *list = alloc_copy_n(text + 1, n - 1), *save;
    size_t capacity = 0;
    for (char *c = strtok_r(list, "|", &save); c; c = strtok_r(NULL, "|", &save)) {
        s->choices = alloc_grow(s->choices, &capacity, s->nchoices + 1, sizeof *s->choices);
        s->choices[s->nchoices++] = alloc_copy(c);
    }
    free(list);
    return text + n + (text[n] == '}');
}

static int parse_bound(units *u, const char *text, double *si, const char **copy, diag *d) {
    if (!*text)
        return SARCINA_OK;
    units_value v;
    *copy = alloc_copy(text);
    int status = units_read(u, text, strlen(text), &v, d);
    *si = v.si;
    return status;
}

/* [lo,hi) and its kin; returns behind it, NULL on an error. */
static const char *parse_range(units *u, const char *text, slot *s, diag *d) {
    char lo[32], hi[32];
    s->lo_open = *text == '(';
    const char *end = copy_until(text + 1, ",", lo, sizeof lo);
    end = copy_until(end + 1, ")]", hi, sizeof hi);
    s->hi_open = *end == ')';
    if (parse_bound(u, lo, &s->lo, &s->lo_text, d) != SARCINA_OK ||
        parse_bound(u, hi, &s->hi, &s->hi_text, d) != SARCINA_OK)
        return NULL;
    return end + 1;
}

static int parse_suffixes(units *u, const char *text, slot *s, diag *d) {
    while (*text) {
        if (*text == '~')
            s->spread = true;
        else if (*text == '%')
            s->percent = true;
        else if (*text == '*')
            s->star = true;
        else if (*text == '?')
            s->optional = true;
        else if (*text == '.')
            s->many = true;
        else if (*text == '!' && isdigit((unsigned char)text[1]))
            s->group = *++text - '0';
        else if (*text == '!')
            s->required = true;
        else if (*text != '[' && *text != '(')
            return diag_error(d, "the record of '%s' has '%s' at its end", s->name, text);
        if (*text == '[' || *text == '(') {
            text = parse_range(u, text, s, d);
            if (!text)
                return SARCINA_ERROR;
        } else {
            text++;
        }
    }
    return SARCINA_OK;
}

static int parse_slot(units *u, const char *spec, slot *s, diag *d) {
    *s = (slot){.lo = -INFINITY, .hi = INFINITY};
    const char *at = copy_until(spec, "=:", s->name, sizeof s->name);
    if (*at == '=') {
        size_t n = strcspn(at + 1, ":");
        s->initial = alloc_copy_n(at + 1, n);
        at += 1 + n;
    }
    if (*at != ':')
        return diag_error(d, "the record '%s' has no kind", spec);
    at++;
    if (*at == '{') {
        snprintf(s->kind_name, sizeof s->kind_name, "word");
        at = parse_choices(at, s);
    } else {
        bool defines = *at == '+';
        at = copy_until(at + defines, "~%!*.?[(", s->kind_name, sizeof s->kind_name);
        set_kind(s);
        if (defines)
            s->kind = SLOT_NEW;
    }
    return parse_suffixes(u, at, s, d);
}

static int parse_head(const char *text, units *u, signature *out, diag *d) {
    char *copy = alloc_copy(text), *save;
    size_t capacity = 0;
    int status = SARCINA_OK;
    for (char *w = strtok_r(copy, " ", &save); w && !status; w = strtok_r(NULL, " ", &save)) {
        if (strcmp(w, "@off") == 0) {
            out->off_at = out->nhead;
            continue;
        }
        out->head = alloc_grow(out->head, &capacity, out->nhead + 1, sizeof *out->head);
        slot *s = &out->head[out->nhead++];
        *s = (slot){.kind = SLOT_LITERAL};
        if (strchr(w, ':'))
            status = parse_slot(u, w, s, d);
        else
            snprintf(s->name, sizeof s->name, "%s", w);
    }
    free(copy);
    return status;
}

static void slot_free(slot *s) {
    free(s->initial);
    free((void *)s->lo_text);
    free((void *)s->hi_text);
    for (size_t i = 0; i < s->nchoices; i++)
        free(s->choices[i]);
    free(s->choices);
}

void signature_free(signature *s) {
    for (size_t i = 0; i < s->nhead; i++)
        slot_free(&s->head[i]);
    for (size_t i = 0; i < s->nkey; i++)
        slot_free(&s->key[i]);
    for (size_t i = 0; i < s->nchoices; i++) {
        free(s->choices[i].choice);
        free(s->choices[i].summary);
    }
    free(s->choices);
    free(s->head);
    free(s->key);
    free(s->head_text);
    *s = (signature){0};
}

int signature_parse(const command_form *form, units *u, signature *out, diag *d) {
    *out = (signature){.form = *form, .head_text = alloc_copy(form->head)};
    out->form.head = out->head_text;
    int status = parse_head(form->head, u, out, d);
    out->key = alloc_zeroed(form->nparams, sizeof *out->key);
    for (size_t i = 0; i < form->nparams && !status; i++) {
        slot s;
        status = parse_slot(u, form->params[i].spec, &s, d);
        slot *in_place = NULL;
        for (size_t k = 1; k < out->nhead; k++)
            if (out->head[k].kind != SLOT_LITERAL && strcmp(out->head[k].name, s.name) == 0)
                in_place = &out->head[k];
        if (in_place) {
            in_place->summary = form->params[i].summary;
            slot_free(&s);
        } else {
            out->key[out->nkey] = s;
            out->key[out->nkey++].summary = form->params[i].summary;
        }
    }
    return status;
}

const slot *signature_find(const signature *s, const char *name, size_t *index) {
    for (size_t i = 0; i < s->nhead + s->nkey; i++) {
        const slot *one = i < s->nhead ? &s->head[i] : &s->key[i - s->nhead];
        if (one->kind != SLOT_LITERAL && strcmp(one->name, name) == 0) {
            *index = i;
            return one;
        }
    }
    return NULL;
}

/* ---- the table ---- */

command_table *command_table_create(units *u) {
    command_table *t = alloc_zeroed(1, sizeof *t);
    t->units = u;
    return t;
}

void command_table_free(command_table *t) {
    if (!t)
        return;
    for (size_t i = 0; i < t->count; i++)
        signature_free(&t->list[i]);
    free(t->list);
    free(t->classes);
    free(t);
}

void command_add(command_table *t, const command_form *forms, size_t n) {
    for (size_t i = 0; i < n; i++) {
        diag d = {0};
        t->list = alloc_grow(t->list, &t->capacity, t->count + 1, sizeof *t->list);
        int status = signature_parse(&forms[i], t->units, &t->list[t->count++], &d);
        assert(status == SARCINA_OK && "a record's notation is wrong");
        (void)status;
    }
}

void command_add_style(command_table *t, const command_form *common, const char *head, const char *summary,
                       const param *params, size_t nparams, int style) {
    command_form form = *common;
    form.head = head;
    form.summary = summary;
    form.params = params;
    form.nparams = nparams;
    form.style = style;
    command_add(t, &form, 1);
}

static signature *last_form(command_table *t) {
    assert(t->count && "there is no form yet to add this to");
    return &t->list[t->count - 1];
}

void command_cite(command_table *t, const char *formula, const char *source) {
    last_form(t)->formula = formula;
    last_form(t)->source = source;
}

void command_add_choice(command_table *t, const char *choice, const char *summary) {
    signature *s = last_form(t);
    s->choices = alloc_resize(s->choices, s->nchoices + 1, sizeof *s->choices);
    s->choices[s->nchoices++] = (choice_text){alloc_copy(choice), alloc_copy(summary)};
}

const char *signature_choice(const signature *s, const char *choice) {
    for (size_t i = 0; i < s->nchoices; i++)
        if (strcmp(s->choices[i].choice, choice) == 0)
            return s->choices[i].summary;
    return NULL;
}

void command_add_pages(command_table *t, const command_page *pages, size_t n) {
    assert(!t->pages && "the pages are added once");
    t->pages = pages;
    t->npages = n;
}

const command_page *signature_page(const command_table *t, const char *command) {
    ptrdiff_t row = table_find(t->pages, t->npages, sizeof *t->pages, command);
    return row < 0 ? NULL : &t->pages[row];
}

size_t signature_forms(const command_table *t, const char *command, const signature **list, size_t room) {
    size_t n = 0;
    for (size_t i = 0; i < t->count; i++)
        if (strcmp(t->list[i].head[0].name, command) == 0 && n++ < room)
            list[n - 1] = &t->list[i];
    return n;
}

const char *signature_command(const command_table *t, size_t i) {
    for (size_t row = 0; row < t->count; row++) {
        const signature *first = NULL;
        signature_forms(t, t->list[row].head[0].name, &first, 1);
        if (first == &t->list[row] && i-- == 0)
            return first->head[0].name;
    }
    return NULL;
}

const char *signature_style(const signature *s) {
    for (size_t i = 1; i < s->nhead; i++)
        if (s->head[i].kind == SLOT_LITERAL)
            return s->head[i].name;
    return "";
}

void command_set_prelude(command_table *t, const char *script, const command_file *files, size_t nfiles) {
    t->prelude = script;
    t->files = files;
    t->nfiles = nfiles;
}

void command_add_class(command_table *t, const name_class *c) {
    t->classes = alloc_grow(t->classes, &t->class_capacity, t->nclasses + 1, sizeof *t->classes);
    t->classes[t->nclasses++] = c;
}

void command_set_line(command_table *t, void (*begins)(interp *in),
                      void (*ended)(interp *in, const char *text, int status)) {
    t->line_begins = begins;
    t->line_ended = ended;
}

void command_set_checked(command_table *t, void (*checked)(interp *in)) {
    t->client_checked = checked;
}

void command_set_client(command_table *t, void *(*create)(interp *in), void (*free_client)(void *client),
                        void (*loop_end)(interp *in)) {
    t->client_create = create;
    t->client_free = free_client;
    t->client_loop_end = loop_end;
}

/* ---- usage ---- */

typedef struct usage {
    char *text;
    size_t n, capacity;
} usage;

static void put(usage *u, const char *text) {
    size_t length = strlen(text);
    u->text = alloc_grow(u->text, &u->capacity, u->n + length + 1, 1);
    memcpy(u->text + u->n, text, length + 1);
    u->n += length;
}

static void put_upper(usage *u, const char *text) {
    char upper[64];
    size_t n = 0;
    for (; text[n] && n + 1 < sizeof upper; n++)
        upper[n] = (char)toupper((unsigned char)text[n]);
    upper[n] = '\0';
    put(u, upper);
}

/* What stands for the value of an argument. */
static void put_kind(usage *u, const slot *s) {
    static const struct {
        slot_kind kind;
        const char *text;
    } texts[] = {
        {SLOT_FLAG, "yes|no"},
        {SLOT_CYCLES, "CYCLES|TIME"},
        {SLOT_EVERY, "CYCLES|TIME \"COMMAND\"..."},
        {SLOT_RELAXATION, "TIME|to FORCE [within TIME]"},
        {SLOT_ORIENT, "x|y|z|xy|random|UX UY UZ"},
        {SLOT_FILEOFF, "FILE|off"},
        {SLOT_LENGTH3, "X Y Z"},
        {SLOT_SIZE, "WIDTH HEIGHT"},
        {SLOT_VIEW, "top|side|front|iso|ANGLE ANGLE"},
        {SLOT_RANGE2, "LO HI"},
        {SLOT_BOUND, "LENGTH|INF"},
        {SLOT_COLUMNFORMAT, "COLUMN FORMAT"},
        {SLOT_INT, "N"},
        {SLOT_CELLCOLOR, "COLOR"},
        {SLOT_COMMAND, "\"COMMAND\""},
        {SLOT_EXPR, "EXPR"},
        {SLOT_CELLEXPR, "EXPR"},
        {SLOT_FORMULA, "EXPR"},
        {SLOT_QUANTITY, "NUMBER"},
    };
    for (size_t i = 0; i < TABLE_COUNT(texts); i++)
        if (texts[i].kind == s->kind) {
            put(u, texts[i].text);
            return;
        }
    for (size_t i = 0; i < s->nchoices; i++) {
        put(u, i ? "|" : "");
        put(u, s->choices[i]);
    }
    if (!s->nchoices)
        put_upper(u, s->kind_name);
    if (s->percent)
        put(u, "|PERCENT");
    if (s->star)
        put(u, "|*");
    if (s->spread)
        put(u, " [sd ...]");
    if (s->many)
        put(u, "...");
}

static void put_keyword(usage *u, const slot *s) {
    put(u, s->name);
    if (s->kind == SLOT_NOTHING)
        return;
    put(u, " ");
    put_kind(u, s);
}

/* A group of which one is required: (a A | b B). */
static void put_group(usage *u, const signature *s, int group) {
    const char *before = " (";
    for (size_t i = 0; i < s->nkey; i++)
        if (s->key[i].group == group) {
            put(u, before);
            put_keyword(u, &s->key[i]);
            before = " | ";
        }
    put(u, ")");
}

char *signature_usage(const signature *s) {
    usage u = {0};
    for (size_t i = 0; i < s->nhead; i++) {
        const slot *h = &s->head[i];
        put(&u, i ? " " : "");
        if (h->optional)
            put(&u, "[");
        if (h->kind == SLOT_CHOICE)
            put_kind(&u, h);
        else
            put(&u, h->name);
        if (h->kind != SLOT_LITERAL && h->many)
            put(&u, "...");
        if (h->optional)
            put(&u, "]");
    }
    if (s->off_at)
        put(&u, " [off]");
    int done = 0;
    for (size_t i = 0; i < s->nkey; i++) {
        const slot *k = &s->key[i];
        if (k->group && k->group > done) {
            done = k->group;
            put_group(&u, s, k->group);
        } else if (!k->group) {
            put(&u, k->required ? " " : " [");
            put_keyword(&u, k);
            put(&u, k->required ? "" : "]");
        }
    }
    return u.text;
}

/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "extremes/table.h"

#include "base/alloc.h"
#include "relax/relax.h"

#include <stdbool.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

const char *const tier_names[TIER_COUNT] = {"quick", "full", "long"};

enum { SCENES_MAX = 40 };

typedef struct scene_lines {
    const char *name;
    size_t n;
    const char *lines[LINES_MAX];
} scene_lines;

typedef struct reader {
    extreme_table *table;
    size_t capacity;
    int line, faults;
    scene_lines scenes[SCENES_MAX];
    size_t nscenes;
    bool in_scene;
} reader;

static void fault(reader *r, const char *what, const char *where) {
    fprintf(stderr, "cases.tbl:%d: %s: '%s'\n", r->line, what, where);
    r->faults++;
}

static char *trim(char *text) {
    text += strspn(text, " \t");
    size_t n = strlen(text);
    while (n && strchr(" \t\r\n", text[n - 1]))
        text[--n] = '\0';
    return text;
}

/* The rest of a line that begins with a word; NULL when it does not. */
static char *after_word(char *line, const char *word) {
    size_t n = strlen(word);
    return strncmp(line, word, n) == 0 && line[n] == ' ' ? trim(line + n) : NULL;
}

static char *next_word(char **rest) {
    char *word = *rest;
    size_t n = strcspn(word, " ");
    *rest = word[n] ? trim(word + n + 1) : word + n;
    word[n] = '\0';
    return word;
}

static void add_line(reader *r, const char **lines, size_t *n, const char *line) {
    if (*n < LINES_MAX)
        lines[(*n)++] = line;
    else
        fault(r, "too many lines", line);
}

/* scene NAME [on OTHER] */
static void begin_scene(reader *r, char *rest) {
    if (r->nscenes == SCENES_MAX) {
        fault(r, "too many scenes", rest);
        return;
    }
    scene_lines *s = &r->scenes[r->nscenes++];
    s->name = next_word(&rest);
    s->n = 0;
    r->in_scene = true;
}

static void take_scene(reader *r, extreme *e, const char *name) {
    for (size_t i = 0; i < r->nscenes; i++) {
        if (strcmp(r->scenes[i].name, name) != 0)
            continue;
        for (size_t k = 0; k < r->scenes[i].n; k++)
            add_line(r, e->lines, &e->nlines, r->scenes[i].lines[k]);
        return;
    }
    fault(r, "no such scene", name);
}

/* case ID TIER SCENE|- TITLE */
static void begin_case(reader *r, char *rest) {
    extreme_table *t = r->table;
    t->list = alloc_grow(t->list, &r->capacity, t->n + 1, sizeof *t->list);
    extreme *e = &t->list[t->n++];
    memset(e, 0, sizeof *e);
    r->in_scene = false;
    e->line = r->line;
    e->id = next_word(&rest);
    const char *of = next_word(&rest), *scene = next_word(&rest);
    e->tier = TIER_COUNT;
    for (int i = 0; i < TIER_COUNT; i++)
        if (strcmp(of, tier_names[i]) == 0)
            e->tier = (tier)i;
    if (e->tier == TIER_COUNT)
        fault(r, "no such tier", of);
    e->title = rest;
    if (strcmp(scene, "-") != 0)
        take_scene(r, e, scene);
}

/* "PRESET PRESET ... : CLAUSE; CLAUSE", for all presets when it says "all". */
static void read_due(reader *r, extreme *e, char *rest, int refused) {
    char *colon = strstr(rest, ": "), *save;
    if (!colon) {
        fault(r, "no colon", rest);
        return;
    }
    *colon = '\0';
    due d = {.refused = refused};
    for (char *c = strtok_r(colon + 2, ";", &save); c && d.nclauses < CLAUSES_MAX; c = strtok_r(NULL, ";", &save))
        d.clause[d.nclauses++] = trim(c);
    for (char *name = strtok_r(rest, " ", &save); name; name = strtok_r(NULL, " ", &save)) {
        bool found = false;
        for (size_t i = 0; i < accuracy_preset_count; i++)
            if (strcmp(name, "all") == 0 || strcmp(name, accuracy_presets[i].name) == 0) {
                if (e->due[i].nclauses)
                    fault(r, "said twice of a preset", name);
                e->due[i] = d;
                found = true;
            }
        if (!found)
            fault(r, "no such preset", name);
    }
}

static void read_line(reader *r, char *line) {
    char *rest;
    if (!*line || *line == '#')
        return;
    if ((rest = after_word(line, "scene"))) {
        begin_scene(r, rest);
        return;
    }
    if ((rest = after_word(line, "case"))) {
        begin_case(r, rest);
        return;
    }
    if (r->in_scene) {
        scene_lines *s = &r->scenes[r->nscenes - 1];
        add_line(r, s->lines, &s->n, line);
        return;
    }
    if (r->table->n == 0) {
        fault(r, "belongs to no case", line);
        return;
    }
    extreme *e = &r->table->list[r->table->n - 1];
    if ((rest = after_word(line, "holds")))
        read_due(r, e, rest, 0);
    else if ((rest = after_word(line, "refused")))
        read_due(r, e, rest, SARCINA_NUMERICAL);
    else if ((rest = after_word(line, "declined")))
        read_due(r, e, rest, SARCINA_ERROR);
    else if ((rest = after_word(line, "then")))
        add_line(r, e->after, &e->nafter, rest);
    else
        add_line(r, e->lines, &e->nlines, line);
}

static char *read_whole(const char *path) {
    FILE *f = fopen(path, "r");
    if (!f)
        return NULL;
    char *text = NULL;
    size_t capacity = 0;
    ssize_t n = getdelim(&text, &capacity, '\0', f);
    fclose(f);
    if (n >= 0)
        return text;
    free(text);
    return NULL;
}

/* Every preset has its answer, every refusal by the mechanics a way to go on. */
static void check_case(reader *r, const extreme *e) {
    bool refused = false;
    r->line = e->line;
    for (size_t i = 0; i < accuracy_preset_count; i++) {
        if (!e->due[i].nclauses)
            fault(r, e->id, accuracy_presets[i].name);
        refused = refused || e->due[i].refused == SARCINA_NUMERICAL;
    }
    if (refused && !e->nafter)
        fault(r, "nothing goes on after the refusal", e->id);
    if (e->nlines == 0)
        fault(r, "nothing is done", e->id);
}

int table_read(const char *path, extreme_table *t) {
    *t = (extreme_table){.text = read_whole(path)};
    reader r = {.table = t};
    if (!t->text) {
        fprintf(stderr, "cannot read %s\n", path);
        return -1;
    }
    char *rest = t->text, *line;
    while ((line = strsep(&rest, "\n"))) {
        r.line++;
        read_line(&r, trim(line));
    }
    for (size_t i = 0; i < t->n; i++)
        check_case(&r, &t->list[i]);
    return r.faults || t->n == 0 ? -1 : 0;
}

void table_free(extreme_table *t) {
    free(t->list);
    free(t->text);
}

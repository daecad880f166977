/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Pages whose prose is written by hand: man/src/NAME.SECTION, in mdoc(7). A line that begins with @ stands for what
 * comes from the tables of the program:
 *
 *     @options @commands @topics @prelude @foreign    options, commands by topic, topics, the prelude, LAMMPS's words
 *     @warts                                          the scripts of tests/language/warts, and what they answer
 *     @rows NAME                                      a table of topics, as help shows it
 *     @example ... @prints ... @end                   lines of a script, and what they print; both run as tests
 *     @shell ... @end                                 lines of a shell, run as tests
 *     @file PATH                                      a file of the project as it is: a table that a study has left
 */
#include "app/mandoc.h"

#include "app/options.h"
#include "base/alloc.h"
#include "base/table.h"
#include "script/foreign.h"

#include <dirent.h>
#include <errno.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

/* ---- what comes from tables ---- */

void mandoc_rows(page *p, topic_row *rows) {
    page name = {0}, text = {0};
    page_put(p, ".Bl -tag -width accelerationx -compact\n");
    for (size_t i = 0; rows(i, &name, &text); i++) {
        page_put(p, ".It ");
        mandoc_escape(p, name.chars);
        page_put(p, "\n");
        if (text.n)
            mandoc_text(p, text.chars);
        name.n = text.n = 0;
    }
    page_put(p, ".El\n");
    free(name.chars);
    free(text.chars);
}

static void put_topic(page *p, const topic *t) {
    page_put(p, ".Sh ");
    for (const char *c = t->title; *c; c++)
        page_put(p, "%c", *c >= 'a' && *c <= 'z' ? *c - 'a' + 'A' : *c);
    page_put(p, "\n");
    for (size_t i = 0; i < t->nparts; i++) {
        page_put(p, "%s", i ? ".Pp\n" : "");
        mandoc_text(p, t->parts[i].text);
        if (t->parts[i].example)
            mandoc_literal(p, t->parts[i].example);
        if (t->parts[i].prints) {
            page_put(p, "prints\n");
            mandoc_literal(p, t->parts[i].prints);
        }
    }
    if (t->rows) {
        page_put(p, ".Pp\n");
        mandoc_rows(p, t->rows);
    }
}

void mandoc_topics(page *p) {
    for (size_t i = 0; i < topic_count; i++)
        put_topic(p, &topic_list[i]);
}

static void put_options(page *p) {
    option_text o;
    page_put(p, ".Bl -tag -width Ds\n");
    for (size_t i = 0; options_list(i, &o); i++) {
        if (!o.takes)
            continue;
        page text = {0};
        page_put(p, ".It Fl ");
        mandoc_escape(p, o.name);
        page_put(p, "%s", *o.takes ? " Ar " : "");
        mandoc_escape(p, o.takes);
        page_put(p, "\n");
        page_sentence(&text, o.summary);
        mandoc_text(p, text.chars);
        free(text.chars);
    }
    page_put(p, ".El\n");
}

static void put_commands(page *p, const command_table *t) {
    const char *heading = "";
    for (size_t i = 0; i < t->npages; i++) {
        const command_page *about = &t->pages[i];
        if (strcmp(about->topic, heading) != 0)
            page_put(p, "%s.Ss %s\n.Bl -tag -width write_restartxxxxxxxx -compact\n", i ? ".El\n" : "", about->topic);
        heading = about->topic;
        page text = {0};
        page_put(p, ".It Xr sarcina-%s 7\n", about->name);
        page_sentence(&text, about->summary);
        mandoc_text(p, text.chars);
        free(text.chars);
    }
    page_put(p, ".El\n");
}

static void put_prelude(page *p, const command_table *t) {
    mandoc_literal(p, t->prelude);
    for (size_t i = 0; i < t->nfiles; i++) {
        page_put(p, "and in the folder stands\n.Pa %s :\n", t->files[i].name);
        mandoc_literal(p, t->files[i].text);
    }
}

static void put_foreign(page *p) {
    foreign_word w;
    page_put(p, ".Bl -tag -width reset_timestepx -compact\n");
    for (size_t i = 0; foreign_list(i, &w); i++) {
        page text = {0};
        page_put(p, ".It Ic %s\n", w.name);
        page_sentence(&text, w.instead);
        mandoc_text(p, text.chars);
        free(text.chars);
    }
    page_put(p, ".El\n");
}

/* ---- reading a page ---- */

typedef struct reading {
    mandoc *m;
    const char *path;
    FILE *file;
    page *out;
    char *line;
    size_t room;
    unsigned number;
} reading;

static bool next_line(reading *r) {
    if (getline(&r->line, &r->room, r->file) < 0)
        return false;
    r->line[strcspn(r->line, "\n")] = '\0';
    r->number++;
    return true;
}

static void complain(const reading *r, const char *what) {
    fprintf(stderr, "%s:%u: %s\n", r->path, r->number, what);
    r->m->failed = true;
}

/* Lines up to @end as they are; those behind @prints are what the others print. */
static void put_example(reading *r) {
    page text = {0};
    while (next_line(r) && strcmp(r->line, "@end") != 0) {
        if (strcmp(r->line, "@prints") != 0) {
            page_put(&text, "%s\n", r->line);
            continue;
        }
        mandoc_literal(r->out, text.chars ? text.chars : "");
        page_put(r->out, "prints\n");
        text.n = 0;
    }
    if (strcmp(r->line, "@end") != 0)
        complain(r, "@example lacks its @end");
    mandoc_literal(r->out, text.n ? text.chars : "");
    free(text.chars);
}

/* A file as literal lines, without those of its head that begin with '#', and without carriage returns. */
static void put_file(reading *r, const char *path, bool skip_head) {
    FILE *f = fopen(path, "r");
    page text = {0};
    char *line = NULL;
    size_t room = 0;
    while (f && getline(&line, &room, f) > 0) {
        line[strcspn(line, "\r\n")] = '\0';
        skip_head = skip_head && *line == '#';
        if (!skip_head)
            page_put(&text, "%s\n", line);
    }
    if (f)
        fclose(f);
    else
        complain(r, path);
    mandoc_literal(r->out, text.chars ? text.chars : "");
    free(text.chars);
    free(line);
}

/* "# KEY: TEXT" of a wart's head as a paragraph behind `before`; KEY wart is the title. */
static void put_wart_head(reading *r, const char *path) {
    static const struct {
        const char *key, *before;
    } keys[] = {
        {"# wart: ", ".Ss "}, {"# lammps: ", "LAMMPS: "}, {"# here: ", ".Pp\nHere: "}, {"# run: ", ".Pp\nRun by: "}};
    FILE *f = fopen(path, "r");
    char *line = NULL;
    size_t room = 0;
    while (f && getline(&line, &room, f) > 0 && *line == '#') {
        line[strcspn(line, "\r\n")] = '\0';
        for (size_t i = 0; i < TABLE_COUNT(keys); i++)
            if (strncmp(line, keys[i].key, strlen(keys[i].key)) == 0) {
                page_put(r->out, "%s", keys[i].before);
                mandoc_text(r->out, line + strlen(keys[i].key));
            }
    }
    free(line);
    if (f)
        fclose(f);
}

/* Every script of tests/language/warts, and its answer beside it. */
static void put_warts(reading *r) {
    struct dirent **entries;
    char *folder = alloc_format("%s/tests/language/warts", r->m->source);
    int n = scandir(folder, &entries, NULL, alphasort);
    for (int i = 0; i < n; i++) {
        const char *dot = strrchr(entries[i]->d_name, '.');
        if (dot && strcmp(dot, ".in") == 0) {
            char *script = alloc_format("%s/%s", folder, entries[i]->d_name);
            char *answer = alloc_format("%s/%.*s.out", folder, (int)(dot - entries[i]->d_name), entries[i]->d_name);
            put_wart_head(r, script);
            put_file(r, script, true);
            page_put(r->out, "answers\n");
            put_file(r, answer, false);
            free(script);
            free(answer);
        }
        free(entries[i]);
    }
    if (n >= 0)
        free(entries);
    else
        complain(r, "there are no warts");
    free(folder);
}

static void put_named_rows(reading *r, const char *name) {
    const topic *t = topic_find(name);
    if (t && t->rows)
        mandoc_rows(r->out, t->rows);
    else
        complain(r, "no such table");
}

static void put_project_file(reading *r, const char *name) {
    char *path = alloc_format("%s/%s", r->m->source, name);
    put_file(r, path, false);
    free(path);
}

static void put_directive(reading *r) {
    const command_table *t = r->m->commands;
    const char *line = r->line;
    if (strcmp(line, "@options") == 0)
        put_options(r->out);
    else if (strcmp(line, "@commands") == 0)
        put_commands(r->out, t);
    else if (strcmp(line, "@topics") == 0)
        mandoc_topics(r->out);
    else if (strcmp(line, "@prelude") == 0)
        put_prelude(r->out, t);
    else if (strcmp(line, "@foreign") == 0)
        put_foreign(r->out);
    else if (strcmp(line, "@warts") == 0)
        put_warts(r);
    else if (strncmp(line, "@rows ", 6) == 0)
        put_named_rows(r, line + 6);
    else if (strncmp(line, "@file ", 6) == 0)
        put_project_file(r, line + 6);
    else if (strcmp(line, "@example") == 0 || strcmp(line, "@shell") == 0)
        put_example(r);
    else
        complain(r, "not known behind @");
}

/* NAME.SECTION: its first line is the summary, the others the page's body. */
static void write_source(mandoc *m, const char *name) {
    page out = {0};
    reading r = {.m = m, .path = alloc_format("%s/man/src/%s", m->source, name), .out = &out};
    const char *dot = strrchr(name, '.');
    char *target = alloc_format("man/%s", name), *stem = alloc_copy_n(name, (size_t)(dot - name));
    r.file = fopen(r.path, "r");
    if (!r.file || !next_line(&r)) {
        complain(&r, "cannot be read");
    } else {
        mandoc_begin(&out, stem, atoi(dot + 1), r.line);
        while (next_line(&r))
            if (*r.line == '@')
                put_directive(&r);
            else
                page_put(&out, "%s\n", r.line);
        mandoc_write(m, target, &out);
    }
    if (r.file)
        fclose(r.file);
    free(r.line);
    free(out.chars);
    free(target);
    free(stem);
    free((void *)r.path);
}

void mandoc_sources(mandoc *m) {
    struct dirent **entries;
    char *folder = alloc_format("%s/man/src", m->source);
    int n = scandir(folder, &entries, NULL, alphasort);
    if (n < 0) {
        fprintf(stderr, "%s: %s\n", folder, strerror(errno));
        m->failed = true;
    }
    for (int i = 0; i < n; i++) {
        if (entries[i]->d_name[0] != '.' && strrchr(entries[i]->d_name, '.'))
            write_source(m, entries[i]->d_name);
        free(entries[i]);
    }
    if (n >= 0)
        free(entries);
    free(folder);
}

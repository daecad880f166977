/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "app/test_run.h"

#include "app/table_diff.h"
#include "base/alloc.h"
#include "base/number.h"

#include <dirent.h>
#include <inttypes.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <unistd.h>

typedef struct tally {
    uint64_t passed, failed;
    size_t scripts;
} tally;

/* ---- finding scripts ---- */

typedef struct path_list {
    char **list;
    size_t n, capacity;
} path_list;

static void add_path(path_list *l, const char *path) {
    l->list = alloc_grow(l->list, &l->capacity, l->n + 1, sizeof *l->list);
    l->list[l->n++] = realpath(path, NULL);
}

static bool ends_with(const char *text, const char *end) {
    size_t n = strlen(text), m = strlen(end);
    return n >= m && strcmp(text + n - m, end) == 0;
}

/* Every *.test.in of a folder and those in it, in the order of their names. */
static void search_folder(path_list *l, const char *folder) {
    struct dirent **entries;
    int n = scandir(folder, &entries, NULL, alphasort);
    for (int i = 0; i < n; i++) {
        const char *name = entries[i]->d_name;
        char *path = alloc_format("%s/%s", folder, name);
        struct stat info;
        bool folder_too = stat(path, &info) == 0 && S_ISDIR(info.st_mode) && *name != '.';
        if (folder_too)
            search_folder(l, path);
        else if (ends_with(name, ".test.in"))
            add_path(l, path);
        free(path);
        free(entries[i]);
    }
    if (n >= 0)
        free(entries);
}

/* ---- a folder to run in ---- */

static void remove_folder(const char *folder) {
    struct dirent **entries;
    int n = scandir(folder, &entries, NULL, NULL);
    for (int i = 0; i < n; i++) {
        const char *name = entries[i]->d_name;
        char *path = alloc_format("%s/%s", folder, name);
        if (strcmp(name, ".") != 0 && strcmp(name, "..") != 0 && remove(path) != 0)
            remove_folder(path);
        free(path);
        free(entries[i]);
    }
    if (n >= 0)
        free(entries);
    rmdir(folder);
}

static char *enter_fresh_folder(char before[4096]) {
    const char *base = getenv("TMPDIR");
    char *folder = alloc_format("%s/sarcina-test-XXXXXX", base && *base ? base : "/tmp");
    if (!getcwd(before, 4096) || !mkdtemp(folder) || chdir(folder) != 0) {
        free(folder);
        return NULL;
    }
    return folder;
}

/* ---- reference tables ---- */

enum { TOLERANCES_MAX = 64 };

/* "rel R", "abs A", "column NAME" from the words of a header line; false when it reads otherwise. */
static bool read_tolerances(char *words, table_tolerance *list, size_t *n) {
    char *save;
    *n = 1;
    list[0] = (table_tolerance){.rel = 0};
    for (char *w = strtok_r(words, " \t\r\n", &save); w; w = strtok_r(NULL, " \t\r\n", &save)) {
        char *value = strtok_r(NULL, " \t\r\n", &save), *end;
        if (!value)
            return false;
        if (strcmp(w, "column") == 0) {
            if (*n == TOLERANCES_MAX)
                return false;
            list[*n] = list[0];
            snprintf(list[(*n)++].column, sizeof list->column, "%s", value);
            continue;
        }
        double x = strtod(value, &end);
        if (*end || (strcmp(w, "rel") != 0 && strcmp(w, "abs") != 0))
            return false;
        *(*w == 'r' ? &list[*n - 1].rel : &list[*n - 1].abs) = x;
    }
    return true;
}

static void count(tally *t, const diag *d, const char *script, bool holds) {
    if (holds)
        t->passed++;
    else
        t->failed++;
    if (!holds)
        fprintf(stderr, "%s: %s\n", script, d->message);
}

/* One "# ref:" line, behind its colon. */
static void compare_table(const char *script, char *line, tally *t) {
    table_tolerance list[TOLERANCES_MAX];
    size_t n;
    char *save, *name = strtok_r(line, " \t\r\n", &save);
    diag d = {0};
    if (!name || !read_tolerances(save, list, &n)) {
        diag_error(&d, "cannot read its '# ref:' line");
        count(t, &d, script, false);
        return;
    }
    const char *slash = strrchr(script, '/');
    char *reference = alloc_format("%.*s/%s.ref", (int)(slash - script), script, name);
    count(t, &d, script, table_diff(name, reference, list, n, &d) == SARCINA_OK);
    free(reference);
}

/* The comments at the head of a script. */
static size_t compare_tables(const char *script, tally *t) {
    FILE *f = fopen(script, "r");
    char *line = NULL;
    size_t room = 0, tables = 0;
    while (f && getline(&line, &room, f) > 0 && *line == '#') {
        if (strncmp(line, "# ref:", 6) != 0)
            continue;
        compare_table(script, line + 6, t);
        tables++;
    }
    free(line);
    if (f)
        fclose(f);
    return tables;
}

/* ---- running ---- */

static void run_script(program *p, const options *o, const char *path, tally *t) {
    char before[4096];
    diag d = {0};
    char *folder = enter_fresh_folder(before);
    interp *in = folder ? program_interp(p, o, &d) : NULL;
    t->scripts++;
    if (!in) {
        count(t, &d, path, false);
        free(folder);
        return;
    }
    int status = interp_check_file(in, path) ? SARCINA_ERROR : interp_run_file(in, path);
    uint64_t passed, failed;
    interp_expects(in, &passed, &failed);
    interp_free(in);
    t->passed += passed;
    t->failed += failed;
    size_t tables = compare_tables(path, t);
    diag_error(&d, "stopped with an error (%d)", status);
    if (status || (passed + failed + tables == 0))
        count(t, &d, path, status == SARCINA_OK);
    if (chdir(before) == 0)
        remove_folder(folder);
    free(folder);
}

int test_run_all(program *p, const options *o) {
    path_list l = {0};
    tally t = {0};
    for (size_t i = 0; i < o->ntests; i++) {
        struct stat info;
        if (stat(o->tests[i], &info) != 0) {
            fprintf(stderr, "no such file or folder: %s\n", o->tests[i]);
            t.failed++;
        } else if (S_ISDIR(info.st_mode)) {
            search_folder(&l, o->tests[i]);
        } else {
            add_path(&l, o->tests[i]);
        }
    }
    FILE *screen = p->screen;
    p->screen = NULL; /* what tests print is their own affair; errors are shown */
    for (size_t i = 0; i < l.n; i++) {
        run_script(p, o, l.list[i], &t);
        free(l.list[i]);
    }
    p->screen = screen;
    free(l.list);
    printf("%zu %s\n%" PRIu64 " passed, %" PRIu64 " failed\n", t.scripts, number_noun(t.scripts, "script", "scripts"),
           t.passed, t.failed);
    if (t.failed)
        return SARCINA_EXPECT;
    return t.scripts ? SARCINA_OK : SARCINA_ERROR;
}

/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "output/collection.h"

#include "base/alloc.h"
#include "base/path.h"
#include "output/field.h"

#include <stdbool.h>
#include <stdlib.h>
#include <string.h>

typedef struct entry {
    double time;
    char *file; /* as the index names it: from its own folder, in the writing of XML */
} entry;

struct collection {
    char *path;
    size_t folder; /* bytes of the pattern that lead to the index's folder */
    char *before;  /* what a file's name has before the step, as it stands in the index */
    entry *list;
    size_t n, capacity;
    bool rewinds;  /* entries of the file that stands are to be read */
    uint64_t keep; /* up to this step */
};

/* Folder part of a path, in bytes, with its slash. */
static size_t folder_length(const char *path, size_t n) {
    while (n > 0 && path[n - 1] != '/')
        n--;
    return n;
}

collection *collection_create(const char *pattern) {
    collection *c = alloc_zeroed(1, sizeof *c);
    size_t n = strcspn(pattern, "*");
    size_t star = n;
    while (n > 0 && strchr("._-", pattern[n - 1]))
        n--;
    c->folder = folder_length(pattern, n);
    char *before = alloc_copy_n(pattern + c->folder, star - c->folder);
    c->before = field_xml(before);
    free(before);
    c->path = n > c->folder ? alloc_format("%.*s.pvd", (int)n, pattern)
                            : alloc_format("%.*sindex.pvd", (int)c->folder, pattern);
    return c;
}

static void forget(collection *c) {
    for (size_t i = 0; i < c->n; i++)
        free(c->list[i].file);
    c->n = 0;
}

void collection_free(collection *c) {
    if (!c)
        return;
    forget(c);
    free(c->list);
    free(c->before);
    free(c->path);
    free(c);
}

/* Takes the name. */
static void append(collection *c, double time, char *file) {
    c->list = alloc_grow(c->list, &c->capacity, c->n + 1, sizeof *c->list);
    c->list[c->n++] = (entry){time, file};
}

/* The step in a file's name: what stands for the first * of the pattern. */
static bool step_of(const collection *c, const char *file, uint64_t *step) {
    size_t n = strlen(c->before);
    char *end;
    if (strncmp(file, c->before, n) != 0)
        return false;
    *step = strtoull(file + n, &end, 10);
    return end > file + n;
}

/* The entries of our own file that stay. */
static void read_index(collection *c) {
    FILE *f = fopen(c->path, "r");
    char *line = NULL;
    size_t room = 0;
    while (f && getline(&line, &room, f) > 0) {
        const char *time = strstr(line, "<DataSet timestep=\""), *file = strstr(line, " file=\"");
        uint64_t step;
        if (!time || !file)
            continue;
        file += strlen(" file=\"");
        char *name = alloc_copy_n(file, strcspn(file, "\""));
        if (step_of(c, name, &step) && step <= c->keep)
            append(c, strtod(time + strlen("<DataSet timestep=\""), NULL), name);
        else
            free(name);
    }
    if (f)
        fclose(f);
    free(line);
}

static int write_index(const collection *c, diag *d) {
    char *beside = alloc_format("%s.new", c->path), digits[FIELD_ROOM];
    FILE *f = path_open(beside, "w", d);
    int status = f ? SARCINA_OK : SARCINA_ERROR;
    if (f) {
        fputs("<?xml version=\"1.0\"?>\n<VTKFile type=\"Collection\" version=\"0.1\" byte_order=\"LittleEndian\">\n"
              "<Collection>\n",
              f);
        for (size_t i = 0; i < c->n; i++)
            fprintf(f, "<DataSet timestep=\"%s\" part=\"0\" file=\"%s\"/>\n", field_number(c->list[i].time, digits),
                    c->list[i].file);
        fputs("</Collection>\n</VTKFile>\n", f);
        status = path_close(f, beside, d);
        if (!status && rename(beside, c->path))
            status = path_error(c->path, d);
    }
    free(beside);
    return status;
}

int collection_add(collection *c, double time, const char *file, diag *d) {
    if (c->rewinds)
        read_index(c);
    c->rewinds = false;
    append(c, time, field_xml(file + c->folder));
    return write_index(c, d);
}

void collection_rewind(collection *c, uint64_t step) {
    forget(c);
    c->rewinds = true;
    c->keep = step;
}

/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "base/csv.h"

#include "base/alloc.h"

#include <errno.h>
#include <stdlib.h>
#include <string.h>

int csv_open(csv *t, const char *path, diag *d) {
    *t = (csv){.path = path, .file = fopen(path, "r")};
    return t->file ? SARCINA_OK : diag_error(d, "cannot read '%s': %s", path, strerror(errno));
}

void csv_close(csv *t) {
    if (t->file)
        fclose(t->file);
    free(t->line);
    free(t->fields);
    *t = (csv){0};
}

/* Unquotes one field in place; returns what comes behind its comma, NULL at the row's end. */
static char *take_field(char *at) {
    if (*at != '"')
        return strsep(&at, ",") ? at : NULL;
    char *to = at, *from = at + 1;
    while (*from && (*from != '"' || from[1] == '"')) {
        from += *from == '"';
        *to++ = *from++;
    }
    from += *from == '"';
    char *comma = strchr(from, ',');
    *to = '\0';
    return comma ? comma + 1 : NULL;
}

/* Spreadsheets put a byte order mark before the first heading. */
static void skip_mark(csv *t) {
    static const char mark[] = "\xef\xbb\xbf";
    size_t n = sizeof mark - 1;
    if (t->row == 1 && strncmp(t->line, mark, n) == 0)
        memmove(t->line, t->line + n, strlen(t->line + n) + 1);
}

bool csv_next(csv *t) {
    ssize_t length;
    do {
        length = getline(&t->line, &t->line_room, t->file);
        t->row++;
    } while (length > 0 && strchr("#\r\n", *t->line));
    if (length <= 0)
        return false;
    t->line[strcspn(t->line, "\r\n")] = '\0';
    skip_mark(t);
    t->n = 0;
    for (char *at = t->line; at; at = take_field(at)) {
        t->fields = alloc_grow(t->fields, &t->field_room, t->n + 1, sizeof *t->fields);
        t->fields[t->n++] = at;
    }
    return true;
}

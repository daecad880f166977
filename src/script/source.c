/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "script/source.h"

#include "base/alloc.h"
#include "base/path.h"

#include <errno.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <unistd.h>

static char *folder_of(const char *path) {
    const char *slash = strrchr(path, '/');
    if (!slash)
        return alloc_copy("");
    return alloc_copy_n(path, slash == path ? 1 : (size_t)(slash - path));
}

static source *source_new(const char *name, char *folder, char *text, size_t length) {
    source *s = alloc_zeroed(1, sizeof *s);
    s->name = alloc_copy(name);
    s->folder = folder;
    s->text = text;
    s->length = length;
    return s;
}

source *source_of_text(const char *name, const char *text) {
    return source_new(name, alloc_copy(""), alloc_copy(text), strlen(text));
}

source *source_read(const char *path, diag *d) {
    struct stat info;
    if (stat(path, &info) == 0 && S_ISDIR(info.st_mode)) {
        diag_error(d, "'%s' is a folder, not a script", path);
        return NULL;
    }
    FILE *f = fopen(path, "rb");
    if (!f) {
        diag_error(d, "no file '%s' to read: %s", path, strerror(errno));
        return NULL;
    }
    size_t length;
    char *text = path_read_all(f, &length);
    fclose(f);
    /* a byte-order mark is no part of the text */
    if (length >= 3 && memcmp(text, "\xef\xbb\xbf", 3) == 0)
        memmove(text, text + 3, (length -= 3) + 1);
    return source_new(path, folder_of(path), text, length);
}

void source_free(source *s) {
    if (!s)
        return;
    free(s->name);
    free(s->folder);
    free(s->text);
    free(s);
}

const char *source_line(const source *s, uint32_t line, size_t *length) {
    const char *at = s->text, *end = s->text + s->length;
    for (uint32_t i = 1; i < line; i++) {
        const char *next = memchr(at, '\n', (size_t)(end - at));
        if (!next)
            return NULL;
        at = next + 1;
    }
    const char *stop = memchr(at, '\n', (size_t)(end - at));
    *length = (size_t)((stop ? stop : end) - at);
    if (*length && at[*length - 1] == '\r')
        --*length;
    return at;
}

char *source_library(const char *program) {
    static const char *const places[] = {"scripts/lib", "share/sarcina/lib"};
    enum { FOLDERS_UP = 4 };
    char *path = alloc_copy(program), *slash, *found = NULL;
    for (int up = 0; up < FOLDERS_UP && !found && (slash = strrchr(path, '/')); up++) {
        *slash = '\0';
        for (size_t i = 0; i < sizeof places / sizeof *places && !found; i++) {
            char *folder = alloc_format("%s/%s", path, places[i]);
            if (access(folder, R_OK) == 0)
                found = folder;
            else
                free(folder);
        }
    }
    free(path);
    return found;
}

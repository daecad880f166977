/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "app/repl_history.h"

#include "base/alloc.h"
#include "base/path.h"

#include <errno.h>
#include <stdbool.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include <readline/history.h>

/* Entries kept, and how many the file may have before it is cut to them. */
enum { HISTORY_KEPT = 2000, HISTORY_MOST = 3000 };

char *repl_history_path(void) {
    const char *state = getenv("XDG_STATE_HOME"), *home = getenv("HOME");
    if (state && *state == '/') /* a relative one is to be ignored, says the XDG specification */
        return alloc_format("%s/sarcina/history", state);
    return home && *home ? alloc_format("%s/.local/state/sarcina/history", home) : NULL;
}

/* ---- one entry a line -------------------------------------------------------------------------------------------- */

static char *encode(const char *entry) {
    char *line = alloc_zeroed(2 * strlen(entry) + 1, 1), *to = line;
    for (; *entry; entry++) {
        if (*entry == '\\' || *entry == '\n')
            *to++ = '\\';
        *to++ = *entry;
        if (*entry == '\n')
            to[-1] = 'n';
    }
    return line;
}

static void decode(char *line) {
    char *to = line;
    for (; *line && *line != '\n'; line++) {
        bool escaped = *line == '\\' && line[1] && line[1] != '\n';
        *to++ = !escaped ? *line : line[1] == 'n' ? '\n' : line[1];
        line += escaped;
    }
    *to = '\0';
}

/* ---- the file ---------------------------------------------------------------------------------------------------- */

/* Writes the newest entries of readline's list to a file beside, which then takes the place of the old one. */
static void cut(const char *path) {
    char *beside = alloc_format("%s.new", path);
    FILE *f = fopen(beside, "w");
    int first = history_base + (history_length > HISTORY_KEPT ? history_length - HISTORY_KEPT : 0);
    for (int i = first; f && i < history_base + history_length; i++) {
        char *line = encode(history_get(i)->line);
        fprintf(f, "%s\n", line);
        free(line);
    }
    if (f && fclose(f) == 0)
        rename(beside, path);
    free(beside);
}

void repl_history_load(const char *path) {
    FILE *f = fopen(path, "r");
    char *line = NULL;
    size_t room = 0;
    int n = 0;
    using_history();
    for (; f && getline(&line, &room, f) > 0; n++) {
        decode(line);
        add_history(line);
    }
    free(line);
    if (f)
        fclose(f);
    if (n > HISTORY_MOST)
        cut(path);
    stifle_history(HISTORY_KEPT);
}

static int append(const char *path, const char *entry) {
    FILE *f = path_make_folders(path, NULL) ? NULL : fopen(path, "a");
    if (!f)
        return errno;
    char *line = encode(entry);
    fprintf(f, "%s\n", line);
    free(line);
    return fclose(f) ? errno : 0;
}

int repl_history_add(const char *path, const char *entry) {
    const HIST_ENTRY *last = history_length ? history_get(history_base + history_length - 1) : NULL;
    if (last && strcmp(last->line, entry) == 0)
        return 0;
    add_history(entry);
    return path ? append(path, entry) : 0;
}

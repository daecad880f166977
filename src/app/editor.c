/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "app/editor.h"

#include "base/alloc.h"

#include <errno.h>
#include <stdbool.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

static const char *name_of_editor(void) {
    const char *visual = getenv("VISUAL"), *editor = getenv("EDITOR");
    return visual && *visual ? visual : editor && *editor ? editor : "vi";
}

/* A new file .in that holds the text; NULL with an error. The caller frees the name. */
static char *write_file(const char *text, diag *d) {
    const char *folder = getenv("TMPDIR");
    char *path = alloc_format("%s/sarcina-XXXXXX.in", folder && *folder ? folder : "/tmp");
    int file = mkstemps(path, 3);
    FILE *f = file < 0 ? NULL : fdopen(file, "w");
    bool good = f && fprintf(f, "%s\n", text) >= 0;
    if (f)
        good = fclose(f) == 0 && good;
    if (good)
        return path;
    diag_error(d, "cannot write '%s' for the editor: %s", path, strerror(errno));
    free(path);
    return NULL;
}

/* The file's text without the line ends at its end; NULL with an error. */
static char *read_file(const char *path, diag *d) {
    FILE *f = fopen(path, "r");
    char *text = NULL;
    size_t room = 0;
    if (!f) {
        diag_error(d, "cannot read '%s' behind the editor: %s", path, strerror(errno));
        return NULL;
    }
    ssize_t n = getdelim(&text, &room, '\0', f);
    fclose(f);
    if (n < 0) {
        free(text);
        return alloc_copy("");
    }
    while (n > 0 && text[n - 1] == '\n')
        text[--n] = '\0';
    return text;
}

int editor_run(char **text, diag *d) {
    char *path = write_file(*text, d);
    if (!path)
        return SARCINA_ERROR;
    char *command = alloc_format("%s '%s'", name_of_editor(), path);
    int code = system(command);
    char *edited = NULL;
    if (code)
        diag_error(d, "the editor ended with %d: %s", code, name_of_editor());
    else
        edited = read_file(path, d);
    unlink(path);
    free(command);
    free(path);
    if (!edited)
        return SARCINA_ERROR;
    free(*text);
    *text = edited;
    return SARCINA_OK;
}

/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "base/path.h"

#include "base/alloc.h"

#include <errno.h>
#include <stdbool.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <unistd.h>

int path_error(const char *path, diag *d) {
    return diag_error(d, "cannot write '%s': %s", path, strerror(errno));
}

/* The folder of a name: "." for none; the caller frees. */
static char *folder_of(const char *path) {
    const char *slash = strrchr(path, '/');
    return !slash ? alloc_copy(".") : alloc_copy_n(path, slash == path ? 1 : (size_t)(slash - path));
}

/* Is the nearest folder that is there one to write in? errno says why not. */
static bool could_be_made(const char *folder) {
    struct stat there;
    if (stat(folder, &there) == 0) {
        if (!S_ISDIR(there.st_mode)) {
            errno = ENOTDIR;
            return false;
        }
        return access(folder, W_OK | X_OK) == 0;
    }
    if (errno != ENOENT)
        return false;
    char *above = folder_of(folder);
    bool good = could_be_made(above);
    free(above);
    return good;
}

int path_check(const char *path, diag *d) {
    struct stat there;
    if (stat(path, &there) == 0) {
        if (S_ISDIR(there.st_mode))
            errno = EISDIR;
        else if (access(path, W_OK) == 0)
            return SARCINA_OK;
        return path_error(path, d);
    }
    char *folder = folder_of(path);
    bool good = could_be_made(folder);
    free(folder);
    return good ? SARCINA_OK : path_error(path, d);
}

int path_make_folders(const char *path, diag *d) {
    char *copy = alloc_copy(path);
    bool good = true;
    for (char *slash = copy[0] ? strchr(copy + 1, '/') : NULL; slash && good; slash = strchr(slash + 1, '/')) {
        *slash = '\0';
        good = mkdir(copy, 0777) == 0 || errno == EEXIST;
        *slash = '/';
    }
    free(copy);
    return good ? SARCINA_OK : path_error(path, d);
}

FILE *path_open(const char *path, const char *mode, diag *d) {
    if (path_make_folders(path, d))
        return NULL;
    FILE *f = fopen(path, mode);
    if (!f)
        path_error(path, d);
    return f;
}

int path_close(FILE *f, const char *path, diag *d) {
    bool lost = ferror(f) != 0; /* errno is that of the write before */
    return fclose(f) == 0 && !lost ? SARCINA_OK : path_error(path, d);
}

char *path_read_all(FILE *f, size_t *length) {
    enum { CHUNK = 65536 };
    char *text = NULL;
    size_t capacity = 0, n = 0, got;
    do {
        text = alloc_grow(text, &capacity, n + CHUNK + 1, 1);
        got = fread(text + n, 1, CHUNK, f);
        n += got;
    } while (got == CHUNK);
    text[n] = '\0';
    if (length)
        *length = n;
    return text;
}

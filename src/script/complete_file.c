/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Candidates that are files: those of the folder that is typed, folders with a stroke behind. */
#include "script/complete_part.h"

#include "base/alloc.h"

#include <dirent.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>

static bool is_folder(const char *path) {
    struct stat info;
    return stat(path, &info) == 0 && S_ISDIR(info.st_mode);
}

/* A blank would end a bare word, and the quote a quoted one. */
static bool can_stand(const completing *c, const char *name) {
    return !strpbrk(name, "$\n") && (c->quote ? !strchr(name, c->quote) : !strpbrk(name, " \t#\"'()"));
}

static void offer_entry(completing *c, const char *folder, const char *name) {
    char *path = alloc_format("%s%s", folder, name);
    bool deeper = is_folder(path);
    const char close[2] = {deeper ? '/' : c->quote, '\0'};
    char *candidate = alloc_format("%s%s", path, close);
    if (can_stand(c, name))
        complete_part_offer(c, candidate, deeper);
    free(candidate);
    free(path);
}

static int by_name(const struct dirent **a, const struct dirent **b) {
    return strcmp((*a)->d_name, (*b)->d_name);
}

void complete_part_file(completing *c) {
    const char *typed = c->text + c->from, *slash = strrchr(typed, '/'), *name = slash ? slash + 1 : typed;
    char *folder = alloc_copy_n(typed, (size_t)(name - typed));
    struct dirent **list;
    int n = scandir(*folder ? folder : ".", &list, NULL, by_name);
    for (int i = 0; i < n; i++) {
        const char *entry = list[i]->d_name;
        /* hidden files only when asked for; . and .. never */
        if ((*entry != '.' || *name == '.') && strcmp(entry, ".") != 0 && strcmp(entry, "..") != 0)
            offer_entry(c, folder, entry);
        free(list[i]);
    }
    if (n >= 0)
        free(list);
    free(folder);
}

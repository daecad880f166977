/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "app/logfile.h"

#include "app/version.h"
#include "base/alloc.h"
#include "engine/scene.h"

#include <errno.h>
#include <inttypes.h>
#include <stdlib.h>
#include <string.h>
#include <time.h>
#include <unistd.h>

enum { HELD_MAX = 1 << 20 }; /* bytes: whoever prints more than this wants a file */

static void put_word(FILE *out, const char *word) {
    static const char plain[] = "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789_-+=./,:%@*";
    if (*word && word[strspn(word, plain)] == '\0') {
        fputs(word, out);
        return;
    }
    fputc('\'', out);
    for (; *word; word++)
        fputs(*word == '\'' ? "'\\''" : (const char[]){*word, '\0'}, out);
    fputc('\'', out);
}

void logfile_create(logfile *l, bool automatic, int argc, char *const *argv) {
    size_t size;
    *l = (logfile){.waiting = automatic, .began = scene_clock()};
    FILE *out = open_memstream(&l->command, &size);
    fputs("sarcina", out);
    for (int i = 1; i < argc; i++) {
        fputc(' ', out);
        put_word(out, argv[i]);
    }
    fclose(out);
}

static void put_head(logfile *l) {
    char date[64];
    setvbuf(l->file, NULL, _IOLBF, BUFSIZ); /* whoever follows the file sees whole lines */
    time_t now = time(NULL);
    struct tm when;
    strftime(date, sizeof date, "%Y-%m-%d %H:%M:%S %z", localtime_r(&now, &when));
    char *version = version_text();
    fprintf(l->file, "Sarcina %s\nDate: %s\nCommand line: %s\n", version, date, l->command);
    free(version);
}

static void stop_waiting(logfile *l) {
    free(l->held);
    l->held = NULL;
    l->nheld = l->room = 0;
    l->waiting = false;
}

static void close_file(logfile *l) {
    bool lost = l->file && ferror(l->file);
    if ((l->file && fclose(l->file)) || lost)
        fputs("sarcina: warning: the log is cut short: not all of it could be written\n", stderr);
    l->file = NULL;
}

int logfile_open(logfile *l, const char *path, bool append, diag *d) {
    FILE *f = path ? fopen(path, append ? "a" : "w") : NULL;
    if (path && !f)
        return diag_error(d, "cannot write the log '%s': %s", path, strerror(errno));
    stop_waiting(l);
    close_file(l);
    l->file = f;
    if (f)
        put_head(l);
    return SARCINA_OK;
}

/* Renames an earlier log to the first free number; no file is ever replaced. */
static void keep_earlier(void) {
    for (unsigned n = 1; access(LOGFILE_NAME, F_OK) == 0; n++) {
        char *kept = alloc_format("%s.%u", LOGFILE_NAME, n);
        bool linked = link(LOGFILE_NAME, kept) == 0, taken = !linked && errno == EEXIST;
        if (linked)
            unlink(LOGFILE_NAME);
        else if (!taken && access(kept, F_OK) != 0 && rename(LOGFILE_NAME, kept) != 0)
            n = UINT32_MAX; /* it stays: opening it will say what is wrong */
        free(kept);
        if (n == UINT32_MAX)
            return;
    }
}

static void begin(logfile *l) {
    for (int i = 0; i < 100 && !l->file; i++) { /* another run may begin its own at this moment */
        keep_earlier();
        l->file = fopen(LOGFILE_NAME, "wx");
        if (!l->file && errno != EEXIST)
            break;
    }
    if (!l->file)
        fprintf(stderr, "sarcina: warning: no log: cannot write '%s': %s\n", LOGFILE_NAME, strerror(errno));
    if (l->file) {
        put_head(l);
        fwrite(l->held, 1, l->nheld, l->file);
    }
    stop_waiting(l);
}

bool logfile_start(logfile *l) {
    if (l->waiting)
        begin(l);
    return l->file != NULL;
}

void logfile_put(logfile *l, const char *text) {
    size_t n = strlen(text);
    if (l->waiting && l->nheld + n > HELD_MAX)
        begin(l);
    if (l->file)
        fwrite(text, 1, n, l->file);
    if (!l->waiting)
        return;
    l->held = alloc_grow(l->held, &l->room, l->nheld + n, 1);
    memcpy(l->held + l->nheld, text, n);
    l->nheld += n;
}

void logfile_end(logfile *l, uint64_t warnings) {
    unsigned s = (unsigned)(scene_clock() - l->began);
    if (l->file)
        fprintf(l->file, "Total # of warnings: %" PRIu64 "\nTotal wall time: %u:%02u:%02u\n", warnings, s / 3600,
                s / 60 % 60, s % 60);
    close_file(l);
    stop_waiting(l);
    free(l->command);
    l->command = NULL;
}

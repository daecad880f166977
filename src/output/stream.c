/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "output/stream.h"

#include "base/alloc.h"
#include "base/path.h"

#include <errno.h>
#include <inttypes.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <sys/types.h>
#include <unistd.h>

struct stream {
    char *path;
    stream_kind kind;
    int step_column;
    FILE *file;
    bool has_step;
    uint64_t last; /* step written last, when has_step */
    bool rewinds;  /* when it opens: as if resumed at `keep` */
    uint64_t keep;
};

stream *stream_create(const char *path, stream_kind kind, int step_column) {
    stream *s = alloc_zeroed(1, sizeof *s);
    s->path = alloc_copy(path);
    s->kind = kind;
    s->step_column = step_column;
    return s;
}

void stream_free(stream *s) {
    if (!s)
        return;
    if (s->file)
        fclose(s->file);
    free(s->path);
    free(s);
}

const char *stream_path(const stream *s) {
    return s->path;
}

/* The column-th field of a line of a CSV as a step; quoted fields may hold commas. */
static bool csv_step(const char *line, int column, uint64_t *step) {
    bool quoted = false;
    for (; column > 0; line++) {
        if (*line == '\0')
            return false;
        if (*line == '"')
            quoted = !quoted;
        column -= *line == ',' && !quoted;
    }
    char *end;
    *step = strtoull(line, &end, 10);
    return end != line && (*end == ',' || *end == '\n' || *end == '\r' || *end == '\0');
}

/* Whether a line begins the block of a step; a dump says so with two lines, of which before is the first. */
static bool begins_block(const stream *s, const char *before, const char *line, uint64_t *step) {
    if (s->kind == STREAM_CSV)
        return before[0] != '\0' && csv_step(line, s->step_column, step);
    if (s->kind == STREAM_XYZ) {
        const char *named = strncmp(line, "Properties=", 11) == 0 ? strstr(line, " step=") : NULL;
        return named && sscanf(named, " step=%" SCNu64, step) == 1;
    }
    return strcmp(before, "ITEM: TIMESTEP\n") == 0 && sscanf(line, "%" SCNu64, step) == 1;
}

/* Length of the file up to the first block of a step after `keep`; notes the last step that stays. */
static off_t find_end(stream *s, FILE *f, uint64_t keep) {
    char *line = NULL, *before = alloc_copy("");
    size_t room = 0;
    off_t here = 0, previous = 0, end = -1;
    s->has_step = false;
    for (ssize_t n; end < 0 && (n = getline(&line, &room, f)) > 0; previous = here, here += n) {
        uint64_t step;
        if (begins_block(s, before, line, &step)) {
            if (step > keep || line[n - 1] != '\n') {
                end = s->kind == STREAM_CSV ? here : previous;
                break;
            }
            s->has_step = true;
            s->last = step;
        }
        free(before);
        before = alloc_copy(line);
    }
    free(line);
    free(before);
    return end < 0 ? here : end;
}

static int shorten(stream *s, uint64_t keep, diag *d) {
    rewind(s->file);
    off_t end = find_end(s, s->file, keep);
    if (fflush(s->file) || ftruncate(fileno(s->file), end) || fseeko(s->file, end, SEEK_SET))
        return path_error(s->path, d);
    return SARCINA_OK;
}

int stream_open(stream *s, diag *d) {
    if (s->file)
        return SARCINA_OK;
    s->file = s->rewinds ? fopen(s->path, "r+") : NULL;
    bool begun = !s->file;
    if (begun)
        s->file = path_open(s->path, "w+", d);
    if (!s->file)
        return SARCINA_ERROR;
    return begun ? SARCINA_OK : shorten(s, s->keep, d);
}

bool stream_is_empty(const stream *s) {
    return ftello(s->file) == 0;
}

bool stream_has(const stream *s, uint64_t step) {
    return s->has_step && step <= s->last;
}

FILE *stream_file(const stream *s) {
    return s->file;
}

int stream_flush(stream *s, diag *d) {
    return fflush(s->file) || ferror(s->file) ? path_error(s->path, d) : SARCINA_OK;
}

int stream_end(stream *s, uint64_t step, diag *d) {
    s->has_step = true;
    s->last = step;
    return stream_flush(s, d);
}

int stream_rewind(stream *s, uint64_t step, diag *d) {
    if (s->file)
        return shorten(s, step, d);
    s->rewinds = true;
    s->keep = step;
    return SARCINA_OK;
}

/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "output/dump.h"

#include "base/alloc.h"
#include "base/path.h"
#include "base/table.h"
#include "output/collection.h"
#include "output/field.h"
#include "output/dump/styles.h"
#include "output/stream.h"

#include <errno.h>
#include <inttypes.h>
#include <stdlib.h>
#include <string.h>

const dump_style *const dump_styles[] = {
#define DUMP_RECORD(name) &dump_##name,
    DUMP_STYLES(DUMP_RECORD)
#undef DUMP_RECORD
};
const size_t dump_style_count = TABLE_COUNT(dump_styles);

int dump_find(const char *name) {
    for (size_t i = 0; i < dump_style_count; i++)
        if (strcmp(dump_styles[i]->name, name) == 0)
            return (int)i;
    return -1;
}

struct dump {
    int style;
    char *pattern;
    int pad;
    stream *file;                     /* of many steps; NULL: one file a step */
    uint64_t last;                    /* step written last; UINT64_MAX: none */
    collection *index, *beside_index; /* of styles that have them */
    void *film;                       /* of styles that have one, once begun */
    char *film_path;
};

char *dump_file_name(const char *pattern, uint64_t step, int pad) {
    char *name = alloc_copy("");
    for (;;) {
        size_t n = strcspn(pattern, "*");
        char *longer = pattern[n] ? alloc_format("%s%.*s%0*" PRIu64, name, (int)n, pattern, pad > 1 ? pad : 1, step)
                                  : alloc_format("%s%s", name, pattern);
        free(name);
        name = longer;
        if (!pattern[n])
            return name;
        pattern += n + 1;
    }
}

/* NAME.*.EXTENSION has NAME.beside.*.EXTENSION beside it; without *, NAME.beside.EXTENSION. The caller frees. */
static char *name_beside(const char *pattern, const char *beside) {
    size_t at = strcspn(pattern, "*"), end = strlen(pattern);
    const char *slash = strrchr(pattern, '/'), *dot = strrchr(pattern, '.');
    size_t base = slash ? (size_t)(slash - pattern) + 1 : 0;
    if (at == end && dot && (size_t)(dot - pattern) > base) /* before the extension */
        return alloc_format("%.*s.%s%s", (int)(dot - pattern), pattern, beside, dot);
    if (at == end)
        return alloc_format("%s.%s", pattern, beside);
    char joint[2] = {at > 0 && strchr("._-", pattern[at - 1]) ? pattern[at - 1] : '.', '\0'};
    size_t n = at > 0 && joint[0] == pattern[at - 1] ? at - 1 : at;
    bool bare = n == 0 || pattern[n - 1] == '/';
    return alloc_format("%.*s%s%s%s%s", (int)n, pattern, bare ? "" : joint, beside, joint, pattern + at);
}

int dump_check(int style, const char *pattern, bool now, diag *d) {
    const dump_style *s = dump_styles[style];
    if (s->film && strchr(pattern, '*'))
        return diag_error(d, "a %s is one file: '%s' has a *", s->name, pattern);
    if (!now && !s->many && !strchr(pattern, '*'))
        return diag_error(d, "a dump of style %s writes one file a step: '%s' needs a * where the step goes", s->name,
                          pattern);
    char *name = dump_file_name(pattern, 0, 0);
    int status = path_check(name, d);
    free(name);
    return status;
}

dump *dump_create(int style, const char *pattern) {
    dump *p = alloc_zeroed(1, sizeof *p);
    p->style = style;
    p->pattern = alloc_copy(pattern);
    p->last = UINT64_MAX;
    const dump_style *s = dump_styles[style];
    if (s->film)
        p->film_path = alloc_copy(pattern);
    else if (!strchr(pattern, '*'))
        p->file = stream_create(pattern, s->blocks, 0);
    if (s->indexed)
        p->index = collection_create(pattern);
    if (s->indexed && s->beside) {
        char *beside = name_beside(pattern, s->beside);
        p->beside_index = collection_create(beside);
        free(beside);
    }
    return p;
}

void dump_free(dump *p) {
    if (!p)
        return;
    if (p->film)
        dump_styles[p->style]->film->end(p->film, NULL);
    stream_free(p->file);
    collection_free(p->index);
    collection_free(p->beside_index);
    free(p->film_path);
    free(p->pattern);
    free(p);
}

void dump_set_pad(dump *p, int pad) {
    p->pad = pad;
}

int dump_style_of(const dump *p) {
    return p->style;
}

const char *dump_pattern(const dump *p) {
    return p->pattern;
}

void dump_set_last(dump *p, uint64_t step) {
    p->last = step;
}

uint64_t dump_last(const dump *p) {
    return p->last;
}

int dump_open(dump *p, diag *d) {
    const dump_style *s = dump_styles[p->style];
    if (s->film && !s->missing && !p->film && s->film->ready(d))
        return SARCINA_ERROR;
    return p->file ? stream_open(p->file, d) : dump_check(p->style, p->pattern, false, d);
}

static int write_text(const dump_frame *f, const char *path, int (*write)(const dump_frame *, FILE *, diag *),
                      diag *d) {
    FILE *out = path_open(path, "w", d);
    if (!out)
        return SARCINA_ERROR;
    int status = write(f, out, d);
    int closed = path_close(out, path, status ? NULL : d);
    return status ? status : closed;
}

int dump_write_now(int style, const char *path, const dump_frame *f, diag *d) {
    const dump_style *s = dump_styles[style];
    dump_frame frame = *f;
    frame.many = false;
    frame.fresh = true;
    if (s->missing)
        return diag_error(d, "%s", s->missing);
    if (s->draw)
        return path_make_folders(path, d) ? SARCINA_ERROR : s->draw(&frame, path, d);
    int status = write_text(&frame, path, s->write, d);
    if (status || !s->beside || !s->has_beside(&frame))
        return status;
    char *beside = name_beside(path, s->beside);
    status = write_text(&frame, beside, s->write_beside, d);
    free(beside);
    return status;
}

/* One more block of the file of many steps. */
static int write_block(dump *p, const dump_frame *f, diag *d) {
    dump_frame frame = *f;
    int status = stream_open(p->file, d);
    if (status || stream_has(p->file, f->view->step))
        return status;
    frame.many = true;
    frame.fresh = stream_is_empty(p->file);
    status = dump_styles[p->style]->write(&frame, stream_file(p->file), d);
    return status ? status : stream_end(p->file, f->view->step, d);
}

/* One more file of a series, what stands beside it, and the series' indices. */
static int write_file(dump *p, const dump_frame *f, diag *d) {
    const dump_style *s = dump_styles[p->style];
    char *name = dump_file_name(p->pattern, f->view->step, p->pad), *series, *beside;
    int status = SARCINA_OK;
    dump_frame frame = *f;
    frame.many = false;
    frame.fresh = true;
    if (s->draw)
        status = path_make_folders(name, d) ? SARCINA_ERROR : s->draw(&frame, name, d);
    else
        status = write_text(&frame, name, s->write, d);
    if (!status && p->index)
        status = collection_add(p->index, f->view->time, name, d);
    free(name);
    if (status || !s->beside || !s->has_beside(&frame))
        return status;
    series = name_beside(p->pattern, s->beside);
    beside = dump_file_name(series, f->view->step, p->pad);
    status = write_text(&frame, beside, s->write_beside, d);
    if (!status && p->beside_index)
        status = collection_add(p->beside_index, f->view->time, beside, d);
    free(series);
    free(beside);
    return status;
}

int dump_write(dump *p, const dump_frame *f, diag *d) {
    const dump_style *s = dump_styles[p->style];
    if (p->last == f->view->step || s->missing)
        return SARCINA_OK;
    int status = p->file   ? write_block(p, f, d)
                 : s->film ? s->film->frame(&p->film, p->film_path, f, d)
                           : write_file(p, f, d);
    if (!status)
        p->last = f->view->step;
    return status;
}

/* NAME.EXTENSION -> NAME.STEP.EXTENSION; the caller frees. */
static char *name_part(const char *path, uint64_t step) {
    const char *slash = strrchr(path, '/'), *dot = strrchr(path, '.');
    size_t n = dot && (!slash || dot > slash) ? (size_t)(dot - path) : strlen(path);
    return alloc_format("%.*s.%" PRIu64 "%s", (int)n, path, step, path + n);
}

int dump_rewind(dump *p, uint64_t step, diag *d) {
    if (p->index)
        collection_rewind(p->index, step);
    if (p->beside_index)
        collection_rewind(p->beside_index, step);
    if (p->film_path && !p->film) { /* a film cannot be taken up again */
        free(p->film_path);
        p->film_path = name_part(p->pattern, step);
    }
    if (!p->file)
        return SARCINA_OK;
    p->last = UINT64_MAX;
    return stream_rewind(p->file, step, d);
}

uint32_t *dump_rows(const dump_frame *f, size_t *n) {
    colony *c = f->view->colony;
    const uint32_t *order = colony_by_id(c);
    uint32_t *rows = alloc_zeroed(c->cell.count, sizeof *rows);
    *n = 0;
    for (size_t i = 0; i < c->cell.count; i++)
        if (!f->members || f->members[order[i]])
            rows[(*n)++] = order[i];
    return rows;
}

int dump_text(const dump_frame *f, size_t i, uint32_t row, char text[64], diag *d) {
    const output_column *c = &f->columns[i];
    if (c->is_text)
        return c->text(c->self, row, text, d);
    double si;
    char digits[FIELD_ROOM];
    int status = c->number(c->self, row, &si, d);
    if (!status)
        snprintf(text, 64, "%s", field_number(si, digits));
    return status;
}

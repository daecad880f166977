/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "output/dump.h"

#include "base/alloc.h"
#include "base/path.h"
#include "base/table.h"
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
    stream *file;  /* of many steps; NULL: one file a step */
    uint64_t last; /* step written last; UINT64_MAX: none */
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

int dump_check(int style, const char *pattern, bool now, diag *d) {
    const dump_style *s = dump_styles[style];
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
    if (!strchr(pattern, '*'))
        p->file = stream_create(pattern, dump_styles[style] == &dump_custom ? STREAM_DUMP : STREAM_CSV, 0);
    return p;
}

void dump_free(dump *p) {
    if (!p)
        return;
    stream_free(p->file);
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
    return p->file ? stream_open(p->file, d) : dump_check(p->style, p->pattern, false, d);
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
    FILE *out = path_open(path, "w", d);
    if (!out)
        return SARCINA_ERROR;
    int status = s->write(&frame, out, d);
    bool failed = ferror(out) != 0;
    if ((fclose(out) || failed) && !status)
        status = path_error(path, d);
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

int dump_write(dump *p, const dump_frame *f, diag *d) {
    if (p->last == f->view->step || dump_styles[p->style]->missing)
        return SARCINA_OK;
    int status;
    if (p->file) {
        status = write_block(p, f, d);
    } else {
        char *name = dump_file_name(p->pattern, f->view->step, p->pad);
        status = dump_write_now(p->style, name, f, d);
        free(name);
    }
    if (!status)
        p->last = f->view->step;
    return status;
}

int dump_rewind(dump *p, uint64_t step, diag *d) {
    p->last = UINT64_MAX;
    return p->file ? stream_rewind(p->file, step, d) : SARCINA_OK;
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

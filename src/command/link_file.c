/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "command/link_file.h"

#include "base/alloc.h"
#include "base/number.h"
#include "base/table.h"
#include "engine/flat.h"

#include <inttypes.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

static const char heading[] = "links";
static const char header[] =
    "link,kind,joint,age[s],cell_a,cell_b,a,a_particle,b,b_particle,k[pg/s2],rest[um],x[um],y[um],z[um],glides";

/* By link_kind. */
static const char *const kinds[] = {"filial", "stick", "anchor"};

typedef enum { WHOLE, REAL, KIND } field_type;

static const struct {
    field_type type;
    size_t offset;
} fields[] = {
    {WHOLE, offsetof(link_file_row, link)},     {KIND, 0},
    {WHOLE, offsetof(link_file_row, joint)},    {REAL, offsetof(link_file_row, age)},
    {WHOLE, offsetof(link_file_row, cell_a)},   {WHOLE, offsetof(link_file_row, cell_b)},
    {WHOLE, offsetof(link_file_row, a)},        {WHOLE, offsetof(link_file_row, a_particle)},
    {WHOLE, offsetof(link_file_row, b)},        {WHOLE, offsetof(link_file_row, b_particle)},
    {REAL, offsetof(link_file_row, k)},         {REAL, offsetof(link_file_row, rest)},
    {REAL, offsetof(link_file_row, anchor[0])}, {REAL, offsetof(link_file_row, anchor[1])},
    {REAL, offsetof(link_file_row, anchor[2])}, {WHOLE, offsetof(link_file_row, glides)},
};

/* ---- reading ---- */

bool link_file_begins(const csv *t) {
    return t->n == 1 && strcmp(t->fields[0], heading) == 0;
}

static bool read_kind(const char *text, link_file_row *row) {
    for (size_t i = 0; i < TABLE_COUNT(kinds); i++)
        if (strcmp(text, kinds[i]) == 0) {
            row->kind = (int)i;
            return true;
        }
    return false;
}

static bool read_field(const char *text, size_t i, link_file_row *row) {
    size_t n = strlen(text);
    char *to = (char *)row + fields[i].offset;
    if (fields[i].type == KIND)
        return read_kind(text, row);
    if (fields[i].type == WHOLE) {
        uint64_t value = strtoull(text, NULL, 10);
        memcpy(to, &value, sizeof value);
        return n && n < 20 && strspn(text, "0123456789") == n;
    }
    double value = number_read(text, number_length(text, n, true), 0);
    memcpy(to, &value, sizeof value);
    return n && number_length(text, n, true) == n && isfinite(value);
}

static int read_row(link_file *l, const csv *t, diag *d) {
    link_file_row row = {0};
    if (t->n != TABLE_COUNT(fields))
        return diag_error(d, "%s:%zu: a spring of a link has %zu %s, not %zu", t->path, t->row, t->n,
                          number_noun(t->n, "value", "values"), TABLE_COUNT(fields));
    for (size_t i = 0; i < t->n; i++)
        if (!read_field(t->fields[i], i, &row))
            return diag_error(d, "%s:%zu: value %zu of a link cannot be '%s'", t->path, t->row, i + 1, t->fields[i]);
    l->rows = alloc_grow(l->rows, &l->capacity, l->n + 1, sizeof *l->rows);
    l->rows[l->n++] = row;
    return SARCINA_OK;
}

/* The header's columns are these, in this order. */
static bool is_header(const csv *t) {
    char *joined = alloc_copy("");
    for (size_t i = 0; i < t->n; i++) {
        char *longer = alloc_format("%s%s%s", joined, i ? "," : "", t->fields[i]);
        free(joined);
        joined = longer;
    }
    bool same = strcmp(joined, header) == 0;
    free(joined);
    return same;
}

int link_file_read(link_file *l, csv *t, diag *d) {
    if (!csv_next(t) || !is_header(t)) {
        diag_error(d, "%s:%zu: the table of links has other columns", t->path, t->row);
        return diag_help(d, "due: %s", header);
    }
    int status = SARCINA_OK;
    while (!status && csv_next(t))
        status = read_row(l, t, d);
    return status;
}

void link_file_free(link_file *l) {
    free(l->rows);
    *l = (link_file){0};
}

/* ---- into the scene ---- */

static int compare_cells(const void *a, const void *b) {
    const cell_row *const *p = a, *const *q = b;
    return (*p)->id < (*q)->id ? -1 : (*p)->id > (*q)->id;
}

/* The cells in the order of their ids; the caller frees. */
static const cell_row **sort_cells(const cell_row *cells, size_t n) {
    const cell_row **sorted = alloc_zeroed(n, sizeof *sorted);
    for (size_t i = 0; i < n; i++)
        sorted[i] = &cells[i];
    qsort((void *)sorted, n, sizeof *sorted, compare_cells);
    return sorted;
}

static const cell_row *find_cell(const cell_row **sorted, size_t n, uint64_t id) {
    const cell_row key = {.id = id}, *wanted = &key;
    const cell_row **found = bsearch((const void *)&wanted, (const void *)sorted, n, sizeof *sorted, compare_cells);
    return found ? *found : NULL;
}

/* A particle (from 1) of one of the two cells that are linked. */
static bool holds(const link_file_row *row, const cell_row **cells, size_t n, uint64_t id, uint64_t particle) {
    const cell_row *cell = find_cell(cells, n, id);
    return id && cell && (id == row->cell_a || id == row->cell_b) && particle >= 1 && particle <= cell->nparticles;
}

int link_file_check(const link_file *l, const scene *s, const cell_row *rows, size_t n, diag *d) {
    const cell_row **cells = sort_cells(rows, n);
    int status = SARCINA_OK;
    for (size_t i = 0; i < l->n && !status; i++) {
        const link_file_row *row = &l->rows[i], *before = i ? row - 1 : row;
        bool same = before->link == row->link;
        bool anchored = row->kind == LINK_ANCHOR && row->b == 0 && row->cell_b == 0;
        bool good = row->joint <= 1 && row->glides <= 1 && row->link >= before->link && row->k > 0 && row->rest >= 0 &&
                    holds(row, cells, n, row->a, row->a_particle) &&
                    (anchored || holds(row, cells, n, row->b, row->b_particle)) &&
                    (!same || (before->cell_a == row->cell_a && before->cell_b == row->cell_b));
        if (!good)
            status = diag_error(d, "spring %zu of the links in the file holds no two particles of its cells", i + 1);
        else
            status = flat_check_link(s, (link_kind)row->kind, d);
    }
    free((void *)cells);
    return status;
}

static void add_link(const link_file_row *rows, size_t n, scene *s) {
    colony *c = s->colony;
    uint32_t link = colony_add_link(c, (link_kind)rows->kind, rows->cell_a, rows->cell_b, n);
    c->link.style[link] = (int32_t)rows->joint;
    c->link.birth[link] = s->time - rows->age;
    for (size_t i = 0; i < n; i++) {
        size_t spring = c->link.first[link] + i;
        const link_file_row *row = &rows[i];
        c->spring.a[spring] = c->cell.first[colony_row(c, row->a)] + (uint32_t)row->a_particle - 1;
        c->spring.b[spring] =
            row->b ? c->cell.first[colony_row(c, row->b)] + (uint32_t)row->b_particle - 1 : SPRING_ANCHOR;
        c->spring.k[spring] = row->k;
        c->spring.rest[spring] = row->rest;
        c->spring.glides[spring] = (uint32_t)row->glides;
        memcpy(c->spring.anchor + 3 * spring, row->anchor, sizeof row->anchor);
    }
}

void link_file_add(const link_file *l, scene *s) {
    for (size_t i = 0, n; i < l->n; i += n) {
        for (n = 1; i + n < l->n && l->rows[i + n].link == l->rows[i].link;)
            n++;
        add_link(&l->rows[i], n, s);
    }
}

/* ---- writing ---- */

/* The cell of a particle: one of the link's two. */
static uint32_t owner(colony *c, uint32_t link, uint32_t particle) {
    uint32_t row = colony_row(c, c->link.cell_a[link]);
    bool first = particle - c->cell.first[row] < c->cell.nparticles[row];
    return first ? row : colony_row(c, c->link.cell_b[link]);
}

static void put_end(FILE *f, colony *c, uint32_t link, uint32_t particle) {
    if (particle == SPRING_ANCHOR) {
        fputs(",0,0", f);
        return;
    }
    uint32_t row = owner(c, link, particle);
    fprintf(f, ",%" PRIu64 ",%u", c->cell.id[row], particle - c->cell.first[row] + 1);
}

static void put_spring(FILE *f, const scene *s, uint32_t link, size_t number, uint32_t spring) {
    colony *c = s->colony;
    fprintf(f, "%zu,%s,%d,%.17g,%" PRIu64 ",%" PRIu64, number, kinds[c->link.kind[link]], c->link.style[link],
            s->time - c->link.birth[link], c->link.cell_a[link], c->link.cell_b[link]);
    put_end(f, c, link, c->spring.a[spring]);
    put_end(f, c, link, c->spring.b[spring]);
    const double *anchor = c->spring.anchor + 3 * (size_t)spring;
    fprintf(f, ",%.17g,%.17g,%.17g,%.17g,%.17g,%u\n", c->spring.k[spring], c->spring.rest[spring], anchor[0], anchor[1],
            anchor[2], c->spring.glides[spring]);
}

void link_file_write(FILE *f, const scene *s) {
    const colony *c = s->colony;
    if (!c->link.count)
        return;
    fprintf(f, "\n%s\n%s\n", heading, header);
    uint32_t *order = colony_links_by_id(s->colony);
    for (size_t i = 0; i < c->link.count; i++)
        for (uint32_t k = 0; k < c->link.nsprings[order[i]]; k++)
            put_spring(f, s, order[i], i + 1, c->link.first[order[i]] + k);
    free(order);
}

/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "mechanics/grid.h"

#include "base/alloc.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

/* Level of a capsule: its half length and radius e are in [4^level, 4^(level + 1)). */
static int32_t level_of(const capsule *c) {
    double e = c->radius + 0.5 * sqrt(c->d[0] * c->d[0] + c->d[1] * c->d[1] + c->d[2] * c->d[2]);
    int twice = e > 0 ? ilogb(e) : 0;
    return (twice >= 0 ? twice : twice - 1) / 2;
}

/* Side of a level's bins: the middle of its range of sizes. */
static double bin_side(int32_t level) {
    return ldexp(2, 2 * level);
}

static int64_t bin_of(double x, double side) {
    double bin = floor(x / side), most = 0x1p40;
    return (int64_t)(bin < -most ? -most : bin > most ? most : bin);
}

static grid_place place_of(const capsule *c, uint32_t index) {
    int32_t level = level_of(c);
    double side = bin_side(level);
    return (grid_place){level, index, bin_of(c->x[2] + 0.5 * c->d[2], side), bin_of(c->x[1] + 0.5 * c->d[1], side),
                        c->x[0] + 0.5 * c->d[0]};
}

static int compare_bins(int32_t level_a, int64_t z_a, int64_t y_a, int32_t level_b, int64_t z_b, int64_t y_b) {
    if (level_a != level_b)
        return level_a < level_b ? -1 : 1;
    if (z_a != z_b)
        return z_a < z_b ? -1 : 1;
    return y_a < y_b ? -1 : y_a > y_b;
}

static int compare_places(const void *a, const void *b) {
    const grid_place *p = a, *q = b;
    int bins = compare_bins(p->level, p->z, p->y, q->level, q->z, q->y);
    if (bins)
        return bins;
    if (p->x != q->x)
        return p->x < q->x ? -1 : 1;
    return p->index < q->index ? -1 : p->index > q->index;
}

void grid_sort(grid *g, const void *capsules, bool flat, size_t n) {
    g->flat = flat;
    g->n = n;
    g->places = alloc_grow(g->places, &g->places_capacity, n, sizeof *g->places);
    for (size_t i = 0; i < n; i++) {
        capsule room;
        g->places[i] = place_of(capsule_get(capsules, i, flat, &room), (uint32_t)i);
    }
    qsort(g->places, n, sizeof *g->places, compare_places);
}

static grid_box box_of(const capsule *c, double reach, double beyond) {
    grid_box box;
    for (int k = 0; k < 3; k++) {
        box.centre[k] = c->x[k] + 0.5 * c->d[k];
        box.half[k] = 0.5 * fabs(c->d[k]) + reach * c->radius + beyond;
    }
    return box;
}

/* The last of the grid's levels is the one being filled: bodies come sorted by level. */
static void note_size(grid *g, int32_t level, const grid_box *box) {
    if (g->nlevels == 0 || g->levels[g->nlevels - 1] != level) {
        g->levels[g->nlevels++] = level;
        memset(g->most[g->nlevels - 1], 0, sizeof g->most[0]);
    }
    double *most = g->most[g->nlevels - 1];
    for (int k = 0; k < 3; k++)
        most[k] = box->half[k] > most[k] ? box->half[k] : most[k];
}

void grid_build(grid *g, const body *bodies, const void *capsules, double reach, double beyond) {
    g->boxes = alloc_grow(g->boxes, &g->boxes_capacity, g->n, sizeof *g->boxes);
    g->rows = alloc_grow(g->rows, &g->rows_capacity, g->n, sizeof *g->rows);
    g->nrows = 0;
    g->nlevels = 0;
    for (uint32_t i = 0; i < g->n; i++) {
        const grid_place *p = &g->places[i];
        capsule room;
        g->boxes[i] = box_of(capsule_get(capsules, i, g->flat, &room), reach, 0.5 * beyond + (double)bodies[i].leeway);
        note_size(g, p->level, &g->boxes[i]);
        grid_row *last = g->nrows ? &g->rows[g->nrows - 1] : NULL;
        if (!last || compare_bins(last->level, last->z, last->y, p->level, p->z, p->y) != 0)
            g->rows[g->nrows++] = (grid_row){p->level, p->z, p->y, i, i + 1};
        else
            last->end = i + 1;
    }
}

void grid_free(grid *g) {
    free(g->places);
    free(g->boxes);
    free(g->rows);
    memset(g, 0, sizeof *g);
}

/* First row that is not before these bins. */
static size_t first_row(const grid *g, int32_t level, int64_t z, int64_t y) {
    size_t low = 0, high = g->nrows;
    while (low < high) {
        size_t middle = (low + high) / 2;
        const grid_row *row = &g->rows[middle];
        if (compare_bins(row->level, row->z, row->y, level, z, y) < 0)
            low = middle + 1;
        else
            high = middle;
    }
    return low;
}

/* First slot of a row whose centre's x is not below x. */
static uint32_t first_slot(const grid *g, const grid_row *row, double x) {
    uint32_t low = row->begin, high = row->end;
    while (low < high) {
        uint32_t middle = low + (high - low) / 2;
        if (g->boxes[middle].centre[0] < x)
            low = middle + 1;
        else
            high = middle;
    }
    return low;
}

static bool meet(const grid_box *a, const grid_box *b) {
    return fabs(a->centre[0] - b->centre[0]) <= a->half[0] + b->half[0] &&
           fabs(a->centre[1] - b->centre[1]) <= a->half[1] + b->half[1] &&
           fabs(a->centre[2] - b->centre[2]) <= a->half[2] + b->half[2];
}

typedef struct search {
    const grid *g;
    size_t slot, own_row;
    uint32_t **found;
    size_t *capacity, count;
} search;

static void search_row(search *s, const grid_row *row, double span) {
    const grid_box *own = &s->g->boxes[s->slot];
    const double begin = own->centre[0] - span, end = own->centre[0] + span;
    uint32_t first = row->begin > s->slot ? first_slot(s->g, row, begin) : (uint32_t)s->slot + 1;
    *s->found = alloc_grow(*s->found, s->capacity, s->count + (row->end - row->begin), sizeof **s->found);
    for (uint32_t i = first; i < row->end && s->g->boxes[i].centre[0] <= end; i++)
        if (meet(own, &s->g->boxes[i]))
            (*s->found)[s->count++] = i;
}

/* All rows of a level that bodies meeting the box may stand in. */
static void search_level(search *s, int32_t level, const double most[3]) {
    const grid *g = s->g;
    const grid_box *own = &g->boxes[s->slot];
    double side = bin_side(level), span[3];
    int64_t low[3], high[3];
    for (int k = 0; k < 3; k++) {
        span[k] = own->half[k] + most[k];
        low[k] = bin_of(own->centre[k] - span[k], side);
        high[k] = bin_of(own->centre[k] + span[k], side);
    }
    size_t i = first_row(g, level, low[2], low[1]);
    i = i > s->own_row ? i : s->own_row;
    while (i < g->nrows && g->rows[i].level == level && g->rows[i].z <= high[2]) {
        const grid_row *row = &g->rows[i];
        if (row->y < low[1])
            i = first_row(g, level, row->z, low[1]);
        else if (row->y > high[1])
            i = first_row(g, level, row->z + 1, low[1]);
        else {
            search_row(s, row, span[0]);
            i++;
        }
    }
}

size_t grid_search(const grid *g, size_t slot, uint32_t **found, size_t *capacity) {
    const grid_place *p = &g->places[slot];
    search s = {g, slot, first_row(g, p->level, p->z, p->y), found, capacity, 0};
    for (int l = 0; l < g->nlevels; l++)
        if (g->levels[l] >= p->level) /* lower levels stand below */
            search_level(&s, g->levels[l], g->most[l]);
    return s.count;
}

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

/* Of a capsule as numbers. In the plane no z is set, nor looked at. */
DIMENSIONS_INLINE void set_box(grid_box *box, const double *c, double reach, double beyond, int dimensions) {
    for (int k = 0; k < dimensions; k++) {
        const double axis = c[CAPSULE_AXIS + k];
        box->centre[k] = c[k] + 0.5 * axis;
        box->half[k] = 0.5 * fabs(axis) + reach * c[dimensions] + beyond;
    }
}

/* The last of the grid's levels is the one being filled: bodies come sorted by level. */
DIMENSIONS_INLINE void note_size(grid *g, int32_t level, const grid_box *box, int dimensions) {
    if (g->nlevels == 0 || g->levels[g->nlevels - 1] != level) {
        g->levels[g->nlevels++] = level;
        memset(g->most[g->nlevels - 1], 0, sizeof g->most[0]);
    }
    double *most = g->most[g->nlevels - 1];
    for (int k = 0; k < dimensions; k++)
        most[k] = box->half[k] > most[k] ? box->half[k] : most[k];
}

static void begin_row(grid *g, const grid_place *p, uint32_t i) {
    grid_row *row = &g->rows[g->nrows++];
    *row = (grid_row){.level = p->level, .z = p->z, .y = p->y, .begin = i};
    for (int k = 0; k < 3; k++) {
        row->low[k] = (double)INFINITY;
        row->high[k] = -(double)INFINITY;
    }
}

DIMENSIONS_INLINE void add_to_row(grid_row *row, const grid_box *box, uint32_t i, int dimensions) {
    row->end = i + 1;
    row->longest = fmax(row->longest, box->half[0]);
    for (int k = 0; k < dimensions; k++) {
        row->low[k] = fmin(row->low[k], box->centre[k] - box->half[k]);
        row->high[k] = fmax(row->high[k], box->centre[k] + box->half[k]);
    }
}

DIMENSIONS_INLINE void build_in(grid *g, const body *bodies, const double *capsules, double reach, double beyond,
                                int dimensions) {
    for (uint32_t i = 0; i < g->n; i++) {
        const grid_place *p = &g->places[i];
        grid_box *box = &g->boxes[i];
        set_box(box, capsules + capsule_place(i, dimensions == 2), reach, 0.5 * beyond + (double)bodies[i].leeway,
                dimensions);
        note_size(g, p->level, box, dimensions);
        const grid_row *last = g->nrows ? &g->rows[g->nrows - 1] : NULL;
        if (!last || compare_bins(last->level, last->z, last->y, p->level, p->z, p->y) != 0)
            begin_row(g, p, i);
        add_to_row(&g->rows[g->nrows - 1], box, i, dimensions);
    }
}

void grid_build(grid *g, const body *bodies, const void *capsules, double reach, double beyond) {
    g->boxes = alloc_grow(g->boxes, &g->boxes_capacity, g->n, sizeof *g->boxes);
    g->rows = alloc_grow(g->rows, &g->rows_capacity, g->n, sizeof *g->rows);
    g->nrows = 0;
    g->nlevels = 0;
    if (g->flat)
        build_in(g, bodies, capsules, reach, beyond, 2);
    else
        build_in(g, bodies, capsules, reach, beyond, 3);
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

DIMENSIONS_INLINE bool meet(const grid_box *a, const grid_box *b, int dimensions) {
    const bool plane = (fabs(a->centre[0] - b->centre[0]) <= a->half[0] + b->half[0]) &
                       (fabs(a->centre[1] - b->centre[1]) <= a->half[1] + b->half[1]);
    return dimensions > 2 ? plane & (fabs(a->centre[2] - b->centre[2]) <= a->half[2] + b->half[2]) : plane;
}

static bool rows_meet(const grid_row *a, const grid_row *b, int dimensions) {
    for (int k = 0; k < dimensions; k++)
        if (!(a->low[k] <= b->high[k] && b->low[k] <= a->high[k]))
            return false;
    return true;
}

/* The rows of a level, from a row itself on, that its bodies may meet. */
static void add_windows(grid_search *s, int32_t level, const double most[3], size_t own) {
    const grid *g = s->g;
    const grid_row *from = &g->rows[own];
    const double side = bin_side(level);
    const int64_t y0 = bin_of(from->low[1] - most[1], side), y1 = bin_of(from->high[1] + most[1], side);
    const int64_t z0 = g->flat ? 0 : bin_of(from->low[2] - most[2], side);
    const int64_t z1 = g->flat ? 0 : bin_of(from->high[2] + most[2], side);
    size_t i = first_row(g, level, z0, y0);
    i = i > own ? i : own;
    while (i < g->nrows && g->rows[i].level == level && g->rows[i].z <= z1) {
        const grid_row *row = &g->rows[i];
        if (row->y < y0)
            i = first_row(g, level, row->z, y0);
        else if (row->y > y1 && g->flat)
            break;
        else if (row->y > y1)
            i = first_row(g, level, row->z + 1, y0);
        else {
            s->windows = alloc_grow(s->windows, &s->windows_capacity, s->nwindows + 1, sizeof *s->windows);
            s->windows[s->nwindows] = (grid_window){row->begin, row->end, row->longest};
            s->nwindows += rows_meet(from, row, g->flat ? 2 : 3);
            i++;
        }
    }
}

/* Windows for the row of a slot, and room for all that they hold. */
static void open_windows(grid_search *s, uint32_t slot) {
    const grid *g = s->g;
    const grid_place *p = &g->places[slot];
    const size_t own = first_row(g, p->level, p->z, p->y);
    size_t most = 1;
    s->nwindows = 0;
    s->row_end = g->rows[own].end;
    s->longest = g->rows[own].longest;
    for (int l = 0; l < g->nlevels; l++)
        if (g->levels[l] >= p->level) /* lower levels stand below */
            add_windows(s, g->levels[l], g->most[l], own);
    for (size_t i = 0; i < s->nwindows; i++)
        most += s->windows[i].end - s->windows[i].next;
    s->found = alloc_grow(s->found, &s->found_capacity, most, sizeof *s->found);
}

/* Candidates pass without a branch: whether boxes meet is anybody's guess. */
DIMENSIONS_INLINE uint32_t *look_through(const grid_box *boxes, double longest, grid_window *w, uint32_t slot,
                                         uint32_t *found, int dimensions) {
    const grid_box *own = &boxes[slot];
    const double begin = own->centre[0] - (longest + w->longest), end = own->centre[0] + (own->half[0] + w->longest);
    uint32_t i = w->next;
    while (i < w->end && boxes[i].centre[0] < begin)
        i++;
    w->next = i;
    for (i = i > slot ? i : slot + 1; i < w->end && boxes[i].centre[0] <= end; i++) {
        *found = i;
        found += meet(own, &boxes[i], dimensions);
    }
    return found;
}

DIMENSIONS_INLINE size_t find_in(grid_search *s, uint32_t slot, int dimensions) {
    uint32_t *found = s->found;
    for (size_t i = 0; i < s->nwindows; i++)
        found = look_through(s->g->boxes, s->longest, &s->windows[i], slot, found, dimensions);
    return (size_t)(found - s->found);
}

size_t grid_find(grid_search *s, uint32_t slot) {
    if (slot >= s->row_end)
        open_windows(s, slot);
    return s->g->flat ? find_in(s, slot, 2) : find_in(s, slot, 3);
}

void grid_search_free(grid_search *s) {
    free(s->windows);
    free(s->found);
}

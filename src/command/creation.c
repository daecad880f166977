/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "command/creation.h"

#include "base/alloc.h"

#include <math.h>
#include <stdlib.h>

enum { GRID_MAX = 10000000 };

double creation_count(const creation *c) {
    switch (c->kind) {
    case CREATION_SINGLE:
        return 1;
    case CREATION_RANDOM:
        return (double)c->n;
    case CREATION_GRID:
        break;
    }
    return (double)c->points[0] * (double)c->points[1] * (double)c->points[2];
}

static int make_grid(scene *s, const creation *c, size_t *created, diag *d) {
    const long long *n = c->points;
    if (creation_count(c) > GRID_MAX)
        return diag_error(d, "%lld x %lld x %lld cells are more than %d", n[0], n[1], n[2], GRID_MAX);
    size_t count = (size_t)(n[0] * n[1] * n[2]);
    cell_row *rows = alloc_zeroed(count, sizeof *rows);
    for (size_t i = 0; i < count; i++) {
        const size_t at[3] = {i % (size_t)n[0], i / (size_t)n[0] % (size_t)n[1], i / (size_t)(n[0] * n[1])};
        rows[i] = (cell_row){.species = c->placement.species, .mass = NAN, .diameter = NAN};
        for (int k = 0; k < 3; k++)
            rows[i].centre[k] = c->at[k] + (double)at[k] * c->step[k];
    }
    int status = scene_create_rows(s, &c->placement, rows, count, created, d);
    free(rows);
    return status;
}

int creation_make(scene *s, const creation *c, size_t *created, diag *d) {
    switch (c->kind) {
    case CREATION_SINGLE:
        return scene_create_single(s, &c->placement, c->at, created, d);
    case CREATION_RANDOM:
        return scene_create_random(s, &c->placement, (size_t)c->n, &c->where, c->spacing, created, d);
    case CREATION_GRID:
        break;
    }
    return make_grid(s, c, created, d);
}

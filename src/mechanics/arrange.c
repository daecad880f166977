/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Rows of the colony in the order of space: an evaluation then finds a body's particles near those of its neighbours.
 */
#include "mechanics/mechanics.h"

#include "base/alloc.h"
#include "mechanics/grid.h"

#include <stdlib.h>

/* Fewer cells than this lie in the cache in any order. */
enum { ARRANGE_LEAST = 500 };

void mechanics_arrange(colony *c) {
    size_t n = c->cell.count;
    if (n < ARRANGE_LEAST)
        return;
    capsule *capsules = alloc_aligned(n, sizeof *capsules, _Alignof(capsule));
    uint32_t *rows = alloc_zeroed(n, sizeof *rows);
    grid g = {0};
    for (size_t i = 0; i < n; i++) {
        const double *first = c->particle.x + 3 * (size_t)c->cell.first[i];
        const double *last = first + 3 * ((size_t)c->cell.nparticles[i] - 1);
        capsule_set(capsules, i, 3, first, last, 0.5 * c->cell.diameter[i], c->cell.rest[i]);
    }
    grid_sort(&g, capsules, false, n);
    for (size_t i = 0; i < n; i++)
        rows[i] = g.places[i].index;
    colony_arrange(c, rows, n);
    grid_free(&g);
    free(rows);
    free(capsules);
}

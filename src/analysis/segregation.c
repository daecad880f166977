/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "analysis/segregation.h"

#include "analysis/neighborhood.h"
#include "base/alloc.h"

#include <math.h>
#include <stdlib.h>

typedef struct products {
    const double *deviation; /* of the number from its mean, by cell row */
    double sum, pairs;
} products;

static void add_pair(void *self, uint32_t a, uint32_t b, double distance) {
    products *p = self;
    (void)distance;
    p->sum += p->deviation[a] * p->deviation[b];
    p->pairs += 1;
}

/* Fills deviation, and which cells count; the sum of squares. In the order of ids. */
static double center(const view *v, const bool *members, double *deviation, bool *counts, double *n) {
    colony *c = v->colony;
    const uint32_t *order = colony_by_id(c);
    double sum = 0, squares = 0;
    *n = 0;
    for (size_t i = 0; i < c->cell.count; i++) {
        uint32_t row = order[i];
        deviation[row] = v->of ? v->of[row] : (double)c->cell.generation[row];
        counts[row] = (!members || members[row]) && !isnan(deviation[row]);
        if (!counts[row])
            continue;
        *n += 1;
        sum += deviation[row];
    }
    for (size_t i = 0; i < c->cell.count; i++) {
        uint32_t row = order[i];
        deviation[row] -= sum / *n;
        if (counts[row])
            squares += deviation[row] * deviation[row];
    }
    return squares;
}

int segregation_measure(const view *v, const bool *members, double *out, diag *d) {
    (void)d;
    size_t cells = v->colony->cell.count;
    double *deviation = alloc_zeroed(cells, sizeof *deviation), n;
    bool *counts = alloc_zeroed(cells, sizeof *counts);
    double squares = center(v, members, deviation, counts, &n);
    products p = {.deviation = deviation};
    if (v->radius > 0)
        neighborhood_pairs(v, counts, v->radius, add_pair, &p);
    else
        neighborhood_contacts(v, counts, add_pair, &p);
    out[0] = p.pairs > 0 && squares > 0 ? n / p.pairs * p.sum / squares : (double)NAN;
    out[1] = p.pairs;
    out[2] = n > 1 ? -1 / (n - 1) : (double)NAN;
    free(deviation);
    free(counts);
    return SARCINA_OK;
}

/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The mean over pairs needs no correction for few neighbours, unlike the largest eigenvalue of a cell's own tensor. */
#include "analysis/order.h"

#include "analysis/cell.h"
#include "analysis/neighborhood.h"
#include "base/alloc.h"
#include "base/vec3.h"

#include <math.h>
#include <stdlib.h>

/* ---- axes ------------------------------------------------------------------------------------------------------- */

typedef struct pair_sum {
    const colony *c;
    double space, pairs, plane, flat_pairs;
} pair_sum;

static void add_pair(void *self, uint32_t a, uint32_t b, double distance) {
    pair_sum *s = self;
    double u[3], w[3];
    (void)distance;
    colony_axis(s->c, a, u);
    colony_axis(s->c, b, w);
    double cosine = u[0] * w[0] + u[1] * w[1] + u[2] * w[2];
    s->space += 1.5 * cosine * cosine - 0.5;
    s->pairs += 1;
    double square = (u[0] * u[0] + u[1] * u[1]) * (w[0] * w[0] + w[1] * w[1]);
    if (square < 1e-12) /* upright: seen from above it has no direction */
        return;
    double flat = u[0] * w[0] + u[1] * w[1];
    s->plane += 2 * flat * flat / square - 1;
    s->flat_pairs += 1;
}

int order_nematic(const view *v, const bool *members, double *out, diag *d) {
    (void)d;
    colony *c = v->colony;
    const uint32_t *order = colony_by_id(c);
    bool *counts = alloc_zeroed(c->cell.count, sizeof *counts);
    double n = 0, length = 0;
    for (size_t i = 0; i < c->cell.count; i++) {
        uint32_t row = order[i];
        double u[3];
        colony_axis(c, row, u);
        counts[row] = (!members || members[row]) && (u[0] != 0 || u[1] != 0 || u[2] != 0);
        if (!counts[row])
            continue;
        n += 1;
        length += cell_length(v, row);
    }
    pair_sum s = {.c = c};
    double radius = v->radius > 0 ? v->radius : n > 0 ? length / n : 0;
    neighborhood_pairs(v, counts, radius, add_pair, &s);
    out[0] = s.pairs > 0 ? s.space / s.pairs : (double)NAN;
    out[1] = s.flat_pairs > 0 ? s.plane / s.flat_pairs : (double)NAN;
    out[2] = s.pairs;
    out[3] = n > 0 ? radius : (double)NAN;
    free(counts);
    return SARCINA_OK;
}

/* ---- species ---------------------------------------------------------------------------------------------------- */

typedef struct nearest {
    const colony *c;
    double *distance; /* by cell row */
    uint32_t *other;
} nearest;

static void offer(nearest *k, uint32_t to, uint32_t other, double distance) {
    bool nearer = distance < k->distance[to] ||
                  (distance == k->distance[to] && k->c->cell.id[other] < k->c->cell.id[k->other[to]]);
    if (!nearer)
        return;
    k->distance[to] = distance;
    k->other[to] = other;
}

static void offer_pair(void *self, uint32_t a, uint32_t b, double distance) {
    offer(self, a, b, distance);
    offer(self, b, a, distance);
}

/* The nearest of every member: the radius is doubled until each has found one (there are two or more). */
static void find_nearest(const view *v, const bool *members, double radius, nearest *k) {
    size_t cells = v->colony->cell.count;
    for (bool all = false; !all && isfinite(radius); radius *= 2) {
        all = true;
        for (size_t row = 0; row < cells; row++)
            k->distance[row] = (double)INFINITY;
        neighborhood_pairs(v, members, radius, offer_pair, k);
        for (size_t row = 0; row < cells; row++)
            all = all && ((members && !members[row]) || k->distance[row] < (double)INFINITY);
    }
}

static void measure_mixing(const view *v, const bool *members, double n, double expected, double *out) {
    const colony *c = v->colony;
    size_t cells = c->cell.count;
    nearest k = {c, alloc_zeroed(cells, sizeof *k.distance), alloc_zeroed(cells, sizeof *k.other)};
    double length = 0, differ = 0;
    for (size_t row = 0; row < cells; row++)
        length = fmax(length, c->cell.diameter[row]);
    find_nearest(v, members, length > 0 ? 2 * length : 1, &k);
    for (uint32_t row = 0; row < cells; row++)
        if (!members || members[row])
            differ += c->cell.species[k.other[row]] != c->cell.species[row];
    out[1] = differ / n;
    out[0] = out[1] / expected;
    free(k.distance);
    free(k.other);
}

int order_mixing(const view *v, const bool *members, double *out, diag *d) {
    (void)d;
    const colony *c = v->colony;
    double n = 0, same = 0;
    double *of = alloc_zeroed(v->species->count, sizeof *of);
    for (size_t row = 0; row < c->cell.count; row++)
        if (!members || members[row]) {
            n += 1;
            of[c->cell.species[row]] += 1;
        }
    for (size_t k = 0; k < v->species->count; k++)
        same += of[k] * (of[k] - 1);
    free(of);
    out[0] = out[1] = NAN;
    out[2] = n > 1 ? 1 - same / (n * (n - 1)) : (double)NAN;
    if (out[2] > 0)
        measure_mixing(v, members, n, out[2], out);
    return SARCINA_OK;
}

/* ---- heights ---------------------------------------------------------------------------------------------------- */

int order_layering(const view *v, const bool *members, double *out, diag *d) {
    (void)d;
    colony *c = v->colony;
    const uint32_t *order = colony_by_id(c);
    double n = 0, diameter = 0, floor_z = INFINITY, highest = 0, sum = 0, first = 0;
    for (size_t i = 0; i < c->cell.count; i++) {
        uint32_t row = order[i];
        if (members && !members[row])
            continue;
        n += 1;
        diameter += c->cell.diameter[row];
        floor_z = fmin(floor_z, cell_zmin(v, row) - 0.5 * c->cell.diameter[row]);
    }
    for (uint32_t row = 0; row < c->cell.count; row++) {
        if (members && !members[row])
            continue;
        double layer = 1 + rint((cell_zmin(v, row) - 0.5 * c->cell.diameter[row] - floor_z) * n / diameter);
        highest = fmax(highest, layer);
        sum += layer; /* whole numbers: the order does not matter */
        first += layer == 1;
    }
    out[0] = n > 0 ? highest : (double)NAN;
    out[1] = n > 0 ? sum / n : (double)NAN;
    out[2] = n > 0 ? first / n : (double)NAN;
    return SARCINA_OK;
}

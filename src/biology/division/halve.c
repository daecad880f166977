/* SPDX-License-Identifier: GPL-3.0-or-later */
/* A flexible cell divides at half its length, as a rod does: mother and daughter keep an end each, and half a diameter
 * away from the middle stand the new ends, so that their balls touch. Both are sampled anew on the mother's curve
 * (chain_point), as many particles each as she had: a coil stays the helix it was. */
#include "biology/division/rules.h"

#include "base/alloc.h"
#include "model/chain.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

/* The mother before: her particles and their velocities (n x 3). */
typedef struct original {
    const chain_coil *coil;
    size_t n;
    double arc; /* of a segment at rest, um */
    const double *x, *v;
    vec3 side; /* to which the coil of a straight one is turned: seeded */
} original;

/* Velocity at u segments from the first particle. */
static vec3 velocity_at(const original *o, double u) {
    size_t i = u > 0 ? (size_t)u : 0;
    i = i < o->n - 2 ? i : o->n - 2;
    double t = u - (double)i;
    return vec3_axpy(vec3_scale(1 - t, vec3_load(o->v + 3 * i)), t, vec3_load(o->v + 3 * i + 3));
}

/* Spreads a cell's particles evenly from `from` to `to` along the original, in its segments. */
static void sample(const division_context *x, const original *o, uint32_t cell, double from, double to) {
    for (uint32_t i = 0; i < o->n; i++) {
        double u = i + 1 < o->n ? from + (to - from) * i / (double)(o->n - 1) : to;
        vec3_store(division_place(x->colony, cell, i), chain_point(o->coil, o->arc, o->x, o->n, u, o->side));
        vec3_store(division_velocity(x->colony, cell, i), velocity_at(o, u));
    }
}

void division_halve(const division_context *x, uint32_t mother, uint32_t daughter) {
    colony *c = x->colony;
    const species *s = &x->species->list[c->cell.species[mother]];
    size_t n = c->cell.nparticles[mother], bytes = 3 * n * sizeof(double);
    double *copy = alloc_zeroed(6 * n, sizeof *copy);
    memcpy(copy, division_place(c, mother, 0), bytes);
    memcpy(copy + 3 * n, division_velocity(c, mother, 0), bytes);
    double side[3];
    rng_direction(rng_get_seed(x->rng), c->cell.id[mother], c->cell.id[daughter], side);
    /* both halves are at their new size: the whole was twice the mother's rest and 2/3 of a diameter long */
    double length = 2 * c->cell.rest[mother] + 2 * c->cell.diameter[mother] / 3, segments = (double)(n - 1);
    const original o = {&s->coil, n, length / segments, copy, copy + 3 * n, vec3_load(side)};
    double short_of = fmin(0.5 * c->cell.diameter[mother] / length, 0.4) * segments,
           far_from = fmin(0.5 * c->cell.diameter[daughter] / length, 0.4) * segments;
    sample(x, &o, mother, 0, 0.5 * segments - short_of);
    sample(x, &o, daughter, 0.5 * segments + far_from, segments);
    double *first = division_place(c, daughter, 0);
    vec3_store(first, vec3_add(vec3_load(first), division_jitter(x, &s->division, c->cell.id[daughter])));
    for (uint32_t i = 0; i < n; i++) {
        division_lift(x, mother, i);
        division_lift(x, daughter, i);
    }
    free(copy);
}

/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The spring inside a rod: F = k (L - L0) along the rod on each end, E = k/2 (L - L0)^2; k by species, L0 the cell's
 * rest length, which its mass sets. A rod of length zero takes a seeded direction. A flexible cell has one spring a
 * segment, whose rest length is its part of the cell's.
 * Source: Storck et al. 2014, "Primary structure". */
#include "mechanics/force/forces.h"
#include "mechanics/spring.h"

#include <math.h>

/* A rod's spring: tension (k times stretch) over length, and the vector of that length from its first particle. */
DIMENSIONS_INLINE double pull(const force_frame *at, const body *b, int dimensions, double d[3]) {
    const double *x = at->x + (size_t)dimensions * b->first;
    for (int i = 0; i < dimensions; i++)
        d[i] = x[i + dimensions] - x[i];
    double length = sqrt(dimensions_square(d, dimensions));
    if (length > 0)
        return b->internal_k * (length - b->rest) / length;
    force_direction(at, body_particle_key(b, b->first), body_particle_key(b, b->first + 1), d);
    return -b->internal_k * b->rest;
}

DIMENSIONS_INLINE void add_in(const force_frame *at, size_t begin, size_t end, double *f, int dimensions) {
    for (size_t slot = begin; slot < end; slot++) {
        const body *b = &at->bodies[slot];
        if (b->count != 2 || b->internal_k == 0)
            continue;
        double d[3], factor = pull(at, b, dimensions, d), *out = f + (size_t)dimensions * b->first;
        for (int i = 0; i < dimensions; i++) {
            out[i] += factor * d[i];
            out[i + dimensions] -= factor * d[i];
        }
    }
}

static void add(const double *p, const force_frame *at, size_t begin, size_t end, double *f) {
    (void)p;
    if (at->flat)
        add_in(at, begin, end, f, 2);
    else
        add_in(at, begin, end, f, 3);
}

static double energy(const double *p, const force_frame *at, size_t slot) {
    (void)p;
    const body *b = &at->bodies[slot];
    if (b->count != 2 || b->internal_k == 0)
        return 0;
    const int dimensions = force_dimensions(at);
    const double *x = at->x + (size_t)dimensions * b->first;
    double stretch = sqrt(dimensions_apart(x + dimensions, x, dimensions)) - b->rest;
    return 0.5 * b->internal_k * stretch * stretch;
}

static void stiffness(const double *p, const force_frame *at, const uint32_t *slots, size_t n, stiff_list *out) {
    (void)p;
    const int dimensions = force_dimensions(at);
    for (size_t i = 0; i < n; i++) {
        const body *b = &at->bodies[slots[i]];
        if (b->count != 2 || b->internal_k == 0)
            continue;
        stiff_spring *s = force_spring_add(out, i, b->internal_k);
        const double *x = at->x + (size_t)dimensions * b->first;
        double u[3], length = spring_direction(x, x + dimensions, at, body_particle_key(b, b->first),
                                               body_particle_key(b, b->first + 1), u);
        s->pull = force_spring_pull(s->k, b->rest, length);
        force_spring_end(s, b->first, 1, u);
        force_spring_end(s, b->first + 1, -1, u);
    }
}

/* Stretch of a chain's i-th segment, and its direction. */
static double stretch_of(const force_frame *at, const chain *c, uint32_t i, double u[3]) {
    const double *x = at->x + 3 * ((size_t)c->first + i);
    return spring_direction(x, x + 3, at, body_chain_key(c, i), body_chain_key(c, i + 1), u) - c->rest;
}

static void add_chain(const double *p, const force_frame *at, size_t begin, size_t end, double *f) {
    (void)p;
    for (const chain *c = at->chains + begin; c < at->chains + end; c++)
        for (uint32_t i = 0; c->internal_k > 0 && i + 1 < c->count; i++) {
            double u[3], tension = c->internal_k * stretch_of(at, c, i, u), *out = f + 3 * ((size_t)c->first + i);
            for (int k = 0; k < 3; k++) {
                out[k] += tension * u[k];
                out[k + 3] -= tension * u[k];
            }
        }
}

static double energy_chain(const double *p, const force_frame *at, size_t index) {
    (void)p;
    const chain *c = &at->chains[index];
    double sum = 0, u[3];
    for (uint32_t i = 0; i + 1 < c->count; i++) {
        double stretch = stretch_of(at, c, i, u);
        sum += 0.5 * c->internal_k * stretch * stretch;
    }
    return sum;
}

static void stiffness_chain(const double *p, const force_frame *at, size_t index, stiff_list *out) {
    (void)p;
    const chain *c = &at->chains[index];
    for (uint32_t i = 0; c->internal_k > 0 && i + 1 < c->count; i++) {
        double u[3], stretch = stretch_of(at, c, i, u);
        stiff_spring *s = force_spring_add(out, 0, c->internal_k);
        s->pull = force_spring_pull(s->k, c->rest, c->rest + stretch);
        force_spring_end(s, c->first + i, 1, u);
        force_spring_end(s, c->first + i + 1, -1, u);
    }
}

/* Has a cell a link of its own, such as a spring listed between its ends? */
static bool has_own_link(const colony *c, uint64_t id) {
    for (size_t l = 0; l < c->link.count; l++)
        if (c->link.kind[l] == LINK_SPRING && c->link.cell_a[l] == id && c->link.cell_b[l] == id)
            return true;
    return false;
}

/* Every rod needs its spring: without one its ends would be free of each other. */
static int prepare(const double *p, const force_scene *scene, diag *d) {
    (void)p;
    const cell_columns *cells = &scene->colony->cell;
    for (size_t i = 0; i < cells->count; i++) {
        const species *s = &scene->species->list[cells->species[i]];
        if (cells->nparticles[i] < 2 || s->internal_k > 0 || has_own_link(scene->colony, cells->id[i]))
            continue;
        diag_error(d, "species %s is %s without link internal: nothing holds its ends together", s->name,
                   cells->nparticles[i] > 2 ? "flexible" : "a rod");
        return diag_help(d, "link internal %s k 5e-11N/m", s->name);
    }
    return SARCINA_OK;
}

const force_style force_internal = {
    .name = "internal",
    .summary = "the spring inside each rod, and each segment of a flexible cell",
    .formula = "F = k (L - L0) along the rod; E = k/2 (L - L0)^2; k by species",
    .source = "Storck et al. 2014, primary structure",
    .example = "link internal ecoli k 5e-11N/m",
    .caps = FORCE_CONSERVATIVE | FORCE_BALANCED | FORCE_CENTRAL | FORCE_WITHIN_CHAINS,
    .prepare = prepare,
    .add = add,
    .energy = energy,
    .stiffness = stiffness,
    .add_chain = add_chain,
    .energy_chain = energy_chain,
    .stiffness_chain = stiffness_chain,
};

/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The springs of links: F on a = k (L - L0) u, u the unit vector from a to b, E = k/2 (L - L0)^2.
 *
 * An anchor holds a particle to a fixed point; a gliding one follows below the particle, so that only z counts. A
 * spring of length zero takes a seeded direction; an anchor of length zero one of those that point down, to where
 * anchors are: what it pushes away, it pushes off the substratum. For a gliding one that is straight down.
 * Source: Storck et al. 2014, "Filial, sticking and anchoring links". */
#include "mechanics/force/forces.h"
#include "mechanics/spring.h"

#include <math.h>

/* The direction of an anchor that has no length, from its particle. */
static void anchor_direction(const force_frame *at, bool glides, uint64_t key, double u[3]) {
    force_direction(at, key, 0, u);
    u[0] = glides ? 0 : u[0];
    u[1] = glides ? 0 : u[1];
    u[2] = glides ? -1 : -fabs(u[2]);
}

/* Length of the spring that ends at a particle, and its direction from there. */
static double reach_end(const force_frame *at, const spring_end *end, uint64_t key, uint32_t particle, double u[3]) {
    const spring_columns *springs = at->springs->springs;
    const size_t width = (size_t)force_dimensions(at);
    const double *x = at->x + width * particle;
    if (end->other != SPRING_ANCHOR)
        return spring_direction(x, at->x + width * end->other, at, key, end->key, u);
    const double *anchor = springs->anchor + 3 * (size_t)end->spring;
    bool glides = springs->glides[end->spring];
    double d[3] = {glides ? 0 : anchor[0] - x[0], glides ? 0 : anchor[1] - x[1], at->flat ? 0 : anchor[2] - x[2]};
    double length = sqrt(d[0] * d[0] + d[1] * d[1] + d[2] * d[2]);
    for (int i = 0; i < 3; i++)
        u[i] = d[i] / length;
    if (length == 0)
        anchor_direction(at, glides, key, u);
    return length;
}

/* What an anchor, or a spring of length zero, does to its particle: apart, so that the loop over all others needs few
 * registers. */
static __attribute__((noinline)) void pull_special(const force_frame *at, const body *b, const spring_end *end,
                                                   uint32_t particle, double f[3]) {
    double u[3], length = reach_end(at, end, body_particle_key(b, particle), particle, u);
    const double tension = end->k * (length - end->rest);
    for (int i = 0; i < 3; i++)
        f[i] = tension * u[i];
}

/* The same of all others; false: it is one of those. */
DIMENSIONS_INLINE bool pull(const force_frame *at, const spring_end *end, const double *x, double *f, int dimensions) {
    if (end->other == SPRING_ANCHOR)
        return false;
    const double *other = at->x + (size_t)dimensions * end->other;
    double d[3];
    for (int i = 0; i < dimensions; i++)
        d[i] = other[i] - x[i];
    const double length = sqrt(dimensions_square(d, dimensions));
    const double factor = end->k * (length - end->rest) / length;
    for (int i = 0; i < dimensions; i++)
        f[i] = factor * d[i];
    return length > 0;
}

DIMENSIONS_INLINE void add_particle(const force_frame *at, const body *b, uint32_t particle, double *f,
                                    int dimensions) {
    const spring_index *index = at->springs;
    const double *x = at->x + (size_t)dimensions * particle;
    double *out = f + (size_t)dimensions * particle, sum[3] = {0, 0, 0};
    const spring_end *last = index->ends + index->start[particle + 1];
    for (const spring_end *end = index->ends + index->start[particle]; end < last; end++) {
        double own[3];
        if (pull(at, end, x, own, dimensions)) {
            for (int i = 0; i < dimensions; i++)
                sum[i] += own[i];
            continue;
        }
        double special[3];
        pull_special(at, b, end, particle, special);
        for (int i = 0; i < dimensions; i++)
            sum[i] += special[i];
    }
    for (int i = 0; i < dimensions; i++)
        out[i] += sum[i];
}

DIMENSIONS_INLINE void add_in(const force_frame *at, size_t begin, size_t end, double *f, int dimensions) {
    for (size_t slot = begin; slot < end; slot++) {
        const body *b = &at->bodies[slot];
        const uint32_t *start = at->springs->start + b->first;
        if (start[0] == start[b->owned])
            continue; /* no spring ends here */
        for (uint32_t i = b->first; i < b->first + b->owned; i++)
            add_particle(at, b, i, f, dimensions);
    }
}

static void add(const double *p, const force_frame *at, size_t begin, size_t end, double *f) {
    (void)p;
    if (at->flat)
        add_in(at, begin, end, f, 2);
    else
        add_in(at, begin, end, f, 3);
}

/* A spring between two particles belongs to its particle a. */
static bool is_owner(const force_frame *at, const spring_end *end, uint32_t particle) {
    return at->springs->springs->a[end->spring] == particle;
}

static double energy(const double *p, const force_frame *at, size_t slot) {
    (void)p;
    const spring_index *index = at->springs;
    const body *b = &at->bodies[slot];
    double sum = 0;
    for (uint32_t i = b->first; i < b->first + b->owned; i++)
        for (uint32_t e = index->start[i]; e < index->start[i + 1]; e++) {
            const spring_end *end = &index->ends[e];
            if (!is_owner(at, end, i))
                continue;
            double u[3],
                stretch = reach_end(at, end, body_particle_key(b, i), i, u) - index->springs->rest[end->spring];
            sum += 0.5 * index->springs->k[end->spring] * stretch * stretch;
        }
    return sum;
}

/* Those of one body. */
static void add_stiffness(const force_frame *at, const body *b, size_t of, stiff_list *out) {
    const spring_index *index = at->springs;
    for (uint32_t i = b->first; i < b->first + b->owned; i++)
        for (uint32_t e = index->start[i]; e < index->start[i + 1]; e++) {
            const spring_end *end = &index->ends[e];
            if (!is_owner(at, end, i))
                continue;
            stiff_spring *s = force_spring_add(out, of, index->springs->k[end->spring]);
            double u[3], length = reach_end(at, end, body_particle_key(b, i), i, u);
            if (!index->springs->glides[end->spring])
                s->pull = force_spring_pull(s->k, index->springs->rest[end->spring], length);
            force_spring_end(s, i, 1, u);
            if (end->other != SPRING_ANCHOR)
                force_spring_end(s, end->other, -1, u);
        }
}

static void stiffness(const double *p, const force_frame *at, const uint32_t *slots, size_t n, stiff_list *out) {
    (void)p;
    for (size_t i = 0; i < n; i++)
        add_stiffness(at, &at->bodies[slots[i]], i, out);
}

const force_style force_springs = {
    .name = "springs",
    .summary = "the springs of filial, sticking and anchoring links",
    .formula = "F on a = k (L - L0) u, u from a to b; E = k/2 (L - L0)^2",
    .source = "Storck et al. 2014, links",
    .example = "link filial ff k 2e-11N/m break 2um short 0.5 long 1.7",
    .caps = FORCE_CONSERVATIVE | FORCE_BALANCED | FORCE_CENTRAL | FORCE_READS_SPRINGS,
    .add = add,
    .energy = energy,
    .stiffness = stiffness,
};

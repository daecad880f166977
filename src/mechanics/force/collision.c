/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Contact between cells: E = k/2 d^2, d the overlap of mechanics/contact.h, under one of two laws: regularised (the
 * default; conservative and smooth) and closest (the published one).
 *
 * The cell of lower id is always A, so both owners compute the identical contact and momentum cancels exactly. Axes
 * that meet have no direction between them: they take a seeded one, with the full force k d.
 * Source: Storck et al. 2014, "Cell-cell collision"; regularised: this project's design notes, model, section 3. */
#include "mechanics/force/forces.h"
#include "mechanics/kernel.h"
#include "mechanics/neighbor.h"

#include <math.h>
#include <stdbool.h>

static contact_law_values law_of(const double *p) {
    bool regularised = (contact_law)p[COLLISION_CONTACT] == CONTACT_REGULARISED;
    return (contact_law_values){p[COLLISION_K], p[COLLISION_REACH], regularised ? p[COLLISION_EPSILON] : 0};
}

/* The contact of two bodies, one by one. Without axes most of the law is constant; in the plane no z of it is set but
 * that of delta. */
DIMENSIONS_INLINE contact_result touch(const force_frame *at, contact_law_values law, size_t slot_a, size_t slot_b,
                                       bool axes, int dimensions) {
    const double *a = (const double *)at->capsules + capsule_place(slot_a, dimensions == 2);
    const double *b = (const double *)at->capsules + capsule_place(slot_b, dimensions == 2);
    const int rest = capsule_rest(dimensions);
    contact_pair pair = {.radii = a[dimensions] + b[dimensions], .rests = axes ? a[rest] * b[rest] : 0};
    for (int k = 0; k < dimensions; k++) {
        pair.r[k] = a[k] - b[k];
        pair.d1[k] = axes ? a[CAPSULE_AXIS + k] : 0;
        pair.d2[k] = axes ? b[CAPSULE_AXIS + k] : 0;
    }
    contact_result c = contact_compute_in(dimensions, law, pair);
    if (dimensions == 2)
        c.delta[2] = 0;
    return c;
}

static contact_result touch_segments(const force_frame *at, contact_law_values law, size_t a, size_t b) {
    return touch(at, law, a, b, true, 3);
}

static contact_result touch_segments_flat(const force_frame *at, contact_law_values law, size_t a, size_t b) {
    return touch(at, law, a, b, true, 2);
}

static contact_result touch_spheres(const force_frame *at, contact_law_values law, size_t a, size_t b) {
    return touch(at, law, a, b, false, 3);
}

static contact_result touch_spheres_flat(const force_frame *at, contact_law_values law, size_t a, size_t b) {
    return touch(at, law, a, b, false, 2);
}

static contact_result contact_with(const force_frame *at, contact_law_values law, size_t slot, uint32_t partner) {
    if (at->flat)
        return (at->cocci ? touch_spheres_flat : touch_segments_flat)(at, law, slot, partner);
    return (at->cocci ? touch_spheres : touch_segments)(at, law, slot, partner);
}

/* What follows is compiled for each kind of scene, with and without flexible cells, in space and in the plane: a test a
 * row would be 0.3 % of an evaluation. */
#define COLLISION_INLINE static inline __attribute__((always_inline))
typedef struct kind {
    bool chains, axes;
    int dimensions;
} kind;

/* Gives an owner the sum of its row. The last particle of a chain's segment belongs to the next one: its share waits
 * there until all bodies are done. */
COLLISION_INLINE void give(const force_frame *at, const body *owner, const kernel_sums *sums, size_t lane, double *f,
                           kind of) {
    const size_t width = (size_t)of.dimensions;
    double *first = f + width * owner->first, *last = first + width * (owner->count - 1);
    if (of.chains && owner->chained) {
        last = at->shares + 3 * (size_t)(owner->first + 1);
        last[0] = last[1] = last[2] = 0;
    }
    for (int k = 0; k < of.dimensions; k++) {
        first[k] += of.axes ? sums->total[k][lane] - sums->last[k][lane] : sums->total[k][lane];
        if (of.axes)
            last[k] += sums->last[k][lane];
    }
}

/* Contact with coincident axes: the full force k R' along the pair's own random direction. */
static void push_coincident(const force_frame *at, contact_law_values law, const body *a, const body *b,
                            contact_result *c) {
    if (c->square >= CONTACT_COINCIDENT * CONTACT_COINCIDENT || c->g >= c->reach)
        return;
    force_direction(at, body_key(a), body_key(b), c->delta);
    c->scale = law.k * (sqrt(c->reach) - sqrt(c->g));
}

/* The sums of an owner's row one by one, as the kernel makes them, with those that have coincident axes. */
static void sum_slowly(const force_frame *at, contact_law_values law, uint32_t slot, size_t lane, kernel_sums *sums) {
    const body *own = &at->bodies[slot];
    neighbor_row row = neighbor_get(at->neighbor, at->bodies, slot);
    for (int k = 0; k < 3; k++)
        sums->total[k][lane] = sums->last[k][lane] = 0;
    for (size_t i = 0; i < row.nlower + row.nupper; i++) {
        bool own_is_a = i >= row.nlower;
        uint32_t partner = own_is_a ? row.upper[i - row.nlower] : row.lower[i];
        const body *other = &at->bodies[partner];
        contact_result c = own_is_a ? contact_with(at, law, slot, partner) : contact_with(at, law, partner, slot);
        push_coincident(at, law, own_is_a ? own : other, own_is_a ? other : own, &c);
        double place = own_is_a ? c.s : c.t, scale = own_is_a ? c.scale : -c.scale;
        for (int k = 0; k < 3; k++) {
            double force = scale * c.delta[k];
            sums->total[k][lane] += force;
            sums->last[k][lane] += place * force;
        }
    }
}

/* The sums of all owners of a group. */
static void sum_group(const force_frame *at, const contact_law_values *law, size_t group, kernel_rows *rows,
                      kernel_sums *sums) {
    uint32_t buffer[NEIGHBOR_BLOCK * KERNEL_LANES];
    bool coincident = false;
    size_t begin = 0;
    do {
        begin = neighbor_rows(at->neighbor, group, begin, buffer, rows);
        coincident |= at->kernel->rows[at->cocci][at->flat](law, rows, sums);
    } while (begin);
    for (size_t l = 0; coincident && l < KERNEL_LANES; l++)
        if (rows->owners[l] < at->nbodies)
            sum_slowly(at, *law, rows->owners[l], l, sums);
}

COLLISION_INLINE void add_rows(const double *p, const force_frame *at, size_t begin, size_t end, double *f, kind of) {
    const contact_law_values law = law_of(p);
    kernel_rows rows = {.capsules = at->capsules};
    kernel_sums sums;
    for (size_t g = begin / KERNEL_LANES; g < neighbor_groups(end); g++) {
        sum_group(at, &law, g, &rows, &sums);
        for (size_t l = 0; l < KERNEL_LANES; l++)
            if (rows.owners[l] < at->nbodies)
                give(at, &at->bodies[rows.owners[l]], &sums, l, f, of);
    }
}

static void add(const double *p, const force_frame *at, size_t begin, size_t end, double *f) {
    if (SARCINA_FLEXIBLE && at->nchains)
        add_rows(p, at, begin, end, f, (kind){true, true, 3});
    else if (at->flat && at->cocci)
        add_rows(p, at, begin, end, f, (kind){false, false, 2});
    else if (at->flat)
        add_rows(p, at, begin, end, f, (kind){false, true, 2});
    else if (at->cocci)
        add_rows(p, at, begin, end, f, (kind){false, false, 3});
    else
        add_rows(p, at, begin, end, f, (kind){false, true, 3});
}

/* The owners of a chain's particles take the shares that its segments left for them. */
static void add_chain(const double *p, const force_frame *at, size_t begin, size_t end, double *f) {
    (void)p;
    for (size_t c = begin; c < end; c++) {
        size_t first = 3 * (size_t)at->chains[c].first;
        for (size_t i = first + 3; i < first + 3 * (size_t)at->chains[c].count; i++)
            f[i] += at->shares[i];
    }
}

static double energy(const double *p, const force_frame *at, size_t slot) {
    contact_law_values law = law_of(p);
    neighbor_row row = neighbor_get(at->neighbor, at->bodies, slot);
    double sum = 0;
    for (size_t i = 0; i < row.nupper; i++) {
        contact_result c = contact_with(at, law, slot, row.upper[i]);
        double overlap = contact_overlap(&c);
        sum += 0.5 * law.k * overlap * overlap;
    }
    return sum;
}

/* Two bodies that touch, the one of lower id first, and the first one's place among those asked for. */
typedef struct touching {
    uint32_t slot, partner, of;
} touching;

/* The spring of a contact, its ends shared by the lever rule; along the direction in which the force acts. */
static void add_spring(const force_frame *at, const touching *who, const contact_result *c, double k, stiff_list *out) {
    const body *pair[2] = {&at->bodies[who->slot], &at->bodies[who->partner]};
    const double place[2] = {c->s, c->t};
    stiff_spring *spring = force_spring_add(out, who->of, k);
    double length = sqrt(c->square), u[3];
    for (int i = 0; i < 3; i++)
        u[i] = c->delta[i] / length;
    if (length < CONTACT_COINCIDENT)
        force_direction(at, body_key(pair[0]), body_key(pair[1]), u);
    for (int side = 0; side < 2; side++) {
        double sign = side ? -1 : 1;
        force_spring_end(spring, pair[side]->first, sign * (1 - place[side]), u);
        if (pair[side]->count > 1)
            force_spring_end(spring, pair[side]->first + 1, sign * place[side], u);
    }
}

/* How a contact resists that its nearest points slide: with h = R' - sqrt G, E'' = k g g' - k h (sqrt G)'', and where
 * s, t are free G'' has -G_xs G_ss^-1 G_sx in it, which makes rods that lie on each other stiff against being turned.
 * One spring a free parameter, of constant k h / (2 sqrt G), orthogonalised (Cholesky). */
typedef struct slide {
    double d[2][3];             /* the axes of A and B, um; 0: a coccus */
    double part[2][4][3];       /* half of d/dx of dG/ds, dG/dt, by particle: both of A, both of B */
    double diagonal[2], across; /* half of the second derivatives of G by s, t */
} slide;

static slide find_slide(const capsule *a, const capsule *b, const contact_result *c, double w) {
    slide v;
    const double place[2] = {c->s, c->t};
    for (int k = 0; k < 3; k++) {
        v.d[0][k] = a->d[k];
        v.d[1][k] = b->d[k];
    }
    for (int side = 0; side < 2; side++)
        for (int end = 0; end < 4; end++) {
            /* delta = (1 - s) A0 + s A1 - (1 - t) B0 - t B1 */
            double share = end % 2 ? place[end / 2] : 1 - place[end / 2], weight = end / 2 == side ? share : -share;
            double own = end / 2 != side ? 0 : end % 2 ? 1 : -1;
            for (int k = 0; k < 3; k++)
                v.part[side][end][k] = weight * v.d[side][k] + (side ? -own : own) * c->delta[k];
        }
    v.across = 0;
    for (int side = 0; side < 2; side++) {
        v.diagonal[side] = w;
        for (int k = 0; k < 3; k++)
            v.diagonal[side] += v.d[side][k] * v.d[side][k];
    }
    for (int k = 0; k < 3; k++)
        v.across -= v.d[0][k] * v.d[1][k];
    return v;
}

/* One spring of those: g = part / root of the pivot. */
static void add_slide(const body *const pair[2], uint32_t of, double part[4][3], double pivot, double k,
                      stiff_list *out) {
    stiff_spring *spring = force_spring_add(out, of, k);
    for (uint32_t end = 0; end < 4; end++)
        if (end % 2 == 0 || pair[end / 2]->count > 1)
            force_spring_end(spring, pair[end / 2]->first + end % 2, 1 / sqrt(pivot), part[end]);
}

static void add_slides(const force_frame *at, contact_law_values law, const touching *who, const contact_result *c,
                       stiff_list *out) {
    const body *const pair[2] = {&at->bodies[who->slot], &at->bodies[who->partner]};
    capsule room[2];
    const capsule *a = capsule_get(at->capsules, who->slot, at->flat, &room[0]),
                  *b = capsule_get(at->capsules, who->partner, at->flat, &room[1]);
    double square = law.reach * (a->radius + b->radius), rests = a->rest * b->rest;
    square *= square;
    const double root = sqrt(c->g), k = law.k * contact_overlap(c) / root;
    slide v = find_slide(a, b, c, law.epsilon * (rests < square ? rests : square));
    const bool free_s = c->s > 0 && c->s<1, free_t = c->t> 0 && c->t < 1;
    if (!(root > CONTACT_COINCIDENT))
        return;
    if (free_s)
        add_slide(pair, who->of, v.part[0], v.diagonal[0], k, out);
    double pivot = v.diagonal[1] - (free_s ? v.across * v.across / v.diagonal[0] : 0);
    if (!free_t || !(pivot > CONTACT_PARALLEL * v.diagonal[1]))
        return;
    double rest[4][3];
    for (int end = 0; end < 4; end++)
        for (int i = 0; i < 3; i++)
            rest[end][i] = v.part[1][end][i] - (free_s ? v.across / v.diagonal[0] * v.part[0][end][i] : 0);
    add_slide(pair, who->of, rest, pivot, k, out);
}

/* Pairs of a few bodies at once. */
typedef struct pairs {
    size_t n;
    touching who[KERNEL_BATCH];
    kernel_batch batch;
} pairs;

static void flush_springs(const force_frame *at, contact_law_values law, pairs *w, stiff_list *out) {
    const kernel_batch *b = &w->batch;
    at->kernel->contact[at->cocci][at->flat](&law, w->n, &w->batch);
    for (size_t i = 0; i < w->n; i++) {
        if (!(b->g[i] < b->reach[i]))
            continue;
        const double z = at->flat ? 0 : b->delta[2][i];
        const contact_result c = {.s = b->s[i],
                                  .t = b->t[i],
                                  .delta = {b->delta[0][i], b->delta[1][i], z},
                                  .square = b->square[i],
                                  .g = b->g[i],
                                  .reach = b->reach[i]};
        add_spring(at, &w->who[i], &c, law.k, out);
        if (out->curved && !at->cocci)
            add_slides(at, law, &w->who[i], &c, out);
    }
    w->n = 0;
}

COLLISION_INLINE void add_springs(const force_frame *at, contact_law_values law, const uint32_t *slots, size_t n,
                                  stiff_list *out, int dimensions) {
    pairs w;
    w.n = 0;
    for (uint32_t of = 0; of < n; of++) {
        neighbor_row row = neighbor_get(at->neighbor, at->bodies, slots[of]);
        for (size_t i = 0; i < row.nupper; i++) {
            if (w.n == KERNEL_BATCH)
                flush_springs(at, law, &w, out);
            kernel_batch_pair(&w.batch, w.n, at->capsules, slots[of], row.upper[i], dimensions);
            w.who[w.n++] = (touching){slots[of], row.upper[i], of};
        }
    }
    flush_springs(at, law, &w, out);
}

static void stiffness(const double *p, const force_frame *at, const uint32_t *slots, size_t n, stiff_list *out) {
    if (at->flat)
        add_springs(at, law_of(p), slots, n, out, 2);
    else
        add_springs(at, law_of(p), slots, n, out, 3);
}

/* Each of two equal cells sees the other give way. */
static double contact_stiffness(const double *p) {
    return 2 * p[COLLISION_K];
}

static const param params[] = {
    {"k=1e-10N/m:stiffness(0,)", "spring constant of a contact"},
    {"reach=1.01:number[1,2)", "cells repel nearer than this many mean diameters"},
    {"contact=regularised:{regularised|closest}", "law between rods: smooth, or as published"},
    {"epsilon=0.01:number(0,1)", "strength of the regularisation"},
};

const force_style force_collision = {
    .name = "collision",
    .command = "force",
    .summary = "repulsion between cells that overlap",
    .formula = "F = k d between the nearest points of two axes, d = reach (r_A + r_B) - distance > 0; E = k/2 d^2",
    .source = "Storck et al. 2014, cell-cell collision",
    .example = "force collision k 1e-10N/m reach 1.01 contact regularised epsilon 0.01",
    .params = params,
    .nparams = sizeof params / sizeof params[0],
    .caps = FORCE_CONSERVATIVE | FORCE_BALANCED | FORCE_CENTRAL | FORCE_NEEDS_PAIRS,
    .add = add,
    .add_chain = add_chain,
    .energy = energy,
    .stiffness = stiffness,
    .contact_stiffness = contact_stiffness,
};

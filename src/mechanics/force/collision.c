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

#include <stdbool.h>
#include <string.h>

static contact_law_values law_of(const double *p) {
    bool regularised = (contact_law)p[COLLISION_CONTACT] == CONTACT_REGULARISED;
    return (contact_law_values){p[COLLISION_K], p[COLLISION_REACH], regularised ? p[COLLISION_EPSILON] : 0};
}

/* Entries of the neighbour list on their way through the kernel, batch by batch, and the row that is being summed. Rows
 * go over the ends of batches: how entries fall into batches changes no bit. */
typedef struct stream {
    const force_frame *at;
    double *f;
    contact_law_values law;
    size_t slot, row_end;           /* owner, and where its row ends */
    double total[3], last[3];       /* on the owner so far, and of that on its last particle */
    const uint32_t *first, *second; /* slots of the batch's pairs */
    uint32_t first_buffer[KERNEL_BATCH], second_buffer[KERNEL_BATCH];
    kernel_batch batch;
} stream;

/* What follows is compiled for each kind of scene, with and without flexible cells, in space and in the plane: a test a
 * row would be 0.3 % of an evaluation. */
#define COLLISION_INLINE static inline __attribute__((always_inline))
typedef struct kind {
    bool chains;
    int dimensions;
} kind;

COLLISION_INLINE void load(stream *s, size_t n, kind of) {
    kernel_batch *b = &s->batch;
    const void *capsules = s->at->capsules;
    const int dimensions = of.dimensions;
    for (size_t i = 0; i < n; i++) {
        const size_t p = s->first[i] & ~NEIGHBOR_OWN, q = s->second[i];
        for (int k = 0; k < of.dimensions; k++) {
            b->r[k][i] = capsule_x(capsules, p, k, dimensions) - capsule_x(capsules, q, k, dimensions);
            b->d1[k][i] = capsule_d(capsules, p, k, dimensions);
            b->d2[k][i] = capsule_d(capsules, q, k, dimensions);
        }
        b->radii[i] = capsule_radius(capsules, p, dimensions) + capsule_radius(capsules, q, dimensions);
        b->rests[i] = capsule_rest(capsules, p, dimensions) * capsule_rest(capsules, q, dimensions);
        b->side[i] = s->first[i] & NEIGHBOR_OWN ? 1 : -1;
    }
}

/* Contacts with coincident axes: the full force k R' along the pair's own random direction. */
static void push_coincident(stream *s, size_t n) {
    kernel_batch *b = &s->batch;
    for (size_t i = 0; i < n; i++) {
        if (b->square[i] >= CONTACT_COINCIDENT * CONTACT_COINCIDENT || b->g[i] >= b->reach[i])
            continue;
        double u[3], push = b->side[i] * s->law.k * (sqrt(b->reach[i]) - sqrt(b->g[i]));
        const body *a = &s->at->bodies[s->first[i] & ~NEIGHBOR_OWN], *c = &s->at->bodies[s->second[i]];
        force_direction(s->at, body_key(a), body_key(c), u);
        for (int k = 0; k < 3; k++) {
            b->force[k][i] = push * u[k];
            b->last[k][i] = b->place[i] * b->force[k][i];
        }
    }
}

static void begin_row(stream *s) {
    if (s->slot < s->at->nbodies)
        s->row_end = neighbor_start(s->at->neighbor, s->slot + 1);
    for (int k = 0; k < 3; k++)
        s->total[k] = s->last[k] = 0;
}

/* Gives the owner the sum of its row, and goes on to the next. The last particle of a chain's segment belongs to the
 * next one: its share waits there until all bodies are done. */
COLLISION_INLINE void end_row(stream *s, kind of) {
    const body *owner = &s->at->bodies[s->slot];
    double *first = s->f + 3 * (size_t)owner->first, *last = first + 3 * (size_t)(owner->count - 1);
    if (of.chains && owner->chained) {
        last = s->at->shares + 3 * (size_t)(owner->first + 1);
        last[0] = last[1] = last[2] = 0;
    }
    for (int k = 0; k < of.dimensions; k++) {
        first[k] += s->total[k] - s->last[k];
        last[k] += s->last[k];
    }
    s->slot++;
    begin_row(s);
}

/* Sums entries begin ... end - 1 of the batch, in the order of the partners' ids. */
COLLISION_INLINE void sum_entries(stream *s, size_t begin, size_t end, kind of) {
    const kernel_batch *b = &s->batch;
    double total[3], last[3];
    memcpy(total, s->total, sizeof total);
    memcpy(last, s->last, sizeof last);
    for (size_t i = begin; i < end; i++)
        for (int k = 0; k < of.dimensions; k++) {
            total[k] += b->force[k][i];
            last[k] += b->last[k][i];
        }
    memcpy(s->total, total, sizeof total);
    memcpy(s->last, last, sizeof last);
}

/* Computes and sums n entries from `begin` on. */
COLLISION_INLINE void pass(stream *s, size_t begin, size_t n, kind of) {
    const contact_kernel *kernel = s->at->kernel;
    neighbor_pairs(s->at->neighbor, s->at->bodies, begin, n, s->first_buffer, s->second_buffer, &s->first, &s->second);
    load(s, n, of);
    if (kernel->contact[s->at->cocci][s->at->flat](&s->law, n, &s->batch))
        push_coincident(s, n);
    for (size_t entry = begin; entry < begin + n;) {
        while (s->row_end == entry)
            end_row(s, of);
        size_t stop = s->row_end < begin + n ? s->row_end : begin + n;
        sum_entries(s, entry - begin, stop - begin, of);
        entry = stop;
    }
}

COLLISION_INLINE void add_rows(const double *p, const force_frame *at, size_t begin, size_t end, double *f, kind of) {
    stream s;
    s.at = at;
    s.f = f;
    s.law = law_of(p);
    s.slot = begin;
    begin_row(&s);
    size_t entry = neighbor_start(at->neighbor, begin), stop = neighbor_start(at->neighbor, end);
    for (; entry < stop; entry += KERNEL_BATCH)
        pass(&s, entry, stop - entry < KERNEL_BATCH ? stop - entry : KERNEL_BATCH, of);
    while (s.slot < end)
        end_row(&s, of);
}

static void add(const double *p, const force_frame *at, size_t begin, size_t end, double *f) {
    if (SARCINA_FLEXIBLE && at->nchains)
        add_rows(p, at, begin, end, f, (kind){true, 3});
    else if (at->flat)
        add_rows(p, at, begin, end, f, (kind){false, 2});
    else
        add_rows(p, at, begin, end, f, (kind){false, 3});
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

static contact_pair pair_of(const force_frame *at, const capsule *a, const capsule *b) {
    contact_pair pair = {.radii = a->radius + b->radius, .rests = at->cocci ? 0 : a->rest * b->rest};
    for (int k = 0; k < 3; k++)
        pair.r[k] = a->x[k] - b->x[k];
    return pair;
}

/* Without axes most of the law is constant. */
static contact_result touch_spheres(const force_frame *at, contact_law_values law, const capsule *a, const capsule *b) {
    return contact_compute(law, pair_of(at, a, b));
}

static contact_result touch_segments(const force_frame *at, contact_law_values law, const capsule *a,
                                     const capsule *b) {
    contact_pair pair = pair_of(at, a, b);
    for (int k = 0; k < 3; k++) {
        pair.d1[k] = a->d[k];
        pair.d2[k] = b->d[k];
    }
    return contact_compute(law, pair);
}

static contact_result contact_with(const force_frame *at, contact_law_values law, size_t slot, uint32_t partner) {
    capsule room[2];
    return (at->cocci ? touch_spheres : touch_segments)(at, law, capsule_get(at->capsules, slot, at->flat, &room[0]),
                                                        capsule_get(at->capsules, partner, at->flat, &room[1]));
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

/* The spring of a contact, its ends shared by the lever rule; along the direction in which the force acts. */
static void add_spring(const force_frame *at, size_t slot, uint32_t partner, const contact_result *c, double k,
                       stiff_list *out) {
    const body *pair[2] = {&at->bodies[slot], &at->bodies[partner]};
    const double place[2] = {c->s, c->t};
    stiff_spring *spring = force_spring_add(out);
    spring->k = k;
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

static void stiffness(const double *p, const force_frame *at, size_t slot, stiff_list *out) {
    contact_law_values law = law_of(p);
    neighbor_row row = neighbor_get(at->neighbor, at->bodies, slot);
    for (size_t i = 0; i < row.nupper; i++) {
        contact_result c = contact_with(at, law, slot, row.upper[i]);
        if (c.g < c.reach)
            add_spring(at, slot, row.upper[i], &c, law.k, out);
    }
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

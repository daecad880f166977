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

#include "base/rng.h"

#include <stdbool.h>
#include <string.h>

static contact_law_values law_of(const double *p) {
    bool regularised = (contact_law)p[COLLISION_CONTACT] == CONTACT_REGULARISED;
    return (contact_law_values){p[COLLISION_K], p[COLLISION_REACH], regularised ? p[COLLISION_EPSILON] : 0};
}

/* Consecutive pairs of one owner in a batch: partners all of lower, or all of higher id. */
typedef struct stretch {
    uint32_t owner, begin, end;
    bool owner_is_a;
} stretch;

/* Pairs of several owners, computed when the batch is full. A row may be spread over batches: each adds on. */
typedef struct stream {
    const force_frame *at;
    const double *p;
    double *f;
    contact_law_values law;
    size_t npairs, nstretches;
    stretch stretches[KERNEL_BATCH];
    uint32_t partner[KERNEL_BATCH];
    kernel_batch batch;
} stream;

static void load(kernel_batch *b, size_t i, const capsule *first, const capsule *second) {
    for (int k = 0; k < 3; k++) {
        b->r[k][i] = first->x[k] - second->x[k];
        b->d1[k][i] = first->d[k];
        b->d2[k][i] = second->d[k];
    }
    b->radii[i] = first->radius + second->radius;
    b->rests[i] = first->rest * second->rest;
}

/* Contacts with coincident axes: the full force along the pair's own random direction. */
static void push_coincident(stream *s, const stretch *run) {
    kernel_batch *b = &s->batch;
    for (uint32_t i = run->begin; i < run->end; i++) {
        if (b->square[i] >= CONTACT_COINCIDENT * CONTACT_COINCIDENT || b->overlap[i] == 0)
            continue;
        uint64_t own = s->at->bodies[run->owner].id, other = s->at->bodies[s->partner[i]].id;
        double u[3];
        rng_direction(s->at->seed, run->owner_is_a ? own : other, run->owner_is_a ? other : own, u);
        for (int k = 0; k < 3; k++)
            b->force[k][i] = s->law.k * b->overlap[i] * u[k];
    }
}

/* Adds a stretch's forces to its owner, in the order of the partners' ids. */
static void sum_stretch(const stream *s, const stretch *run) {
    const kernel_batch *b = &s->batch;
    const body *owner = &s->at->bodies[run->owner];
    const double *place = run->owner_is_a ? b->s : b->t;
    double sign = run->owner_is_a ? 1 : -1;
    double *f = s->f + 3 * (size_t)owner->first, first[3], last[3] = {0};
    size_t far = 3 * (size_t)(owner->count - 1);
    memcpy(first, f, sizeof first);
    if (far)
        memcpy(last, f + far, sizeof last);
    for (uint32_t i = run->begin; i < run->end; i++)
        for (int k = 0; k < 3; k++) {
            double force = sign * b->force[k][i], at_last = place[i] * force;
            last[k] += at_last;
            first[k] += force - at_last;
        }
    memcpy(f, first, sizeof first);
    if (far)
        memcpy(f + far, last, sizeof last);
}

static void flush(stream *s) {
    size_t coincident = s->at->kernel->contact(&s->law, s->npairs, &s->batch);
    for (size_t i = 0; i < s->nstretches; i++) {
        if (coincident)
            push_coincident(s, &s->stretches[i]);
        sum_stretch(s, &s->stretches[i]);
    }
    s->npairs = s->nstretches = 0;
}

/* Appends an owner's pairs with these partners. */
static void push(stream *s, size_t owner, const uint32_t *partners, size_t n, bool owner_is_a) {
    const capsule *capsules = s->at->capsules, *own = &capsules[owner];
    while (n) {
        if (s->npairs == KERNEL_BATCH || s->nstretches == KERNEL_BATCH)
            flush(s);
        size_t room = KERNEL_BATCH - s->npairs, count = n < room ? n : room, at = s->npairs;
        s->stretches[s->nstretches++] = (stretch){(uint32_t)owner, (uint32_t)at, (uint32_t)(at + count), owner_is_a};
        memcpy(s->partner + at, partners, count * sizeof *partners);
        for (size_t i = 0; i < count; i++)
            if (owner_is_a)
                load(&s->batch, at + i, own, &capsules[partners[i]]);
            else
                load(&s->batch, at + i, &capsules[partners[i]], own);
        s->npairs += count;
        partners += count;
        n -= count;
    }
}

static void add(const double *p, const force_frame *at, size_t begin, size_t end, double *f) {
    stream s;
    s.at = at;
    s.p = p;
    s.f = f;
    s.law = law_of(p);
    s.npairs = s.nstretches = 0;
    for (size_t slot = begin; slot < end; slot++) {
        neighbor_row row = neighbor_get(at->neighbor, at->bodies, slot);
        push(&s, slot, row.lower, row.nlower, false);
        push(&s, slot, row.upper, row.nupper, true);
    }
    flush(&s);
}

static contact_result contact_with(const force_frame *at, contact_law_values law, size_t slot, uint32_t partner) {
    const capsule *a = &at->capsules[slot], *b = &at->capsules[partner];
    contact_pair pair = {.radii = a->radius + b->radius, .rests = a->rest * b->rest};
    for (int k = 0; k < 3; k++) {
        pair.r[k] = a->x[k] - b->x[k];
        pair.d1[k] = a->d[k];
        pair.d2[k] = b->d[k];
    }
    return contact_compute(law, pair);
}

static double energy(const double *p, const force_frame *at, size_t slot) {
    contact_law_values law = law_of(p);
    neighbor_row row = neighbor_get(at->neighbor, at->bodies, slot);
    double sum = 0;
    for (size_t i = 0; i < row.nupper; i++) {
        contact_result c = contact_with(at, law, slot, row.upper[i]);
        sum += 0.5 * law.k * c.overlap * c.overlap;
    }
    return sum;
}

/* The spring of a contact, its ends shared by the lever rule. */
static void add_spring(const force_frame *at, size_t slot, uint32_t partner, const contact_result *c, double k,
                       stiff_list *out) {
    const body *pair[2] = {&at->bodies[slot], &at->bodies[partner]};
    const double place[2] = {c->s, c->t};
    stiff_spring *spring = force_spring_add(out);
    spring->k = k;
    double length = sqrt(c->square);
    for (int i = 0; i < 3; i++)
        spring->direction[i] = length > 0 ? c->delta[i] / length : i == 2;
    for (int side = 0; side < 2; side++) {
        double sign = side ? -1 : 1;
        spring->particle[spring->count] = pair[side]->first;
        spring->weight[spring->count++] = sign * (1 - place[side]);
        if (pair[side]->count < 2)
            continue;
        spring->particle[spring->count] = pair[side]->first + pair[side]->count - 1;
        spring->weight[spring->count++] = sign * place[side];
    }
}

static void stiffness(const double *p, const force_frame *at, size_t slot, stiff_list *out) {
    contact_law_values law = law_of(p);
    neighbor_row row = neighbor_get(at->neighbor, at->bodies, slot);
    for (size_t i = 0; i < row.nupper; i++) {
        contact_result c = contact_with(at, law, slot, row.upper[i]);
        if (c.overlap > 0)
            add_spring(at, slot, row.upper[i], &c, law.k, out);
    }
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
    .example = "force collision k 1e-10N/m reach 1.01 contact regularised",
    .params = params,
    .nparams = sizeof params / sizeof params[0],
    .caps = FORCE_CONSERVATIVE | FORCE_BALANCED | FORCE_CENTRAL | FORCE_NEEDS_PAIRS,
    .add = add,
    .energy = energy,
    .stiffness = stiffness,
};

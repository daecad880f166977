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

static contact_law_values law_of(const double *p) {
    bool regularised = (contact_law)p[COLLISION_CONTACT] == CONTACT_REGULARISED;
    return (contact_law_values){p[COLLISION_K], p[COLLISION_REACH], regularised ? p[COLLISION_EPSILON] : 0};
}

/* Consecutive pairs of one owner in a batch: its partners all of lower, or all of higher id. */
typedef struct stretch {
    uint32_t owner, begin, end;
    bool owner_is_a;
    bool opens, closes; /* do the partners begin, and end, in this batch? */
    const uint32_t *partners;
} stretch;

/* What partners do to an owner: the sum of forces, and of the parts that its last particle bears. */
typedef struct load_sum {
    double total[3], last[3];
} load_sum;

/* Pairs of several owners, computed when the batch is full. Where an owner's partners are spread over batches, the sum
 * so far is carried on: how pairs fall into batches changes no bit. */
typedef struct stream {
    const force_frame *at;
    double *f;
    contact_law_values law;
    size_t npairs, nstretches;
    load_sum carry;
    stretch stretches[KERNEL_BATCH];
    kernel_batch batch;
} stream;

/* Pairs of an owner with n partners, as A or as B, into a batch. */
static void load(kernel_batch *b, size_t at, const capsule *capsules, const capsule *own, const stretch *run) {
    double(*mine)[KERNEL_BATCH] = run->owner_is_a ? b->d1 : b->d2;
    double(*theirs)[KERNEL_BATCH] = run->owner_is_a ? b->d2 : b->d1;
    const double sign = run->owner_is_a ? 1 : -1;
    const size_t n = run->end - run->begin;
    for (int k = 0; k < 3; k++)
        for (size_t i = 0; i < n; i++)
            mine[k][at + i] = own->d[k];
    for (size_t i = 0; i < n; i++) {
        const capsule *other = &capsules[run->partners[i]];
        for (int k = 0; k < 3; k++) {
            b->r[k][at + i] = sign * (own->x[k] - other->x[k]);
            theirs[k][at + i] = other->d[k];
        }
        b->radii[at + i] = own->radius + other->radius;
        b->rests[at + i] = own->rest * other->rest;
    }
}

/* Contacts with coincident axes: the full force along the pair's own random direction. */
static void push_coincident(stream *s, const stretch *run) {
    kernel_batch *b = &s->batch;
    for (uint32_t i = run->begin; i < run->end; i++) {
        if (b->square[i] >= CONTACT_COINCIDENT * CONTACT_COINCIDENT || b->overlap[i] == 0)
            continue;
        uint64_t own = s->at->bodies[run->owner].id, other = s->at->bodies[run->partners[i - run->begin]].id;
        double u[3];
        rng_direction(s->at->seed, run->owner_is_a ? own : other, run->owner_is_a ? other : own, u);
        for (int k = 0; k < 3; k++)
            b->force[k][i] = s->law.k * b->overlap[i] * u[k];
    }
}

/* Sums a stretch in the order of the partners' ids. */
static load_sum sum_stretch(const kernel_batch *b, const stretch *run, load_sum sum) {
    const double *place = run->owner_is_a ? b->s : b->t;
    for (uint32_t i = run->begin; i < run->end; i++)
        for (int k = 0; k < 3; k++) {
            sum.total[k] += b->force[k][i];
            sum.last[k] += place[i] * b->force[k][i];
        }
    return sum;
}

static void apply(const body *owner, bool owner_is_a, const load_sum *sum, double *f) {
    const double sign = owner_is_a ? 1 : -1;
    double *first = f + 3 * (size_t)owner->first;
    if (owner->count == 1) {
        for (int k = 0; k < 3; k++)
            first[k] += sign * sum->total[k];
        return;
    }
    for (int k = 0; k < 3; k++) {
        first[k] += sign * (sum->total[k] - sum->last[k]);
        first[k + 3] += sign * sum->last[k];
    }
}

static void flush(stream *s) {
    const contact_kernel *kernel = s->at->kernel;
    size_t coincident = (s->at->cocci ? kernel->sphere : kernel->contact)(&s->law, s->npairs, &s->batch);
    for (size_t i = 0; i < s->nstretches; i++) {
        const stretch *run = &s->stretches[i];
        if (coincident)
            push_coincident(s, run);
        load_sum sum = sum_stretch(&s->batch, run, run->opens ? (load_sum){0} : s->carry);
        if (run->closes)
            apply(&s->at->bodies[run->owner], run->owner_is_a, &sum, s->f);
        else
            s->carry = sum;
    }
    s->npairs = s->nstretches = 0;
}

/* Appends an owner's pairs with these partners. */
static void push(stream *s, size_t owner, const uint32_t *partners, size_t n, bool owner_is_a) {
    bool opens = true;
    while (n) {
        if (s->npairs == KERNEL_BATCH)
            flush(s);
        size_t room = KERNEL_BATCH - s->npairs, count = n < room ? n : room, at = s->npairs;
        stretch *run = &s->stretches[s->nstretches++];
        *run =
            (stretch){(uint32_t)owner, (uint32_t)at, (uint32_t)(at + count), owner_is_a, opens, count == n, partners};
        load(&s->batch, at, s->at->capsules, &s->at->capsules[owner], run);
        s->npairs += count;
        partners += count;
        n -= count;
        opens = false;
    }
}

static void add(const double *p, const force_frame *at, size_t begin, size_t end, double *f) {
    stream s;
    s.at = at;
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

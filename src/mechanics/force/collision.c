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

/* What partners do to an owner: the sum of forces on A, and of the parts that the owner's last particle bears. */
typedef struct load_sum {
    double total[3], last[3];
} load_sum;

/* Entries of the neighbour list on their way through the kernel, batch by batch, and the row that is being summed. Rows
 * go over the ends of batches: how entries fall into batches changes no bit. */
typedef struct stream {
    const force_frame *at;
    double *f;
    contact_law_values law;
    size_t slot, part_end; /* owner, and the entry at which its present part (lower or upper ids) ends */
    bool owner_is_a;       /* the upper part */
    load_sum sum;
    const uint32_t *first, *second; /* slots of the batch's pairs */
    uint32_t first_buffer[KERNEL_BATCH], second_buffer[KERNEL_BATCH];
    kernel_batch batch;
} stream;

static void load(stream *s, size_t n) {
    kernel_batch *b = &s->batch;
    const capsule *capsules = s->at->capsules;
    for (size_t i = 0; i < n; i++) {
        const capsule *p = &capsules[s->first[i]], *q = &capsules[s->second[i]];
        for (int k = 0; k < 3; k++) {
            b->r[k][i] = p->x[k] - q->x[k];
            b->d1[k][i] = p->d[k];
            b->d2[k][i] = q->d[k];
        }
        b->radii[i] = p->radius + q->radius;
        b->rests[i] = p->rest * q->rest;
    }
}

/* Contacts with coincident axes: the full force along the pair's own random direction. */
static void push_coincident(stream *s, size_t n) {
    kernel_batch *b = &s->batch;
    for (size_t i = 0; i < n; i++) {
        if (b->square[i] >= CONTACT_COINCIDENT * CONTACT_COINCIDENT || b->overlap[i] == 0)
            continue;
        double u[3];
        rng_direction(s->at->seed, s->at->bodies[s->first[i]].id, s->at->bodies[s->second[i]].id, u);
        for (int k = 0; k < 3; k++)
            b->force[k][i] = s->law.k * b->overlap[i] * u[k];
    }
}

static void begin_part(stream *s, bool upper) {
    const neighbor *list = s->at->neighbor;
    s->owner_is_a = upper;
    if (s->slot == s->at->nbodies) /* past the last row */
        return;
    s->part_end = upper ? neighbor_start(list, s->slot + 1)
                        : neighbor_start(list, s->slot) + neighbor_middle(list, s->at->bodies, s->slot);
    s->sum = (load_sum){0};
}

/* Gives the owner the sum of a part, and goes on to the next part. */
static void end_part(stream *s) {
    const body *owner = &s->at->bodies[s->slot];
    const double sign = s->owner_is_a ? 1 : -1;
    double *first = s->f + 3 * (size_t)owner->first, *last = first + 3 * (size_t)(owner->count - 1);
    for (int k = 0; k < 3; k++) {
        first[k] += sign * (s->sum.total[k] - s->sum.last[k]);
        last[k] += sign * s->sum.last[k];
    }
    s->slot += s->owner_is_a;
    begin_part(s, !s->owner_is_a);
}

/* Sums entries from ... to - 1, the first of which is that number of the batch, in the order of the partners' ids. */
static void sum_entries(stream *s, size_t from, size_t to, size_t in_batch) {
    const kernel_batch *b = &s->batch;
    const double *place = s->owner_is_a ? b->s : b->t;
    load_sum sum = s->sum;
    for (size_t i = in_batch; i < in_batch + to - from; i++)
        for (int k = 0; k < 3; k++) {
            sum.total[k] += b->force[k][i];
            sum.last[k] += place[i] * b->force[k][i];
        }
    s->sum = sum;
}

/* Computes and sums n entries from `begin` on. */
static void pass(stream *s, size_t begin, size_t n) {
    const contact_kernel *kernel = s->at->kernel;
    neighbor_pairs(s->at->neighbor, s->at->bodies, begin, n, s->first_buffer, s->second_buffer, &s->first, &s->second);
    load(s, n);
    if ((s->at->cocci ? kernel->sphere : kernel->contact)(&s->law, n, &s->batch))
        push_coincident(s, n);
    for (size_t entry = begin; entry < begin + n;) {
        while (s->part_end == entry)
            end_part(s);
        size_t stop = s->part_end < begin + n ? s->part_end : begin + n;
        sum_entries(s, entry, stop, entry - begin);
        entry = stop;
    }
}

static void add(const double *p, const force_frame *at, size_t begin, size_t end, double *f) {
    stream s;
    s.at = at;
    s.f = f;
    s.law = law_of(p);
    s.slot = begin;
    begin_part(&s, false);
    size_t entry = neighbor_start(at->neighbor, begin), stop = neighbor_start(at->neighbor, end);
    for (; entry < stop; entry += KERNEL_BATCH)
        pass(&s, entry, stop - entry < KERNEL_BATCH ? stop - entry : KERNEL_BATCH);
    while (s.slot < end)
        end_part(&s);
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

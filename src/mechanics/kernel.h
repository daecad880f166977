/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Contacts, many at once: of the rows of several owners side by side (kernel_rows.h), and of any pairs by the batch
 * (kernel_batch.h). The same source is compiled once a vector width (kernels.cmake); the widest that the processor has
 * is chosen when the program runs. All give the same bits: each lane does the IEEE operations of the one law
 * (contact_law.h), without contraction. */
#ifndef SARCINA_MECHANICS_KERNEL_H
#define SARCINA_MECHANICS_KERNEL_H

#include "mechanics/body.h"
#include "mechanics/contact.h"

#include <stddef.h>

enum { KERNEL_LANES = 8, KERNEL_BATCH = 128 }; /* pairs at once: the arrays below stay in the first-level cache */

/* KERNEL_LANES bodies beside each other, each with a row of its own partners. Rows that end sooner are filled with a
 * body that nothing reaches, so that every lane does the same: what such a body adds is 0, and changes no bit. */
typedef struct kernel_rows {
    const void *capsules;     /* by slot: capsule, or flat_capsule in the plane */
    const uint32_t *owners;   /* (KERNEL_LANES) slots */
    const uint32_t *partners; /* (length x KERNEL_LANES) in the order of ids: capsule_place of their slots */
    size_t begin, length;     /* these are the partners from the begin-th on; of the longest row */
    const double *lower;      /* (KERNEL_LANES) partners with ids below the owner's, from the row's begin on: the
                               * first so many */
} kernel_rows;

/* What the partners do to each owner, and the part of that on its last particle; 1e-21 N. */
typedef struct kernel_sums {
    _Alignas(64) double total[3][KERNEL_LANES], last[3][KERNEL_LANES];
} kernel_sums;

/* Pairs as a structure of arrays: in, and out. */
typedef struct kernel_batch {
    /* in */
    _Alignas(64) double r[3][KERNEL_BATCH]; /* A0 - B0, um */
    double d1[3][KERNEL_BATCH], d2[3][KERNEL_BATCH];
    double radii[KERNEL_BATCH]; /* r_A + r_B */
    double rests[KERNEL_BATCH]; /* L_A L_B */
    /* out: of contact_result */
    double s[KERNEL_BATCH], t[KERNEL_BATCH], delta[3][KERNEL_BATCH];
    double square[KERNEL_BATCH], g[KERNEL_BATCH], reach[KERNEL_BATCH];
} kernel_batch;

/* The i-th pair, of two capsules of a list: where their axes lie, and what a contact takes beside. */
DIMENSIONS_INLINE void kernel_batch_axes(kernel_batch *batch, size_t i, const void *capsules, size_t slot_a,
                                         size_t slot_b, int dimensions) {
    const double *a = (const double *)capsules + capsule_place(slot_a, dimensions == 2);
    const double *b = (const double *)capsules + capsule_place(slot_b, dimensions == 2);
    for (int k = 0; k < dimensions; k++) {
        batch->r[k][i] = a[k] - b[k];
        batch->d1[k][i] = a[CAPSULE_AXIS + k];
        batch->d2[k][i] = b[CAPSULE_AXIS + k];
    }
}

DIMENSIONS_INLINE void kernel_batch_pair(kernel_batch *batch, size_t i, const void *capsules, size_t slot_a,
                                         size_t slot_b, int dimensions) {
    const double *a = (const double *)capsules + capsule_place(slot_a, dimensions == 2);
    const double *b = (const double *)capsules + capsule_place(slot_b, dimensions == 2);
    const int rest = capsule_rest(dimensions);
    kernel_batch_axes(batch, i, capsules, slot_a, slot_b, dimensions);
    batch->radii[i] = a[dimensions] + b[dimensions];
    batch->rests[i] = a[rest] * b[rest];
}

enum { KERNEL_SEGMENTS, KERNEL_SPHERES }; /* what touches: contact_kernel.contact[...] */
enum { KERNEL_SPACE, KERNEL_PLANE };      /* [...][...] */

/* All components of a state on their way through a step: a kick and a damped flight. */
typedef struct kernel_flight {
    const double *kick, *decay, *flight; /* per component: s/pg, exp(-g h), (1 - exp(-g h)) / g */
    const double *x0, *v0, *force;       /* where it starts */
    double *x, *v;                       /* where it ends */
    double near;                         /* um: changes of a component no larger than this are not counted */
} kernel_flight;

typedef struct contact_kernel {
    const char *name; /* "avx512", "avx2", "base" */
    /* Contacts of the first n pairs, by what touches and where; a sphere's axis and, in the plane, z components are
     * neither read nor written. */
    void (*contact[2][2])(const contact_law_values *law, size_t n, kernel_batch *b);
    /* Squared distances of the axes of the first n pairs, by the same; nothing but r, d1, d2 is read. */
    void (*apart[2][2])(size_t n, kernel_batch *b);
    /* Sums the contacts of some bodies with all their partners, each in the order of its row, by what touches and
     * where, as above; from begin > 0 on to what the sums hold. Components that are not computed are left as they are.
     * Returns whether some touch with coincident axes: the sums lack those. */
    bool (*rows[2][2])(const contact_law_values *law, const kernel_rows *rows, kernel_sums *sums);
    /* y = exp(x), n a multiple of KERNEL_LANES; SLEEF's deterministic one, the same bits in every width. */
    void (*exponential)(size_t n, const double *x, double *y);
    void (*exponential_less_one)(size_t n, const double *x,
                                 double *y); /* exp(x) - 1, as exact near 0; the same of it */
    /* n components fly; returns how many change by more than `near`, or to what is no number. */
    size_t (*fly)(size_t n, const kernel_flight *q);
    /* v += weight x kick x force, n components; returns how many of kick |force - before| are not within `little` (a
     * number that is not finite is not). */
    size_t (*kick)(size_t n, double weight, const double *kick, const double *before, const double *force,
                   double little, double *v);
} contact_kernel;

/* The widest kernel of this processor; the one called name, NULL where the program or the processor lacks it. */
const contact_kernel *kernel_best(void);
const contact_kernel *kernel_find(const char *name);

#endif

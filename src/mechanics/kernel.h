/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Contacts by the batch: many pairs at once through loops that the compiler turns into vector code. The same source is
 * compiled once a vector width (kernels.cmake); the widest that the processor has is chosen when the program runs. All
 * give the same bits: each lane does the IEEE operations of contact_compute, without contraction. */
#ifndef SARCINA_MECHANICS_KERNEL_H
#define SARCINA_MECHANICS_KERNEL_H

#include "mechanics/contact.h"

#include <stddef.h>

enum { KERNEL_LANES = 8, KERNEL_BATCH = 128 }; /* pairs at once: the arrays below stay in the first-level cache */

/* Pairs as a structure of arrays: in, and out. A is the body of lower id. */
typedef struct kernel_batch {
    /* in */
    _Alignas(64) double r[3][KERNEL_BATCH]; /* A0 - B0, um */
    double d1[3][KERNEL_BATCH], d2[3][KERNEL_BATCH];
    double radii[KERNEL_BATCH]; /* r_A + r_B */
    double rests[KERNEL_BATCH]; /* L_A L_B */
    double side[KERNEL_BATCH];  /* 1: the owner of the entry is A; -1: B */
    /* out */
    double place[KERNEL_BATCH];    /* of the contact on the owner: s or t */
    double force[3][KERNEL_BATCH]; /* on the owner, 1e-21 N */
    double last[3][KERNEL_BATCH];  /* of that, on its last particle */
    double square[KERNEL_BATCH];   /* squared distance, um2 */
    double g[KERNEL_BATCH], reach[KERNEL_BATCH];
} kernel_batch;

enum { KERNEL_SEGMENTS, KERNEL_SPHERES }; /* what touches: contact_kernel.contact[...] */
enum { KERNEL_SPACE, KERNEL_PLANE };      /* [...][...] */

/* All components of a state on their way through a step: a kick of `weight` times the half of one, and a damped flight.
 */
typedef struct kernel_flight {
    double weight;
    const double *kick, *decay, *flight; /* per component: h / (2 m), exp(-g h), (1 - exp(-g h)) / g */
    const double *x0, *v0, *force;       /* where it starts */
    double *x, *v;                       /* where it ends */
    double near;                         /* um: changes of a component no larger than this are not counted */
} kernel_flight;

typedef struct contact_kernel {
    const char *name; /* "avx512", "avx2", "base" */
    /* Contacts of the first n pairs, by what touches and where; a sphere's axis and, in the
     * plane, z components are neither read nor written. Returns how many touch with coincident axes, which have no
     * direction. */
    size_t (*contact[2][2])(const contact_law_values *law, size_t n, kernel_batch *b);
    /* y = exp(x), n a multiple of KERNEL_LANES; SLEEF's deterministic one, the same bits in every width. */
    void (*exponential)(size_t n, const double *x, double *y);
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

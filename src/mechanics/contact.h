/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Contact between two segments p(s) = A0 + s d1 and q(t) = B0 + t d2, s and t in [0, 1]; a coccus has d = 0.
 *
 *     G  = min over s, t of |p - q|^2 + w [(s - 1/2)^2 + (t - 1/2)^2]
 *     R'^2 = R^2 + w/4,  R = reach (r_A + r_B)
 *     E  = k/2 max(0, R' - sqrt G)^2
 *     force on p(s*) = k (R' - sqrt G) / sqrt G (p - q), the opposite on q(t*), shared by the lever rule
 *
 * w = 0 is the published law (Storck et al. 2014, Eq. 5; closest points by Ericson, Real-Time Collision
 * Detection, 5.1.9): the force acts between the closest points, and jumps where two rods pass through parallel. The
 * regularised law takes w = epsilon min(R^2, L_A L_B), L the rest lengths: the minimiser is then unique and smooth, so
 * the law is exactly conservative and Lipschitz. Cocci have w = 0 under both.
 *
 * Everything here is straight-line IEEE arithmetic, the same in every vector width.
 */
#ifndef SARCINA_MECHANICS_CONTACT_H
#define SARCINA_MECHANICS_CONTACT_H

#include <math.h>
#include <stdbool.h>

/* Below this sin^2 of the angle between two rods the closest points are rounding noise: s = 0, as for parallel rods. */
#define CONTACT_PARALLEL 2e-15

/* Axes nearer than this (um) have no direction between them: contacts take a seeded one (rng_direction). */
#define CONTACT_COINCIDENT 1e-9

typedef struct contact_law_values {
    double k;       /* pg/s2 */
    double reach;   /* times r_A + r_B */
    double epsilon; /* 0: the published law */
} contact_law_values;

/* The law is written down once (contact_law.h), for a number here and for a vector of them in the kernels. */
#define CONTACT_REAL double
#define CONTACT_MASK bool
#define CONTACT_(name) contact_##name
static inline double contact_set(double x) {
    return x;
}
static inline double contact_min(double a, double b) {
    return a < b ? a : b;
}
static inline double contact_max(double a, double b) {
    return a > b ? a : b;
}
static inline bool contact_less(double a, double b) {
    return a < b;
}
static inline bool contact_equal(double a, double b) {
    return a == b;
}
static inline double contact_pick(bool of, double a, double b) {
    return of ? a : b;
}
static inline double contact_sqrt(double x) {
    return sqrt(x);
}
#include "mechanics/contact_law.h"
#undef CONTACT_REAL
#undef CONTACT_MASK
#undef CONTACT_

static inline contact_result contact_compute(contact_law_values law, contact_pair p) {
    return contact_compute_in(3, law, p);
}

/* R' - sqrt G where they touch, 0 apart; um. */
static inline double contact_overlap(const contact_result *c) {
    return c->g < c->reach ? sqrt(c->reach) - sqrt(c->g) : 0;
}

#endif

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
 * Everything here is straight-line IEEE arithmetic, the same in every vector width: inlined into loops, it vectorises.
 */
#ifndef SARCINA_MECHANICS_CONTACT_H
#define SARCINA_MECHANICS_CONTACT_H

#include <math.h>

/* Below this sin^2 of the angle between two rods the closest points are rounding noise: s = 0, as for parallel rods. */
#define CONTACT_PARALLEL 2e-15

/* Axes nearer than this (um) have no direction between them: contacts take a seeded one (rng_direction). */
#define CONTACT_COINCIDENT 1e-9

typedef struct contact_law_values {
    double k;       /* pg/s2 */
    double reach;   /* times r_A + r_B */
    double epsilon; /* 0: the published law */
} contact_law_values;

typedef struct contact_pair {
    double r[3]; /* A0 - B0, um */
    double d1[3], d2[3];
    double radii; /* r_A + r_B */
    double rests; /* L_A L_B, um2 */
} contact_pair;

typedef struct contact_result {
    double s, t;
    double delta[3]; /* p(s) - q(t), um */
    double square;   /* |delta|^2 */
    double g, reach; /* G and R'^2, um2: they touch where G < R'^2 */
    double scale;    /* k (R' / sqrt G - 1), 0 apart: force on A is scale x delta */
} contact_result;

static inline double contact_clamp(double x) {
    x = x < 0 ? 0 : x;
    return x > 1 ? 1 : x;
}

/* a . b in that many dimensions; in the plane the third component is 0 and left out, which changes no bit. */
static inline __attribute__((always_inline)) double contact_dot(const double a[3], const double b[3], int dimensions) {
    double sum = a[0] * b[0] + a[1] * b[1];
    return dimensions > 2 ? sum + a[2] * b[2] : sum;
}

/* In 2 dimensions the z components of the pair are not read, and that of delta is not written. */
static inline __attribute__((always_inline)) contact_result contact_compute_in(int dimensions, contact_law_values law,
                                                                               contact_pair p) {
    double reach = law.reach * p.radii, square = reach * reach;
    double w = law.epsilon * (p.rests < square ? p.rests : square);

    double a = contact_dot(p.d1, p.d1, dimensions) + w, e = contact_dot(p.d2, p.d2, dimensions) + w;
    double b = contact_dot(p.d1, p.d2, dimensions);
    double c = contact_dot(p.d1, p.r, dimensions) - 0.5 * w;
    double f = contact_dot(p.d2, p.r, dimensions) + 0.5 * w;
    a = a > 0 ? a : 1; /* a coccus: b, c (or f) are 0 and so is its s (or t) */
    e = e > 0 ? e : 1;

    double det = a * e - b * b, least = CONTACT_PARALLEL * (a * e);
    double s = contact_clamp((b * f - c * e) / (det > least ? det : 1));
    s = det > least ? s : 0;
    double free_t = (b * s + f) / e, t = contact_clamp(free_t);
    double s_again = contact_clamp((b * t - c) / a);
    s = free_t == t ? s : s_again;

    contact_result out = {.s = s, .t = t};
    for (int k = 0; k < dimensions; k++)
        out.delta[k] = p.r[k] + s * p.d1[k] - t * p.d2[k];
    out.square = contact_dot(out.delta, out.delta, dimensions);
    out.g = out.square + w * ((s - 0.5) * (s - 0.5) + (t - 0.5) * (t - 0.5));
    out.reach = square + 0.25 * w;
    double stretch = sqrt(out.reach / (out.g > 0 ? out.g : out.reach)) - 1;
    out.scale = law.k * (stretch > 0 ? stretch : 0);
    return out;
}

static inline contact_result contact_compute(contact_law_values law, contact_pair p) {
    return contact_compute_in(3, law, p);
}

/* R' - sqrt G where they touch, 0 apart; um. */
static inline double contact_overlap(const contact_result *c) {
    return c->g < c->reach ? sqrt(c->reach) - sqrt(c->g) : 0;
}

#endif

/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The loops of the batched kernels, included by one small file a vector width, which defines KERNEL_NAME, the width's
 * suffix, and KERNEL_EXP(x, y) and KERNEL_EXPM1(x, y), SLEEF's exponential of KERNEL_EXP_LANES numbers, and that less
 * 1. */
#include "mechanics/kernel.h"
#include "mechanics/kernel_rows.h"

#define KERNEL_JOIN_(a, b) a##b
#define KERNEL_JOIN(a, b) KERNEL_JOIN_(a, b)

KERNEL_INLINE void store(int dimensions, kernel_batch *b, size_t i, const contact_result *c) {
    b->s[i] = c->s;
    b->t[i] = c->t;
    for (int k = 0; k < dimensions; k++)
        b->delta[k][i] = c->delta[k];
    b->square[i] = c->square;
    b->g[i] = c->g;
    b->reach[i] = c->reach;
}

KERNEL_INLINE void contact_in(int dimensions, const contact_law_values *law, size_t n, kernel_batch *b) {
    const contact_law_values l = *law;
    for (size_t i = 0; i < n; i++) {
        contact_pair p = {.radii = b->radii[i], .rests = b->rests[i]};
        for (int k = 0; k < dimensions; k++) {
            p.r[k] = b->r[k][i];
            p.d1[k] = b->d1[k][i];
            p.d2[k] = b->d2[k][i];
        }
        contact_result c = contact_compute_in(dimensions, l, p);
        store(dimensions, b, i, &c);
    }
}

KERNEL_INLINE void sphere_in(int dimensions, const contact_law_values *law, size_t n, kernel_batch *b) {
    const contact_law_values l = *law;
    for (size_t i = 0; i < n; i++) {
        contact_pair p = {.radii = b->radii[i]};
        for (int k = 0; k < dimensions; k++)
            p.r[k] = b->r[k][i];
        contact_result c = contact_compute_in(dimensions, l, p);
        store(dimensions, b, i, &c);
    }
}

static void contact(const contact_law_values *law, size_t n, kernel_batch *b) {
    contact_in(3, law, n, b);
}

static void contact_flat(const contact_law_values *law, size_t n, kernel_batch *b) {
    contact_in(2, law, n, b);
}

static void sphere(const contact_law_values *law, size_t n, kernel_batch *b) {
    sphere_in(3, law, n, b);
}

static void sphere_flat(const contact_law_values *law, size_t n, kernel_batch *b) {
    sphere_in(2, law, n, b);
}

KERNEL_INLINE void apart_in(int dimensions, size_t n, kernel_batch *b) {
    static const contact_law_values axes = {1, 1, 0};
    for (size_t i = 0; i < n; i++) {
        contact_pair p = {.radii = 0};
        contact_result c;
        for (int k = 0; k < dimensions; k++) {
            p.r[k] = b->r[k][i];
            p.d1[k] = b->d1[k][i];
            p.d2[k] = b->d2[k][i];
        }
        contact_nearest(dimensions, axes, &p, &c);
        b->square[i] = contact_dot(c.delta, c.delta, dimensions);
    }
}

KERNEL_INLINE void sphere_apart_in(int dimensions, size_t n, kernel_batch *b) {
    for (size_t i = 0; i < n; i++) {
        double square = b->r[0][i] * b->r[0][i] + b->r[1][i] * b->r[1][i];
        b->square[i] = dimensions > 2 ? square + b->r[2][i] * b->r[2][i] : square;
    }
}

static void apart(size_t n, kernel_batch *b) {
    apart_in(3, n, b);
}

static void apart_flat(size_t n, kernel_batch *b) {
    apart_in(2, n, b);
}

static void sphere_apart(size_t n, kernel_batch *b) {
    sphere_apart_in(3, n, b);
}

static void sphere_apart_flat(size_t n, kernel_batch *b) {
    sphere_apart_in(2, n, b);
}

static void exponential(size_t n, const double *x, double *y) {
    for (size_t i = 0; i < n; i += KERNEL_EXP_LANES)
        KERNEL_EXP(x + i, y + i);
}

static void exponential_less_one(size_t n, const double *x, double *y) {
    for (size_t i = 0; i < n; i += KERNEL_EXP_LANES)
        KERNEL_EXPM1(x + i, y + i);
}

/* Compilers believe `restrict` of parameters, and need it to compute several components at once. */
static size_t fly_apart(size_t n, double near, const double *restrict kick, const double *restrict decay,
                        const double *restrict flight, const double *restrict x0, const double *restrict v0,
                        const double *restrict f, double *restrict x, double *restrict v) {
    size_t far = 0;
    for (size_t i = 0; i < n; i++) {
        double kicked = v0[i] + kick[i] * f[i];
        double moved = x0[i] + flight[i] * kicked;
        x[i] = moved;
        v[i] = decay[i] * kicked;
        far += fabs(moved - x0[i]) <= near ? 0 : 1;
    }
    return far;
}

static size_t fly(size_t n, const kernel_flight *q) {
    return fly_apart(n, q->near, q->kick, q->decay, q->flight, q->x0, q->v0, q->force, q->x, q->v);
}

static size_t kick(size_t n, double weight, const double *restrict by, const double *restrict before,
                   const double *restrict force, double little, double *restrict v) {
    size_t jolted = 0;
    for (size_t i = 0; i < n; i++) {
        v[i] += weight * by[i] * force[i];
        jolted += by[i] * fabs(force[i] - before[i]) <= little ? 0 : 1;
    }
    return jolted;
}

extern const contact_kernel KERNEL_JOIN(kernel_, KERNEL_NAME);
#define KERNEL_TEXT_(a) #a
#define KERNEL_TEXT(a) KERNEL_TEXT_(a)
const contact_kernel KERNEL_JOIN(kernel_, KERNEL_NAME) = {
    KERNEL_TEXT(KERNEL_NAME),
    {{contact, contact_flat}, {sphere, sphere_flat}},
    {{apart, apart_flat}, {sphere_apart, sphere_apart_flat}},
    {{rows_segments, rows_segments_flat}, {rows_spheres, rows_spheres_flat}},
    exponential,
    exponential_less_one,
    fly,
    kick};

/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Rotations as unit quaternions (i, j, k, w), by value. */
#ifndef SARCINA_BASE_QUATERNION_H
#define SARCINA_BASE_QUATERNION_H

#include "base/vec3.h"

typedef struct quaternion {
    vec3 v;   /* axis times the sine of half the angle */
    double w; /* cosine of half the angle */
} quaternion;

static inline quaternion quaternion_load(const double *p) {
    return (quaternion){vec3_load(p), p[3]};
}
static inline void quaternion_store(double *p, quaternion q) {
    vec3_store(p, q.v);
    p[3] = q.w;
}
/* First b, then a. */
static inline quaternion quaternion_multiply(quaternion a, quaternion b) {
    vec3 v = vec3_add(vec3_axpy(vec3_scale(b.w, a.v), a.w, b.v), vec3_cross(a.v, b.v));
    return (quaternion){v, a.w * b.w - vec3_dot(a.v, b.v)};
}
static inline vec3 quaternion_rotate(quaternion q, vec3 x) {
    vec3 t = vec3_scale(2, vec3_cross(q.v, x));
    return vec3_add(vec3_axpy(x, q.w, t), vec3_cross(q.v, t));
}
/* The same rotation by a quaternion of length 1. */
static inline quaternion quaternion_normalise(quaternion q) {
    double scale = 1 / sqrt(vec3_dot(q.v, q.v) + q.w * q.w);
    return (quaternion){vec3_scale(scale, q.v), scale * q.w};
}
/* The shortest rotation that takes the unit vector a to the unit vector b, which must not be opposite. */
static inline quaternion quaternion_between(vec3 a, vec3 b) {
    return quaternion_normalise((quaternion){vec3_cross(a, b), 1 + vec3_dot(a, b)});
}

/* A rotation that takes x to the unit vector u: the shortest, or about z where they are opposite. */
static inline quaternion quaternion_from_x(vec3 u) {
    if (u.x < -0.999999)
        return (quaternion){{0, 0, 1}, 0};
    return quaternion_between(vec3_of(1, 0, 0), u);
}

#endif

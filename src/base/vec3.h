/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Three components, by value. Every operation is one IEEE operation a component, in the order written. */
#ifndef SARCINA_BASE_VEC3_H
#define SARCINA_BASE_VEC3_H

#include <math.h>

typedef struct vec3 {
    double x, y, z;
} vec3;

static inline vec3 vec3_of(double x, double y, double z) {
    return (vec3){x, y, z};
}
static inline vec3 vec3_load(const double *p) {
    return (vec3){p[0], p[1], p[2]};
}
static inline void vec3_store(double *p, vec3 a) {
    p[0] = a.x;
    p[1] = a.y;
    p[2] = a.z;
}
static inline vec3 vec3_add(vec3 a, vec3 b) {
    return (vec3){a.x + b.x, a.y + b.y, a.z + b.z};
}
static inline vec3 vec3_sub(vec3 a, vec3 b) {
    return (vec3){a.x - b.x, a.y - b.y, a.z - b.z};
}
static inline vec3 vec3_scale(double s, vec3 a) {
    return (vec3){s * a.x, s * a.y, s * a.z};
}
/* a + s b */
static inline vec3 vec3_axpy(vec3 a, double s, vec3 b) {
    return (vec3){a.x + s * b.x, a.y + s * b.y, a.z + s * b.z};
}
static inline double vec3_dot(vec3 a, vec3 b) {
    return a.x * b.x + a.y * b.y + a.z * b.z;
}
static inline vec3 vec3_cross(vec3 a, vec3 b) {
    return (vec3){a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}
static inline double vec3_norm(vec3 a) {
    return sqrt(vec3_dot(a, a));
}

#endif

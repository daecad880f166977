/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "model/chain.h"

#include <sleef.h>

static double square_of_step(const chain_coil *coil, double a) {
    double across = 2 * coil->radius * Sleef_cinz_sind1_u10purec(0.5 * a), along = coil->pitch * a / (2 * M_PI);
    return across * across + along * along;
}

double chain_coil_longest(const chain_coil *coil) {
    return coil->radius > 0 ? sqrt(square_of_step(coil, M_PI)) : (double)INFINITY;
}

/* The step grows with the angle up to pi: bisection finds it to the last bit, the same one everywhere. */
double chain_coil_step(const chain_coil *coil, double segment) {
    if (!(coil->radius > 0))
        return 0;
    double low = 0, high = M_PI, square = segment * segment;
    if (square_of_step(coil, high) <= square)
        return M_PI;
    for (int i = 0; i < 60; i++) {
        double middle = 0.5 * (low + high);
        if (square_of_step(coil, middle) < square)
            low = middle;
        else
            high = middle;
    }
    return 0.5 * (low + high);
}

void chain_coil_places(const chain_coil *coil, double segment, size_t n, double *x) {
    double a = chain_coil_step(coil, segment), side = coil->left ? -1 : 1;
    double along = coil->radius > 0 ? coil->pitch * a / (2 * M_PI) : segment;
    for (size_t i = 0; i < n; i++) {
        double place = (double)i - 0.5 * (double)(n - 1);
        x[3 * i] = along * place;
        x[3 * i + 1] = coil->radius * Sleef_cinz_cosd1_u10purec(a * place);
        x[3 * i + 2] = side * coil->radius * Sleef_cinz_sind1_u10purec(a * place);
    }
}

double chain_turn(vec3 a, vec3 b) {
    return Sleef_cinz_atan2d1_u10purec(vec3_norm(vec3_cross(a, b)), vec3_dot(a, b));
}

void chain_torsion(vec3 a, vec3 b, vec3 c, double *cos_phi, double *sin_phi) {
    vec3 m = vec3_cross(a, b), n = vec3_cross(b, c);
    double y = vec3_norm(b) * vec3_dot(a, n), x = vec3_dot(m, n), length = sqrt(x * x + y * y);
    *cos_phi = length > 0 ? x / length : 1;
    *sin_phi = length > 0 ? y / length : 0;
}

void chain_coil_angles(const chain_coil *coil, double segment, double *theta, double *cos_phi, double *sin_phi) {
    double x[12];
    *theta = *sin_phi = 0;
    *cos_phi = 1;
    if (!(coil->radius > 0) || !(segment > 0))
        return;
    chain_coil_places(coil, segment, 4, x);
    vec3 a = vec3_sub(vec3_load(x + 3), vec3_load(x)), b = vec3_sub(vec3_load(x + 6), vec3_load(x + 3)),
         c = vec3_sub(vec3_load(x + 9), vec3_load(x + 6));
    *theta = chain_turn(a, b);
    chain_torsion(a, b, c, cos_phi, sin_phi);
}

static vec3 segment_of(const double *x, size_t i) {
    return vec3_sub(vec3_load(x + 3 * (i + 1)), vec3_load(x + 3 * i));
}

double chain_length(const double *x, size_t n) {
    double sum = 0;
    for (size_t i = 0; i + 1 < n; i++)
        sum += vec3_norm(segment_of(x, i));
    return sum;
}

vec3 chain_point(const double *x, size_t n, double s, vec3 *direction) {
    size_t i = 0;
    vec3 d = segment_of(x, 0);
    double length = vec3_norm(d);
    while (s > length && i + 2 < n) {
        s -= length;
        d = segment_of(x, ++i);
        length = vec3_norm(d);
    }
    d = length > 0 ? vec3_scale(1 / length, d) : vec3_of(0, 0, 0);
    if (direction)
        *direction = d;
    return vec3_axpy(vec3_load(x + 3 * i), s, d);
}

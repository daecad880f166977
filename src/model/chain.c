/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "model/chain.h"

#include <sleef.h>

double chain_coil_turn(const chain_coil *coil) {
    double round = 2 * M_PI * coil->radius;
    return coil->radius > 0 ? sqrt(round * round + coil->pitch * coil->pitch) : (double)INFINITY;
}

double chain_coil_step(const chain_coil *coil, double arc) {
    return 2 * M_PI * arc / chain_coil_turn(coil);
}

vec3 chain_coil_place(const chain_coil *coil, double arc) {
    if (!(coil->radius > 0))
        return vec3_of(arc, 0, 0);
    double a = chain_coil_step(coil, arc), side = coil->left ? -1 : 1;
    return vec3_of(coil->pitch * a / (2 * M_PI), coil->radius * Sleef_cinz_cosd1_u10purec(a),
                   side * coil->radius * Sleef_cinz_sind1_u10purec(a));
}

double chain_coil_chord(const chain_coil *coil, double arc) {
    if (!(coil->radius > 0))
        return arc;
    return vec3_norm(vec3_sub(chain_coil_place(coil, arc), chain_coil_place(coil, 0)));
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

void chain_coil_angles(const chain_coil *coil, double arc, double *theta, double *cos_phi, double *sin_phi) {
    *theta = *sin_phi = 0;
    *cos_phi = 1;
    if (!(coil->radius > 0) || !(arc > 0))
        return;
    vec3 segment[3];
    for (int i = 0; i < 3; i++)
        segment[i] = vec3_sub(chain_coil_place(coil, (i + 1) * arc), chain_coil_place(coil, i * arc));
    *theta = chain_turn(segment[0], segment[1]);
    chain_torsion(segment[0], segment[1], segment[2], cos_phi, sin_phi);
}

/* Unit vector along d; 0 0 0 without length. */
static vec3 unit(vec3 d) {
    double length = vec3_norm(d);
    return length > 0 ? vec3_scale(1 / length, d) : vec3_of(0, 0, 0);
}

/* Three unit vectors at right angles: along a segment, towards where its neighbours (0 0 0: there is none) bend (on the
 * straight: to a side), and across. */
static void frame_of(vec3 before, vec3 d, vec3 after, vec3 side, vec3 frame[3]) {
    frame[0] = unit(d);
    vec3 bend = {0, 0, 0};
    if (vec3_norm(before) > 0)
        bend = vec3_add(bend, vec3_sub(frame[0], unit(before)));
    if (vec3_norm(after) > 0)
        bend = vec3_add(bend, vec3_sub(unit(after), frame[0]));
    bend = vec3_axpy(bend, -vec3_dot(bend, frame[0]), frame[0]);
    if (!(vec3_norm(bend) > 1e-9))
        bend = vec3_cross(frame[0], side);
    frame[1] = unit(bend);
    frame[2] = vec3_cross(frame[0], frame[1]);
}

vec3 chain_point(const chain_coil *coil, double arc, const double *x, size_t n, double u, vec3 side) {
    size_t i = u > 0 ? (size_t)u : 0;
    i = i < n - 2 ? i : n - 2;
    double t = u - (double)i;
    const double *p = x + 3 * i;
    const vec3 none = {0, 0, 0}, here = vec3_load(p), d = vec3_sub(vec3_load(p + 3), here);
    vec3 point = vec3_axpy(here, t, d);
    if (!(coil->radius > 0))
        return point;
    vec3 before = i > 0 ? vec3_sub(here, vec3_load(p - 3)) : none;
    vec3 after = i + 2 < n ? vec3_sub(vec3_load(p + 6), vec3_load(p + 3)) : none;
    vec3 frame[3], ideal[3], places[4];
    for (int k = 0; k < 4; k++)
        places[k] = chain_coil_place(coil, (k - 1) * arc);
    vec3 chord = vec3_sub(places[2], places[1]);
    frame_of(before, d, after, side, frame);
    frame_of(i > 0 ? vec3_sub(places[1], places[0]) : none, chord, i + 2 < n ? vec3_sub(places[3], places[2]) : none,
             side, ideal);
    /* how far the helix is off its chord, in the ideal frame and from there in the cell's own */
    vec3 off = vec3_sub(chain_coil_place(coil, t * arc), vec3_axpy(places[1], t, chord));
    for (int k = 0; k < 3; k++)
        point = vec3_axpy(point, vec3_dot(off, ideal[k]), frame[k]);
    return point;
}

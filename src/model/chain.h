/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The geometry of flexible cells: chains of n particles whose n - 1 segments have one length. Where a chain is coiled,
 * its particles at rest stand evenly on a helix of radius R and pitch P (R = 0: on a line), and what three and four
 * consecutive ones span is all that bending and twisting need to know:
 *   theta  turning angle at a particle, between the segments that meet there, 0 straight ... pi folded back
 *   phi    torsion of four, the angle by which the plane of the last three is turned about the middle segment from that
 *          of the first three: 0 for an arc (cis), positive for a right-handed helix
 * Units: um. */
#ifndef SARCINA_MODEL_CHAIN_H
#define SARCINA_MODEL_CHAIN_H

#include "base/vec3.h"

#include <stdbool.h>
#include <stddef.h>

typedef struct chain_coil {
    double radius, pitch; /* radius 0: straight */
    bool left;            /* its hand */
} chain_coil;

/* Angle about the helix's axis between neighbours that a segment's length apart, in [0, pi]: from
 * (2 R sin(a/2))^2 + (P a / 2 pi)^2 = length^2. pi where the segment is longer than such a step can be. */
double chain_coil_step(const chain_coil *coil, double segment);

/* The longest segment with which the particles still show the coil: a step of half a turn. */
double chain_coil_longest(const chain_coil *coil);

/* Places of n particles at rest (n x 3): the helix's axis, or the line, is x, its middle the origin. */
void chain_coil_places(const chain_coil *coil, double segment, size_t n, double *x);

/* Turning angle, and cosine and sine of the torsion, of that shape. */
void chain_coil_angles(const chain_coil *coil, double segment, double *theta, double *cos_phi, double *sin_phi);

/* Turning angle between two segments, in [0, pi]; 0 where one has no length. */
double chain_turn(vec3 a, vec3 b);

/* Cosine and sine of the torsion of three segments in a row; (1, 0) where it has none because two of them are
 * parallel. */
void chain_torsion(vec3 a, vec3 b, vec3 c, double *cos_phi, double *sin_phi);

/* The length along the n particles at x (n x 3). */
double chain_length(const double *x, size_t n);

/* Point (and unit direction) at length s along them; beyond an end: on the end segment's line. */
vec3 chain_point(const double *x, size_t n, double s, vec3 *direction);

#endif

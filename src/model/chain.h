/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The geometry of flexible cells: chains of n particles, evenly spaced along a curve whose length is the cell's rest
 * length. At rest the curve is a line, or a helix of radius R and pitch P. A segment is the chord between neighbours,
 * and what three and four consecutive particles span is all that bending and twisting need to know: theta  turning
 * angle at a particle, between the segments that meet there, 0 straight ... pi folded back phi    torsion of four, the
 * angle by which the plane of the last three is turned about the middle segment from that of the first three: 0 for an
 * arc (cis), positive for a right-handed helix Units: um. */
#ifndef SARCINA_MODEL_CHAIN_H
#define SARCINA_MODEL_CHAIN_H

#include "base/vec3.h"

#include <stdbool.h>
#include <stddef.h>

typedef struct chain_coil {
    double radius, pitch; /* radius 0: straight */
    bool left;            /* its hand */
} chain_coil;

/* Length of one turn along the helix; infinite for a line. */
double chain_coil_turn(const chain_coil *coil);

/* Angle about the helix's axis between neighbours that are `arc` apart along the curve; and the chord between them. */
double chain_coil_step(const chain_coil *coil, double arc);
double chain_coil_chord(const chain_coil *coil, double arc);

/* The place at `arc` along the curve from its middle: the helix's axis, or the line, is x, its middle the origin. */
vec3 chain_coil_place(const chain_coil *coil, double arc);

/* Turning angle, and cosine and sine of the torsion, of particles that are `arc` apart. */
void chain_coil_angles(const chain_coil *coil, double arc, double *theta, double *cos_phi, double *sin_phi);

/* Turning angle between two segments, in [0, pi]; 0 where one has no length. */
double chain_turn(vec3 a, vec3 b);

/* Cosine and sine of the torsion of three segments in a row; (1, 0) where it has none because two of them are
 * parallel. */
void chain_torsion(vec3 a, vec3 b, vec3 c, double *cos_phi, double *sin_phi);

/* The point of the curve through n particles at x (n x 3) that is u segments from the first, u in [0, n - 1]: each
 * segment carries the arc of the rest shape, turned about it to where its neighbours bend; `arc` is its rest length
 * along the curve. Particles of a cell at rest lie on its helix, however few they are. Where the cell is straight its
 * helix is turned to the side of `side`, a unit vector. */
vec3 chain_point(const chain_coil *coil, double arc, const double *x, size_t n, double u, vec3 side);

#endif

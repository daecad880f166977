/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The colony in space: the convex hull of its cells, and how much of it they fill. */
#ifndef SARCINA_ANALYSIS_SOLID_H
#define SARCINA_ANALYSIS_SOLID_H

#include "analysis/view.h"

/* Of a convex body (um3, um2, um): volume, surface, and mean curvature integrated over its surface (of a convex
 * polyhedron: half the sum over its edges of length times the angle between the normals of its sides). */
typedef struct solid_body {
    double volume, surface, curvature;
} solid_body;

/* The convex hull of n points (n x 3); also of points that lie in a plane, on a line, in one place: then the hull is
 * that of a body of no thickness, both of whose sides count. */
solid_body solid_hull(const double *points, size_t n);

/* Volume of all that is nearer than r to a convex body (Steiner's formula). */
double solid_grown_volume(const solid_body *b, double r);

/* value.h measure, compactness: volume of the cells over that of their convex hull, which is the hull of the particle
 * centres grown by the cells' mean radius. Field volume: of that hull. */
int solid_compactness(const view *v, const bool *members, double *out, diag *d);

#endif

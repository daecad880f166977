/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The smallest ellipse that encloses points of the plane. */
#ifndef SARCINA_ANALYSIS_ELLIPSE_H
#define SARCINA_ANALYSIS_ELLIPSE_H

#include "analysis/plane.h"

/* Centre, lengths of the axes (whole, not half) and the angle of the major axis to x, in (-pi/2, pi/2]. */
typedef struct ellipse {
    point2 centre;
    double area, major, minor, angle;
} ellipse;

/* Of n points, best the corners of a convex hull. Its area is at most 1e-9 above the smallest, and the points are
 * inside but for rounding. Points on a line: a segment of area 0; n = 0: all NaN. */
ellipse ellipse_around(const point2 *points, size_t n);

/* value.h measure: area, then fields area, major, minor, angle, of the ellipse around the particle centres. */
int ellipse_measure(const view *v, const bool *members, double *out, diag *d);

#endif

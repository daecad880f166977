/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The colony seen from above: particle centres projected on the plane z = 0, and what encloses them. */
#ifndef SARCINA_ANALYSIS_PLANE_H
#define SARCINA_ANALYSIS_PLANE_H

#include "analysis/view.h"

typedef struct point2 {
    double x, y;
} point2;

/* x, y of every particle of the members (NULL: all cells), sorted by x, then y; the caller frees. *n: how many. */
point2 *plane_points(const view *v, const bool *members, size_t *n);

/* The corners of the convex hull, anticlockwise from the leftmost, of n points sorted as above, into hull (n + 1 of
 * room); collinear points are left out. Returns how many: 0 to 2 when the points span no area. */
size_t plane_hull(const point2 *points, size_t n, point2 *hull);

double plane_area(const point2 *polygon, size_t n);

/* value.h measure: area of the convex hull. */
int plane_hull_measure(const view *v, const bool *members, double *out, diag *d);

#endif

/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Distances between the axes of cells (the segments between their particles, a point for a coccus), for questions asked
 * once, such as "is there room?". The mechanics have kernels of their own. */
#ifndef SARCINA_MODEL_AXIS_H
#define SARCINA_MODEL_AXIS_H

#include "model/colony.h"

/* Between a point and a segment; either may have length zero. um. */
double axis_point_distance(const double p[3], const double a[3], const double b[3]);

/* Between two segments, right for parallel, collinear, crossing and degenerate ones. */
double axis_segment_distance(const double a0[3], const double a1[3], const double b0[3], const double b1[3]);

/* From a point to a cell's axis, and between the axes of two cells. */
double axis_cell_point_distance(const colony *c, uint32_t cell, const double p[3]);
double axis_cell_distance(const colony *c, uint32_t cell, uint32_t other);

/* The same, and which segments of the two are nearest: segment i joins particles i and i + 1 (a coccus has one, 0). */
double axis_cell_nearest(const colony *c, uint32_t cell, uint32_t other, uint32_t *segment, uint32_t *other_segment);

#endif

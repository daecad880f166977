/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "model/axis.h"

#include "base/vec3.h"

#include <math.h>

double axis_point_distance(const double p[3], const double a[3], const double b[3]) {
    vec3 start = vec3_load(a), d = vec3_sub(vec3_load(b), start), to = vec3_sub(vec3_load(p), start);
    double square = vec3_dot(d, d);
    double s = square > 0 ? vec3_dot(to, d) / square : 0;
    s = s < 0 ? 0 : s > 1 ? 1 : s;
    return vec3_norm(vec3_axpy(to, -s, d));
}

/* The least distance is between an end and the other segment, or between two inner points; the latter only where the
 * lines are not parallel, so that a determinant lost to rounding can only cost what the ends already give. */
double axis_segment_distance(const double a0[3], const double a1[3], const double b0[3], const double b1[3]) {
    double least = fmin(fmin(axis_point_distance(a0, b0, b1), axis_point_distance(a1, b0, b1)),
                        fmin(axis_point_distance(b0, a0, a1), axis_point_distance(b1, a0, a1)));
    vec3 p = vec3_load(a0), q = vec3_load(b0), d = vec3_sub(vec3_load(a1), p), e = vec3_sub(vec3_load(b1), q);
    vec3 r = vec3_sub(p, q);
    double dd = vec3_dot(d, d), ee = vec3_dot(e, e), de = vec3_dot(d, e), dr = vec3_dot(d, r), er = vec3_dot(e, r);
    double determinant = dd * ee - de * de;
    if (!(determinant > 0))
        return least;
    double s = (de * er - dr * ee) / determinant, t = (dd * er - de * dr) / determinant;
    if (!(s > 0 && s < 1 && t > 0 && t < 1))
        return least;
    return fmin(least, vec3_norm(vec3_sub(vec3_axpy(r, s, d), vec3_scale(t, e))));
}

static const double *particle(const colony *c, uint32_t cell, uint32_t i) {
    return c->particle.x + 3 * ((size_t)c->cell.first[cell] + i);
}

/* Segments of a cell: a coccus has one, from its particle to itself. */
static uint32_t segments(const colony *c, uint32_t cell) {
    return c->cell.nparticles[cell] > 1 ? c->cell.nparticles[cell] - 1 : 1;
}

static const double *segment_end(const colony *c, uint32_t cell, uint32_t i) {
    return particle(c, cell, c->cell.nparticles[cell] > 1 ? i + 1 : i);
}

double axis_cell_point_distance(const colony *c, uint32_t cell, const double p[3]) {
    double least = INFINITY;
    for (uint32_t i = 0; i < segments(c, cell); i++)
        least = fmin(least, axis_point_distance(p, particle(c, cell, i), segment_end(c, cell, i)));
    return least;
}

double axis_cell_nearest(const colony *c, uint32_t cell, uint32_t other, uint32_t *segment, uint32_t *other_segment) {
    double least = INFINITY;
    *segment = *other_segment = 0;
    for (uint32_t i = 0; i < segments(c, cell); i++)
        for (uint32_t j = 0; j < segments(c, other); j++) {
            double distance = axis_segment_distance(particle(c, cell, i), segment_end(c, cell, i),
                                                    particle(c, other, j), segment_end(c, other, j));
            if (distance >= least)
                continue;
            least = distance;
            *segment = i;
            *other_segment = j;
        }
    return least;
}

double axis_cell_distance(const colony *c, uint32_t cell, uint32_t other) {
    uint32_t i, j;
    return axis_cell_nearest(c, cell, other, &i, &j);
}

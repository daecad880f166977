/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Named parts of space: where cells are created, and which cells are there. Lengths in um. A region's surface belongs
 * to it; that of its complement (side out) does not. */
#ifndef SARCINA_MODEL_REGION_H
#define SARCINA_MODEL_REGION_H

#include <gsl/gsl_rng.h>
#include <stdbool.h>
#include <stddef.h>

typedef enum { REGION_BLOCK, REGION_SPHERE, REGION_CYLINDER, REGION_PLANE } region_kind;

typedef struct region {
    char name[64];
    region_kind kind;
    bool outside; /* side out: the complement */
    int axis;     /* cylinder: 0 1 2 of x y z */
    double p[6];  /* block: xlo xhi ylo yhi zlo zhi, infinite ends allowed; sphere: x y z r;
                   * cylinder: c1 c2 r lo hi, the centre in the other two coordinates in the order of x y z;
                   * plane: a point and the unit normal of the half space it bounds */
} region;

typedef struct region_table {
    size_t count, capacity;
    region *list;
} region_table;

int region_find(const region_table *t, const char *name);
region *region_add(region_table *t, const char *name);
void region_remove(region_table *t, int row);
bool region_contains(const region *r, const double x[3]);

/* Why no place can be drawn from the region ("it has no end along z"); NULL: one can. */
const char *region_unbounded(const region *r);

/* A point uniform in the region, of which region_unbounded must have said NULL. A flat one is drawn from evenly too. */
void region_draw(const region *r, gsl_rng *stream, double x[3]);

/* Has the region a part in the plane z = 0; and the same from that part of it, of which that must have been true. */
bool region_meets_plane(const region *r);
void region_draw_flat(const region *r, gsl_rng *stream, double x[3]);

#endif

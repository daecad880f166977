/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Named parts of space: where cells are created, and which cells are there. Lengths in um. */
#ifndef SARCINA_MODEL_REGION_H
#define SARCINA_MODEL_REGION_H

#include <gsl/gsl_rng.h>
#include <stdbool.h>
#include <stddef.h>

typedef enum { REGION_BLOCK, REGION_SPHERE } region_kind;

typedef struct region {
    char name[64];
    region_kind kind;
    bool outside; /* side out: the complement */
    double p[6];  /* block: xlo xhi ylo yhi zlo zhi, infinite ends allowed; sphere: x y z r */
} region;

typedef struct region_table {
    size_t count, capacity;
    region *list;
} region_table;

int region_find(const region_table *t, const char *name);
region *region_add(region_table *t, const char *name);
void region_remove(region_table *t, int row);
bool region_contains(const region *r, const double x[3]);

/* A point uniform in the region; false when the region has no finite volume to draw from. */
bool region_draw(const region *r, gsl_rng *stream, double x[3]);

#endif

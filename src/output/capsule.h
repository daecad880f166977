/* SPDX-License-Identifier: GPL-3.0-or-later */
/* What pictures are made of: balls swept along segments. A ball has both ends in one place. */
#ifndef SARCINA_OUTPUT_CAPSULE_H
#define SARCINA_OUTPUT_CAPSULE_H

#include "base/vec3.h"
#include "output/color.h"

#include <stddef.h>
#include <stdint.h>

typedef struct capsule {
    vec3 a, b;      /* um */
    double r;       /* um */
    rgb color;      /* linear light */
    uint32_t owner; /* capsules of one owner do not darken each other */
} capsule;

/* The point of the axis that is nearest to p. */
vec3 capsule_nearest(const capsule *c, vec3 p);

/* How much light from all sides capsules leave to a place: found by a grid of bins over their surroundings. */
typedef struct capsule_shade capsule_shade;

/* Of n capsules (which must outlive it), each darkening what is nearer than reach to its surface. */
capsule_shade *capsule_shade_create(const capsule *list, size_t n, double reach);
void capsule_shade_free(capsule_shade *s); /* NULL is allowed */

/* In [0, 1]: the part of the sky that a surface at p with normal n sees past the capsules, those of owner left out. */
double capsule_shade_open(const capsule_shade *s, vec3 p, vec3 n, uint32_t owner);

#define CAPSULE_NO_OWNER UINT32_MAX

#endif

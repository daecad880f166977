/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Points that keep a distance from each other (dart throwing), found by a hash of cubes as wide as the distance: a look
 * costs the 27 cubes around a point, however many points there are. */
#ifndef SARCINA_ENGINE_SPOTS_H
#define SARCINA_ENGINE_SPOTS_H

#include <stdbool.h>
#include <stddef.h>

typedef struct spots spots;

/* For at most n points, um apart by spacing (> 0) or more; free with spots_free, which takes NULL. */
spots *spots_create(size_t n, double spacing);
void spots_free(spots *s);

/* Is no point of the set nearer to x than the spacing? */
bool spots_are_free(const spots *s, const double x[3]);
void spots_add(spots *s, const double x[3]);

#endif

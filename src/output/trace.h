/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Rays against capsules, by Embree. */
#ifndef SARCINA_OUTPUT_TRACE_H
#define SARCINA_OUTPUT_TRACE_H

#include "base/diag.h"
#include "output/capsule.h"

#include <stdbool.h>

typedef struct trace trace;

/* Of n capsules near origin (which must outlive it), looked at mostly along `eye`. NULL on error; a build without
 * Embree always fails. */
trace *trace_create(const capsule *list, size_t n, vec3 origin, vec3 eye, diag *d);
void trace_free(trace *t); /* NULL is allowed */

/* The first capsule that the ray from `from` along the unit vector meets: its row and the place on its surface. Rays
 * may be traced by several threads at once. */
bool trace_hit(const trace *t, vec3 from, vec3 direction, uint32_t *row, vec3 *place);

/* Whether anything stands in the ray's way. */
bool trace_blocked(const trace *t, vec3 from, vec3 direction);

#endif

/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Linear springs: F on a = k (L - L0) u, u from a to b, E = k/2 (L - L0)^2; and which springs touch which particle, so
 * that a particle's owner can sum them itself. */
#ifndef SARCINA_MECHANICS_SPRING_H
#define SARCINA_MECHANICS_SPRING_H

#include "mechanics/force_style.h"

/* A spring as one particle sees it. */
typedef struct spring_end {
    uint32_t spring; /* spring row */
    uint32_t other;  /* particle row at the far end; SPRING_ANCHOR */
    uint64_t key;    /* of the far end's particle, for the fallback direction */
    double k, rest;  /* of the spring: what a sum over ends reads lies together */
} spring_end;

typedef struct spring_index {
    const spring_columns *springs;
    uint32_t *start;  /* (nparticles + 1), into ends */
    spring_end *ends; /* by particle, in the order of spring rows, which is that of link ids */
    size_t start_capacity, ends_capacity;
} spring_index;

/* Rebuilds the index for the colony's springs; keys come from owner, the body of each particle row. */
void spring_index_build(spring_index *index, const colony *c, const uint32_t *owner, const body *bodies);
void spring_index_free(spring_index *index);

/* Unit vector and length from x_a to x_b (dimensions each; u[2] is 0 in the plane). Without length the direction is
 * seeded by the two keys: the same spring seen from its other end has exactly the opposite one. */
double spring_direction(const double *a, const double *b, const force_frame *at, uint64_t key_a, uint64_t key_b,
                        double u[3]);

#endif

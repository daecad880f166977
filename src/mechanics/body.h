/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The colony as the mechanics see it: one body a cell, in slots whose order the mechanics choose (by space, so that
 * neighbours in space are neighbours in memory). No result depends on the order of slots. Units: um, pg, s. */
#ifndef SARCINA_MECHANICS_BODY_H
#define SARCINA_MECHANICS_BODY_H

#include <stddef.h>
#include <stdint.h>

typedef struct body {
    uint64_t id;       /* of the cell */
    uint32_t row;      /* cell row in the colony */
    uint32_t first;    /* row of its first particle */
    uint32_t count;    /* particles it has */
    uint32_t rank;     /* place of its id among all ids */
    double radius;     /* um */
    double rest;       /* rest length between its ends, um; 0 for a coccus */
    double internal_k; /* of the spring inside it, pg/s2; 0: none */
    double density;    /* pg/um3 */
} body;

/* The segment between a body's ends, and what a contact needs of it: one cache line. */
typedef struct capsule {
    _Alignas(64) double x[3]; /* first end, um */
    double d[3];              /* from the first end to the last; 0 0 0 for a coccus */
    double radius, rest;
} capsule;

/* What tells a particle from all others, the same after any reordering: the key of its random directions. */
static inline uint64_t body_particle_key(const body *b, uint32_t particle_row) {
    return b->id << 16 | (particle_row - b->first);
}

/* Mass of a body's i-th particle: half of a segment's mass goes to each of its ends. */
static inline double body_share(uint32_t count, uint32_t i) {
    if (count == 1)
        return 1;
    double segment = 1.0 / (count - 1);
    return i == 0 || i == count - 1 ? 0.5 * segment : segment;
}

#endif

/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The colony as the mechanics see it: bodies, in slots whose order the mechanics choose (by space, so that neighbours
 * in space are neighbours in memory). No result depends on the order of slots. A body is what touches others: a coccus,
 * a rod, or one segment of a flexible cell, which shares its ends with the segments beside it. Each particle is owned
 * by one body, which sums what acts on it: a segment owns its first particle, a cell's last segment both. Units: um,
 * pg, s. */
#ifndef SARCINA_MECHANICS_BODY_H
#define SARCINA_MECHANICS_BODY_H

#include "mechanics/dimensions.h"

#include <math.h>
#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

/* A build may leave flexible cells out (src/without.cmake). */
#ifndef SARCINA_FLEXIBLE
#define SARCINA_FLEXIBLE 1
#endif

typedef struct body {
    uint64_t id;       /* of the cell */
    uint32_t row;      /* cell row in the colony */
    uint32_t first;    /* row of its first particle */
    uint32_t count;    /* particles at its ends: 1 or 2 */
    uint32_t rank;     /* place among all bodies in the order of ids and, within a cell, of segments */
    uint16_t segment;  /* of its cell, from 0 */
    uint8_t owned;     /* particles it owns, from first on */
    bool chained;      /* a segment of a flexible cell */
    float leeway;      /* its ends may be so far from where they were when the neighbour list was built, um */
    double radius;     /* um */
    double rest;       /* rest length between its ends, um; 0 for a coccus */
    double internal_k; /* of a rod's spring, pg/s2; 0: none, or a chain's, which has its own */
    double density;    /* pg/um3 */
} body;

/* The segment between a body's ends, and what a contact needs of it: one cache line. What spheres need comes first. */
typedef struct capsule {
    _Alignas(64) double x[3]; /* first end, um */
    double radius;
    double d[3]; /* from the first end to the last; 0 0 0 for a coccus */
    double rest;
} capsule;

/* The same in the plane. Lists of capsules are of the one or the other. */
typedef struct flat_capsule {
    double x[2], radius, rest, d[2];
} flat_capsule;

/* As numbers: x ..., radius; then the axis, and before or behind it the rest length. */
enum { CAPSULE_AXIS = 4 };
static inline int capsule_rest(int dimensions) {
    return dimensions == 2 ? 3 : 7;
}
_Static_assert(offsetof(capsule, radius) == 3 * sizeof(double) && offsetof(capsule, d) == 4 * sizeof(double) &&
                   offsetof(capsule, rest) == 7 * sizeof(double) && sizeof(capsule) == 8 * sizeof(double),
               "capsules are read as numbers");
_Static_assert(offsetof(flat_capsule, radius) == 2 * sizeof(double) &&
                   offsetof(flat_capsule, rest) == 3 * sizeof(double) &&
                   offsetof(flat_capsule, d) == 4 * sizeof(double) && sizeof(flat_capsule) == 6 * sizeof(double),
               "capsules are read as numbers");

static inline size_t capsule_size(bool flat) {
    return flat ? sizeof(flat_capsule) : sizeof(capsule);
}

/* Where a slot's capsule begins in a list of them, in numbers of 8 bytes: lists may have 2^29 of them. */
static inline uint32_t capsule_place(size_t slot, bool flat) {
    return (uint32_t)(slot * (capsule_size(flat) / sizeof(double)));
}

/* A capsule of a list; in the plane with z 0, in *room. */
static inline const capsule *capsule_get(const void *list, size_t slot, bool flat, capsule *room) {
    if (!flat)
        return &((const capsule *)list)[slot];
    const flat_capsule *c = &((const flat_capsule *)list)[slot];
    *room = (capsule){{c->x[0], c->x[1], 0}, c->radius, {c->d[0], c->d[1], 0}, c->rest};
    return room;
}

/* Sets it to the segment between two ends. */
DIMENSIONS_INLINE void capsule_set(void *list, size_t slot, int dimensions, const double *first, const double *last,
                                   double radius, double rest) {
    capsule *c = &((capsule *)list)[slot];
    flat_capsule *flat = &((flat_capsule *)list)[slot];
    if (dimensions == 2) {
        *flat = (flat_capsule){{first[0], first[1]}, radius, rest, {last[0] - first[0], last[1] - first[1]}};
        return;
    }
    for (int k = 0; k < 3; k++) {
        c->x[k] = first[k];
        c->d[k] = last[k] - first[k];
    }
    c->radius = radius;
    c->rest = rest;
}

/* Points that no body reaches, nor one of them the other, though distances from them are numbers: what fills the places
 * of owners (n) and of partners (n + 1) that there are none of. */
enum { CAPSULES_NOWHERE = 2 };
DIMENSIONS_INLINE void capsule_set_nowhere(void *list, size_t n, int dimensions) {
    static const double owners[3] = {1e18, 1e18, 1e18}, partners[3] = {-1e18, -1e18, -1e18};
    capsule_set(list, n, dimensions, owners, owners, 0, 0);
    capsule_set(list, n + 1, dimensions, partners, partners, 0, 0);
}

/* What tells a particle from all others, the same after any reordering: the key of its random directions. */
static inline uint64_t body_particle_key(const body *b, uint32_t particle_row) {
    return b->id << 16 | (b->segment + particle_row - b->first);
}

/* The same for a body among bodies. */
static inline uint64_t body_key(const body *b) {
    return b->id ^ (uint64_t)b->segment << 48;
}

/* Do two bodies never collide: segments of one cell that share a particle, or that are so near along it (less than half
 * the circumference of its touching surface) that bending alone brings them within reach of each other, without the
 * cell lying on itself? */
static inline bool body_is_joined(const body *a, const body *b, double reach) {
    if (a->id != b->id)
        return false;
    int between = (a->segment > b->segment ? a->segment - b->segment : b->segment - a->segment) - 1;
    return between < 1 || between * a->rest < M_PI * reach * a->radius;
}

/* A flexible cell: a chain of particles, `count` of them from row `first` on, and what holds it in shape. */
typedef struct chain {
    uint64_t id;             /* of the cell */
    uint32_t row, first;     /* cell row; row of its first particle */
    uint32_t count;          /* particles */
    double radius, rest;     /* um; rest length of a segment */
    double internal_k;       /* pg/s2 */
    double bend_k, theta;    /* 1e-27 J; turning angle at rest */
    double twist_k;          /* 1e-27 J */
    double cos_phi, sin_phi; /* of the torsion at rest */
    double straight;         /* sine of the turning angle below which the torsion fades out */
} chain;

/* What tells a chain's i-th particle from all others. */
static inline uint64_t body_chain_key(const chain *c, uint32_t i) {
    return c->id << 16 | i;
}

/* Mass of a body's i-th particle: half of a segment's mass goes to each of its ends. */
static inline double body_share(uint32_t count, uint32_t i) {
    if (count == 1)
        return 1;
    double segment = 1.0 / (count - 1);
    return i == 0 || i == count - 1 ? 0.5 * segment : segment;
}

#endif

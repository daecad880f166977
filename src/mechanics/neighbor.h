/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Which bodies may touch which: for each body a row of all its partners, in the order of their ids, so that its owner
 * can sum what they do to it in an order that nothing else decides. A Verlet list with a skin, found by a hierarchy of
 * grids; or, as the oracle, every other body. */
#ifndef SARCINA_MECHANICS_NEIGHBOR_H
#define SARCINA_MECHANICS_NEIGHBOR_H

#include "mechanics/body.h"
#include "mechanics/grid.h"
#include "mechanics/kernel.h"
#include "mechanics/mechanics.h"

/* Bodies that a thread takes at once, and whose rows are sorted by length into groups of KERNEL_LANES. */
enum { NEIGHBOR_WINDOW = 128 };

/* A body's partners by slot: those of lower id, then those of higher. */
typedef struct neighbor_row {
    const uint32_t *lower, *upper;
    size_t nlower, nupper;
} neighbor_row;

typedef struct neighbor {
    neighbor_method method;
    double margin; /* rows hold pairs this much further apart, um */
    bool chained;  /* some bodies are segments of chains: those that are joined (body_is_joined) are no pair */
    bool spheres;  /* no body has an axis */
    bool flat;     /* all lies in a plane of constant z */
    bool listed;   /* the rows are written down; else they are of all pairs */
    size_t n;
    uint32_t *partners; /* row after row (start[n]): slots, in the order of ids */
    size_t *start;      /* (n + 1) */
    uint32_t *middle;   /* entries with partners of lower id in a row (n) */
    uint32_t *by_id;    /* slots in the order of ids (n): the rows of the all-pairs method */
    /* The same for the kernel: rows of about one length beside each other, filled up with what is no body. */
    uint32_t *members;   /* (groups x KERNEL_LANES) slots of a group's owners */
    double *lower;       /* (groups x KERNEL_LANES) how many of their partners have lower ids */
    uint32_t *lanes;     /* (group_start[groups] x KERNEL_LANES) their partners: where these capsules begin */
    size_t *group_start; /* (groups + 1) */
    size_t entries_capacity, lanes_capacity, n_capacity;
    grid grid;
} neighbor;

void neighbor_free(neighbor *list);

/* Puts n bodies into an order in which those near in space are near in memory: order (n) gets their indices. */
void neighbor_sort(neighbor *list, const void *capsules, size_t n, uint32_t *order);

/* Builds the rows for all pairs whose segments are nearer than reach (r_A + r_B) + margin + the leeways of both. The
 * bodies and capsules (n) stand in the order that the last neighbor_sort gave. */
void neighbor_build(neighbor *list, const body *bodies, const void *capsules, double reach, int threads,
                    const contact_kernel *kernel);

/* Entries of all rows. */
size_t neighbor_entries(const neighbor *list);

/* Groups of n bodies. Bodies begin ... end - 1 are the members of the groups from begin / KERNEL_LANES on, if begin is
 * a multiple of NEIGHBOR_WINDOW, and so is end or it is n. */
static inline size_t neighbor_groups(size_t n) {
    return (n + KERNEL_LANES - 1) / KERNEL_LANES;
}

/* A group's rows from their begin-th partners on, but for the capsules: all that is left, or what the buffer
 * (NEIGHBOR_BLOCK x KERNEL_LANES) holds for the all-pairs method. Returns where the next call begins; 0: that was all.
 * The slot n is no body: its capsule is nowhere. */
enum { NEIGHBOR_BLOCK = 32 };
size_t neighbor_rows(const neighbor *list, size_t group, size_t begin, uint32_t *buffer, kernel_rows *rows);

static inline neighbor_row neighbor_get(const neighbor *list, const body *bodies, size_t slot) {
    if (!list->listed) {
        size_t rank = bodies[slot].rank;
        return (neighbor_row){list->by_id, list->by_id + rank + 1, rank, list->n - rank - 1};
    }
    size_t start = list->start[slot], middle = list->middle[slot], count = list->start[slot + 1] - start;
    return (neighbor_row){list->partners + start, list->partners + start + middle, middle, count - middle};
}

#endif

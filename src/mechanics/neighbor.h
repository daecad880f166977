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

#define NEIGHBOR_OWN 0x80000000u

/* A body's partners by slot: those of lower id, then those of higher. */
typedef struct neighbor_row {
    const uint32_t *lower, *upper;
    size_t nlower, nupper;
} neighbor_row;

typedef struct neighbor {
    neighbor_method method;
    double skin;   /* um */
    double margin; /* rows hold pairs this much further apart, um */
    bool chained;  /* some bodies are segments of chains: those that are joined (body_is_joined) are no pair */
    bool spheres;  /* no body has an axis */
    bool flat;     /* all lies in a plane of constant z */
    bool listed;   /* the rows are written down; else they are of all pairs */
    size_t n;
    /* entries, row after row (start[n]), in the order of the partners' ids: the slots of a pair, that of lower id
     * first; one of them is the row's owner, and NEIGHBOR_OWN marks first where it is that one. */
    uint32_t *first, *second;
    size_t *start;    /* (n + 1) */
    uint32_t *middle; /* entries with partners of lower id in a row (n) */
    uint32_t *by_id;  /* slots in the order of ids (n): the rows of the all-pairs method */
    size_t entries_capacity, n_capacity;
    grid grid;
} neighbor;

void neighbor_free(neighbor *list);

/* Puts n bodies into an order in which those near in space are near in memory: order (n) gets their indices. */
void neighbor_sort(neighbor *list, const void *capsules, size_t n, uint32_t *order);

/* Builds the rows for all pairs whose segments are nearer than reach (r_A + r_B) + margin + skin. The bodies and
 * capsules (n) stand in the order that the last neighbor_sort gave. */
void neighbor_build(neighbor *list, const body *bodies, const void *capsules, double reach, int threads,
                    const contact_kernel *kernel);

/* Entries of all rows; where a slot's row begins (of n: the end). */
size_t neighbor_entries(const neighbor *list);
static inline size_t neighbor_start(const neighbor *list, size_t slot) {
    return list->listed ? list->start[slot] : slot * (list->n - 1);
}

/* The pairs of count entries from entry `begin` on, in *first and *second: the list's own, or written to the buffers
 * (count each) for the all-pairs method. */
void neighbor_pairs(const neighbor *list, const body *bodies, size_t begin, size_t count, uint32_t *first_buffer,
                    uint32_t *second_buffer, const uint32_t **first, const uint32_t **second);

static inline neighbor_row neighbor_get(const neighbor *list, const body *bodies, size_t slot) {
    if (!list->listed) {
        size_t rank = bodies[slot].rank;
        return (neighbor_row){list->by_id, list->by_id + rank + 1, rank, list->n - rank - 1};
    }
    size_t start = list->start[slot], middle = list->middle[slot], count = list->start[slot + 1] - start;
    return (neighbor_row){list->first + start, list->second + start + middle, middle, count - middle};
}

#endif

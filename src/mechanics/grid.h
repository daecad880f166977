/* SPDX-License-Identifier: GPL-3.0-or-later */
/* A hierarchy of grids over capsules: one level for every factor 4 in size, so that a long body among small ones costs
 * only its own search. A level's cells are rows along x (y and z are binned, x is sorted), so a search is a few
 * contiguous stretches. Sorting by (level, z bin, y bin, x) is also the order in which bodies lie in memory. */
#ifndef SARCINA_MECHANICS_GRID_H
#define SARCINA_MECHANICS_GRID_H

#include "mechanics/body.h"

#include <stdbool.h>

/* Centre of a capsule and the half sides of its box, grown by half of what a pair may be apart. */
typedef struct grid_box {
    double centre[3], half[3];
} grid_box;

/* Bodies begin ... end - 1 have these bins; their centres' x grow. */
typedef struct grid_row {
    int32_t level;
    int64_t z, y;
    uint32_t begin, end;
    double low[3], high[3]; /* what their boxes take up together */
    double longest;         /* largest half side along x */
} grid_row;

enum { GRID_LEVELS_MAX = 64 };

/* Where a capsule is sorted. */
typedef struct grid_place {
    int32_t level;
    uint32_t index; /* of the capsule as it was given */
    int64_t z, y;
    double x;
} grid_place;

typedef struct grid {
    grid_place *places; /* (n), sorted */
    grid_box *boxes;    /* (n), in that order */
    grid_row *rows;     /* (nrows), sorted */
    bool flat;          /* what kind of capsules */
    size_t n, nrows, places_capacity, boxes_capacity, rows_capacity;
    double most[GRID_LEVELS_MAX][3]; /* largest half sides of each level */
    int32_t levels[GRID_LEVELS_MAX]; /* the levels present */
    int nlevels;
} grid;

/* Sorts n capsules (flat_capsule if flat) into places; slots are positions in that order from here on. Memory is kept
 * from build to build. */
void grid_sort(grid *g, const void *capsules, bool flat, size_t n);

/* Boxes and rows over the same capsules and their bodies, now in the grid's order, for pairs nearer than
 * reach (r_A + r_B) + beyond + the leeways of both. */
void grid_build(grid *g, const body *bodies, const void *capsules, double reach, double beyond);
void grid_free(grid *g);

/* Bodies of a row among which those of another look for partners: the next ones first. */
typedef struct grid_window {
    uint32_t next, end; /* bodies before `next` are too far back along x for all that are still to look */
    double longest;     /* largest half side along x here */
} grid_window;

/* A search for partners, body after body in the order of slots: what a row's bodies have in common is found once for
 * all of them. Zeroed to begin with, but for the grid. */
typedef struct grid_search {
    const grid *g;
    uint32_t row_end; /* the windows hold up to here */
    double longest;   /* largest half side along x of the row's bodies */
    grid_window *windows;
    size_t nwindows, windows_capacity;
    uint32_t *found;
    size_t found_capacity;
} grid_search;

/* Slots above this one whose boxes meet its own: how many stand in search->found. Slots must come in their order. */
size_t grid_find(grid_search *search, uint32_t slot);
void grid_search_free(grid_search *search);

#endif

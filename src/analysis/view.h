/* SPDX-License-Identifier: GPL-3.0-or-later */
/* What measures may look at: the state and the clock, read only.
 *
 * A view shows the state of the moment it was made at: after any change, make another. What is dear to compute for one
 * cell and cheap for all (forces, contacts, numbers of links) is kept in the view's cache, which whoever makes the
 * view owns and resets (view_cache_reset) each time. */
#ifndef SARCINA_ANALYSIS_VIEW_H
#define SARCINA_ANALYSIS_VIEW_H

#include "mechanics/mechanics.h"
#include "model/colony.h"
#include "model/lineage.h"
#include "model/species.h"

typedef struct view {
    colony *colony;
    const species_table *species;
    const lineage *dead;  /* mothers of the cells that are no longer there */
    mechanics *mechanics; /* bound to the colony as it stands; NULL: its parts do not fit, what they measure is NaN */
    uint64_t seed, step;  /* cycles done */
    double time, relaxed; /* sums of growth steps and of relaxation, s */
    double wall;          /* seconds of computing */
    uint64_t links_formed, links_broken;
    double radius;            /* for measures of what is near, um; 0: their own */
    const double *of;         /* for measures of a number of each cell: by row; NULL: their own */
    struct view_cache *cache; /* never NULL where a value of the mechanics or of links is read */
} view;

#endif

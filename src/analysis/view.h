/* SPDX-License-Identifier: GPL-3.0-or-later */
/* What measures may look at: the state and the clock, read only. */
#ifndef SARCINA_ANALYSIS_VIEW_H
#define SARCINA_ANALYSIS_VIEW_H

#include "mechanics/mechanics.h"
#include "model/colony.h"
#include "model/species.h"

typedef struct view {
    colony *colony;
    const species_table *species;
    mechanics *mechanics; /* bound to the colony as it stands */
    uint64_t seed, step;  /* cycles done */
    double time, relaxed; /* sums of growth steps and of relaxation, s */
    double wall;          /* seconds of computing */
    uint64_t links_formed, links_broken;
} view;

#endif

/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Pairs of cells that are near each other, for measures: the mechanics have a list of their own. */
#ifndef SARCINA_ANALYSIS_NEIGHBORHOOD_H
#define SARCINA_ANALYSIS_NEIGHBORHOOD_H

#include "analysis/view.h"

/* Takes a pair of cell rows and the distance of their centres, um. */
typedef void neighborhood_visit(void *self, uint32_t a, uint32_t b, double distance);

/* Every pair of members (NULL: all cells) whose centres are at most radius apart, each once, in an order that depends
 * on the places and ids alone. */
void neighborhood_pairs(const view *v, const bool *members, double radius, neighborhood_visit *visit, void *self);

/* Every pair of members that touch: whose surfaces are nearer than the collision's reach (`contacts` of a cell counts
 * the same). The distance is that of their axes. */
void neighborhood_contacts(const view *v, const bool *members, neighborhood_visit *visit, void *self);

#endif

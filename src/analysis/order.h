/* SPDX-License-Identifier: GPL-3.0-or-later */
/* How like its neighbours a cell is. value.h measures. */
#ifndef SARCINA_ANALYSIS_ORDER_H
#define SARCINA_ANALYSIS_ORDER_H

#include "analysis/view.h"

/* Local nematic order: over all pairs of members with an axis whose centres are at most view.radius apart (0: one mean
 * length of theirs, caps included), the mean of (3 cos^2(theta) - 1)/2, theta between the axes in space. 1: parallel;
 * 0: at random in space. Fields: plane, the mean of 2 cos^2(phi) - 1 with the axes seen from above (0: at random in
 * the plane; pairs one of which stands upright left out); pairs, how many; radius. NaN without pairs. */
int order_nematic(const view *v, const bool *members, double *out, diag *d);

/* Mixing of species: the part of the members whose nearest member (by centres; of two, that of lower id) is of another
 * species, over what it would be if the same species stood in these places at random, 1 - sum n_s (n_s - 1) / (n (n -
 * 1)). 0: apart; 1: at random; above: alternating. Fields: observed, expected. NaN for one species. */
int order_mixing(const view *v, const bool *members, double *out, diag *d);

/* Layers: a member is in layer 1 + round(h / D), h the height of its lowest point above the lowest of all, D the mean
 * diameter. Bare: the highest layer; fields: mean layer, part of the members in the first. */
int order_layering(const view *v, const bool *members, double *out, diag *d);

#endif

/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The shape of filaments. */
#ifndef SARCINA_ANALYSIS_CHAIN_H
#define SARCINA_ANALYSIS_CHAIN_H

#include "analysis/view.h"

/* Of chains of cells that filial links between members join, with two ends and no branch: the mean length along the
 * chain, the sum of the distances of successive centres, and the mean straightness, the distance of its end cells'
 * centres over that length (1: straight; chains of three or more cells). NaN where there is none. */
void chain_shape(const view *v, const bool *members, double *length, double *straightness);

#endif

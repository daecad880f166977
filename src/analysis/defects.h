/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Where the order of the cells' axes breaks, seen from above. */
#ifndef SARCINA_ANALYSIS_DEFECTS_H
#define SARCINA_ANALYSIS_DEFECTS_H

#include "analysis/view.h"

/* value.h measure, defects: disclinations, around which the axes turn by half a turn with (plus) or against (minus) the
 * way round. The axes, weighted by (1 - r^2/R^2)^2, R = 1.5 mean cell lengths, are averaged at the nodes of a grid of
 * one such length; a square of four nodes with cells is asked how far the average turns around it (Wenzel et al. 2021,
 * Phys. Rev. E 104:014409, do the same on images). Bare: how many; fields: plus, minus, density (per area of these
 * squares). */
int defects_measure(const view *v, const bool *members, double *out, diag *d);

#endif

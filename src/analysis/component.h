/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Connected components of cells, links being the edges: clusters (any link) and filaments (filial links). */
#ifndef SARCINA_ANALYSIS_COMPONENT_H
#define SARCINA_ANALYSIS_COMPONENT_H

#include "analysis/view.h"

#define COMPONENT_ANY_LINK (-1)

/* For each cell row the row of the cell of lowest id in its component (root: cells). Only links of this kind count
 * (COMPONENT_ANY_LINK: every kind), and only between members (NULL: all cells); others are alone. */
void component_roots(colony *c, int kind, const bool *members, uint32_t *root);

/* value.h measures. clusters: count, largest, mean size. filaments: components of two cells or more that filial links
 * join: count, longest, mean, and the ends (cells with one filial link). */
int component_clusters(const view *v, const bool *members, double *out, diag *d);
int component_filaments(const view *v, const bool *members, double *out, diag *d);

#endif

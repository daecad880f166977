/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Connected components of cells, links being the edges: clusters (any link) and filaments (filial links). */
#ifndef SARCINA_ANALYSIS_COMPONENT_H
#define SARCINA_ANALYSIS_COMPONENT_H

#include "analysis/view.h"

#define COMPONENT_ANY_LINK (-1)

/* For each cell row the row of the cell of lowest id in its component (root: cells). Only links of this kind count
 * (COMPONENT_ANY_LINK: every kind), and only between members (NULL: all cells); others are alone. */
void component_roots(colony *c, int kind, const bool *members, uint32_t *root);

/* For other edges than links: joins the components of two rows (root: cells, at first every row its own). */
void component_join(const colony *c, uint32_t *root, uint32_t a, uint32_t b);

/* Of the components of at least `least` members: how many, cells in the largest, and on average (NaN: none). */
void component_sizes(const colony *c, uint32_t *root, const bool *members, uint32_t least, double out[3]);

/* value.h measures. clusters: count, largest, mean size. filaments: components of two cells or more that filial links
 * join: count, longest, mean, the ends (cells with one filial link), and the mean length along the chain and
 * straightness (chain.h). */
int component_clusters(const view *v, const bool *members, double *out, diag *d);
int component_filaments(const view *v, const bool *members, double *out, diag *d);

#endif

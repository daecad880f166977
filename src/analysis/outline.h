/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The outline of the colony seen from above. */
#ifndef SARCINA_ANALYSIS_OUTLINE_H
#define SARCINA_ANALYSIS_OUTLINE_H

#include "analysis/view.h"

/* value.h measure, outline. The cells' projections, each grown by half the mean diameter, so that gaps narrower than a
 * diameter close; holes are filled. Bare: circularity, 4 pi area / perimeter^2 (1 for a disc, less for whatever is
 * longer, rougher or in pieces). Fields: area, perimeter, circularity, roughness (standard deviation over mean, along
 * the outline, of its distance from the centroid of the area; 0 for a disc). */
int outline_measure(const view *v, const bool *members, double *out, diag *d);

#endif

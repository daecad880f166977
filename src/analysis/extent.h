/* SPDX-License-Identifier: GPL-3.0-or-later */
/* How far a colony reaches. */
#ifndef SARCINA_ANALYSIS_EXTENT_H
#define SARCINA_ANALYSIS_EXTENT_H

#include "analysis/view.h"

/* value.h measures. thickness: z of the highest particle centre (Storck et al. 2014); NaN without cells.
 * gyration: root of the mean square distance of the cells' centres from their mean; NaN without cells. */
int extent_thickness(const view *v, const bool *members, double *out, diag *d);
int extent_gyration(const view *v, const bool *members, double *out, diag *d);

#endif

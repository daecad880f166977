/* SPDX-License-Identifier: GPL-3.0-or-later */
/* What of the filaments reaches out of a floc. */
#ifndef SARCINA_ANALYSIS_BRIDGING_H
#define SARCINA_ANALYSIS_BRIDGING_H

#include "analysis/view.h"

/* value.h measure, bridging. The floc is the sphere around the mean centre of the members without filial links that
 * holds 95 % of these centres. Bare: summed length of the members with filial links whose centres lie outside it;
 * fields: ends (those of them with one filial link), radius (of the floc), reach (largest distance of a cell with
 * filial links from the floc's centre). NaN without cells of the first kind. */
int bridging_measure(const view *v, const bool *members, double *out, diag *d);

#endif

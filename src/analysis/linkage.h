/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Links by kind: how stretched, how old. value.h measures, of links all of whose cells are members. */
#ifndef SARCINA_ANALYSIS_LINKAGE_H
#define SARCINA_ANALYSIS_LINKAGE_H

#include "analysis/view.h"

/* Mean over the springs of links of (L - L0)/L0; fields: least, largest, and the mean of each kind: filial, stick,
 * anchor. NaN where there is none. */
int linkage_strain(const view *v, const bool *members, double *out, diag *d);

/* Mean age of the links, s; fields: oldest, and the mean of each kind. */
int linkage_age(const view *v, const bool *members, double *out, diag *d);

#endif

/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Who touches whom. value.h measures; a contact is what `contacts` of a cell counts, here between members. */
#ifndef SARCINA_ANALYSIS_TOUCHING_H
#define SARCINA_ANALYSIS_TOUCHING_H

#include "analysis/view.h"

/* Mean number of contacts of a member; fields: pairs that touch, part of the members that touch nobody. */
int touching_coordination(const view *v, const bool *members, double *out, diag *d);

/* Sets of members joined by contacts, single cells included; fields: cells in the largest, and on average. */
int touching_clusters(const view *v, const bool *members, double *out, diag *d);

#endif

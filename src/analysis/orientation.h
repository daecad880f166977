/* SPDX-License-Identifier: GPL-3.0-or-later */
/* How far cells are aligned: the orientation correlation C of Storck et al. (2014). */
#ifndef SARCINA_ANALYSIS_ORIENTATION_H
#define SARCINA_ANALYSIS_ORIENTATION_H

#include "analysis/view.h"

/* value.h measure: the mean over all pairs of cells that have an axis of 2 cos^2(theta) - 1, theta the angle between
 * their axes in space. 1: parallel; 0: at random in a plane; -1/3: at random in space. NaN for fewer than two. */
int orientation_measure(const view *v, const bool *members, double *out, diag *d);

#endif

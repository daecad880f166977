/* SPDX-License-Identifier: GPL-3.0-or-later */
/* How a colony fills space and which way its cells stand. value.h measures. */
#ifndef SARCINA_ANALYSIS_TEXTURE_H
#define SARCINA_ANALYSIS_TEXTURE_H

#include "analysis/view.h"

/* Mass-radius dimension: the slope of ln(mass within r of the centre of mass) over ln r, by least squares over 16 radii
 * from two mean diameters to the mass's radius of gyration: 1 for a filament, 2 for a disc, 3 for a ball. NaN where
 * that radius is below four diameters: nothing scales there. */
int texture_fractal(const view *v, const bool *members, double *out, diag *d);

/* The part of the cells with an axis that stand at more than 45 degrees to the plane. */
int texture_verticalised(const view *v, const bool *members, double *out, diag *d);

#endif

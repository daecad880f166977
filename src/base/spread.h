/* SPDX-License-Identifier: GPL-3.0-or-later */
/* A number or a distribution, one value wherever either may stand: `1.23/h`, `1.23/h sd 0.277/h`,
 * `uniform 50% 100%`, `normal M SD`, `lognormal MEDIAN GSD`. */
#ifndef SARCINA_BASE_SPREAD_H
#define SARCINA_BASE_SPREAD_H

#include <gsl/gsl_rng.h>

typedef enum { SPREAD_FIXED, SPREAD_NORMAL, SPREAD_UNIFORM, SPREAD_LOGNORMAL } spread_law;

typedef struct spread {
    spread_law law;
    double a; /* value; mean; lower end; median */
    double b; /* 0; standard deviation; upper end; geometric standard deviation (1: no spread) */
} spread;

static inline spread spread_fixed(double x) {
    return (spread){SPREAD_FIXED, x, 0};
}

/* One draw, in the spread's own unit; a fixed value draws nothing from the stream. */
double spread_draw(const spread *s, gsl_rng *stream);

double spread_mean(const spread *s);

#endif

/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Statistics of a few numbers (n, in a given order): sums go in that order, so equal input gives equal bits. */
#ifndef SARCINA_BASE_STATISTICS_H
#define SARCINA_BASE_STATISTICS_H

#include <stddef.h>

double statistics_sum(const double *x, size_t n);
double statistics_mean(const double *x, size_t n); /* NaN of nothing */

/* Standard deviation of the sample: n - 1 in the denominator; NaN below two. */
double statistics_sd(const double *x, size_t n);

/* Half-width of the 95 % confidence interval of the mean: Student's t with n - 1 degrees of freedom; NaN below two. */
double statistics_ci95(const double *x, size_t n);

double statistics_min(const double *x, size_t n); /* NaN of nothing */
double statistics_max(const double *x, size_t n);

/* Value that the part p (0 to 1) of them does not exceed, between order statistics at p (n - 1) from the smallest
 * (Hyndman & Fan 1996, type 7, the default of R and NumPy). Sorts x. */
double statistics_quantile(double *x, size_t n, double p);

#endif

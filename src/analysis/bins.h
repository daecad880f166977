/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Numbers sorted into bins of equal width: histograms, and profiles of a second number along the first. */
#ifndef SARCINA_ANALYSIS_BINS_H
#define SARCINA_ANALYSIS_BINS_H

#include <stddef.h>

typedef struct bins {
    size_t n;
    double low, high;             /* the ends; the last bin has its upper end too */
    double total;                 /* numbers that lie between them */
    double *count, *sum, *square; /* (n) of each bin; sums of the second number, and of its squared distance from the
                                   * bin's mean */
} bins;

bins bins_create(size_t n);
void bins_free(bins *b);

/* Sorts `count` numbers x; low, high NaN: the least and largest of them. NaN and what lies outside is left out. value:
 * the second number of each, or NULL; where it is NaN the pair is left out. Of no numbers, ends not given are NaN. */
void bins_fill(bins *b, const double *x, const double *value, size_t count, double low, double high);

/* The lower end of bin i; of bin n the upper end of the last. */
double bins_edge(const bins *b, size_t i);

/* Of the second number in bin i: mean, standard deviation (n - 1), and half the width of the 95 % interval of the mean
 * by Student's t. NaN for too few. */
double bins_mean(const bins *b, size_t i);
double bins_sd(const bins *b, size_t i);
double bins_ci95(const bins *b, size_t i);

#endif

/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "base/statistics.h"

#include <gsl/gsl_cdf.h>
#include <gsl/gsl_sort.h>
#include <gsl/gsl_statistics_double.h>
#include <math.h>

double statistics_sum(const double *x, size_t n) {
    double total = 0;
    for (size_t i = 0; i < n; i++)
        total += x[i];
    return total;
}

double statistics_mean(const double *x, size_t n) {
    return statistics_sum(x, n) / (double)n; /* 0 / 0: NaN */
}

double statistics_sd(const double *x, size_t n) {
    if (n < 2)
        return NAN;
    double centre = statistics_mean(x, n), total = 0;
    for (size_t i = 0; i < n; i++)
        total += (x[i] - centre) * (x[i] - centre);
    return sqrt(total / (double)(n - 1));
}

double statistics_ci95(const double *x, size_t n) {
    if (n < 2)
        return NAN;
    return gsl_cdf_tdist_Pinv(0.975, (double)(n - 1)) * statistics_sd(x, n) / sqrt((double)n);
}

double statistics_min(const double *x, size_t n) {
    double least = n ? x[0] : (double)NAN;
    for (size_t i = 1; i < n; i++)
        least = x[i] < least ? x[i] : least;
    return least;
}

double statistics_max(const double *x, size_t n) {
    double most = n ? x[0] : (double)NAN;
    for (size_t i = 1; i < n; i++)
        most = x[i] > most ? x[i] : most;
    return most;
}

double statistics_quantile(double *x, size_t n, double p) {
    gsl_sort(x, 1, n);
    return gsl_stats_quantile_from_sorted_data(x, 1, n, p);
}

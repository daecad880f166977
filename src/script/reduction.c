/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Sums are taken in the order the numbers come in, that of the cells' ids, so no result depends on the order of rows.
 * Quantiles interpolate between order statistics, at p (n - 1) from the smallest (Hyndman & Fan 1996, type 7, the
 * default of R and NumPy). */
#include "script/reduction.h"

#include "base/table.h"

#include <gsl/gsl_cdf.h>
#include <gsl/gsl_sort.h>
#include <gsl/gsl_statistics_double.h>
#include <math.h>

static double sum(double *v, size_t n, double p) {
    (void)p;
    double total = 0;
    for (size_t i = 0; i < n; i++)
        total += v[i];
    return total;
}

static double mean(double *v, size_t n, double p) {
    return sum(v, n, p) / (double)n;
}

/* Of the sample: n - 1 in the denominator. */
static double sd(double *v, size_t n, double p) {
    (void)p;
    if (n < 2)
        return NAN;
    double centre = mean(v, n, 0), total = 0;
    for (size_t i = 0; i < n; i++)
        total += (v[i] - centre) * (v[i] - centre);
    return sqrt(total / (double)(n - 1));
}

static double ci95(double *v, size_t n, double p) {
    (void)p;
    if (n < 2)
        return NAN;
    return gsl_cdf_tdist_Pinv(0.975, (double)(n - 1)) * sd(v, n, 0) / sqrt((double)n);
}

static double quantile(double *v, size_t n, double p) {
    gsl_sort(v, 1, n);
    return gsl_stats_quantile_from_sorted_data(v, 1, n, p);
}

static double median(double *v, size_t n, double p) {
    (void)p;
    return quantile(v, n, 0.5);
}

static double least(double *v, size_t n, double p) {
    (void)p;
    double m = v[0];
    for (size_t i = 1; i < n; i++)
        m = v[i] < m ? v[i] : m;
    return m;
}

static double most(double *v, size_t n, double p) {
    (void)p;
    double m = v[0];
    for (size_t i = 1; i < n; i++)
        m = v[i] > m ? v[i] : m;
    return m;
}

const reduction_style reduction_styles[] = {
    {"mean", "mean(x [where test])", "mean over cells or a list", REDUCTION_VALUE, mean},
    {"sum", "sum(x [where test])", "sum", REDUCTION_SUM, sum},
    {"sd", "sd(x [where test])", "standard deviation of the sample", REDUCTION_VALUE, sd},
    {"median", "median(x [where test])", "median", REDUCTION_VALUE, median},
    {"min", "min(x [where test])", "smallest", REDUCTION_VALUE, least},
    {"max", "max(x [where test])", "largest", REDUCTION_VALUE, most},
    {"count", "count(test)", "how many cells it holds for; how many a list has", REDUCTION_COUNT, NULL},
    {"fraction", "fraction(test [where test])", "part of the cells it holds for", REDUCTION_FRACTION, NULL},
    {"quantile", "quantile(p, x [where test])", "value that the part p of them does not exceed", REDUCTION_QUANTILE,
     quantile},
    {"ci95", "ci95(x [where test])", "half-width of the 95 % interval of the mean (Student's t)", REDUCTION_VALUE,
     ci95},
};
const size_t reduction_style_count = TABLE_COUNT(reduction_styles);

const reduction_style *reduction_find(const char *name) {
    ptrdiff_t row = table_find(reduction_styles, reduction_style_count, sizeof *reduction_styles, name);
    return row < 0 ? NULL : &reduction_styles[row];
}

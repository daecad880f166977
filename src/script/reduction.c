/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The numbers come in the order of the cells' ids, so no result depends on the order of rows. */
#include "script/reduction.h"

#include "base/statistics.h"
#include "base/table.h"

#define REDUCE(name, call)                                                                                             \
    static double name(double *v, size_t n, double p) {                                                                \
        (void)p;                                                                                                       \
        return call(v, n);                                                                                             \
    }
REDUCE(sum, statistics_sum)
REDUCE(mean, statistics_mean)
REDUCE(sd, statistics_sd)
REDUCE(ci95, statistics_ci95)
REDUCE(least, statistics_min)
REDUCE(most, statistics_max)
#undef REDUCE

static double median(double *v, size_t n, double p) {
    (void)p;
    return statistics_quantile(v, n, 0.5);
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
     statistics_quantile},
    {"ci95", "ci95(x [where test])", "half-width of the 95 % interval of the mean (Student's t)", REDUCTION_VALUE,
     ci95},
};
const size_t reduction_style_count = TABLE_COUNT(reduction_styles);

const reduction_style *reduction_find(const char *name) {
    ptrdiff_t row = table_find(reduction_styles, reduction_style_count, sizeof *reduction_styles, name);
    return row < 0 ? NULL : &reduction_styles[row];
}

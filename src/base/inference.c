/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "base/inference.h"

#include "base/alloc.h"
#include "base/statistics.h"

#include <gsl/gsl_cdf.h>
#include <math.h>
#include <stdlib.h>

inference_sample inference_sample_of(const double *x, size_t n) {
    double *known = alloc_zeroed(n, sizeof *known);
    size_t count = 0;
    for (size_t i = 0; i < n; i++)
        if (!isnan(x[i]))
            known[count++] = x[i];
    inference_sample s = {statistics_mean(known, count), statistics_sd(known, count), count};
    free(known);
    return s;
}

/* The quantile of Student's t; NaN without degrees of freedom. */
static double quantile(double p, double freedom) {
    return freedom > 0 ? gsl_cdf_tdist_Pinv(p, freedom) : (double)NAN;
}

inference_sample inference_sample_behind(double mean, double ci95, size_t n) {
    return (inference_sample){mean, ci95 / quantile(0.975, (double)n - 1) * sqrt((double)n), n};
}

double inference_ci95(inference_sample a) {
    return quantile(0.975, (double)a.n - 1) * a.sd / sqrt((double)a.n);
}

double inference_prediction95(inference_sample a) {
    return quantile(0.975, (double)a.n - 1) * a.sd * sqrt(1 + 1 / (double)a.n);
}

inference_difference inference_compare(inference_sample a, inference_sample b) {
    double va = a.sd * a.sd / (double)a.n, vb = b.sd * b.sd / (double)b.n, v = va + vb;
    double freedom = v * v / (va * va / ((double)a.n - 1) + vb * vb / ((double)b.n - 1));
    return (inference_difference){a.mean - b.mean, sqrt(v), freedom};
}

inference_difference inference_paired(inference_sample differences) {
    double n = (double)differences.n;
    return (inference_difference){differences.mean, differences.sd / sqrt(n), n - 1};
}

double inference_width(inference_difference d, double level) {
    return d.error == 0 ? 0 : quantile(0.5 + level / 2, d.freedom) * d.error;
}

/* Samples without any spread leave no doubt. */
double inference_p_above(inference_difference d, double bound) {
    if (d.error == 0)
        return d.value > bound ? 0 : 1;
    return d.freedom > 0 ? gsl_cdf_tdist_Q((d.value - bound) / d.error, d.freedom) : (double)NAN;
}

double inference_p_equivalent(inference_difference d, double margin) {
    inference_difference turned = d;
    turned.value = -d.value;
    double lower = inference_p_above(d, -margin), upper = inference_p_above(turned, -margin);
    return isnan(lower) || lower > upper ? lower : upper;
}

/* The chance that the mean of n differences clears a test whose bound is the t at `certainty`, of an effect of `ratio`
 * standard deviations; both: from either side at once. */
static double power_of(double n, double ratio, double certainty, int both) {
    double beyond = ratio * sqrt(n) - gsl_cdf_tdist_Pinv(certainty, n - 1);
    double power = gsl_cdf_tdist_P(beyond, n - 1);
    return both ? 2 * power - 1 : power;
}

static double pairs_for(double ratio, double certainty, int both) {
    const double most = 1e6, power = 0.8;
    if (isnan(ratio))
        return NAN;
    if (!(power_of(most, ratio, certainty, both) >= power))
        return INFINITY;
    double low = 1, high = most; /* too few; enough */
    while (high - low > 1) {
        double middle = floor((low + high) / 2);
        *(power_of(middle, ratio, certainty, both) >= power ? &high : &low) = middle;
    }
    return high;
}

double inference_pairs_equivalent(double sd, double margin) {
    return pairs_for(margin / sd, 0.95, 1);
}

double inference_pairs_different(double sd, double difference, double level) {
    return pairs_for(fabs(difference) / sd, 0.5 + level / 2, 0);
}

void inference_holm(const double *p, size_t n, double *adjusted) {
    size_t *order = alloc_zeroed(n, sizeof *order), asked = 0;
    for (size_t i = 0; i < n; i++) {
        adjusted[i] = NAN;
        if (!isnan(p[i]))
            order[asked++] = i;
    }
    /* few: insertion by p */
    for (size_t i = 1; i < asked; i++)
        for (size_t k = i; k > 0 && p[order[k]] < p[order[k - 1]]; k--) {
            size_t other = order[k];
            order[k] = order[k - 1];
            order[k - 1] = other;
        }
    double most = 0;
    for (size_t i = 0; i < asked; i++) {
        most = fmax(most, fmin(1, (double)(asked - i) * p[order[i]]));
        adjusted[order[i]] = most;
    }
    free(order);
}

double inference_hedges(inference_sample a, inference_sample b, double *ci95) {
    double na = (double)a.n, nb = (double)b.n, n = na + nb;
    double pooled = sqrt(((na - 1) * a.sd * a.sd + (nb - 1) * b.sd * b.sd) / (n - 2));
    double g = (1 - 3 / (4 * (n - 2) - 1)) * (a.mean - b.mean) / pooled;
    *ci95 = gsl_cdf_ugaussian_Pinv(0.975) * sqrt(n / (na * nb) + g * g / (2 * n));
    return g;
}

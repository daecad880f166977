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

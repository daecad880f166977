/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "analysis/bins.h"

#include "base/alloc.h"

#include <gsl/gsl_cdf.h>
#include <math.h>
#include <stdlib.h>

bins bins_create(size_t n) {
    return (bins){.n = n,
                  .low = NAN,
                  .high = NAN,
                  .count = alloc_zeroed(n, sizeof(double)),
                  .sum = alloc_zeroed(n, sizeof(double)),
                  .square = alloc_zeroed(n, sizeof(double))};
}

void bins_free(bins *b) {
    free(b->count);
    free(b->sum);
    free(b->square);
    *b = (bins){0};
}

/* The bin of x; n: none. */
static size_t find_bin(const bins *b, double x) {
    if (!(x >= b->low && x <= b->high))
        return b->n;
    if (b->high == b->low)
        return 0;
    size_t i = (size_t)((double)b->n * ((x - b->low) / (b->high - b->low)));
    i = i < b->n ? i : b->n - 1;
    /* what was rounded decides as the edges do */
    if (i > 0 && x < bins_edge(b, i))
        i--;
    else if (i + 1 < b->n && x >= bins_edge(b, i + 1))
        i++;
    return i;
}

static void set_ends(bins *b, const double *x, const double *value, size_t count, double low, double high) {
    b->low = low;
    b->high = high;
    for (size_t k = 0; k < count; k++) {
        if (value && isnan(value[k]))
            continue;
        b->low = isnan(low) ? fmin(b->low, x[k]) : low;
        b->high = isnan(high) ? fmax(b->high, x[k]) : high;
    }
}

void bins_fill(bins *b, const double *x, const double *value, size_t count, double low, double high) {
    set_ends(b, x, value, count, low, high);
    b->total = 0;
    for (size_t i = 0; i < b->n; i++)
        b->count[i] = b->sum[i] = b->square[i] = 0;
    for (size_t k = 0; k < count; k++) {
        size_t i = find_bin(b, x[k]);
        if (i == b->n || (value && isnan(value[k])))
            continue;
        b->total += 1;
        b->count[i] += 1;
        if (!value)
            continue;
        double before = b->count[i] > 1 ? b->sum[i] / (b->count[i] - 1) : value[k]; /* Welford's way: no digits lost */
        b->sum[i] += value[k];
        b->square[i] += (value[k] - before) * (value[k] - b->sum[i] / b->count[i]);
    }
}

double bins_edge(const bins *b, size_t i) {
    return i == b->n ? b->high : b->low + (b->high - b->low) * ((double)i / (double)b->n);
}

double bins_mean(const bins *b, size_t i) {
    return b->count[i] > 0 ? b->sum[i] / b->count[i] : (double)NAN;
}

double bins_sd(const bins *b, size_t i) {
    return b->count[i] > 1 ? sqrt(b->square[i] / (b->count[i] - 1)) : (double)NAN;
}

double bins_ci95(const bins *b, size_t i) {
    if (!(b->count[i] > 1))
        return NAN;
    return gsl_cdf_tdist_Pinv(0.975, b->count[i] - 1) * bins_sd(b, i) / sqrt(b->count[i]);
}

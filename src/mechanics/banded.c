/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "mechanics/banded.h"

#include <math.h>

static const double least_pivot = 1e-14; /* of its diagonal */

/* First column of row i, and where it stands in the matrix; the others follow. */
static size_t begin_of(size_t i) {
    return i < BANDED_WIDTH - 1 ? 0 : i - (BANDED_WIDTH - 1);
}

static size_t place_of(size_t i, size_t column) {
    return i * BANDED_WIDTH + (column + BANDED_WIDTH - 1 - i);
}

void banded_factor(double *matrix, size_t n) {
    for (size_t i = 0; i < n; i++) {
        const size_t first = begin_of(i);
        double *row = matrix + place_of(i, first), diagonal = row[i - first];
        for (size_t j = first; j <= i; j++) {
            const double *other = matrix + place_of(j, first);
            double sum = row[j - first];
            for (size_t k = 0; k < j - first; k++)
                sum -= row[k] * other[k];
            row[j - first] = j < i ? sum / other[j - first] : sqrt(fmax(sum, least_pivot * diagonal));
        }
    }
}

void banded_solve(const double *matrix, size_t n, const double *y, double *out) {
    for (size_t i = 0; i < n; i++) {
        const size_t first = begin_of(i);
        const double *row = matrix + place_of(i, first);
        double rest = y[i];
        for (size_t j = first; j < i; j++)
            rest -= row[j - first] * out[j];
        out[i] = rest / row[i - first];
    }
    for (size_t i = n; i-- > 0;) {
        const size_t first = begin_of(i);
        const double *row = matrix + place_of(i, first);
        out[i] /= row[i - first];
        for (size_t j = first; j < i; j++)
            out[j] -= row[j - first] * out[i];
    }
}

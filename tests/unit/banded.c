/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Banded Cholesky against dense elimination, for every size from one row on, and where rounding leaves no pivot. */
#include "check.h"

#include "mechanics/banded.h"

#include <gsl/gsl_linalg.h>
#include <gsl/gsl_rng.h>

enum { MOST = 40 };

/* A matrix of squares g g' over up to four particles, as springs make them, and `shift` on the diagonal; banded and
 * dense. */
static void fill(gsl_rng *r, size_t n, double shift, double *banded, gsl_matrix *dense) {
    gsl_matrix_set_zero(dense);
    for (size_t i = 0; i < n; i++)
        gsl_matrix_set(dense, i, i, shift);
    for (size_t s = 0; s < 2 * n; s++) {
        size_t first = gsl_rng_uniform_int(r, n) / 3 * 3;
        double g[BANDED_WIDTH], k = pow(10, 6 * gsl_rng_uniform(r));
        for (size_t i = 0; i < BANDED_WIDTH; i++)
            g[i] = gsl_rng_uniform(r) - 0.5;
        for (size_t i = 0; i < BANDED_WIDTH && first + i < n; i++)
            for (size_t j = 0; j < BANDED_WIDTH && first + j < n; j++)
                *gsl_matrix_ptr(dense, first + i, first + j) += k * g[i] * g[j];
    }
    for (size_t i = 0; i < n; i++)
        for (size_t j = i < BANDED_WIDTH - 1 ? 0 : i - (BANDED_WIDTH - 1); j <= i; j++)
            *banded_at(banded, i, j) = gsl_matrix_get(dense, i, j);
}

static void test_against_dense(void **state) {
    (void)state;
    gsl_rng *r = gsl_rng_alloc(gsl_rng_mt19937);
    for (size_t n = 1; n <= MOST; n++) {
        double banded[MOST * BANDED_WIDTH], y[MOST], out[MOST];
        gsl_matrix *dense = gsl_matrix_alloc(n, n);
        gsl_vector *x = gsl_vector_alloc(n);
        for (size_t i = 0; i < MOST * BANDED_WIDTH; i++)
            banded[i] = NAN; /* what lies left of the first column is not read */
        fill(r, n, 1, banded, dense);
        for (size_t i = 0; i < n; i++)
            gsl_vector_set(x, i, y[i] = gsl_rng_uniform(r) - 0.5);
        banded_factor(banded, n);
        banded_solve(banded, n, y, out);
        banded_solve(banded, n, y, y); /* in place: the same bits */
        gsl_linalg_cholesky_decomp1(dense);
        gsl_linalg_cholesky_svx(dense, x);
        for (size_t i = 0; i < n; i++) {
            assert_near(out[i], gsl_vector_get(x, i), 1e-8 * (1 + fabs(out[i])));
            assert_true(y[i] == out[i]);
        }
        gsl_vector_free(x);
        gsl_matrix_free(dense);
    }
    gsl_rng_free(r);
}

/* A matrix that is singular but for rounding, and one that rounding has made indefinite: finite answers, along which
 * what it is solved for has not turned round. */
static void test_without_pivots(void **state) {
    (void)state;
    for (int indefinite = 0; indefinite < 2; indefinite++) {
        double banded[3 * BANDED_WIDTH] = {0}, y[3] = {1, 2, -1}, out[3], along = 0;
        for (size_t i = 0; i < 3; i++)
            for (size_t j = 0; j <= i; j++)
                *banded_at(banded, i, j) = 1e20 + (i == j ? 0 : indefinite * 1e6);
        banded_factor(banded, 3);
        banded_solve(banded, 3, y, out);
        for (size_t i = 0; i < 3; i++) {
            assert_true(isfinite(out[i]));
            along += y[i] * out[i];
        }
        assert_true(along > 0);
    }
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_against_dense),
        cmocka_unit_test(test_without_pivots),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}

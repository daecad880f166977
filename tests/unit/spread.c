/* SPDX-License-Identifier: GPL-3.0-or-later */
/* A number or a distribution: moments and ends of what is drawn, five standard errors wide, seeds fixed. */
#include "check.h"

#include "base/rng.h"
#include "base/spread.h"

#include <stdlib.h>

enum { DRAWS = 100000 };

typedef struct moments {
    double mean, variance, least, greatest;
} moments;

/* Of one draw from each of many streams, as cells draw. */
static moments draw_moments(spread s) {
    rng *r = rng_create(42);
    double sum = 0, square = 0;
    moments m = {0, 0, INFINITY, -INFINITY};
    for (uint64_t id = 1; id <= DRAWS; id++) {
        double x = spread_draw(&s, rng_stream(r, RNG_RATE, id, 1));
        sum += x;
        square += x * x;
        m.least = fmin(m.least, x);
        m.greatest = fmax(m.greatest, x);
    }
    rng_free(r);
    m.mean = sum / DRAWS;
    m.variance = square / DRAWS - m.mean * m.mean;
    return m;
}

static void test_fixed_draws_nothing(void **state) {
    (void)state;
    rng *r = rng_create(1), *s = rng_create(1);
    const spread fixed = spread_fixed(0.75);
    gsl_rng *stream = rng_stream(r, RNG_RATE, 1, 1);
    assert_true(spread_draw(&fixed, stream) == 0.75);
    assert_true(spread_mean(&fixed) == 0.75);
    assert_true(gsl_rng_get(stream) == gsl_rng_get(rng_stream(s, RNG_RATE, 1, 1)));
    rng_free(r);
    rng_free(s);
}

/* The growth rate of E. coli (model.md section 4), per hour. */
static void test_normal(void **state) {
    (void)state;
    const spread s = {SPREAD_NORMAL, 1.23, 0.277};
    moments m = draw_moments(s);
    assert_near(m.mean, 1.23, 5 * 0.277 / sqrt(DRAWS));
    assert_near(m.variance, 0.277 * 0.277, 5 * 0.277 * 0.277 * sqrt(2.0 / DRAWS));
    assert_true(m.greatest > 1.23 + 3.5 * 0.277 && m.least < 1.23 - 3.5 * 0.277);
    assert_true(spread_mean(&s) == 1.23);
}

static void test_uniform(void **state) {
    (void)state;
    const spread s = {SPREAD_UNIFORM, 0.5, 1};
    moments m = draw_moments(s);
    assert_near(m.mean, 0.75, 5 * 0.5 / sqrt(12.0 * DRAWS));
    assert_near(m.variance, 0.25 / 12, 5 * 0.25 * sqrt(1 / 180.0 / DRAWS));
    assert_true(m.least >= 0.5 && m.least < 0.5005);
    assert_true(m.greatest < 1 && m.greatest > 0.9995);
    assert_near(spread_mean(&s), 0.75, 0);
}

/* MEDIAN GSD: half lie below the median, and the logarithms are normal with log GSD. */
static void test_lognormal(void **state) {
    (void)state;
    const double median = 2.45, gsd = 1.2;
    const spread s = {SPREAD_LOGNORMAL, median, gsd};
    moments m = draw_moments(s);
    double sigma2 = log(gsd) * log(gsd), mean = median * exp(sigma2 / 2);
    double variance = (exp(sigma2) - 1) * mean * mean;
    assert_near(m.mean, mean, 5 * sqrt(variance / DRAWS));
    assert_near(m.variance, variance, 0.05 * variance);
    assert_near(spread_mean(&s), mean, 1e-12);
    assert_true(m.least > 0);
    rng *r = rng_create(8);
    int below = 0;
    for (uint64_t id = 1; id <= DRAWS; id++)
        below += spread_draw(&s, rng_stream(r, RNG_SIZE, id, 1)) < median;
    rng_free(r);
    assert_near(below, DRAWS / 2.0, 5 * sqrt(DRAWS) / 2);
    const spread narrow = {SPREAD_LOGNORMAL, median, 1};
    r = rng_create(8);
    assert_near(spread_draw(&narrow, rng_stream(r, RNG_SIZE, 1, 1)), median, 1e-15 * median);
    rng_free(r);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_fixed_draws_nothing),
        cmocka_unit_test(test_normal),
        cmocka_unit_test(test_uniform),
        cmocka_unit_test(test_lognormal),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}

/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Statistics against values worked out by hand and from tables of Student's t. */
#include "check.h"

#include "base/statistics.h"

static void test_moments(void **state) {
    (void)state;
    const double x[] = {2, 4, 4, 4, 5, 5, 7, 9};
    assert_near(statistics_sum(x, 8), 40, 0);
    assert_near(statistics_mean(x, 8), 5, 0);
    assert_near(statistics_sd(x, 8), sqrt(32.0 / 7), 1e-15);
    assert_near(statistics_min(x, 8), 2, 0);
    assert_near(statistics_max(x, 8), 9, 0);
}

/* t(0.975) is 12.706205 with 1 degree of freedom, 2.262157 with 9 (any table). */
static void test_interval(void **state) {
    (void)state;
    const double two[] = {1, 3};
    assert_near(statistics_ci95(two, 2), 12.7062047361747 * 1, 1e-9);
    double ten[10];
    for (int i = 0; i < 10; i++)
        ten[i] = i;
    assert_near(statistics_ci95(ten, 10), 2.26215716285 * sqrt(82.5 / 9) / sqrt(10), 1e-9);
}

static void test_too_few(void **state) {
    (void)state;
    const double one = 3;
    assert_true(isnan(statistics_mean(&one, 0)));
    assert_true(isnan(statistics_min(&one, 0)));
    assert_true(isnan(statistics_max(&one, 0)));
    assert_near(statistics_mean(&one, 1), 3, 0);
    assert_true(isnan(statistics_sd(&one, 1)));
    assert_true(isnan(statistics_ci95(&one, 1)));
}

static void test_quantile(void **state) {
    (void)state;
    double x[] = {4, 1, 3, 2};
    assert_near(statistics_quantile(x, 4, 0), 1, 0);
    assert_near(statistics_quantile(x, 4, 0.5), 2.5, 1e-15);
    assert_near(statistics_quantile(x, 4, 0.9), 3.7, 1e-15); /* R: quantile(1:4, .9) */
    assert_near(statistics_quantile(x, 4, 1), 4, 0);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_moments),
        cmocka_unit_test(test_interval),
        cmocka_unit_test(test_too_few),
        cmocka_unit_test(test_quantile),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}

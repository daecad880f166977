/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Comparisons of samples: the sleep data of Student (1908, Biometrika 6:1), whose Welch test every statistics program
 * prints (R's manual of t.test: t = -1.8608, df = 17.776, p = 0.07939, interval -3.3654832 ... 0.2054832), Hedges' g of
 * the same data, Holm's steps by hand, and equivalence against the interval to which it is dual. */
#include "check.h"

#include "base/inference.h"

static const double drug1[] = {0.7, -1.6, -0.2, -1.2, -0.1, 3.4, 3.7, 0.8, 0.0, 2.0};
static const double drug2[] = {1.9, 0.8, 1.1, 0.1, -0.1, 4.4, 5.5, 1.6, 4.6, 3.4};

static inference_difference sleep_difference(void) {
    return inference_compare(inference_sample_of(drug1, 10), inference_sample_of(drug2, 10));
}

static void test_welch(void **state) {
    (void)state;
    inference_difference d = sleep_difference();
    assert_near(d.value / d.error, -1.8608, 5e-5);
    assert_near(d.freedom, 17.776, 5e-4);
    assert_near(2 * (1 - inference_p_above(d, 0)), 0.07939, 5e-6);
    assert_near(d.value - inference_width(d, 0.95), -3.3654832, 5e-8);
    assert_near(d.value + inference_width(d, 0.95), 0.2054832, 5e-8);
}

/* A bound at the end of the 95 % interval is exceeded with p = 2.5 %. */
static void test_bound(void **state) {
    (void)state;
    inference_difference d = sleep_difference();
    assert_near(inference_p_above(d, d.value - inference_width(d, 0.95)), 0.025, 1e-9);
    assert_near(inference_p_above(d, d.value), 0.5, 1e-12);
}

/* Equivalent at 5 % exactly when the margin holds the 90 % interval. */
static void test_equivalence(void **state) {
    (void)state;
    inference_difference d = sleep_difference();
    double margin = fabs(d.value) + inference_width(d, 0.90);
    assert_near(inference_p_equivalent(d, margin), 0.05, 1e-9);
    assert_true(inference_p_equivalent(d, 1.1 * margin) < 0.05);
    assert_true(inference_p_equivalent(d, fabs(d.value)) > 0.49);
    inference_difference turned = {-d.value, d.error, d.freedom};
    assert_near(inference_p_equivalent(turned, margin), 0.05, 1e-9);
}

/* Cohen's d is -0.8321811; g is that by 1 - 3/71. Its variance: 20/100 + g^2/40. */
static void test_hedges(void **state) {
    (void)state;
    double ci95, g = inference_hedges(inference_sample_of(drug1, 10), inference_sample_of(drug2, 10), &ci95);
    assert_near(g, -0.8321811 * (1 - 3.0 / 71), 1e-7);
    assert_near(ci95, 1.959963984540054 * sqrt(0.2 + g * g / 40), 1e-12);
}

static void test_samples(void **state) {
    (void)state;
    const double x[] = {1, NAN, 3, 2, NAN};
    inference_sample s = inference_sample_of(x, 5);
    assert_int_equal(s.n, 3);
    assert_near(s.mean, 2, 0);
    assert_near(s.sd, 1, 0);
    assert_near(inference_ci95(s), 4.30265272991 / sqrt(3), 1e-9);
    assert_near(inference_prediction95(s), 4.30265272991 * sqrt(4.0 / 3), 1e-9);
    inference_sample again = inference_sample_behind(2, inference_ci95(s), 3);
    assert_near(again.sd, 1, 1e-12);
    assert_true(isnan(inference_prediction95(inference_sample_of(x, 1))));
}

/* 4 x .005 = .02, 3 x .01 = .03, 2 x .03 = .06, then .04 may not fall below that. */
static void test_holm(void **state) {
    (void)state;
    const double p[] = {0.01, 0.04, NAN, 0.03, 0.005}, due[] = {0.03, 0.06, NAN, 0.06, 0.02};
    double adjusted[5];
    inference_holm(p, 5, adjusted);
    for (int i = 0; i < 5; i++)
        if (isnan(due[i]))
            assert_true(isnan(adjusted[i]));
        else
            assert_near(adjusted[i], due[i], 1e-15);
    const double large[] = {0.6, 0.7};
    inference_holm(large, 2, adjusted);
    assert_near(adjusted[0], 1, 0);
    assert_near(adjusted[1], 1, 0);
}

/* Without spread there is no doubt, and nothing is divided by zero. */
static void test_without_spread(void **state) {
    (void)state;
    inference_difference d = inference_compare((inference_sample){3, 0, 5}, (inference_sample){2, 0, 5});
    assert_near(inference_p_above(d, 0), 0, 0);
    assert_near(inference_p_above(d, 1), 1, 0);
    assert_near(inference_width(d, 0.95), 0, 0);
    assert_near(inference_p_equivalent(d, 1.5), 0, 0);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_welch),          cmocka_unit_test(test_bound),   cmocka_unit_test(test_equivalence),
        cmocka_unit_test(test_hedges),         cmocka_unit_test(test_samples), cmocka_unit_test(test_holm),
        cmocka_unit_test(test_without_spread),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}

/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The time a run still takes, where it is known what that is. */
#include "output/progress.h"

#include "check.h"

#include <stdio.h>
#include <string.h>

/* A colony whose mass grows by g a cycle, each cycle of which takes 1 ms a pg: a run of n cycles, watched after m. */
static progress grow(double g, unsigned n, unsigned m, double *now) {
    double mass = 1;
    progress p = progress_begin(n, *now = 5, mass);
    for (unsigned i = 0; i < m; i++) {
        mass *= g;
        *now += 1e-3 * mass;
        progress_cycle(&p, *now, mass);
    }
    return p;
}

/* What the cycles after the m-th take. */
static double rest(double g, unsigned n, unsigned m) {
    double seconds = 0;
    for (unsigned i = m + 1; i <= n; i++)
        seconds += 1e-3 * pow(g, i);
    return seconds;
}

static void exponential_growth_is_foreseen(void **state) {
    (void)state;
    static const double factors[] = {1.08, 1, 0.97, 1.6};
    double now;
    for (size_t i = 0; i < sizeof factors / sizeof *factors; i++)
        for (unsigned m = 1; m <= 70; m += 23) {
            progress p = grow(factors[i], 70, m, &now);
            double wanted = rest(factors[i], 70, m);
            assert_near(progress_left(&p), wanted, 1e-6 * wanted);
        }
}

static void the_mean_so_far_would_be_far_off(void **state) {
    (void)state;
    double now;
    progress p = grow(1.08, 70, 35, &now);
    double naive = (now - 5) / 35 * 35;
    assert_true(progress_left(&p) > 10 * naive);
}

static void a_change_of_speed_is_followed(void **state) {
    (void)state;
    progress p = progress_begin(200, 0, 2);
    double now = 0;
    for (int i = 0; i < 100; i++)
        progress_cycle(&p, now += i < 50 ? 1 : 0.1, 2);
    assert_near(progress_left(&p), 10, 0.1 * 10);
}

static void nothing_is_known_before_the_first_cycle(void **state) {
    (void)state;
    char line[200];
    progress p = progress_begin(10, 0, 1);
    assert_true(isnan(progress_left(&p)));
    progress_cycle(&p, 1, 0); /* an empty scene */
    assert_true(isnan(progress_left(&p)));
    progress_line(&p, 0, 0, false, line, sizeof line);
    assert_string_equal(line, "cycle 1 of 10, 0 cells, 1 s a cycle, ? left");
}

static void lines_are_rare_and_say_what_they_know(void **state) {
    (void)state;
    char line[200];
    progress p = progress_begin(8000, 0, 1);
    progress_cycle(&p, 0.4, 1);
    assert_false(progress_is_due(&p));
    progress_cycle(&p, 0.8, 1);
    assert_true(progress_is_due(&p));
    progress_line(&p, 40, 187, true, line, sizeof line);
    assert_string_equal(line, "cycle 42 of 8040, 187 cells, 2.5 cycles/s, at most 0:53:19 left");
    progress_cycle(&p, 1, 1);
    assert_false(progress_is_due(&p));
    progress_cycle(&p, 1.1, 1);
    assert_true(progress_is_due(&p));
}

static void a_time_beyond_all_measure_has_a_word(void **state) {
    (void)state;
    char line[200];
    double now;
    progress p = grow(2, 5000, 5, &now);
    progress_line(&p, 0, 32, false, line, sizeof line);
    assert_non_null(strstr(line, "more than 100 days left"));
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(exponential_growth_is_foreseen),
        cmocka_unit_test(the_mean_so_far_would_be_far_off),
        cmocka_unit_test(a_change_of_speed_is_followed),
        cmocka_unit_test(nothing_is_known_before_the_first_cycle),
        cmocka_unit_test(lines_are_rare_and_say_what_they_know),
        cmocka_unit_test(a_time_beyond_all_measure_has_a_word),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}

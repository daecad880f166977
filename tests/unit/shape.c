/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Mass and size are each other's inverse, and give the published cells (model.md section 6, Table 1 set right). */
#include "check.h"

#include "model/shape.h"

#include <stdlib.h>

enum { TRIALS = 20000 };
static const double density = 1.01; /* 1010 kg/m3 */

static double between(double low, double high) {
    return low + (high - low) * ((double)rand() / RAND_MAX);
}

/* Volume of the capsule itself, not the formula under test. */
static double capsule_mass(double rest, double d, double rho) {
    return rho * (M_PI / 4 * d * d * rest + M_PI / 6 * d * d * d);
}

static void test_round_trips(void **state) {
    (void)state;
    srand(1);
    for (int i = 0; i < TRIALS; i++) {
        double d = between(0.1, 5), rest = between(0, 20), rho = between(0.5, 3);
        double mass = shape_rod_mass(rest, d, rho);
        assert_near(mass, capsule_mass(rest, d, rho), 1e-14 * mass);
        assert_near(shape_rod_rest(mass, d, rho), rest, 1e-14 * (rest + d));
        mass = shape_coccus_mass(d, rho);
        assert_near(mass, capsule_mass(0, d, rho), 1e-14 * mass);
        assert_near(shape_coccus_diameter(mass, rho), d, 1e-15 * d);
    }
}

/* A rod of fixed aspect a has rest length (a - 1) D, whatever its mass. */
static void test_aspect(void **state) {
    (void)state;
    srand(2);
    for (int i = 0; i < TRIALS; i++) {
        double aspect = between(1, 10), mass = between(0.01, 10), rho = between(0.5, 3);
        double d = shape_rod_aspect_diameter(mass, aspect, rho);
        assert_near(capsule_mass((aspect - 1) * d, d, rho), mass, 1e-14 * mass);
    }
    assert_near(shape_rod_aspect_diameter(0.5, 1, density), shape_coccus_diameter(0.5, density), 1e-15);
}

/* Printed with few digits: within half of the last one. */
static void test_table_1(void **state) {
    (void)state;
    assert_near(shape_rod_rest(2.45, 0.75, density), 5.0, 0.05);
    assert_near(shape_rod_rest(2.45 / 2, 0.75, density), 2.25, 0.005);
    assert_near(shape_rod_rest(3.70, 1.0, density), 4.0, 0.05);
    assert_near(shape_rod_rest(3.70 / 2, 1.0, density), 1.667, 0.002);
    assert_near(shape_rod_rest(0.609, 0.70, density), 1.1, 0.05);
    assert_near(shape_rod_rest(0.609 / 2, 0.70, density), 0.317, 0.0005);
    assert_near(shape_coccus_diameter(0.595, density), 1.04, 0.005);
    assert_near(shape_coccus_diameter(0.609, density), 1.048, 0.0005);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_round_trips),
        cmocka_unit_test(test_aspect),
        cmocka_unit_test(test_table_1),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}

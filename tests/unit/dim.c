/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Dimensions: names, suffixes, and conversions between SI and the engine's units that round once. */
#include "check.h"

#include "base/dim.h"

#include <stdlib.h>
#include <string.h>

/* Exponents in twelfths. */
static void test_names(void **state) {
    (void)state;
    static const struct {
        const char *name;
        dim d;
    } known[] = {
        {"length", {12, 0, 0}},          {"area", {24, 0, 0}},
        {"volume", {36, 0, 0}},          {"mass", {0, 12, 0}},
        {"density", {-36, 12, 0}},       {"time", {0, 0, 12}},
        {"rate", {0, 0, -12}},           {"wavenumber", {-12, 0, 0}},
        {"velocity", {12, 0, -12}},      {"drag", {0, 12, -12}},
        {"stiffness", {0, 12, -24}},     {"force", {12, 12, -24}},
        {"energy", {24, 12, -24}},       {"number", {0, 0, 0}},
        {"fraction", {0, 0, 0}},         {"angle", {0, 0, 0}},
        {"massrate", {0, 12, -12}},      {"bending", {24, 12, -24}},
        {"energylength", {36, 12, -24}}, {"acceleration", {12, 0, -24}},
    };
    for (size_t i = 0; i < sizeof known / sizeof known[0]; i++) {
        dim d = DIM_MASS;
        assert_true(dim_by_name(known[i].name, &d));
        assert_true(dim_equal(d, known[i].d));
    }
    dim d = DIM_MASS;
    assert_false(dim_by_name("lenght", &d));
    assert_true(dim_equal(d, DIM_MASS));
}

/* An error uses the first name of a dimension that has several. */
static void test_what_errors_say(void **state) {
    (void)state;
    char buffer[48];
    assert_string_equal(dim_name(DIM_LENGTH, buffer), "length");
    assert_string_equal(dim_name(DIM_NONE, buffer), "pure number");
    assert_string_equal(dim_name(DIM_ENERGY, buffer), "energy");
    assert_string_equal(dim_name(DIM(0, 1, -1), buffer), "drag");
    assert_string_equal(dim_name(DIM(5, 0, 0), buffer), "m5");
}

static void test_suffixes(void **state) {
    (void)state;
    char buffer[48];
    assert_string_equal(dim_suffix(DIM_NONE, buffer), "");
    assert_string_equal(dim_suffix(DIM_LENGTH, buffer), "m");
    assert_string_equal(dim_suffix(DIM_AREA, buffer), "m2");
    assert_string_equal(dim_suffix(DIM_RATE, buffer), "/s");
    assert_string_equal(dim_suffix(DIM_STIFFNESS, buffer), "N/m");
    assert_string_equal(dim_suffix(DIM_FORCE, buffer), "N");
    assert_string_equal(dim_suffix(DIM_ENERGY, buffer), "J");
    assert_string_equal(dim_suffix(DIM(-1, 1, -2), buffer), "Pa");
    assert_string_equal(dim_suffix(DIM(2, 1, -3), buffer), "kg.m2/s3");
    assert_string_equal(dim_suffix(DIM_DENSITY, buffer), "kg/m3");
    assert_string_equal(dim_suffix(DIM(-1, 0, -1), buffer), "/m/s");
    assert_string_equal(dim_suffix((dim){6, 0, 0}, buffer), "m^0.5");
    /* the longest there is stays inside */
    const char *longest = dim_suffix((dim){-32767, 32767, -32767}, buffer);
    assert_true(strlen(longest) < sizeof buffer);
}

/* Engine units are um, pg, s: one correctly rounded multiplication or division by an exact power of ten. */
static void test_conversion_rounds_once(void **state) {
    (void)state;
    for (int i = 1; i < 20000; i++) {
        double x = i * 1.2345e-7;
        assert_true(dim_to_engine(x, DIM_LENGTH) == x * 1e6);
        assert_true(dim_to_engine(x, DIM_AREA) == x * 1e12);
        assert_true(dim_to_engine(x, DIM_VOLUME) == x * 1e18);
        assert_true(dim_to_engine(x, DIM_STIFFNESS) == x * 1e15);
        assert_true(dim_to_engine(x, DIM_FORCE) == x * 1e21);
        assert_true(dim_to_engine(x, DIM_DENSITY) == x / 1e3);
        assert_true(dim_to_engine(x, DIM_RATE) == x);
        assert_true(dim_from_engine(x, DIM_LENGTH) == x / 1e6);
        assert_true(dim_from_engine(x, DIM_DENSITY) == x * 1e3);
    }
}

static void test_known_values(void **state) {
    (void)state;
    assert_true(dim_to_engine(1e-10, DIM_STIFFNESS) == 1e5);      /* k of collisions, model.md section 5 */
    assert_true(dim_to_engine(1e-13, DIM(0, 1, -1)) == 100);      /* damping */
    assert_true(dim_to_engine(1010, DIM_DENSITY) == 1.01);        /* pg/um3 */
    assert_near(dim_to_engine(1e-31, DIM(3, 1, -2)), 100, 1e-13); /* C_vdW, N m2 */
    assert_near(dim_to_engine(1e-22, DIM_ENERGY) * dim_to_engine(5e7, DIM(-1, 0, 0)), 5e6, 1e-9); /* C_ES kappa */
    assert_near(dim_to_engine(4, (dim){6, 0, 0}), 4e3, 1e-12); /* a root of a length */
}

/* There and back is within one unit in the last place, for whole exponents of any size. */
static void test_there_and_back(void **state) {
    (void)state;
    const dim dims[] = {DIM_LENGTH, DIM_VOLUME, DIM_MASS, DIM_DENSITY,   DIM_STIFFNESS,
                        DIM_FORCE,  DIM_ENERGY, DIM_TIME, DIM(3, 1, -2), DIM(-6, -1, 4)};
    for (size_t k = 0; k < sizeof dims / sizeof dims[0]; k++)
        for (int i = 1; i < 5000; i++) {
            double x = i / 7.0, y = dim_from_engine(dim_to_engine(x, dims[k]), dims[k]);
            assert_true(fabs(y - x) <= 4.5e-16 * x);
        }
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_names),        cmocka_unit_test(test_what_errors_say),
        cmocka_unit_test(test_suffixes),     cmocka_unit_test(test_conversion_rounds_once),
        cmocka_unit_test(test_known_values), cmocka_unit_test(test_there_and_back),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}

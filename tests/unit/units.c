/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Numbers and their units: the grammar's edges, UDUNITS's traps, and that a unit never costs a bit. */
#include "base/number.h"
#include "base/units.h"

#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>

#include <cmocka.h>

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

static int set_up(void **state) {
    *state = units_create(NULL);
    return *state == NULL;
}

static int tear_down(void **state) {
    units_free(*state);
    return 0;
}

static double read_si(units *u, const char *text, dim expected) {
    units_value v;
    diag d = {0};
    if (units_read(u, text, strlen(text), &v, &d) != SARCINA_OK)
        fail_msg("%s: %s", text, d.message);
    if (!dim_equal(v.d, expected))
        fail_msg("%s has another dimension", text);
    return v.si;
}

static void test_values(void **state) {
    const struct {
        const char *text;
        double si;
        dim d;
    } cases[] = {
        {"0.75um", 7.5e-7, DIM_LENGTH},
        {"0.75µm", 7.5e-7, DIM_LENGTH},
        {"0.75μm", 7.5e-7, DIM_LENGTH},
        {".75um", 7.5e-7, DIM_LENGTH},
        {"7.5e-7", 7.5e-7, DIM_NONE},
        {"4min", 240, DIM_TIME},
        {"1.23/h", 1.23 / 3600, DIM_RATE},
        {"1.23h-1", 1.23 / 3600, DIM_RATE},
        {"1.23h⁻¹", 1.23 / 3600, DIM_RATE},
        {"1.23h^-1", 1.23 / 3600, DIM_RATE},
        {"5e-11N/m", 5e-11, DIM_STIFFNESS},
        {"1e-13N.s/m", 1e-13, DIM(0, 1, -1)},
        {"1e-13N·s/m", 1e-13, DIM(0, 1, -1)},
        {"1010kg/m3", 1010, DIM_DENSITY},
        {"1010kg/m³", 1010, DIM_DENSITY},
        {"1010g/l", 1010, DIM_DENSITY},
        {"1pg", 1e-15, DIM_MASS},
        {"1pg/um3", 1e3, DIM_DENSITY},
        {"2um3", 2e-18, DIM_VOLUME},
        {"5%", 0.05, DIM_NONE},
        {"180deg", 180 * (3.14159265358979323846 / 180), DIM_NONE},
        {"-1e2", -100, DIM_NONE},
        {"+1.", 1, DIM_NONE},
    };
    for (size_t i = 0; i < sizeof cases / sizeof cases[0]; i++) {
        double si = read_si(*state, cases[i].text, cases[i].d);
        if (memcmp(&si, &cases[i].si, sizeof si) != 0)
            fail_msg("%s: %.17g, not %.17g", cases[i].text, si, cases[i].si);
    }
}

/* 0.75um and 7.5e-7 to the bit, for every decimal of four digits, and the same for the other powers of ten. */
static void test_bits(void **state) {
    const struct {
        const char *unit;
        int power;
        dim d;
    } cases[] = {{"um", -6, DIM_LENGTH},       {"nm", -9, DIM_LENGTH}, {"pg", -15, DIM_MASS},
                 {"mm", -3, DIM_LENGTH},       {"ms", -3, DIM_TIME},   {"um3", -18, DIM_VOLUME},
                 {"pN/um", -6, DIM_STIFFNESS}, {"g/l", 0, DIM_DENSITY}};
    char text[64];
    for (size_t c = 0; c < sizeof cases / sizeof cases[0]; c++)
        for (int i = 1; i < 10000; i++) {
            snprintf(text, sizeof text, "%d.%03d%s", i / 1000, i % 1000, cases[c].unit);
            double with_unit = read_si(*state, text, cases[c].d);
            snprintf(text, sizeof text, "%d.%03de%d", i / 1000, i % 1000, cases[c].power);
            double without = strtod(text, NULL);
            if (memcmp(&with_unit, &without, sizeof without) != 0)
                fail_msg("%s: %.17g, not %.17g", text, with_unit, without);
        }
}

static void test_refused(void **state) {
    static const struct {
        const char *text, *message;
    } cases[] = {
        {"1.5.2m", "not a unit"}, {"0x10", "not a number"}, {"inf", "not a number"},   {"nan", "not a number"},
        {"1e400", "not finite"},  {"5um@3", "not a unit"},  {"0.75umm", "not a unit"}, {"1e-13N*s/m", "not a unit"},
        {"1..10", "not a unit"},  {"0,75um", "not a unit"}, {"0.75UM", "not a unit"},  {"1em", "not a unit"},
        {"", "not a number"},     {"-", "not a number"},    {".", "not a number"},     {"1e-400", "too small"},
        {"1um/", "not a unit"},   {"1/", "not a unit"},     {"1um^", "not a unit"},    {"20celsius", "not a unit"},
        {"1mol", "not a unit"},   {"1 um", "not a unit"},   {"5 %", "not a unit"},     {"1%%", "not a unit"},
        {"--1", "not a number"},  {"h0", "not a number"},   {"1um..s", "not a unit"},  {"1m999", "not a unit"},
    };
    for (size_t i = 0; i < sizeof cases / sizeof cases[0]; i++) {
        units_value v;
        diag d = {0};
        int status = units_read(*state, cases[i].text, strlen(cases[i].text), &v, &d);
        if (status == SARCINA_OK || !strstr(d.message, cases[i].message))
            fail_msg("%s: '%s', not '%s'", cases[i].text, d.message, cases[i].message);
    }
}

static void test_hints(void **state) {
    units_value v;
    diag d = {0};
    units_read(*state, "5mins", 5, &v, &d);
    assert_string_equal(d.help, "minutes are min");
    units_read(*state, "0.75UM", 6, &v, &d);
    assert_string_equal(d.help, "did you mean 'um'?");
    units_read(*state, "0,75um", 6, &v, &d);
    assert_non_null(strstr(d.help, "decimal sign is a point"));
    dim time = DIM_TIME;
    assert_string_equal(units_hint("m", 1, &time), "m is metre; minutes are min");
    assert_null(units_hint("kg", 2, &time));
}

static void test_write(void **state) {
    (void)state;
    char buffer[32];
    assert_string_equal(number_write(0.1, buffer), "0.1");
    assert_string_equal(number_write(1e-6 * 3, buffer), "3e-06");
    for (int i = 1; i < 1000; i++) {
        double x = 1.0 / i;
        assert_true(strtod(number_write(x, buffer), NULL) == x);
    }
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_values), cmocka_unit_test(test_bits),  cmocka_unit_test(test_refused),
        cmocka_unit_test(test_hints),  cmocka_unit_test(test_write),
    };
    return cmocka_run_group_tests_name("units", tests, set_up, tear_down);
}

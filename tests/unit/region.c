/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Regions: what lies inside, and draws that are inside and even. */
#include "check.h"

#include "base/rng.h"
#include "model/region.h"

#include <stdlib.h>
#include <string.h>

enum { DRAWS = 40000 };

static const region block = {.kind = REGION_BLOCK, .p = {-1, 2, 0, 4, 5, 5.5}};
static const region sphere = {.kind = REGION_SPHERE, .p = {1, -2, 3, 2}};
static const region along[] = {
    {.kind = REGION_CYLINDER, .axis = 0, .p = {1, -2, 2, 4, 7}},
    {.kind = REGION_CYLINDER, .axis = 1, .p = {1, -2, 2, 4, 7}},
    {.kind = REGION_CYLINDER, .axis = 2, .p = {1, -2, 2, 4, 7}},
};
static const region plane = {.kind = REGION_PLANE, .p = {0, 0, 1, 0.6, 0, 0.8}};

static void test_table(void **state) {
    (void)state;
    region_table t = {0};
    char name[16];
    for (int i = 0; i < 30; i++) {
        snprintf(name, sizeof name, "r%d", i);
        assert_int_equal(region_find(&t, name), -1);
        region_add(&t, name)->p[0] = i;
    }
    region_remove(&t, 29);
    region_remove(&t, 3);
    region_remove(&t, 0);
    assert_int_equal(t.count, 27);
    assert_int_equal(region_find(&t, "r0"), -1);
    assert_int_equal(region_find(&t, "r3"), -1);
    assert_int_equal(region_find(&t, "r29"), -1);
    assert_int_equal(region_find(&t, "r1"), 0);
    assert_int_equal(region_find(&t, "r4"), 2);
    assert_true(t.list[region_find(&t, "r28")].p[0] == 28);
    free(t.list);
}

static void test_contains(void **state) {
    (void)state;
    assert_true(region_contains(&block, (double[]){0, 1, 5.2}));
    assert_true(region_contains(&block, (double[]){-1, 4, 5})); /* the surface belongs to it */
    assert_false(region_contains(&block, (double[]){0, 1, 5.6}));
    assert_false(region_contains(&block, (double[]){2.1, 1, 5.2}));
    assert_false(region_contains(&block, (double[]){0, -0.1, 5.2}));
    assert_true(region_contains(&sphere, (double[]){1, -2, 5}));
    assert_true(region_contains(&sphere, (double[]){2.1, -3.1, 4.1}));
    assert_false(region_contains(&sphere, (double[]){2.2, -3.2, 4.2}));
    /* the two coordinates of the axis stand in the order of x y z */
    assert_true(region_contains(&along[0], (double[]){5, 2.9, -2}));
    assert_false(region_contains(&along[0], (double[]){5, -1.1, -2}));
    assert_true(region_contains(&along[1], (double[]){1, 4, -4}));
    assert_false(region_contains(&along[1], (double[]){1, 3.9, -2}));
    assert_true(region_contains(&along[2], (double[]){1, -2, 7}));
    assert_false(region_contains(&along[2], (double[]){2.5, -0.5, 5}));
    /* the normal points into the region */
    assert_true(region_contains(&plane, (double[]){0, 5, 1}));
    assert_true(region_contains(&plane, (double[]){0.8, -5, 0.41}));
    assert_false(region_contains(&plane, (double[]){0.8, 0, 0.39}));
}

/* Inside and complement share no point and leave none out. */
static void test_complement(void **state) {
    (void)state;
    srand(3);
    const region *both[] = {&block, &sphere, &along[0], &along[1], &along[2], &plane};
    for (int k = 0; k < 6; k++) {
        region out = *both[k];
        out.outside = true;
        for (int i = 0; i < DRAWS; i++) {
            double x[3];
            for (int j = 0; j < 3; j++)
                x[j] = -8 + 16.0 * rand() / RAND_MAX;
            assert_true(region_contains(both[k], x) != region_contains(&out, x));
        }
        assert_non_null(region_unbounded(&out));
    }
}

static void test_infinite(void **state) {
    (void)state;
    const region half = {.kind = REGION_BLOCK, .p = {-INFINITY, INFINITY, -INFINITY, INFINITY, 0, INFINITY}};
    assert_true(region_contains(&half, (double[]){1e30, -1e30, 0}));
    assert_false(region_contains(&half, (double[]){0, 0, -1e-9}));
    const region slab = {.kind = REGION_BLOCK, .p = {0, 1, 0, 1, -INFINITY, 0}};
    const region tube = {.kind = REGION_CYLINDER, .axis = 1, .p = {0, 0, 1, 0, INFINITY}};
    assert_string_equal(region_unbounded(&half), "it has no end along x");
    assert_string_equal(region_unbounded(&slab), "it has no end along z");
    assert_string_equal(region_unbounded(&tube), "it has no end along y");
    assert_string_equal(region_unbounded(&plane), "it is half of space");
    assert_null(region_unbounded(&block));
    assert_null(region_unbounded(&along[1]));
}

/* Draws are inside and uniform: means and variances of each coordinate, five standard errors wide, and no lean
 * between coordinates. */
static void check_uniform(const region *r, const double mean[3], const double variance[3]) {
    rng *source = rng_create(12);
    double sum[3] = {0}, square[3] = {0}, product[3] = {0};
    for (uint64_t id = 1; id <= DRAWS; id++) {
        double x[3];
        region_draw(r, rng_stream(source, RNG_CREATE, id, 0), x);
        assert_true(region_contains(r, x));
        for (int k = 0; k < 3; k++) {
            double d = x[k] - mean[k], e = x[(k + 1) % 3] - mean[(k + 1) % 3];
            sum[k] += d;
            square[k] += d * d;
            product[k] += d * e;
        }
    }
    rng_free(source);
    for (int k = 0; k < 3; k++) {
        assert_near(sum[k] / DRAWS, 0, 5 * sqrt(variance[k] / DRAWS));
        assert_near(square[k] / DRAWS, variance[k], 5 * variance[k] * sqrt(1.5 / DRAWS));
        assert_near(product[k] / DRAWS, 0, 5 * sqrt(variance[k] * variance[(k + 1) % 3] / DRAWS));
    }
}

static void test_draws(void **state) {
    (void)state;
    check_uniform(&block, (double[]){0.5, 2, 5.25}, (double[]){9 / 12.0, 16 / 12.0, 0.25 / 12});
    check_uniform(&sphere, (double[]){1, -2, 3}, (double[]){0.8, 0.8, 0.8});  /* R^2 / 5 */
    check_uniform(&along[0], (double[]){5.5, 1, -2}, (double[]){0.75, 1, 1}); /* 3^2 / 12; R^2 / 4 */
    check_uniform(&along[1], (double[]){1, 5.5, -2}, (double[]){1, 0.75, 1});
    check_uniform(&along[2], (double[]){1, -2, 5.5}, (double[]){1, 1, 0.75});
}

/* A third of an even ball's points lie beyond (2/3)^(1/3) of its radius. */
static void test_radius_of_draws(void **state) {
    (void)state;
    rng *source = rng_create(13);
    int beyond = 0;
    for (uint64_t id = 1; id <= DRAWS; id++) {
        double x[3];
        region_draw(&sphere, rng_stream(source, RNG_CREATE, id, 0), x);
        beyond += hypot(hypot(x[0] - 1, x[1] + 2), x[2] - 3) > 2 * cbrt(2.0 / 3);
    }
    rng_free(source);
    assert_near(beyond, DRAWS / 3.0, 5 * sqrt(DRAWS * 2.0 / 9));
}

/* A flat block and a disc are even too. */
static void test_flat(void **state) {
    (void)state;
    const region sheet = {.kind = REGION_BLOCK, .p = {0, 4, 0, 2, 3, 3}};
    const region disc = {.kind = REGION_CYLINDER, .axis = 2, .p = {0, 0, 2, 1, 1}};
    rng *source = rng_create(14);
    double x[3], sum = 0, square = 0;
    for (uint64_t id = 1; id <= DRAWS; id++) {
        region_draw(&sheet, rng_stream(source, RNG_CREATE, id, 0), x);
        assert_true(x[2] == 3 && region_contains(&sheet, x));
        sum += x[0];
        region_draw(&disc, rng_stream(source, RNG_CREATE, id, 1), x);
        assert_true(x[2] == 1 && region_contains(&disc, x));
        square += x[0] * x[0] + x[1] * x[1];
    }
    rng_free(source);
    assert_near(sum / DRAWS, 2, 5 * sqrt(16 / 12.0 / DRAWS));
    assert_near(square / DRAWS, 2, 5 * sqrt(16 / 12.0 / DRAWS)); /* R^2 / 2, and R^4 / 12 */
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_table),    cmocka_unit_test(test_contains), cmocka_unit_test(test_complement),
        cmocka_unit_test(test_infinite), cmocka_unit_test(test_draws),    cmocka_unit_test(test_radius_of_draws),
        cmocka_unit_test(test_flat),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}

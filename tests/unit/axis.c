/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Distances between axes: known positions, and against a search over the segments. */
#include "check.h"

#include "model/axis.h"

#include <stdlib.h>
#include <string.h>

static double between(double low, double high) {
    return low + (high - low) * ((double)rand() / RAND_MAX);
}

static double gap(const double a0[3], const double a1[3], double s, const double b0[3], const double b1[3], double t) {
    double square = 0;
    for (int i = 0; i < 3; i++) {
        double d = a0[i] + s * (a1[i] - a0[i]) - b0[i] - t * (b1[i] - b0[i]);
        square += d * d;
    }
    return sqrt(square);
}

static void test_known(void **state) {
    (void)state;
    const double o[3] = {0, 0, 0}, x[3] = {4, 0, 0}, y0[3] = {1, -1, 3}, y1[3] = {1, 5, 3}, far0[3] = {7, 0, 0},
                 far1[3] = {9, 0, 0}, side0[3] = {1, 2, 0}, side1[3] = {3, 2, 0}, cross0[3] = {2, -1, 0},
                 cross1[3] = {2, 1, 0}, inside[3] = {2, 0, 0};
    assert_near(axis_segment_distance(o, x, y0, y1), 3, 1e-15);         /* skew, both inner */
    assert_near(axis_segment_distance(o, x, far0, far1), 3, 1e-15);     /* collinear, apart */
    assert_near(axis_segment_distance(o, x, inside, far0), 0, 1e-15);   /* collinear, one in the other */
    assert_near(axis_segment_distance(o, x, side0, side1), 2, 1e-15);   /* parallel */
    assert_near(axis_segment_distance(o, x, cross0, cross1), 0, 1e-15); /* crossing */
    assert_near(axis_segment_distance(o, o, side0, side0), sqrt(5), 1e-15);
    assert_near(axis_segment_distance(o, x, side0, side0), 2, 1e-15);
    assert_near(axis_point_distance(y0, o, x), sqrt(10), 1e-15);
    assert_near(axis_point_distance(far1, o, x), 5, 1e-15);
    assert_near(axis_point_distance(far1, o, o), 9, 1e-15);
}

/* No pair of points is nearer, and by alternating projections (convex, so to the minimum) none is needed farther. */
static void test_against_search(void **state) {
    (void)state;
    srand(4);
    for (int trial = 0; trial < 4000; trial++) {
        double a[2][3], b[2][3];
        for (int i = 0; i < 3; i++) {
            a[0][i] = between(-3, 3);
            a[1][i] = between(-3, 3);
            b[0][i] = between(-3, 3);
            /* every third pair nearly parallel */
            b[1][i] = trial % 3 ? between(-3, 3) : b[0][i] + (a[1][i] - a[0][i]) * 0.7 + between(-1e-6, 1e-6);
        }
        double distance = axis_segment_distance(a[0], a[1], b[0], b[1]);
        assert_near(axis_segment_distance(b[1], b[0], a[0], a[1]), distance, 1e-9);
        double least = INFINITY;
        for (int i = 0; i <= 40; i++)
            for (int j = 0; j <= 40; j++)
                least = fmin(least, gap(a[0], a[1], i / 40.0, b[0], b[1], j / 40.0));
        assert_true(distance <= least + 1e-12);
        /* a grid of spacing h misses the least distance by no more than h of each segment */
        double la = gap(a[0], a[1], 1, a[0], a[1], 0), lb = gap(b[0], b[1], 1, b[0], b[1], 0);
        assert_true(distance >= least - (la + lb) / 80);
    }
}

/* Cells: a coccus is a segment of length zero, a chain several segments. */
static void test_cells(void **state) {
    (void)state;
    colony *c = colony_create();
    const double rod[6] = {0, 0, 0, 4, 0, 0}, coccus[3] = {2, 3, 0}, chain[9] = {-5, 6, 1, 2, 6, 1, 2, 9, 1};
    uint32_t r = colony_add_cell(c, 2, rod), k = colony_add_cell(c, 1, coccus), h = colony_add_cell(c, 3, chain);
    assert_near(axis_cell_distance(c, r, k), 3, 1e-15);
    assert_near(axis_cell_distance(c, k, r), 3, 1e-15);
    assert_near(axis_cell_distance(c, k, h), sqrt(10), 1e-14);
    assert_near(axis_cell_distance(c, r, h), sqrt(37), 1e-14);
    assert_near(axis_cell_point_distance(c, h, (double[]){3, 8, 1}), 1, 1e-15);
    assert_near(axis_cell_point_distance(c, k, coccus), 0, 0);
    colony_free(c);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_known),
        cmocka_unit_test(test_against_search),
        cmocka_unit_test(test_cells),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}

/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Measures of the colony's form against what geometry says: lattices, rings, known ellipses, pairs at known angles. */
#include "check.h"

#include "analysis/component.h"
#include "analysis/ellipse.h"
#include "analysis/extent.h"
#include "analysis/orientation.h"
#include "analysis/plane.h"
#include "analysis/state.h"
#include "analysis/value.h"

#include <gsl/gsl_rng.h>
#include <stdlib.h>
#include <string.h>

/* A rod of length l between its particles, at a centre, along (cos a, sin a, 0); returns its id. */
static uint64_t add_rod(colony *c, double x, double y, double z, double a, double l) {
    double dx = 0.5 * l * cos(a), dy = 0.5 * l * sin(a);
    const double p[6] = {x - dx, y - dy, z, x + dx, y + dy, z};
    uint32_t row = colony_add_cell(c, 2, p);
    return c->cell.id[row];
}

static uint64_t add_coccus(colony *c, double x, double y, double z) {
    const double p[3] = {x, y, z};
    uint32_t row = colony_add_cell(c, 1, p);
    return c->cell.id[row];
}

static void add_link(colony *c, link_kind kind, uint64_t a, uint64_t b) {
    colony_add_link(c, kind, a, b, 0);
}

static double measure(int (*function)(const view *, const bool *, double *, diag *), colony *c, const bool *members) {
    double out[17];
    const view v = {.colony = c};
    assert_int_equal(function(&v, members, out, NULL), SARCINA_OK);
    return out[0];
}

/* The rows in reverse order: ids stay. */
static void reverse(colony *c) {
    uint32_t *rows = malloc(c->cell.count * sizeof *rows);
    for (uint32_t i = 0; i < c->cell.count; i++)
        rows[i] = (uint32_t)c->cell.count - 1 - i;
    colony_arrange(c, rows, c->cell.count);
    free(rows);
}

static void scatter(colony *c, int n, unsigned long seed) {
    gsl_rng *r = gsl_rng_alloc(gsl_rng_mt19937);
    gsl_rng_set(r, seed);
    for (int i = 0; i < n; i++) {
        double x = 30 * gsl_rng_uniform(r), y = 20 * gsl_rng_uniform(r), z = 3 * gsl_rng_uniform(r);
        add_rod(c, x, y, z, 2 * M_PI * gsl_rng_uniform(r), 2 + gsl_rng_uniform(r));
    }
    gsl_rng_free(r);
}

static void test_orientation_of_pairs(void **state) {
    (void)state;
    for (int degrees = 0; degrees <= 180; degrees += 15) {
        colony *c = colony_create();
        add_rod(c, 0, 0, 0, 0.3, 2);
        add_rod(c, 9, 1, 0, 0.3 + degrees * M_PI / 180, 3);
        assert_near(measure(orientation_measure, c, NULL), cos(2 * degrees * M_PI / 180), 4e-15);
        colony_free(c);
    }
}

static void test_orientation_of_fans(void **state) {
    (void)state;
    colony *c = colony_create();
    assert_true(isnan(measure(orientation_measure, c, NULL)));
    add_rod(c, 0, 0, 0, 0, 2);
    assert_true(isnan(measure(orientation_measure, c, NULL)));
    /* n axes spread evenly over half a turn: sum over all pairs j != k of cos 2(a_j - a_k) is -n */
    for (int i = 1; i < 12; i++)
        add_rod(c, i, 0, 0, i * M_PI / 12, 2);
    assert_near(measure(orientation_measure, c, NULL), -1.0 / 11, 1e-15);
    /* cocci have no axis and do not count */
    for (int i = 0; i < 5; i++)
        add_coccus(c, i, 9, 0);
    assert_near(measure(orientation_measure, c, NULL), -1.0 / 11, 1e-15);
    colony_free(c);

    /* three axes at right angles in space: every pair gives -1 */
    c = colony_create();
    const double axes[3][6] = {{0, 0, 0, 1, 0, 0}, {0, 0, 0, 0, 2, 0}, {0, 0, 0, 0, 0, 3}};
    for (int i = 0; i < 3; i++)
        colony_add_cell(c, 2, axes[i]);
    assert_near(measure(orientation_measure, c, NULL), -1, 1e-15);
    colony_free(c);
}

/* The one-pass form against the sum over pairs that defines it. */
static void test_orientation_is_the_mean_over_pairs(void **state) {
    (void)state;
    colony *c = colony_create();
    scatter(c, 60, 3);
    double sum = 0;
    for (uint32_t j = 0; j < 60; j++)
        for (uint32_t k = j + 1; k < 60; k++) {
            double u[3], w[3];
            colony_axis(c, j, u);
            colony_axis(c, k, w);
            double cosine = u[0] * w[0] + u[1] * w[1] + u[2] * w[2];
            sum += 2 * cosine * cosine - 1;
        }
    assert_near(measure(orientation_measure, c, NULL), sum / (60 * 59 / 2.0), 1e-14);
    colony_free(c);
}

static void test_extent(void **state) {
    (void)state;
    colony *c = colony_create();
    assert_true(isnan(measure(extent_thickness, c, NULL)));
    assert_true(isnan(measure(extent_gyration, c, NULL)));
    for (int i = 0; i < 12; i++) /* a ring of radius 5 */
        add_coccus(c, 7 + 5 * cos(i * M_PI / 6), -3 + 5 * sin(i * M_PI / 6), 0.5);
    assert_near(measure(extent_gyration, c, NULL), 5, 1e-14);
    assert_near(measure(extent_thickness, c, NULL), 0.5, 0);
    const double leaning[6] = {0, 0, 1, 0, 0, 2.5}; /* the higher particle counts, not the centre */
    colony_add_cell(c, 2, leaning);
    assert_near(measure(extent_thickness, c, NULL), 2.5, 0);
    bool members[13] = {false};
    members[0] = members[3] = true;
    assert_near(measure(extent_thickness, c, members), 0.5, 0);
    assert_near(measure(extent_gyration, c, members), 2.5 * sqrt(2), 1e-14);
    colony_free(c);
}

static void test_hull(void **state) {
    (void)state;
    colony *c = colony_create();
    assert_true(isnan(measure(plane_hull_measure, c, NULL)));
    for (int i = 0; i < 5; i++)
        for (int j = 0; j < 4; j++)
            add_coccus(c, i, 2 * j, i * j);
    assert_near(measure(plane_hull_measure, c, NULL), 4 * 6, 1e-14);
    add_rod(c, 2, 9, 0, 0, 0); /* twice the same point: a roof 3 high over the 4 wide lattice */
    assert_near(measure(plane_hull_measure, c, NULL), 4 * 6 + 0.5 * 4 * 3, 1e-14);
    point2 line[5] = {{0, 0}, {1, 1}, {2, 2}, {2, 2}, {4, 4}}, hull[6];
    assert_int_equal(plane_hull(line, 5, hull), 2);
    point2 same[3] = {{1, 2}, {1, 2}, {1, 2}};
    assert_int_equal(plane_hull(same, 3, hull), 1);
    colony_free(c);
}

/* Corners of a regular n-gon on the ellipse with half-axes a >= b, turned by `turn`. */
static size_t polygon(point2 *p, size_t n, double a, double b, double turn) {
    for (size_t i = 0; i < n; i++) {
        double t = 2 * M_PI * (double)i / (double)n + 0.1, x = a * cos(t), y = b * sin(t);
        p[i] = (point2){3 + x * cos(turn) - y * sin(turn), -1 + x * sin(turn) + y * cos(turn)};
    }
    return n;
}

/* Smallest ellipses are carried along by affine maps, and a regular polygon's is its circle. */
static void test_ellipse_around_images_of_regular_polygons(void **state) {
    (void)state;
    const double axes[][2] = {{1, 1}, {2, 1}, {10, 0.5}, {300, 0.001}};
    for (size_t k = 0; k < 4; k++)
        for (size_t n = 3; n <= 40; n += 1 + n / 8) {
            point2 p[40];
            double a = axes[k][0], b = axes[k][1];
            ellipse e = ellipse_around(p, polygon(p, n, a, b, 0.4));
            double rounding = 1e-15 * a / b; /* of the coordinates, seen across the thin side */
            assert_near(e.area / (M_PI * a * b), 1, 1e-9 + 10 * rounding);
            assert_near(e.major / (2 * a), 1, 1e-8 + 10 * rounding);
            assert_near(e.minor / (2 * b), 1, 1e-8 + 10 * rounding);
            assert_near(e.centre.x, 3, 1e-8 * a);
            assert_near(e.centre.y, -1, 1e-8 * a);
            if (a > b)
                assert_near(e.angle, 0.4, 1e-7);
        }
}

/* A square with a point far off: by symmetry the ellipse is found in one unknown, here by search over its centre. */
static double kite_area(double tip) {
    double least = INFINITY;
    for (int i = 1; i < 4000000; i++) { /* (x - m)^2/a^2 + y^2/b^2 = 1 through (tip, 0) and (0, +-1) */
        double m = tip * i / 4e6, a = tip - m, b2 = a * a / (a * a - m * m);
        if (a > m && 1 + m <= a) /* (-1, 0) inside */
            least = fmin(least, M_PI * a * sqrt(b2));
    }
    return least;
}

static void test_ellipse_with_corners_that_do_not_touch(void **state) {
    (void)state;
    point2 p[4] = {{-1, 0}, {0, -1}, {0, 1}, {6, 0}};
    ellipse e = ellipse_around(p, 4);
    assert_near(e.area / kite_area(6), 1, 1e-9);
    assert_near(e.angle, 0, 1e-12);
}

/* Every point inside, at least three and at most five (in general position) on the boundary. */
static void test_ellipse_encloses(void **state) {
    (void)state;
    colony *c = colony_create();
    scatter(c, 200, 11);
    size_t n;
    const view v = {.colony = c};
    point2 *p = plane_points(&v, NULL, &n), *hull = malloc((n + 1) * sizeof *hull);
    ellipse e = ellipse_around(hull, plane_hull(p, n, hull));
    size_t touching = 0;
    for (size_t i = 0; i < n; i++) {
        double x = p[i].x - e.centre.x, y = p[i].y - e.centre.y;
        double along = (x * cos(e.angle) + y * sin(e.angle)) / (0.5 * e.major);
        double across = (y * cos(e.angle) - x * sin(e.angle)) / (0.5 * e.minor);
        assert_true(along * along + across * across <= 1 + 1e-12);
        touching += along * along + across * across > 1 - 1e-8;
    }
    assert_true(touching >= 3 && touching <= 5);
    assert_near(e.area, M_PI / 4 * e.major * e.minor, 1e-12 * e.area);
    assert_true(plane_area(hull, plane_hull(p, n, hull)) < e.area);
    assert_near(measure(ellipse_measure, c, NULL), e.area, 1e-9 * e.area);
    free(p);
    free(hull);
    colony_free(c);
}

static void test_ellipse_of_a_line(void **state) {
    (void)state;
    colony *c = colony_create();
    assert_true(isnan(measure(ellipse_measure, c, NULL)));
    add_rod(c, 1, 2, 0, M_PI / 6, 3);
    double out[5];
    const view v = {.colony = c};
    ellipse_measure(&v, NULL, out, NULL);
    assert_near(out[0], 0, 0);
    assert_near(out[2], 3, 1e-15);
    assert_near(out[3], 0, 0);
    assert_near(out[4], M_PI / 6, 1e-15);
    add_coccus(c, 1 + 4 * cos(M_PI / 6), 2 + 4 * sin(M_PI / 6), 0);
    ellipse_measure(&v, NULL, out, NULL);
    assert_near(out[0], 0, 1e-6);
    assert_near(out[2], 5.5, 1e-9);
    colony_free(c);
}

static void test_components(void **state) {
    (void)state;
    colony *c = colony_create();
    uint64_t id[9];
    for (int i = 0; i < 9; i++)
        id[i] = add_rod(c, 4 * i, 0, 0, 0, 2);
    double out[1 + VALUE_FIELDS_MAX];
    const view v = {.colony = c};
    component_filaments(&v, NULL, out, NULL);
    assert_near(out[0], 0, 0);
    assert_true(isnan(out[2]));

    /* a chain of four, a ring of three, one stuck to the ring, one alone and anchored */
    for (int i = 0; i < 3; i++)
        add_link(c, LINK_FILIAL, id[3 - i], id[2 - i]);
    add_link(c, LINK_FILIAL, id[4], id[5]);
    add_link(c, LINK_FILIAL, id[5], id[6]);
    add_link(c, LINK_FILIAL, id[6], id[4]);
    add_link(c, LINK_STICK, id[7], id[5]);
    add_link(c, LINK_ANCHOR, id[8], 0);
    for (int turn = 0; turn < 2; turn++) {
        component_clusters(&v, NULL, out, NULL);
        assert_near(out[0], 3, 0);
        assert_near(out[1], 4, 0);
        assert_near(out[2], 3, 0);
        component_filaments(&v, NULL, out, NULL);
        assert_near(out[0], 2, 0);
        assert_near(out[1], 4, 0);
        assert_near(out[2], 3.5, 0);
        assert_near(out[3], 2, 0);
        uint32_t root[9];
        component_roots(c, COMPONENT_ANY_LINK, NULL, root);
        assert_int_equal(c->cell.id[root[colony_row(c, id[7])]], id[4]);
        assert_int_equal(c->cell.id[root[colony_row(c, id[8])]], id[8]);
        reverse(c);
    }
    /* without the chain's second cell two pieces are left, one of them a filament */
    bool members[9] = {true, false, true, true};
    component_clusters(&v, members, out, NULL);
    assert_near(out[0], 2, 0);
    component_filaments(&v, members, out, NULL);
    assert_near(out[0], 1, 0);
    assert_near(out[1], 2, 0);
    colony_free(c);
}

static void test_counts(void **state) {
    (void)state;
    colony *c = colony_create();
    uint64_t a = add_rod(c, 0, 0, 0, 0, 2), b = add_rod(c, 4, 0, 0, 0, 2), s = add_coccus(c, 8, 0, 0);
    add_link(c, LINK_FILIAL, a, b);
    add_link(c, LINK_STICK, b, s);
    add_link(c, LINK_ANCHOR, a, 0);
    const view v = {.colony = c, .links_formed = 5, .links_broken = 2};
    const bool members[3] = {true, true, false};
    double out[9];
    state_links(&v, NULL, out, NULL);
    const double all[9] = {3, 2, 0, 0, 1, 1, 1, 5, 2}, two[9] = {2, 2, 0, 0, 1, 0, 1, 5, 2};
    assert_memory_equal(out, all, sizeof all);
    state_links(&v, members, out, NULL);
    assert_memory_equal(out, two, sizeof two);
    assert_near(measure(state_cells, c, NULL), 3, 0);
    assert_near(measure(state_cells, c, members), 2, 0);
    assert_near(measure(state_particles, c, NULL), 5, 0);
    assert_near(measure(state_particles, c, members), 4, 0);
    colony_free(c);
}

/* Same bits whatever the order of rows. */
static void test_no_measure_depends_on_the_order_of_rows(void **state) {
    (void)state;
    int (*const functions[])(const view *, const bool *, double *, diag *) = {
        orientation_measure, extent_thickness, extent_gyration, plane_hull_measure, ellipse_measure};
    colony *c = colony_create();
    scatter(c, 101, 5);
    for (size_t i = 0; i < sizeof functions / sizeof *functions; i++) {
        double before = measure(functions[i], c, NULL);
        reverse(c);
        double after = measure(functions[i], c, NULL);
        assert_memory_equal(&before, &after, sizeof before);
    }
    colony_free(c);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_orientation_of_pairs),
        cmocka_unit_test(test_orientation_of_fans),
        cmocka_unit_test(test_orientation_is_the_mean_over_pairs),
        cmocka_unit_test(test_extent),
        cmocka_unit_test(test_hull),
        cmocka_unit_test(test_ellipse_around_images_of_regular_polygons),
        cmocka_unit_test(test_ellipse_with_corners_that_do_not_touch),
        cmocka_unit_test(test_ellipse_encloses),
        cmocka_unit_test(test_ellipse_of_a_line),
        cmocka_unit_test(test_components),
        cmocka_unit_test(test_counts),
        cmocka_unit_test(test_no_measure_depends_on_the_order_of_rows),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}

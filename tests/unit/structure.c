/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Measures of a floc's or colony's structure on scenes whose answers geometry gives. */
#include "check.h"

#include "analysis/bridging.h"
#include "analysis/cell.h"
#include "analysis/defects.h"
#include "analysis/outline.h"
#include "analysis/solid.h"
#include "analysis/texture.h"
#include "analysis/view_cache.h"
#include "model/shape.h"

#include <stdlib.h>
#include <string.h>

typedef struct fixture {
    colony *c;
    species_table species;
    species one;
    view_cache *cache;
    double out[17];
} fixture;

static void begin(fixture *f) {
    *f = (fixture){.c = colony_create(), .cache = view_cache_create()};
    f->one.density = 1;
    f->species = (species_table){.list = &f->one, .count = 1};
}

static void end(fixture *f) {
    view_cache_free(f->cache);
    colony_free(f->c);
}

/* A cell of diameter 1: a coccus, or a rod from a to b. */
static uint32_t add(fixture *f, const double *a, const double *b) {
    double p[6], rest = 0;
    memcpy(p, a, 3 * sizeof *p);
    if (b) {
        memcpy(p + 3, b, 3 * sizeof *p);
        rest = sqrt(pow(b[0] - a[0], 2) + pow(b[1] - a[1], 2) + pow(b[2] - a[2], 2));
    }
    uint32_t row = colony_add_cell(f->c, b ? 2 : 1, p);
    f->c->cell.diameter[row] = 1;
    f->c->cell.rest[row] = rest;
    f->c->cell.mass[row] = b ? shape_rod_mass(rest, 1, 1) : shape_coccus_mass(1, 1);
    return row;
}

static uint32_t add_coccus(fixture *f, double x, double y, double z) {
    const double p[3] = {x, y, z};
    return add(f, p, NULL);
}

/* A rod of length l between its particles at an angle in the plane. */
static uint32_t add_flat(fixture *f, double x, double y, double angle, double l) {
    const double a[3] = {x - 0.5 * l * cos(angle), y - 0.5 * l * sin(angle), 0};
    const double b[3] = {x + 0.5 * l * cos(angle), y + 0.5 * l * sin(angle), 0};
    return add(f, a, b);
}

static double *measure(fixture *f, int (*function)(const view *, const bool *, double *, diag *), const bool *members) {
    const view v = {.colony = f->c, .species = &f->species, .cache = f->cache};
    view_cache_reset(f->cache);
    memset(f->out, 0, sizeof f->out);
    assert_int_equal(function(&v, members, f->out, NULL), SARCINA_OK);
    return f->out;
}

/* ---- the hull in space ---- */

static void test_hull_of_a_cube(void **state) {
    (void)state;
    double corners[9 * 3];
    for (int i = 0; i < 8; i++)
        for (int k = 0; k < 3; k++)
            corners[3 * i + k] = i >> k & 1 ? 2 : 0;
    corners[24] = corners[25] = corners[26] = 1; /* and one inside */
    solid_body b = solid_hull(corners, 9);
    assert_near(b.volume, 8, 1e-12);
    assert_near(b.surface, 24, 1e-12);
    assert_near(b.curvature, 0.5 * 12 * 2 * M_PI / 2, 1e-12); /* 12 edges of length 2, each a right angle */
}

static void test_hull_of_a_tetrahedron(void **state) {
    (void)state;
    const double p[12] = {1, 1, 1, 1, -1, -1, -1, 1, -1, -1, -1, 1};
    solid_body b = solid_hull(p, 4);
    double edge = 2 * sqrt(2);
    assert_near(b.volume, pow(edge, 3) / (6 * sqrt(2)), 1e-12);
    assert_near(b.surface, sqrt(3) * edge * edge, 1e-12);
    assert_near(b.curvature, 0.5 * 6 * edge * (M_PI - acos(1.0 / 3)), 1e-12);
}

static void test_flat_hulls(void **state) {
    (void)state;
    const double square[15] = {0, 0, 5, 3, 0, 5, 3, 3, 5, 0, 3, 5, 1, 1, 5};
    solid_body b = solid_hull(square, 5);
    assert_near(b.volume, 0, 0);
    assert_near(b.surface, 18, 1e-12);
    assert_near(b.curvature, 6 * M_PI, 1e-12);
    const double line[9] = {0, 0, 0, 1, 2, 2, 2, 4, 4};
    b = solid_hull(line, 3);
    assert_near(b.surface, 0, 1e-12);
    assert_near(b.curvature, 6 * M_PI, 1e-12);
    b = solid_hull(line, 1);
    assert_near(solid_grown_volume(&b, 2), 4 * M_PI / 3 * 8, 1e-12);
}

static void test_compactness(void **state) {
    (void)state;
    fixture f;
    begin(&f);
    assert_true(isnan(measure(&f, solid_compactness, NULL)[0]));
    add_coccus(&f, 1, 2, 3);
    assert_near(measure(&f, solid_compactness, NULL)[0], 1, 1e-12);
    add_coccus(&f, 1, 2, 13); /* two balls 10 apart: a capsule around them */
    double capsule = M_PI / 4 * 10 + M_PI / 6;
    assert_near(measure(&f, solid_compactness, NULL)[0], 2 * M_PI / 6 / capsule, 1e-12);
    assert_near(f.out[1], capsule, 1e-11);
    const bool second[] = {false, true};
    assert_near(measure(&f, solid_compactness, second)[0], 1, 1e-12);
    end(&f);
    begin(&f);
    add_flat(&f, 3, 4, 0.7, 5);
    assert_near(measure(&f, solid_compactness, NULL)[0], 1, 1e-12);
    end(&f);
}

/* A cubic lattice of touching balls: pi/6 of space but for the rim. */
static void test_compactness_of_a_lattice(void **state) {
    (void)state;
    fixture f;
    begin(&f);
    int n = 12;
    for (int i = 0; i < n * n * n; i++)
        add_coccus(&f, i % n, i / n % n, (double)(i / n / n));
    double a = n - 1, hull = a * a * a + 0.5 * 6 * a * a + 0.25 * 3 * M_PI * a + M_PI / 6;
    assert_near(measure(&f, solid_compactness, NULL)[1], hull, 1e-9 * hull);
    assert_near(f.out[0], n * n * n * M_PI / 6 / hull, 1e-9);
    end(&f);
}

/* ---- the outline ---- */

static void test_outline_of_discs(void **state) {
    (void)state;
    fixture f;
    begin(&f);
    assert_true(isnan(measure(&f, outline_measure, NULL)[0]));
    add_coccus(&f, 0.3, 0.1, 0); /* a disc of radius 1/2, grown by 1/2 */
    measure(&f, outline_measure, NULL);
    assert_near(f.out[0], 1, 0.003);
    assert_near(f.out[1], M_PI, 0.01 * M_PI);
    assert_near(f.out[2], 2 * M_PI, 0.005 * 2 * M_PI);
    assert_near(f.out[4], 0, 0.005);
    add_coccus(&f, 20.3, 0.1, 7); /* two discs: area and perimeter double */
    measure(&f, outline_measure, NULL);
    assert_near(f.out[0], 0.5, 0.002);
    assert_near(f.out[1], 2 * M_PI, 0.02 * M_PI);
    end(&f);
}

static void test_outline_of_a_rod(void **state) {
    (void)state;
    fixture f;
    begin(&f);
    add_flat(&f, 1, 1, 0.4, 10);
    measure(&f, outline_measure, NULL);
    double area = M_PI + 2 * 10, perimeter = 2 * M_PI + 20;
    assert_near(f.out[1], area, 0.005 * area);
    assert_near(f.out[2], perimeter, 0.005 * perimeter);
    assert_near(f.out[3], 4 * M_PI * area / (perimeter * perimeter), 0.01);
    end(&f);
}

/* A ring of cells has one outline: its hole does not count. */
static void test_outline_of_a_ring(void **state) {
    (void)state;
    fixture f;
    begin(&f);
    for (int i = 0; i < 2000; i++)
        add_coccus(&f, 30 * cos(i * M_PI / 1000), 30 * sin(i * M_PI / 1000), 0);
    measure(&f, outline_measure, NULL);
    assert_near(f.out[1], M_PI * 31 * 31, 0.01 * M_PI * 31 * 31);
    assert_near(f.out[0], 1, 0.01);
    assert_near(f.out[4], 0, 0.005);
    end(&f);
}

/* A filled square of side a, grown with round corners; and a star is rougher than a disc. */
static void test_outline_of_shapes(void **state) {
    (void)state;
    fixture f;
    begin(&f);
    for (int i = 0; i < 900; i++)
        add_coccus(&f, i % 30, i / 30, 0); /* a = 29, grown by 1 */
    measure(&f, outline_measure, NULL);
    double area = 29 * 29 + 4 * 29 + M_PI, perimeter = 4 * 29 + 2 * M_PI;
    assert_near(f.out[1], area, 0.01 * area);
    assert_near(f.out[2], perimeter, 0.05 * perimeter); /* the rim of touching discs is scalloped */
    end(&f);
    begin(&f);
    for (int i = 0; i < 5; i++)
        add_flat(&f, 10 * cos(i * 0.4 * M_PI), 10 * sin(i * 0.4 * M_PI), i * 0.4 * M_PI, 20);
    measure(&f, outline_measure, NULL);
    assert_true(f.out[0] < 0.15);
    assert_true(f.out[4] > 0.4);
    end(&f);
}

/* Order of rows and place in the plane change nothing but by the grid's resolution. */
static void test_outline_moves(void **state) {
    (void)state;
    fixture f;
    begin(&f);
    for (int i = 0; i < 40; i++)
        add_flat(&f, 1e3 + 3 * cos(i * 2.4) * sqrt(i), 7 + 3 * sin(i * 2.4) * sqrt(i), i * 0.7, 2);
    double before = measure(&f, outline_measure, NULL)[0];
    for (size_t i = 0; i < 3 * f.c->particle.count; i++)
        f.c->particle.x[i] += i % 3 == 2 ? 0 : 0.037;
    assert_near(measure(&f, outline_measure, NULL)[0], before, 0.01);
    uint32_t rows[40];
    for (uint32_t i = 0; i < 40; i++)
        rows[i] = 39 - i;
    double moved = f.out[0];
    colony_arrange(f.c, rows, 40);
    assert_near(measure(&f, outline_measure, NULL)[0], moved, 0);
    end(&f);
}

/* ---- texture ---- */

static void test_fractal_dimensions(void **state) {
    (void)state;
    fixture f;
    begin(&f);
    for (int i = 0; i < 60; i++)
        add_coccus(&f, i, 0.5 * i, 2);
    assert_near(measure(&f, texture_fractal, NULL)[0], 1, 0.05);
    end(&f);
    begin(&f);
    for (int i = -40; i <= 40; i++)
        for (int j = -40; j <= 40; j++)
            if (i * i + j * j <= 1600)
                add_coccus(&f, i, j, 0);
    assert_near(measure(&f, texture_fractal, NULL)[0], 2, 0.05);
    end(&f);
    begin(&f);
    for (int i = -14; i <= 14; i++)
        for (int j = -14; j <= 14; j++)
            for (int k = -14; k <= 14; k++)
                if (i * i + j * j + k * k <= 196)
                    add_coccus(&f, i, j, k);
    assert_near(measure(&f, texture_fractal, NULL)[0], 3, 0.1);
    end(&f);
    begin(&f);
    add_coccus(&f, 0, 0, 0); /* too small to scale */
    assert_true(isnan(measure(&f, texture_fractal, NULL)[0]));
    end(&f);
}

static void test_verticalised(void **state) {
    (void)state;
    fixture f;
    begin(&f);
    assert_true(isnan(measure(&f, texture_verticalised, NULL)[0]));
    for (int i = 0; i < 90; i++) { /* tilts of 0.5, 1.5 ... 89.5 degrees */
        double t = (i + 0.5) * M_PI / 180;
        const double a[3] = {0, 3.0 * i, 0}, b[3] = {2 * cos(t), 3.0 * i, i % 2 ? 2 * sin(t) : -2 * sin(t)};
        add(&f, a, b);
    }
    add_coccus(&f, 0, -3, 0); /* has no axis */
    assert_near(measure(&f, texture_verticalised, NULL)[0], 0.5, 1e-15);
    end(&f);
}

/* Axes at k times the angle around the middle: a defect of charge k there, and no other. */
static void test_defects(void **state) {
    (void)state;
    const double charge[] = {0.5, -0.5, 1, 0};
    const double plus[] = {1, 0, 2, 0}, minus[] = {0, 1, 0, 0};
    for (int k = 0; k < 4; k++) {
        fixture f;
        begin(&f);
        for (int i = -15; i <= 15; i++)
            for (int j = -15; j <= 15; j++) {
                double x = 1.5 * i + 0.4, y = 1.5 * j + 0.3;
                add_flat(&f, x, y, charge[k] * atan2(y, x) + 0.2, 1.5);
            }
        measure(&f, defects_measure, NULL);
        assert_near(f.out[1], plus[k], 0);
        assert_near(f.out[2], minus[k], 0);
        assert_near(f.out[0], plus[k] + minus[k], 0);
        assert_near(f.out[3] * 45 * 45, f.out[0], 0.2 * f.out[0]);
        end(&f);
    }
    fixture f;
    begin(&f);
    add_coccus(&f, 0, 0, 0);
    assert_true(isnan(measure(&f, defects_measure, NULL)[0]));
    end(&f);
}

/* A ball of cocci with one filament through it: what lies beyond the ball, and its two ends. */
static void test_bridging(void **state) {
    (void)state;
    fixture f;
    begin(&f);
    assert_true(isnan(measure(&f, bridging_measure, NULL)[0]));
    for (int i = -5; i <= 5; i++)
        for (int j = -5; j <= 5; j++)
            for (int k = -5; k <= 5; k++)
                if (i * i + j * j + k * k <= 25)
                    add_coccus(&f, i, j, k);
    uint64_t last = 0;
    for (int i = -10; i <= 10; i++) { /* 21 rods of total length 3, centres 3.5 apart: from -35 to 35 */
        uint32_t row = add_flat(&f, 3.5 * i, 0, 0, 2);
        if (last)
            colony_add_link(f.c, LINK_FILIAL, last, f.c->cell.id[row], 0);
        last = f.c->cell.id[row];
    }
    measure(&f, bridging_measure, NULL);
    assert_true(f.out[2] > 4.5 && f.out[2] <= 5);
    assert_near(f.out[0], 3 * 18, 1e-12); /* centres at 0 and +-3.5 lie inside */
    assert_near(f.out[1], 2, 0);
    assert_near(f.out[3], 35, 1e-12);
    end(&f);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_hull_of_a_cube),
        cmocka_unit_test(test_hull_of_a_tetrahedron),
        cmocka_unit_test(test_flat_hulls),
        cmocka_unit_test(test_compactness),
        cmocka_unit_test(test_compactness_of_a_lattice),
        cmocka_unit_test(test_outline_of_discs),
        cmocka_unit_test(test_outline_of_a_rod),
        cmocka_unit_test(test_outline_of_a_ring),
        cmocka_unit_test(test_outline_of_shapes),
        cmocka_unit_test(test_outline_moves),
        cmocka_unit_test(test_fractal_dimensions),
        cmocka_unit_test(test_verticalised),
        cmocka_unit_test(test_defects),
        cmocka_unit_test(test_bridging),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}

/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Growth and division: mass is conserved, shapes follow, and nothing depends on the order of rows. */
#include "check.h"

#include "base/rng.h"
#include "base/vec3.h"
#include "biology/division.h"
#include "biology/growth.h"
#include "model/axis.h"
#include "model/shape.h"

#include <stdlib.h>
#include <string.h>

typedef struct culture {
    colony *c;
    species_table t;
    rng *r;
    double time;
    uint64_t step;
    bool substratum;
} culture;

static void set_rule(species *s, int style, double mass) {
    s->division.style = style;
    s->division.values[DIVISION_MASS] = spread_fixed(mass);
    s->division.values[DIVISION_SIZE] = spread_fixed(NAN);
    s->division.values[DIVISION_JITTER] = spread_fixed(0);
    s->division.values[DIVISION_AXIS] = spread_fixed(AXIS_AUTO);
    s->division.values[DIVISION_TRIES] = spread_fixed(100);
}

static culture make(shape_kind shape) {
    culture k = {.c = colony_create(), .r = rng_create(7)};
    species_add(&k.t, "ecoli");
    species *s = &k.t.list[0];
    s->shape = shape;
    s->density = 1.01;
    s->diameter = shape == SHAPE_ROD ? (spread){SPREAD_NORMAL, 0.75, 0.0375} : spread_fixed(0);
    s->growth.style = 0;
    s->growth.values[GROWTH_RATE] = (spread){SPREAD_NORMAL, 1.23 / 3600, 0.277 / 3600};
    s->growth.values[GROWTH_DRAW] = spread_fixed(DRAW_STEP);
    set_rule(s, shape == SHAPE_ROD ? 0 : 1, shape == SHAPE_ROD ? 2.45 : 0.6);
    double x[6] = {0, 0, 0.375, 2.25, 0, 0.375};
    uint32_t row = colony_add_cell(k.c, species_particles(s), x);
    k.c->cell.founder[row] = 1;
    k.c->cell.mass[row] = shape == SHAPE_ROD ? 1.225 : 0.3;
    k.c->cell.diameter[row] = 0.75;
    k.c->cell.limit[row] = shape == SHAPE_ROD ? 2.45 : 0.6;
    species_shape_cell(s, k.c, row);
    return k;
}

static void discard(culture *k) {
    colony_free(k->c);
    free(k->t.list);
    rng_free(k->r);
}

static size_t divide(culture *k) {
    const division_context x = {
        .colony = k->c, .species = &k->t, .rng = k->r, .time = k->time, .substratum = k->substratum};
    return division_step(&x);
}

static void advance(culture *k, double dt) {
    assert_int_equal(growth_step(k->c, &k->t, k->r, k->step++, dt, NULL), SARCINA_OK);
    k->time += dt;
    divide(k);
}

static double total_mass(const colony *c) {
    double sum = 0;
    for (size_t i = 0; i < c->cell.count; i++)
        sum += c->cell.mass[i];
    return sum;
}

static void test_division_conserves(void **state) {
    (void)state;
    for (int shape = SHAPE_COCCUS; shape <= SHAPE_ROD; shape++) {
        culture k = make(shape);
        k.c->cell.mass[0] = shape == SHAPE_ROD ? 2.5 : 0.7;
        species_shape_cell(&k.t.list[0], k.c, 0);
        double mass = k.c->cell.mass[0];
        assert_int_equal(divide(&k), 1);
        assert_int_equal(k.c->cell.count, 2);
        assert_true(total_mass(k.c) == mass); /* halving is exact */
        assert_int_equal(k.c->cell.parent[1], 1);
        assert_int_equal(k.c->cell.founder[1], 1);
        assert_int_equal(k.c->cell.generation[0], 1);
        assert_int_equal(k.c->cell.generation[1], 1);
        discard(&k);
    }
}

/* The new ends touch, the outer particles stay, and with equal diameters each rod is D/6 too short for its spring. */
static void test_rod_daughters_touch(void **state) {
    (void)state;
    culture k = make(SHAPE_ROD);
    k.t.list[0].diameter = spread_fixed(0.75);
    k.c->cell.mass[0] = 2.46;
    species_shape_cell(&k.t.list[0], k.c, 0);
    double *x = k.c->particle.x;
    x[3] = k.c->cell.rest[0]; /* at rest along x */
    double end = x[3], length = end;
    divide(&k);
    x = k.c->particle.x;
    assert_true(x[0] == 0 && x[9] == end);
    assert_near(x[6] - x[3], 0.75, 1e-12);
    assert_near(k.c->cell.rest[0] - (x[3] - x[0]), 0.75 / 6, 1e-12);
    assert_near(k.c->cell.rest[1] - (x[9] - x[6]), 0.75 / 6, 1e-12);
    assert_near(k.c->cell.rest[0], length / 2 - 0.75 / 3, 1e-12);
    discard(&k);
}

static void test_jitter(void **state) {
    (void)state;
    for (int plane = 0; plane < 2; plane++) {
        culture k = make(SHAPE_ROD), still = make(SHAPE_ROD);
        k.substratum = still.substratum = plane;
        k.t.list[0].division.values[DIVISION_JITTER] = spread_fixed(0.01);
        k.c->cell.mass[0] = still.c->cell.mass[0] = 2.5;
        divide(&k);
        divide(&still);
        double d[3], square = 0;
        for (int i = 0; i < 3; i++) {
            d[i] = k.c->particle.x[6 + i] - still.c->particle.x[6 + i];
            square += d[i] * d[i];
        }
        assert_near(sqrt(square), 0.01, 1e-12);
        assert_true((fabs(d[2]) < 1e-15) == plane); /* horizontal on a substratum */
        discard(&k);
        discard(&still);
    }
}

static void test_coccus_takes_free_direction(void **state) {
    (void)state;
    culture k = make(SHAPE_COCCUS);
    /* walls of cocci on both sides along x and y leave only z */
    for (int i = 0; i < 4; i++) {
        double x[3] = {i == 0 ? 0.9 : i == 1 ? -0.9 : 0, i == 2 ? 0.9 : i == 3 ? -0.9 : 0, 0.375};
        uint32_t row = colony_add_cell(k.c, 1, x);
        k.c->cell.mass[row] = 0.5;
        k.c->cell.limit[row] = INFINITY;
        species_shape_cell(&k.t.list[0], k.c, row);
    }
    k.c->cell.mass[0] = 0.61;
    species_shape_cell(&k.t.list[0], k.c, 0);
    divide(&k);
    assert_int_equal(k.c->cell.count, 6);
    double separation[3];
    for (int i = 0; i < 3; i++)
        separation[i] = k.c->particle.x[15 + i] - k.c->particle.x[i];
    double distance =
        sqrt(separation[0] * separation[0] + separation[1] * separation[1] + separation[2] * separation[2]);
    assert_near(distance, k.c->cell.diameter[0], 1e-12);
    for (uint32_t i = 1; i < 5; i++) {
        double free_space = 0.5 * (k.c->cell.diameter[0] + k.c->cell.diameter[i]);
        assert_true(axis_cell_distance(k.c, 0, i) >= free_space);
        assert_true(axis_cell_distance(k.c, 5, i) >= free_space);
    }
    discard(&k);
}

static void test_exponential_growth(void **state) {
    (void)state;
    culture k = make(SHAPE_ROD);
    k.t.list[0].growth.values[GROWTH_RATE] = spread_fixed(1.23 / 3600);
    double before = total_mass(k.c);
    for (int i = 0; i < 60; i++)
        advance(&k, 240);
    assert_near(total_mass(k.c) / before, exp(1.23 * 4), 1e-9 * exp(1.23 * 4));
    /* equal rates: all cells divide together, log2 of the growth times they have done so */
    assert_int_equal(k.c->cell.count, 128);
    for (size_t i = 0; i < k.c->cell.count; i++) {
        assert_true(k.c->cell.mass[i] <= 2.45);
        double diameter = k.c->cell.diameter[i];
        assert_near(shape_rod_mass(k.c->cell.rest[i], diameter, 1.01), k.c->cell.mass[i], 1e-12);
    }
    discard(&k);
}

static void reverse_rows(colony *c) {
    uint32_t *rows = malloc(c->cell.count * sizeof *rows);
    for (uint32_t i = 0; i < c->cell.count; i++)
        rows[i] = (uint32_t)c->cell.count - 1 - i;
    colony_arrange(c, rows, c->cell.count);
    free(rows);
}

/* Turning the rows round before every step changes no bit of any cell. */
static void test_row_order_does_not_matter(void **state) {
    (void)state;
    culture a = make(SHAPE_ROD), b = make(SHAPE_ROD);
    for (int i = 0; i < 50; i++) {
        advance(&a, 240);
        reverse_rows(b.c);
        advance(&b, 240);
    }
    assert_true(a.c->cell.count > 20);
    assert_int_equal(a.c->cell.count, b.c->cell.count);
    for (uint64_t id = 1; id < a.c->next_cell_id; id++) {
        uint32_t p = colony_row(a.c, id), q = colony_row(b.c, id);
        assert_true(a.c->cell.mass[p] == b.c->cell.mass[q]);
        assert_true(a.c->cell.diameter[p] == b.c->cell.diameter[q]);
        assert_int_equal(a.c->cell.parent[p], b.c->cell.parent[q]);
        assert_memory_equal(a.c->particle.x + 3 * a.c->cell.first[p], b.c->particle.x + 3 * b.c->cell.first[q],
                            6 * sizeof(double));
    }
    discard(&a);
    discard(&b);
}

static void test_rate_moments_and_draws(void **state) {
    (void)state;
    culture k = make(SHAPE_ROD);
    k.t.list[0].division.style = -1;
    double sum = 0, square = 0;
    enum { STEPS = 4000 };
    for (int i = 0; i < STEPS; i++) {
        k.c->cell.mass[0] = 1;
        growth_step(k.c, &k.t, k.r, k.step++, 1, NULL);
        sum += k.c->cell.rate[0] * 3600;
        square += k.c->cell.rate[0] * 3600 * k.c->cell.rate[0] * 3600;
    }
    double mean = sum / STEPS, deviation = sqrt(square / STEPS - mean * mean);
    assert_near(mean, 1.23, 4 * 0.277 / sqrt(STEPS));
    assert_near(deviation, 0.277, 4 * 0.277 / sqrt(2 * STEPS));

    k.t.list[0].growth.values[GROWTH_DRAW] = spread_fixed(DRAW_BIRTH);
    growth_step(k.c, &k.t, k.r, k.step++, 1, NULL);
    double once = k.c->cell.rate[0];
    growth_step(k.c, &k.t, k.r, k.step++, 1, NULL);
    assert_true(k.c->cell.rate[0] == once);
    discard(&k);
}

static void test_refusals(void **state) {
    (void)state;
    culture k = make(SHAPE_ROD);
    diag d = {0};
    assert_int_equal(division_check(&k.t.list[0], &d), SARCINA_OK);
    set_rule(&k.t.list[0], 0, 0.4); /* half of it is lighter than a ball of 0.75 um */
    assert_int_equal(division_check(&k.t.list[0], &d), SARCINA_ERROR);
    assert_non_null(strstr(d.message, "shorter than wide"));
    set_rule(&k.t.list[0], 1, 2);
    assert_int_equal(division_check(&k.t.list[0], &d), SARCINA_ERROR);
    assert_non_null(strstr(d.message, "division random is for cocci"));

    /* a mass that overflows is refused, and nothing has grown */
    k.t.list[0].growth.values[GROWTH_RATE] = spread_fixed(0.009);
    assert_int_equal(growth_step(k.c, &k.t, k.r, 0, 1e6, &d), SARCINA_NUMERICAL);
    assert_true(k.c->cell.mass[0] == 1.225);
    discard(&k);
}

/* Unit vector from one cell to another. */
static vec3 direction_to(const culture *k, uint64_t from, uint64_t to) {
    const double *a = k->c->particle.x + 3 * (size_t)k->c->cell.first[colony_row(k->c, from)];
    const double *b = k->c->particle.x + 3 * (size_t)k->c->cell.first[colony_row(k->c, to)];
    vec3 d = vec3_sub(vec3_load(b), vec3_load(a));
    return vec3_scale(1 / vec3_norm(d), d);
}

/* The cosines between a cell's first three axes of division are 1 (one plane), or 0 between successive ones and 1 (two)
 * or 0 (three) between the first and the third; the daughter's next axis is at right angles to her birth's. Rows change
 * their order meanwhile. */
static void test_planes(void **state) {
    (void)state;
    for (int planes = 1; planes <= 3; planes++) {
        culture k = make(SHAPE_COCCUS);
        set_rule(&k.t.list[0], 2, 0.6);
        k.t.list[0].division.values[DIVISION_PLANES] = spread_fixed(planes);
        vec3 axis[3], daughters = {0, 0, 0};
        for (int round = 0; round < 3; round++) {
            for (uint32_t i = 0; i < k.c->cell.count; i++) {
                k.c->cell.mass[i] = 0.61;
                species_shape_cell(&k.t.list[0], k.c, i);
            }
            reverse_rows(k.c);
            uint64_t newborn = k.c->next_cell_id;
            assert_int_equal(divide(&k), 1 << round);
            axis[round] = direction_to(&k, 1, newborn);
            if (round == 1)
                daughters = direction_to(&k, 2, newborn + 1);
        }
        assert_near(vec3_dot(axis[0], axis[1]), planes == 1, 1e-12);
        assert_near(vec3_dot(axis[1], axis[2]), planes == 1, 1e-12);
        assert_near(fabs(vec3_dot(axis[0], axis[2])), planes < 3, 1e-12);
        assert_near(vec3_dot(axis[0], daughters), planes == 1, 1e-12);
        discard(&k);
    }
}

/* On a substratum the first two axes lie in the plane. */
static void test_planes_on_substratum(void **state) {
    (void)state;
    culture k = make(SHAPE_COCCUS);
    set_rule(&k.t.list[0], 2, 0.6);
    k.t.list[0].division.values[DIVISION_PLANES] = spread_fixed(2);
    k.substratum = true;
    for (int round = 0; round < 2; round++) {
        for (size_t i = 0; i < k.c->cell.count; i++)
            k.c->cell.mass[i] = 0.61;
        divide(&k);
    }
    assert_int_equal(k.c->cell.count, 4);
    for (int i = 1; i < 4; i++)
        assert_near(k.c->particle.x[3 * i + 2], k.c->particle.x[2], 1e-12);
    discard(&k);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_division_conserves),
        cmocka_unit_test(test_rod_daughters_touch),
        cmocka_unit_test(test_jitter),
        cmocka_unit_test(test_coccus_takes_free_direction),
        cmocka_unit_test(test_exponential_growth),
        cmocka_unit_test(test_row_order_does_not_matter),
        cmocka_unit_test(test_rate_moments_and_draws),
        cmocka_unit_test(test_planes),
        cmocka_unit_test(test_planes_on_substratum),
        cmocka_unit_test(test_refusals),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}

/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Measures of who is near whom, of layers, links and chains, and bins, on lattices, lines and rings where the answer is
 * known. */
#include "check.h"

#include "analysis/bins.h"
#include "analysis/component.h"
#include "analysis/linkage.h"
#include "analysis/neighborhood.h"
#include "analysis/order.h"
#include "analysis/segregation.h"
#include "analysis/touching.h"

#include <gsl/gsl_rng.h>
#include <gsl/gsl_statistics_double.h>
#include <stdlib.h>

typedef struct culture {
    colony *c;
    species_table species;
} culture;

static culture make(void) {
    culture k = {.c = colony_create()};
    species_add(&k.species, "one");
    species_add(&k.species, "two");
    return k;
}

static void discard(culture *k) {
    colony_free(k->c);
    free(k->species.list);
}

static uint32_t add_ball(culture *k, double x, double y, double z, int kind) {
    uint32_t row = colony_add_cell(k->c, 1, (const double[]){x, y, z});
    k->c->cell.diameter[row] = 1;
    k->c->cell.species[row] = kind;
    return row;
}

/* A rod of length 2 between its ends, around a centre, at an angle in the plane and above it. */
static uint32_t add_rod(culture *k, double x, double y, double z, double angle, double rise) {
    double u[3] = {cos(angle) * cos(rise), sin(angle) * cos(rise), sin(rise)};
    uint32_t row =
        colony_add_cell(k->c, 2, (const double[]){x - u[0], y - u[1], z - u[2], x + u[0], y + u[1], z + u[2]});
    k->c->cell.diameter[row] = 1;
    return row;
}

typedef int measure(const view *, const bool *, double *, diag *);

static void look(culture *k, measure *function, const bool *members, double radius, double out[17]) {
    const view v = {.colony = k->c, .species = &k->species, .time = 100, .radius = radius};
    assert_int_equal(function(&v, members, out, NULL), SARCINA_OK);
}

/* Rows in another order: no measure may see it. */
static void shuffle(culture *k) {
    uint32_t n = (uint32_t)k->c->cell.count, *rows = malloc(n * sizeof *rows);
    for (uint32_t i = 0; i < n; i++)
        rows[i] = (uint32_t)((7ull * i + 3) % n);
    colony_arrange(k->c, rows, n);
    free(rows);
}

/* 6 x 7 balls that just touch on a square lattice (7 does not divide 42 x 1: shuffle wants n prime to 7). */
static void square(culture *k, int nx, int ny, double step) {
    for (int i = 0; i < nx; i++)
        for (int j = 0; j < ny; j++)
            add_ball(k, step * i, step * j, 0.5, (i + j) % 2);
}

static void test_coordination_of_a_lattice(void **state) {
    (void)state;
    culture k = make();
    double out[17];
    square(&k, 6, 5, 0.99);
    shuffle(&k);
    look(&k, touching_coordination, NULL, 0, out);
    double pairs = 5 * 5 + 6 * 4; /* along x, along y */
    assert_near(out[1], pairs, 0);
    assert_near(out[0], 2 * pairs / 30, 1e-15);
    assert_near(out[2], 0, 0);
    add_ball(&k, 50, 50, 0.5, 0);
    look(&k, touching_coordination, NULL, 0, out);
    assert_near(out[2], 1.0 / 31, 1e-15);
    bool *members = calloc(31, 1); /* one species of a chessboard touches only the other */
    for (uint32_t row = 0; row < 31; row++)
        members[row] = k.c->cell.species[row] == 1;
    look(&k, touching_coordination, members, 0, out);
    assert_near(out[0], 0, 0);
    assert_near(out[2], 1, 0);
    free(members);
    discard(&k);
}

/* Rods side by side touch along their length though their centres are far from their ends. */
static void test_contacts_are_of_surfaces(void **state) {
    (void)state;
    culture k = make();
    double out[17];
    add_rod(&k, 0, 0, 0, 0, 0);
    add_rod(&k, 2.9, 0, 0, 0, 0);  /* end to end: 0.9 apart along x, between axes */
    add_rod(&k, 0, 0.95, 0, 0, 0); /* side by side */
    add_rod(&k, 0, 3, 0, 0, 0);    /* apart */
    look(&k, touching_coordination, NULL, 0, out);
    assert_near(out[1], 2, 0); /* 2 and 3 are apart by 0.9 along x and 0.95 along y */
    discard(&k);
}

static void test_contact_clusters(void **state) {
    (void)state;
    culture k = make();
    double out[17];
    for (int i = 0; i < 5; i++) /* a line of five, a pair, one alone */
        add_ball(&k, 0.9 * i, 0, 0, 0);
    add_ball(&k, 0, 10, 0, 0);
    add_ball(&k, 0.9, 10, 0, 0);
    add_ball(&k, 20, 20, 0, 0);
    look(&k, touching_clusters, NULL, 0, out);
    assert_near(out[0], 3, 0);
    assert_near(out[1], 5, 0);
    assert_near(out[2], 8.0 / 3, 1e-15);
    bool members[8] = {true, true, false, true, true, true, true, true}; /* the line is cut */
    look(&k, touching_clusters, members, 0, out);
    assert_near(out[0], 4, 0);
    assert_near(out[1], 2, 0);
    discard(&k);
}

static void test_nematic_order(void **state) {
    (void)state;
    culture k = make();
    double out[17];
    for (int i = 0; i < 5; i++) /* parallel, one of them head to tail */
        add_rod(&k, 0, 1.2 * i, 0, i == 2 ? M_PI : 0, 0);
    look(&k, order_nematic, NULL, 0, out);
    assert_near(out[0], 1, 1e-14);
    assert_near(out[1], 1, 1e-14);
    assert_near(out[3], 3, 1e-14); /* one mean length, caps included */
    assert_near(out[2], 4 + 3, 0); /* neighbours at 1.2 and 2.4 */
    look(&k, order_nematic, NULL, 1.3, out);
    assert_near(out[2], 4, 0);
    discard(&k);
    k = make(); /* a cross, then one upright: two pairs with it have no angle seen from above */
    add_rod(&k, 0, 0, 0, 0, 0);
    add_rod(&k, 0.1, 0, 1, M_PI / 2, 0);
    look(&k, order_nematic, NULL, 0, out);
    assert_near(out[0], -0.5, 1e-15);
    assert_near(out[1], -1, 1e-15);
    add_rod(&k, 0, 0, 2, 0, M_PI / 2);
    look(&k, order_nematic, NULL, 0, out);
    assert_near(out[0], -0.5, 1e-14);
    assert_near(out[1], -1, 1e-14);
    assert_near(out[2], 3, 0);
    look(&k, order_nematic, NULL, 0.01, out);
    assert_true(isnan(out[0]) && isnan(out[1]));
    discard(&k);
}

/* Rods at random angles in the plane: 0 seen from above, 1/4 in space (the mean of (3 cos^2 - 1)/2 with cos^2 = 1/2).
 */
static void test_nematic_order_of_disorder(void **state) {
    (void)state;
    culture k = make();
    gsl_rng *r = gsl_rng_alloc(gsl_rng_mt19937);
    double out[17], again[17];
    for (int i = 0; i < 600; i++)
        add_rod(&k, 40 * gsl_rng_uniform(r), 40 * gsl_rng_uniform(r), 0, 2 * M_PI * gsl_rng_uniform(r), 0);
    look(&k, order_nematic, NULL, 8, out);
    assert_true(out[2] > 10000);
    assert_near(out[1], 0, 0.02);
    assert_near(out[0], 0.25, 0.75 * 0.02);
    shuffle(&k);
    look(&k, order_nematic, NULL, 8, again);
    assert_near(again[0], out[0], 0); /* to the bit */
    gsl_rng_free(r);
    discard(&k);
}

static void test_mixing(void **state) {
    (void)state;
    culture k = make();
    double out[17];
    for (int i = 0; i < 20; i++) /* a chain of alternating species, ever closer, so that nearest is well defined */
        add_ball(&k, 30 * (1 - pow(0.9, i)), 0, 0, i % 2);
    look(&k, order_mixing, NULL, 0, out);
    assert_near(out[1], 1, 0);
    assert_near(out[2], 1 - 2 * 10.0 * 9 / (20 * 19), 1e-15);
    assert_near(out[0], 1 / out[2], 1e-14);
    discard(&k);
    k = make(); /* two heaps far apart */
    for (int i = 0; i < 20; i++)
        add_ball(&k, i % 2 * 1e3 + 1.1 * i, 0, 0, i % 2);
    look(&k, order_mixing, NULL, 0, out);
    assert_near(out[0], 0, 0);
    discard(&k);
    k = make(); /* one species: there is nothing to mix */
    square(&k, 1, 1, 1);
    add_ball(&k, 5, 0, 0, 0);
    look(&k, order_mixing, NULL, 0, out);
    assert_true(isnan(out[0]));
    discard(&k);
}

static void test_mixing_at_random(void **state) {
    (void)state;
    culture k = make();
    gsl_rng *r = gsl_rng_alloc(gsl_rng_mt19937);
    double out[17];
    for (int i = 0; i < 3000; i++)
        add_ball(&k, 100 * gsl_rng_uniform(r), 100 * gsl_rng_uniform(r), 0, gsl_rng_uniform(r) < 0.3);
    look(&k, order_mixing, NULL, 0, out);
    assert_near(out[2], 2 * 0.3 * 0.7, 0.02);
    assert_near(out[0], 1, 0.1);
    gsl_rng_free(r);
    discard(&k);
}

static void test_layering(void **state) {
    (void)state;
    culture k = make();
    double out[17];
    for (int i = 0; i < 6; i++)
        add_ball(&k, 2 * i, 0, 0.5, 0);
    for (int i = 0; i < 3; i++)
        add_ball(&k, 2 * i + 0.5, 0, 0.5 + sqrt(2.0 / 3), 0); /* in the hollows of the first */
    add_rod(&k, 0, 9, 1.5, 0, M_PI / 2);                      /* upright on the floor: the first, however tall */
    look(&k, order_layering, NULL, 0, out);
    assert_near(out[0], 2, 0);
    assert_near(out[1], (7 * 1 + 3 * 2) / 10.0, 1e-15);
    assert_near(out[2], 0.7, 1e-15);
    discard(&k);
}

static void add_link(culture *k, link_kind kind, uint32_t a, uint32_t b, double rest, double birth) {
    colony *c = k->c;
    uint32_t link = colony_add_link(c, kind, c->cell.id[a], b == SPRING_ANCHOR ? 0 : c->cell.id[b], 1);
    uint32_t s = c->link.first[link];
    c->link.birth[link] = birth;
    c->spring.a[s] = c->cell.first[a];
    c->spring.b[s] = b == SPRING_ANCHOR ? SPRING_ANCHOR : c->cell.first[b];
    c->spring.rest[s] = rest;
}

static void test_strain_and_age_of_links(void **state) {
    (void)state;
    culture k = make();
    double out[17];
    for (int i = 0; i < 4; i++)
        add_ball(&k, 2 * i, 0, 3, 0);
    add_link(&k, LINK_FILIAL, 0, 1, 1, 90);             /* 2 long: strain 1, age 10 */
    add_link(&k, LINK_STICK, 1, 2, 4, 60);              /* -0.5, 40 */
    add_link(&k, LINK_STICK, 2, 3, 2, 80);              /* 0, 20 */
    add_link(&k, LINK_ANCHOR, 0, SPRING_ANCHOR, 6, 40); /* 3 long to the origin: -0.5, 60 */
    look(&k, linkage_strain, NULL, 0, out);
    assert_near(out[0], 0, 1e-15);
    assert_near(out[1], -0.5, 1e-15);
    assert_near(out[2], 1, 1e-15);
    assert_near(out[3], 1, 1e-15);
    assert_near(out[4], -0.25, 1e-15);
    assert_near(out[5], -0.5, 1e-15);
    look(&k, linkage_age, NULL, 0, out);
    assert_near(out[0], 32.5, 1e-15);
    assert_near(out[1], 60, 0);
    assert_near(out[3], 30, 0);
    const bool members[4] = {false, true, true, true};
    look(&k, linkage_strain, members, 0, out);
    assert_near(out[0], -0.25, 1e-15);
    assert_true(isnan(out[3]));
    discard(&k);
}

static void test_straightness_of_filaments(void **state) {
    (void)state;
    culture k = make();
    double out[17];
    for (int i = 0; i < 5; i++) /* straight, 4 long */
        add_ball(&k, i, 0, 0, 0);
    for (int i = 0; i < 5; i++) /* half a ring of radius 2 */
        add_ball(&k, 2 * cos(M_PI * i / 4), 10 + 2 * sin(M_PI * i / 4), 0, 0);
    for (int i = 0; i < 4; i++) { /* a chain each; the links of the second come in another order */
        add_link(&k, LINK_FILIAL, (uint32_t)i, (uint32_t)i + 1, 1, 0);
        add_link(&k, LINK_FILIAL, 9 - (uint32_t)i, 8 - (uint32_t)i, 1, 0);
    }
    for (int i = 0; i < 4; i++) /* a closed ring: it has no ends */
        add_ball(&k, i, 50 + i % 2, 0, 0);
    for (uint32_t i = 0; i < 4; i++)
        add_link(&k, LINK_FILIAL, 10 + i, 10 + (i + 1) % 4, 1, 0);
    for (int i = 0; i < 4; i++) /* a star */
        add_ball(&k, i, 90, 0, 0);
    for (uint32_t i = 1; i < 4; i++)
        add_link(&k, LINK_FILIAL, 14, 14 + i, 1, 0);
    double bow = 4 * 4 * sin(M_PI / 8);
    look(&k, component_filaments, NULL, 0, out);
    assert_near(out[0], 4, 0);
    assert_near(out[3], 2 + 2 + 3, 0);
    assert_near(out[4], (4 + bow) / 2, 1e-13);
    assert_near(out[5], (1 + 4 / bow) / 2, 1e-14);
    discard(&k);
}

/* ---- segregation ------------------------------------------------------------------------------------------------ */

static void look_at(culture *k, const double *of, double radius, double out[17]) {
    const view v = {.colony = k->c, .species = &k->species, .radius = radius, .of = of};
    assert_int_equal(segregation_measure(&v, NULL, out, NULL), SARCINA_OK);
}

/* A chessboard of 6 x 6: every neighbour is the opposite. Two halves: only the 6 pairs across the border differ, of 60.
 */
static void test_segregation_of_a_lattice(void **state) {
    (void)state;
    culture k = make();
    double out[17], half[36];
    square(&k, 6, 6, 0.99);
    for (uint32_t row = 0; row < 36; row++)
        k.c->cell.generation[row] = 3 + 2 * k.c->cell.species[row];
    look(&k, segregation_measure, NULL, 0, out);
    assert_near(out[0], -1, 1e-14);
    assert_near(out[1], 60, 0);
    assert_near(out[2], -1.0 / 35, 1e-15);
    for (int i = 0; i < 36; i++)
        half[i] = i < 18 ? 7 : -2;
    look_at(&k, half, 0, out);
    assert_near(out[0], 1 - 2 * 6 / 60.0, 1e-14);
    look_at(&k, half, 100, out); /* everybody a neighbour of everybody: as dealt at random, whatever the numbers */
    assert_near(out[0], -1.0 / 35, 1e-14);
    assert_near(out[1], 36 * 35 / 2.0, 0);
    bool *members = calloc(36, 1); /* one colour of the chessboard alone */
    for (uint32_t row = 0; row < 36; row++)
        members[row] = k.c->cell.species[row] == 1;
    look(&k, segregation_measure, members, 0, out);
    assert_true(isnan(out[0]) && out[1] == 0);
    free(members);
    for (int i = 0; i < 36; i++)
        half[i] = 5;
    look_at(&k, half, 0, out);
    assert_true(isnan(out[0]));
    discard(&k);
}

/* On a ring of N a wave of m periods has I = cos(2 pi m/N). */
static void test_segregation_of_a_ring(void **state) {
    (void)state;
    enum { N = 20 };
    culture k = make();
    double out[17], wave[N + 1], radius = 0.499 / sin(M_PI / N); /* neighbours touch */
    for (int i = 0; i < N; i++)
        add_ball(&k, radius * cos(2 * M_PI * i / N), radius * sin(2 * M_PI * i / N), 0, 0);
    for (int m = 1; m <= N / 2; m++) {
        for (int i = 0; i < N; i++)
            wave[i] = 4 + cos(2 * M_PI * m * i / N);
        look_at(&k, wave, 0, out);
        assert_near(out[0], cos(2 * M_PI * m / N), 1e-13);
        assert_near(out[1], N, 0);
    }
    add_ball(&k, 0, 0, 0, 0); /* without a number it does not count, nor its neighbours' pairs */
    wave[N] = NAN;
    look_at(&k, wave, radius + 1e-9, out);
    assert_near(out[2], -1.0 / (N - 1), 1e-15);
    discard(&k);
}

/* Two discs far apart, each of one generation, are apart; dealt at random, the mean over many deals is -1/(N - 1). */
static void test_segregation_of_discs(void **state) {
    (void)state;
    culture k = make();
    gsl_rng *r = gsl_rng_alloc(gsl_rng_mt19937);
    double out[17], number[200], sum = 0, squares = 0;
    int n = 0;
    for (int disc = 0; disc < 2; disc++)
        for (int i = -4; i <= 4; i++)
            for (int j = -4; j <= 4; j++)
                if (i * i + j * j <= 16) {
                    uint32_t row = add_ball(&k, 100 * disc + 0.99 * i, 0.99 * j, 0, 0);
                    k.c->cell.generation[row] = disc;
                    n++;
                }
    look(&k, segregation_measure, NULL, 0, out);
    assert_near(out[0], 1, 1e-14);
    enum { DEALS = 4000 };
    for (int deal = 0; deal < DEALS; deal++) {
        for (int i = 0; i < n; i++)
            number[i] = gsl_rng_uniform(r);
        look_at(&k, number, 0, out);
        sum += out[0];
        squares += out[0] * out[0];
    }
    double mean = sum / DEALS, error = sqrt((squares / DEALS - mean * mean) / DEALS);
    assert_near(mean, -1.0 / (n - 1), 4 * error);
    assert_true(error < 0.2 / (n - 1));
    shuffle(&k);
    look(&k, segregation_measure, NULL, 0, out);
    assert_near(out[0], 1, 1e-14);
    gsl_rng_free(r);
    discard(&k);
}

/* ---- bins ------------------------------------------------------------------------------------------------------- */

static void test_histogram(void **state) {
    (void)state;
    const double x[] = {0, 0.1, 0.25, 0.5, 0.99, 1, 1.01, -0.01, NAN};
    bins b = bins_create(4);
    bins_fill(&b, x, NULL, 9, 0, 1);
    const double counts[] = {2, 1, 1, 2}; /* lower ends belong to a bin, the upper end to the last */
    for (size_t i = 0; i < 4; i++)
        assert_near(b.count[i], counts[i], 0);
    assert_near(b.total, 6, 0);
    assert_near(bins_edge(&b, 4), 1, 0);
    bins_fill(&b, x, NULL, 9, NAN, NAN); /* of the data */
    assert_near(b.low, -0.01, 0);
    assert_near(b.high, 1.01, 0);
    assert_near(b.total, 8, 0);
    bins_fill(&b, x, NULL, 1, NAN, NAN); /* all in one place */
    assert_near(b.count[0], 1, 0);
    bins_fill(&b, x, NULL, 0, NAN, NAN);
    assert_true(isnan(b.low) && b.total == 0);
    bins_free(&b);
    b = bins_create(10); /* every edge, as it is rounded, begins its own bin */
    for (size_t i = 0; i < 10; i++) {
        b.low = 0;
        b.high = 0.3;
        double edge = bins_edge(&b, i);
        bins_fill(&b, &edge, NULL, 1, 0, 0.3);
        assert_near(b.count[i], 1, 0);
    }
    bins_free(&b);
}

static void test_profile(void **state) {
    (void)state;
    const double x[] = {0, 1, 2, 3, 4, 10, 5}, y[] = {3, 4, 8, 1, 1e9, 7, NAN};
    bins b = bins_create(2);
    bins_fill(&b, x, y, 7, NAN, NAN);
    assert_near(b.count[0], 5, 0);
    assert_near(b.count[1], 1, 0);
    assert_near(bins_mean(&b, 0), gsl_stats_mean(y, 1, 5), 1e-6);
    assert_near(bins_sd(&b, 0), gsl_stats_sd(y, 1, 5), 1e-6);
    bins_fill(&b, x, y, 4, NAN, NAN); /* ci95 with 1 degree of freedom: t = 12.7062 */
    assert_near(bins_ci95(&b, 0), 12.706204736 * sqrt(0.5) / sqrt(2), 1e-8);
    assert_near(bins_mean(&b, 1), 4.5, 0);
    bins_fill(&b, x + 5, y + 5, 1, NAN, NAN);
    assert_true(isnan(bins_sd(&b, 0)) && isnan(bins_ci95(&b, 0)) && isnan(bins_mean(&b, 1)));
    bins_free(&b);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_coordination_of_a_lattice),
        cmocka_unit_test(test_contacts_are_of_surfaces),
        cmocka_unit_test(test_contact_clusters),
        cmocka_unit_test(test_segregation_of_a_lattice),
        cmocka_unit_test(test_segregation_of_a_ring),
        cmocka_unit_test(test_segregation_of_discs),
        cmocka_unit_test(test_nematic_order),
        cmocka_unit_test(test_nematic_order_of_disorder),
        cmocka_unit_test(test_mixing),
        cmocka_unit_test(test_mixing_at_random),
        cmocka_unit_test(test_layering),
        cmocka_unit_test(test_strain_and_age_of_links),
        cmocka_unit_test(test_straightness_of_filaments),
        cmocka_unit_test(test_histogram),
        cmocka_unit_test(test_profile),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}

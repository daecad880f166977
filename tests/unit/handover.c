/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Links at division: daughters are inserted into filaments, begin branches, and share what their mother stuck to. */
#include "check.h"

#include "base/alloc.h"
#include "base/rng.h"
#include "biology/division.h"
#include "model/link.h"
#include "model/link_check.h"
#include "model/shape.h"

#include <stdlib.h>
#include <string.h>

enum { ROD, COCCUS, SPECIES };

typedef struct culture {
    colony *c;
    species_table t;
    link_rules links;
    rng *r;
    bool substratum;
} culture;

static void set_rule(culture *k, link_kind kind, int a, int b, const double *p) {
    link_rule rule = {.on = true};
    memcpy(rule.p, p, sizeof rule.p);
    link_rules_set(&k->links, kind, a, b, &rule);
}

static void set_division(species *s, int style, double mass, double own) {
    s->division.style = style;
    s->division.values[DIVISION_MASS] = spread_fixed(mass);
    s->division.values[DIVISION_SIZE] = spread_fixed(NAN);
    s->division.values[DIVISION_JITTER] = spread_fixed(0);
    s->division.values[DIVISION_AXIS] = spread_fixed(AXIS_AUTO);
    s->division.values[DIVISION_OWN] = spread_fixed(own);
}

/* Rods of diameter 1 um that divide at rest length 4 um; cocci that divide along one plane. All stick; all are filial.
 */
static culture make(double branch) {
    culture k = {.c = colony_create(), .r = rng_create(3)};
    species_add(&k.t, "rod");
    species_add(&k.t, "coccus");
    k.t.list[ROD].shape = SHAPE_ROD;
    k.t.list[ROD].diameter = spread_fixed(1);
    k.t.list[ROD].density = k.t.list[COCCUS].density = 1.01;
    set_division(&k.t.list[ROD], 0, shape_rod_mass(4, 1, 1.01), branch);
    set_division(&k.t.list[COCCUS], 2, shape_coccus_mass(1, 1.01), 1);
    link_rules_clear(&k.links);
    for (int a = 0; a < SPECIES; a++) {
        set_rule(&k, LINK_FILIAL, a, a, (double[]){2e4, 2, 0.5, 1.7, 1.1});
        for (int b = 0; b <= a; b++)
            set_rule(&k, LINK_STICK, a, b, (double[]){1e4, 0.5, 1, HANDOVER_NEARER, 0});
    }
    return k;
}

static void discard(culture *k) {
    assert_null(link_check(k->c).what);
    colony_free(k->c);
    free(k->t.list);
    link_rules_free(&k->links);
    rng_free(k->r);
}

/* A rod of this rest length about a centre, along a unit vector; returns its id. */
static uint64_t add_rod(culture *k, const double centre[3], const double u[3], double rest) {
    double x[6];
    for (int i = 0; i < 6; i++)
        x[i] = centre[i % 3] + (i < 3 ? -0.5 : 0.5) * rest * u[i % 3];
    uint32_t row = colony_add_cell(k->c, 2, x);
    k->c->cell.species[row] = ROD;
    k->c->cell.diameter[row] = 1;
    k->c->cell.rest[row] = rest;
    k->c->cell.mass[row] = shape_rod_mass(rest, 1, 1.01);
    k->c->cell.limit[row] = INFINITY;
    return k->c->cell.id[row];
}

static uint64_t add_coccus(culture *k, double x, double y, double z) {
    uint32_t row = colony_add_cell(k->c, 1, (double[]){x, y, z});
    k->c->cell.species[row] = COCCUS;
    k->c->cell.diameter[row] = 1;
    k->c->cell.mass[row] = shape_coccus_mass(1, 1.01);
    k->c->cell.limit[row] = INFINITY;
    return k->c->cell.id[row];
}

static uint32_t row_of(const culture *k, uint64_t id) {
    return colony_row(k->c, id);
}

static void step(culture *k) {
    const division_context x = {
        .colony = k->c, .species = &k->t, .links = &k->links, .rng = k->r, .substratum = k->substratum, .time = 60};
    division_step(&x);
    link_renew(k->c, &k->links);
    assert_null(link_check(k->c).what);
}

/* Lets the cell divide, and no other. Returns the daughter's id. */
static uint64_t divide(culture *k, uint64_t mother) {
    uint64_t daughter = k->c->next_cell_id;
    for (uint32_t i = 0; i < k->c->cell.count; i++)
        k->c->cell.limit[i] = INFINITY;
    k->c->cell.limit[row_of(k, mother)] = 0;
    step(k);
    assert_int_equal(k->c->next_cell_id, daughter + 1);
    return daughter;
}

static const double along_x[3] = {1, 0, 0};

/* The link between two cells (b 0: to the substratum), of any kind; COLONY_NO_ROW. */
static uint32_t link_between(const culture *k, uint64_t a, uint64_t b) {
    for (uint32_t l = 0; l < k->c->link.count; l++)
        if ((k->c->link.cell_a[l] == a && k->c->link.cell_b[l] == b) ||
            (k->c->link.cell_a[l] == b && k->c->link.cell_b[l] == a))
            return l;
    return COLONY_NO_ROW;
}

static double centre_x(const culture *k, uint64_t id) {
    double centre[3];
    colony_centre(k->c, row_of(k, id), centre);
    return centre[0];
}

static int compare_x(const void *a, const void *b) {
    double p = ((const double *)a)[0], q = ((const double *)b)[0];
    return (p > q) - (p < q);
}

/* The cells along x are linked each to the next and to no other, by their facing ends. */
static void check_row(const culture *k) {
    size_t n = k->c->cell.count;
    double(*places)[2] = malloc(n * sizeof *places);
    for (uint32_t i = 0; i < n; i++) {
        places[i][0] = centre_x(k, k->c->cell.id[i]);
        places[i][1] = (double)k->c->cell.id[i];
    }
    qsort(places, n, sizeof *places, compare_x);
    assert_int_equal(k->c->link.count, n - 1);
    for (size_t i = 0; i + 1 < n; i++) {
        uint32_t l = link_between(k, (uint64_t)places[i][1], (uint64_t)places[i + 1][1]);
        assert_true(l != COLONY_NO_ROW);
        /* nothing lies between the ends that face each other */
        double gap = colony_spring_length(k->c, k->c->link.first[l]);
        assert_true(gap < 1.2);
    }
    free(places);
}

/* Lets every rod of a row along x grow to its length at division, in its place in the row. */
static void regrow(culture *k) {
    size_t n = k->c->cell.count;
    double(*places)[2] = malloc(n * sizeof *places);
    for (uint32_t i = 0; i < n; i++) {
        places[i][0] = k->c->particle.x[3 * (size_t)k->c->cell.first[i]];
        places[i][1] = i;
    }
    qsort(places, n, sizeof *places, compare_x);
    for (size_t at = 0; at < n; at++) {
        uint32_t row = (uint32_t)places[at][1];
        double *x = k->c->particle.x + 3 * (size_t)k->c->cell.first[row];
        x[0] = 5.1 * (double)at;
        x[3] = x[0] + 4;
        k->c->cell.mass[row] = shape_rod_mass(4, 1, 1.01);
        k->c->cell.limit[row] = 0;
        species_shape_cell(&k->t.list[ROD], k->c, row);
    }
    free(places);
}

static void test_filament_of_rods(void **state) {
    (void)state;
    culture k = make(0);
    add_rod(&k, (double[]){0, 0, 0}, along_x, 4);
    for (int round = 0; round < 4; round++) {
        regrow(&k);
        step(&k);
        check_row(&k);
    }
    assert_int_equal(k.c->cell.count, 16);
    discard(&k);
}

/* Cells in the middle of a row divide alone, in an order that is not that of their places. */
static void test_insertion(void **state) {
    (void)state;
    culture k = make(0);
    uint64_t a = add_rod(&k, (double[]){0, 0, 0}, along_x, 4), b = divide(&k, a), c = divide(&k, a);
    divide(&k, b);
    divide(&k, c);
    divide(&k, a);
    check_row(&k);
    discard(&k);
}

static void test_chain_of_cocci(void **state) {
    (void)state;
    culture k = make(0);
    uint64_t a = add_coccus(&k, 0, 0, 0), b = divide(&k, a);
    /* along the frame drawn at the first division, whatever it is */
    uint64_t c = divide(&k, a), d = divide(&k, b);
    const uint64_t row[] = {a, c, b, d};
    assert_int_equal(k.c->link.count, 3);
    size_t degree[4] = {0};
    for (int i = 0; i < 4; i++)
        for (int j = 0; j < 4; j++)
            degree[i] += i != j && link_between(&k, row[i], row[j]) != COLONY_NO_ROW;
    for (int i = 0; i < 4; i++)
        assert_true(degree[i] == 1 || degree[i] == 2);
    assert_int_equal(degree[0] + degree[1] + degree[2] + degree[3], 6);
    discard(&k);
}

/* Three rods in a row, the middle one linked at both ends. */
static void make_three(culture *k, uint64_t id[3]) {
    for (int i = 0; i < 3; i++)
        id[i] = add_rod(k, (double[]){5.1 * i, 0, 0}, along_x, 4);
    for (int i = 0; i < 2; i++)
        link_add_filial(k->c, link_rules_find(&k->links, LINK_FILIAL, ROD, ROD), LINK_STRAIGHT, (uint32_t)i + 1,
                        LINK_FIRST_END, (uint32_t)i, LINK_LAST_END, 0);
}

static void test_branch(void **state) {
    (void)state;
    culture k = make(1);
    uint64_t id[3];
    make_three(&k, id);
    uint64_t daughter = divide(&k, id[1]);
    uint32_t kept = link_between(&k, id[1], id[2]);
    assert_int_equal(k.c->link.count, 4);
    assert_int_equal(k.c->link.style[kept], LINK_STRAIGHT);
    const uint64_t joined[] = {id[1], id[2]};
    const link_end ends[] = {LINK_LAST_END, LINK_FIRST_END};
    for (int i = 0; i < 2; i++) {
        uint32_t l = link_between(&k, daughter, joined[i]);
        assert_int_equal(k.c->link.style[l], LINK_BRANCHED);
        assert_int_equal(link_find_end(k.c, l, row_of(&k, daughter)), LINK_FIRST_END);
        assert_int_equal(link_find_end(k.c, l, row_of(&k, joined[i])), ends[i]);
        for (uint32_t s = 0; s < 2; s++)
            assert_near(k.c->spring.k[k.c->link.first[l] + s], 5e3, 1e-9);
        assert_near(k.c->spring.rest[k.c->link.first[l]], 1.1, 1e-12);
    }
    /* an end cell is inserted, whatever the probability; the branch goes with the end it holds */
    uint64_t next = divide(&k, id[0]), after = divide(&k, id[1]);
    assert_int_equal(k.c->link.style[link_between(&k, next, id[0])], LINK_STRAIGHT);
    assert_true(link_between(&k, after, id[1]) != COLONY_NO_ROW);
    discard(&k);
}

/* How often 30 % of divisions of inner cells branch: 400 of them, 4 standard deviations. */
static void test_branch_probability(void **state) {
    (void)state;
    int branched = 0;
    for (uint64_t seed = 1; seed <= 400; seed++) {
        culture k = make(0.3);
        uint64_t id[3];
        rng_seed(k.r, seed);
        make_three(&k, id);
        uint64_t daughter = divide(&k, id[1]);
        branched += k.c->link.style[link_between(&k, daughter, id[1])] == LINK_BRANCHED;
        discard(&k);
    }
    assert_near(branched, 0.3 * 400, 4 * sqrt(400 * 0.3 * 0.7));
}

/* A rod with a coccus beside each end, stuck to both. */
static uint64_t make_stuck(culture *k, uint64_t side[2]) {
    uint64_t mother = add_rod(k, (double[]){0, 0, 0}, along_x, 4);
    for (int i = 0; i < 2; i++) {
        side[i] = add_coccus(k, i ? 1.8 : -1.8, 1.2, 0);
        uint32_t row = row_of(k, mother), other = row_of(k, side[i]);
        uint32_t l = link_add_stick(k->c, link_rules_find(&k->links, LINK_STICK, ROD, COCCUS), row, other, 7);
        k->c->spring.rest[k->c->link.first[l]] = 1.05; /* under tension */
    }
    return mother;
}

static void test_stick_nearer(void **state) {
    (void)state;
    culture k = make(0);
    uint64_t side[2], mother = make_stuck(&k, side), daughter = divide(&k, mother);
    uint32_t stays = link_between(&k, mother, side[0]), goes = link_between(&k, daughter, side[1]);
    assert_int_equal(k.c->link.count, 3);
    assert_true(stays != COLONY_NO_ROW && goes != COLONY_NO_ROW);
    const uint32_t links[] = {stays, goes};
    for (int i = 0; i < 2; i++) {
        assert_near(k.c->link.birth[links[i]], 7, 0);
        for (uint32_t s = k.c->link.first[links[i]]; s < k.c->link.first[links[i]] + 2; s++) {
            assert_near(k.c->spring.rest[s], fmax(colony_spring_length(k.c, s), 1), 1e-15);
            assert_near(k.c->spring.k[s], 5e3, 0);
        }
    }
    discard(&k);
}

static void test_stick_mother(void **state) {
    (void)state;
    culture k = make(0);
    set_rule(&k, LINK_STICK, ROD, COCCUS, (double[]){1e4, 0.5, 1, HANDOVER_MOTHER, 0});
    uint64_t side[2], mother = make_stuck(&k, side);
    double rest[2][2];
    for (int i = 0; i < 2; i++)
        memcpy(rest[i], k.c->spring.rest + k.c->link.first[link_between(&k, mother, side[i])], sizeof rest[i]);
    divide(&k, mother);
    for (int i = 0; i < 2; i++) {
        uint32_t l = link_between(&k, mother, side[i]);
        assert_true(l != COLONY_NO_ROW);
        assert_memory_equal(rest[i], k.c->spring.rest + k.c->link.first[l], sizeof rest[i]);
    }
    discard(&k);
}

static void set_anchor(culture *k, int handover) {
    k->substratum = true;
    set_rule(k, LINK_ANCHOR, ROD, ROD, (double[]){1e4, 0.5, 1, 0, handover});
    set_rule(k, LINK_ANCHOR, COCCUS, COCCUS, (double[]){1e4, 0.5, 1, 0, handover});
}

static uint64_t make_anchored(culture *k, const double centre[3], const double u[3]) {
    uint64_t mother = add_rod(k, centre, u, 4);
    uint32_t l = link_add_anchor(k->c, link_rules_find(&k->links, LINK_ANCHOR, ROD, ROD), row_of(k, mother), 0, 7);
    for (uint32_t s = 0; s < 2; s++)
        k->c->spring.rest[k->c->link.first[l] + s] = 0.6 + 0.1 * s; /* to be known again */
    return mother;
}

/* A flat rod: each half keeps the anchor of the end it keeps. */
static void test_anchor_nearer(void **state) {
    (void)state;
    culture k = make(0);
    set_anchor(&k, HANDOVER_NEARER);
    uint64_t mother = make_anchored(&k, (double[]){0, 0, 0.55}, along_x), daughter = divide(&k, mother);
    const uint64_t halves[] = {mother, daughter};
    for (uint32_t i = 0; i < 2; i++) {
        uint32_t l = link_between(&k, halves[i], 0), first = k.c->link.first[l];
        assert_near(k.c->link.birth[l], 7, 0);
        assert_near(k.c->spring.rest[first + i], 0.6 + 0.1 * i, 0);
        assert_near(k.c->spring.anchor[3 * (first + i)], i ? 2 : -2, 1e-15);
        /* the particle born in the middle stands over its point */
        uint32_t born = first + 1 - i;
        assert_near(k.c->spring.anchor[3 * born], k.c->particle.x[3 * k.c->spring.a[born]], 0);
        assert_near(k.c->spring.rest[born], 0.55, 1e-15);
    }
    discard(&k);
}

/* An upright rod: the lower half keeps both points, the upper none. */
static void test_anchor_upright(void **state) {
    (void)state;
    culture k = make(0);
    set_anchor(&k, HANDOVER_NEARER);
    uint64_t mother = make_anchored(&k, (double[]){0, 0, 2.6}, (double[]){0, 0, 1}), daughter = divide(&k, mother);
    assert_true(link_between(&k, mother, 0) != COLONY_NO_ROW);
    assert_true(link_between(&k, daughter, 0) == COLONY_NO_ROW);
    /* standing on its head: the daughter is the lower one */
    uint64_t other = make_anchored(&k, (double[]){9, 0, 2.6}, (double[]){0, 0, -1}), lower = divide(&k, other);
    assert_true(link_between(&k, other, 0) == COLONY_NO_ROW);
    uint32_t l = link_between(&k, lower, 0);
    assert_true(l != COLONY_NO_ROW);
    assert_near(k.c->spring.rest[k.c->link.first[l] + 1], 0.7, 0); /* its last particle has not moved */
    discard(&k);
}

static void test_anchor_mother(void **state) {
    (void)state;
    culture k = make(0);
    set_anchor(&k, HANDOVER_MOTHER);
    uint64_t mother = make_anchored(&k, (double[]){0, 0, 0.55}, along_x), daughter = divide(&k, mother);
    uint32_t l = link_between(&k, mother, 0);
    assert_true(link_between(&k, daughter, 0) == COLONY_NO_ROW);
    /* her inner particle has jumped: the spring is longer than its rest length by more than the link bears */
    assert_true(colony_spring_length(k.c, k.c->link.first[l] + 1) > 0.7 + 1);
    discard(&k);
}

static void test_anchored_coccus(void **state) {
    (void)state;
    culture k = make(0);
    set_anchor(&k, HANDOVER_NEARER);
    uint64_t mother = add_coccus(&k, 0, 0, 0.5);
    link_add_anchor(k.c, link_rules_find(&k.links, LINK_ANCHOR, COCCUS, COCCUS), row_of(&k, mother), 0, 7);
    uint64_t daughter = divide(&k, mother);
    bool has[] = {link_between(&k, mother, 0) != COLONY_NO_ROW, link_between(&k, daughter, 0) != COLONY_NO_ROW};
    assert_true(has[0] != has[1]);
    uint32_t l = link_between(&k, has[0] ? mother : daughter, 0), s = k.c->link.first[l];
    assert_near(k.c->spring.anchor[3 * s], k.c->particle.x[3 * k.c->spring.a[s]], 0);
    discard(&k);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_filament_of_rods),   cmocka_unit_test(test_insertion),
        cmocka_unit_test(test_chain_of_cocci),     cmocka_unit_test(test_branch),
        cmocka_unit_test(test_branch_probability), cmocka_unit_test(test_stick_nearer),
        cmocka_unit_test(test_stick_mother),       cmocka_unit_test(test_anchor_nearer),
        cmocka_unit_test(test_anchor_upright),     cmocka_unit_test(test_anchor_mother),
        cmocka_unit_test(test_anchored_coccus),
    };
    return cmocka_run_group_tests_name("handover", tests, NULL, NULL);
}

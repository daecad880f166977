/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Species: the table, and the shape a cell takes from its mass and what it keeps. */
#include "check.h"

#include "model/shape.h"
#include "model/species.h"

#include <stdlib.h>
#include <string.h>

static void test_table(void **state) {
    (void)state;
    species_table t = {0};
    char name[80];
    for (int i = 0; i < 100; i++) {
        snprintf(name, sizeof name, "s%d", i);
        assert_int_equal(species_find(&t, name), -1);
        assert_int_equal(species_add(&t, name), i);
        t.list[i].density = i; /* what was set stays when the table grows */
    }
    for (int i = 0; i < 100; i++) {
        snprintf(name, sizeof name, "s%d", i);
        assert_int_equal(species_find(&t, name), i);
        assert_true(t.list[i].density == i);
        assert_int_equal(t.list[i].growth.style, -1);
        assert_int_equal(t.list[i].division.style, -1);
        assert_true(t.list[i].internal_k == 0);
    }
    memset(name, 'n', sizeof name - 1);
    name[sizeof name - 1] = '\0';
    int row = species_add(&t, name);
    assert_int_equal(strlen(t.list[row].name), sizeof t.list[row].name - 1);
    free(t.list);
}

static void test_rest_and_particles(void **state) {
    (void)state;
    species rod = {.shape = SHAPE_ROD, .density = 1.01}, coccus = {.shape = SHAPE_COCCUS, .density = 1.01};
    assert_int_equal(species_particles(&rod), 2);
    assert_int_equal(species_particles(&coccus), 1);
    assert_true(species_rest(&coccus, 0.5, 1, 0) == 0);
    assert_true(species_rest(&rod, 2.45, 0.75, 0) == shape_rod_rest(2.45, 0.75, 1.01));
    double d = shape_rod_aspect_diameter(2.45, 4, 1.01);
    assert_near(species_rest(&rod, 2.45, 0.75, 4), 3 * d, 1e-15);
}

/* Growth keeps a rod's diameter, or its aspect, and a coccus keeps neither. */
static void test_cell_follows_its_mass(void **state) {
    (void)state;
    colony *c = colony_create();
    double x[6] = {0};
    species rod = {.shape = SHAPE_ROD, .density = 1.01}, coccus = {.shape = SHAPE_COCCUS, .density = 1.01};
    uint32_t thin = colony_add_cell(c, 2, x), alike = colony_add_cell(c, 2, x), ball = colony_add_cell(c, 1, x);
    c->cell.diameter[thin] = 0.75;
    c->cell.aspect[alike] = 3;
    for (double mass = 1; mass < 4; mass += 0.25) {
        c->cell.mass[thin] = c->cell.mass[alike] = c->cell.mass[ball] = mass;
        species_shape_cell(&rod, c, thin);
        species_shape_cell(&rod, c, alike);
        species_shape_cell(&coccus, c, ball);
        assert_true(c->cell.diameter[thin] == 0.75);
        assert_near(shape_rod_mass(c->cell.rest[thin], 0.75, 1.01), mass, 1e-14);
        assert_near(c->cell.rest[alike], 2 * c->cell.diameter[alike], 1e-14);
        assert_near(shape_rod_mass(c->cell.rest[alike], c->cell.diameter[alike], 1.01), mass, 1e-13);
        assert_true(c->cell.rest[ball] == 0);
        assert_near(shape_coccus_mass(c->cell.diameter[ball], 1.01), mass, 1e-14 * mass);
    }
    colony_free(c);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_table),
        cmocka_unit_test(test_rest_and_particles),
        cmocka_unit_test(test_cell_follows_its_mass),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}

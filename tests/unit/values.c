/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The table of values: its records are whole, and each value is what its definition says on scenes worked out by
 * hand. */
#include "check.h"

#include "analysis/value.h"
#include "engine/scene.h"

#include <stdlib.h>
#include <string.h>

static double cell_value(scene *s, const char *name, uint32_t row) {
    const value_style *style = value_find(name);
    assert_non_null(style);
    assert_int_equal(style->scope, VALUE_CELL);
    view v = scene_view(s);
    return style->cell(&v, row);
}

/* name or name.field of the whole scene. */
static double scene_value(scene *s, const char *name, const char *field) {
    double out[1 + VALUE_FIELDS_MAX];
    const value_style *style = value_find(name);
    assert_non_null(style);
    view v = scene_view(s);
    assert_int_equal(style->measure(&v, NULL, out, NULL), SARCINA_OK);
    int i = field ? value_field_find(style, field) : -1;
    assert_true(!field || i >= 0);
    return out[1 + i];
}

/* Two species with springs inside rods, collision and damping: k 1e5, reach 1.01, the published law. */
static scene *make(void) {
    scene *s = scene_create();
    species_add(&s->species, "rod");
    species_add(&s->species, "ball");
    species *rod = &s->species.list[0], *ball = &s->species.list[1];
    rod->shape = SHAPE_ROD;
    rod->density = 1.01;
    rod->internal_k = 5e4;
    ball->density = 1.1;
    s->forces.term[FORCE_INTERNAL].on = true;
    s->forces.term[FORCE_COLLISION] =
        (force_settings){true, {[COLLISION_K] = 1e5, [COLLISION_REACH] = 1.01, [COLLISION_CONTACT] = CONTACT_CLOSEST}};
    s->forces.term[FORCE_DAMPING] = (force_settings){true, {[DAMPING_K] = 100}};
    return s;
}

static uint32_t add(scene *s, int kind, const double *x, double mass, double diameter, double rest) {
    colony *c = s->colony;
    uint32_t row = colony_add_cell(c, kind ? 1 : 2, x);
    c->cell.species[row] = kind;
    c->cell.mass[row] = mass;
    c->cell.diameter[row] = diameter;
    c->cell.rest[row] = rest;
    c->cell.limit[row] = INFINITY;
    c->cell.founder[row] = c->cell.id[row];
    return row;
}

static void test_records_are_whole(void **state) {
    (void)state;
    for (size_t i = 0; i < value_style_count; i++) {
        const value_style *s = &value_styles[i];
        dim d;
        assert_ptr_equal(value_find(s->name), s);
        assert_true(strlen(s->summary) > 5 && s->summary[strlen(s->summary) - 1] != '.');
        assert_true(strcmp(s->dimension, "text") == 0 || dim_by_name(s->dimension, &d));
        bool is_text = strcmp(s->dimension, "text") == 0;
        assert_int_equal(s->scope == VALUE_CELL && !is_text, s->cell != NULL);
        assert_int_equal(is_text, s->text != NULL);
        assert_int_equal(s->scope != VALUE_CELL, s->measure != NULL);
        assert_true(value_field_count(s) <= VALUE_FIELDS_MAX);
        for (size_t j = 0; j < value_field_count(s); j++) {
            char name[32];
            value_field(s, j, name, &d);
            assert_int_equal(value_field_find(s, name), (int)j);
        }
    }
    assert_null(value_find("thicknes"));
    const value_style *ellipse = value_find("ellipse");
    char name[32];
    dim d;
    assert_int_equal(value_field_count(ellipse), 4);
    value_field(ellipse, 2, name, &d);
    assert_string_equal(name, "minor");
    assert_true(dim_equal(d, DIM_LENGTH) && dim_equal(value_dim(ellipse), DIM_AREA));
    assert_int_equal(value_field_find(ellipse, "min"), -1);
    assert_int_equal(value_field_find(ellipse, "aera"), -1);
}

static void test_every_value_of_an_empty_scene(void **state) {
    (void)state;
    scene *s = make();
    view v = scene_view(s);
    for (size_t i = 0; i < value_style_count; i++) {
        double out[1 + VALUE_FIELDS_MAX];
        if (value_styles[i].measure)
            assert_int_equal(value_styles[i].measure(&v, NULL, out, NULL), SARCINA_OK);
    }
    assert_near(scene_value(s, "cells", NULL), 0, 0);
    assert_near(scene_value(s, "energy", NULL), 0, 0);
    assert_near(scene_value(s, "fmax", NULL), 0, 0);
    assert_true(isnan(scene_value(s, "thickness", NULL)));
    assert_true(isnan(scene_value(s, "orientation", NULL)));
    scene_free(s);
}

static void test_identity_and_shape(void **state) {
    (void)state;
    scene *s = make();
    /* along (2, 1, 2)/3, 3 between its particles, centre (2, 0.5, 3) */
    uint32_t rod = add(s, 0, (double[6]){1, 0, 2, 3, 1, 4}, 2, 0.8, 2.5);
    uint32_t ball = add(s, 1, (double[3]){-9, 8, 7}, 0.55, 1.2, 0);
    colony *c = s->colony;
    c->cell.birth[rod] = 240;
    c->cell.limit[rod] = 2.5;
    c->cell.rate[rod] = 3e-4;
    c->cell.generation[rod] = 4;
    c->cell.parent[rod] = 17;
    c->cell.founder[rod] = 3;
    s->time = 960;
    const double v6[6] = {1, 2, 3, 3, 2, 1};
    memcpy(c->particle.v, v6, sizeof v6);
    const struct {
        const char *name;
        double rod, ball;
    } wanted[] = {
        {"id", 1, 2},
        {"parent", 17, 0},
        {"founder", 3, 2},
        {"generation", 4, 0},
        {"age", 720, 960},
        {"mass", 2, 0.55},
        {"stage", 0.8, 0},
        {"rate", 3e-4, 0},
        {"x", 2, -9},
        {"y", 0.5, 8},
        {"z", 3, 7},
        {"ux", 2 / 3.0, 0},
        {"uy", 1 / 3.0, 0},
        {"uz", 2 / 3.0, 0},
        {"zmin", 2, 7},
        {"zmax", 4, 7},
        {"length", 3.8, 1.2},
        {"diameter", 0.8, 1.2},
        {"volume", 2 / 1.01, 0.5},
        {"vx", 2, 0},
        {"vz", 2, 0},
        {"speed", 2 * sqrt(3), 0},
        {"shapex", 0.8, 1.2},
        {"shapey", 0.8, 1.2},
        {"shapez", 6, 0},
        {"contacts", 0, 0},
        {"overlap", 0, 0},
        {"stretch", 0.5, 0},
        {"strain", 0.2, 0},
        {"filial", 0, 0},
    };
    for (size_t i = 0; i < sizeof wanted / sizeof *wanted; i++) {
        assert_near(cell_value(s, wanted[i].name, rod), wanted[i].rod, 1e-14);
        assert_near(cell_value(s, wanted[i].name, ball), wanted[i].ball, 1e-14);
    }
    view v = scene_view(s);
    assert_string_equal(value_find("species")->text(&v, rod), "rod");
    assert_string_equal(value_find("species")->text(&v, ball), "ball");
    scene_free(s);
}

/* The rotation by (i, j, k, w) takes z to the axis, or to its opposite. */
static void test_quaternions(void **state) {
    (void)state;
    const double axes[][3] = {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {0, 0, -1}, {1, 2, 3}, {-2, 1, -0.5}, {-1, 0, -1e-9}};
    for (size_t i = 0; i < sizeof axes / sizeof *axes; i++) {
        scene *s = make();
        const double *u = axes[i], norm = sqrt(u[0] * u[0] + u[1] * u[1] + u[2] * u[2]);
        add(s, 0, (double[6]){0, 0, 0, u[0], u[1], u[2]}, 1, 0.5, 1);
        double x = cell_value(s, "quati", 0), y = cell_value(s, "quatj", 0), z = cell_value(s, "quatk", 0),
               w = cell_value(s, "quatw", 0);
        assert_near(x * x + y * y + z * z + w * w, 1, 1e-15);
        const double turned[3] = {2 * (x * z + w * y), 2 * (y * z - w * x), 1 - 2 * (x * x + y * y)};
        double cosine = (turned[0] * u[0] + turned[1] * u[1] + turned[2] * u[2]) / norm;
        assert_near(fabs(cosine), 1, 1e-15);
        scene_free(s);
    }
}

/* Two balls 0.9 apart of diameter 1: overlap 0.1, force k (1.01 - 0.9) each; a third within reach of the second only
 * by the 1 %. */
static void test_contacts_and_forces(void **state) {
    (void)state;
    scene *s = make();
    for (int i = 0; i < 4; i++)
        add(s, 1, (double[3]){(const double[]){0, 0.9, 1.905, 9}[i], 0, 0}, 0.5, 1, 0);
    const double contacts[] = {1, 2, 1, 0}, overlap[] = {0.1, 0.1, 0, 0};
    const double force[] = {-1e5 * 0.11, 1e5 * (0.11 - 0.005), 1e5 * 0.005, 0};
    for (uint32_t i = 0; i < 4; i++) {
        assert_near(cell_value(s, "contacts", i), contacts[i], 0);
        assert_near(cell_value(s, "overlap", i), overlap[i], 1e-14);
        assert_near(cell_value(s, "fx", i), force[i], 1e-9);
        assert_near(cell_value(s, "fy", i), 0, 1e-9);
    }
    assert_near(scene_value(s, "fmax", NULL), 1e5 * 0.11, 1e-9);
    assert_near(scene_value(s, "energy", "collision"), 0.5 * 1e5 * (0.11 * 0.11 + 0.005 * 0.005), 1e-9);
    s->colony->particle.v[1] = 3;
    assert_near(scene_value(s, "energy", "kinetic"), 0.5 * 0.5 * 9, 1e-14);
    assert_near(scene_value(s, "energy", NULL),
                scene_value(s, "energy", "collision") + scene_value(s, "energy", "kinetic"), 1e-9);
    scene_free(s);
}

static void set_spring(colony *c, uint32_t s, uint32_t a, uint32_t b, double k, double rest) {
    c->spring.a[s] = a;
    c->spring.b[s] = b;
    c->spring.k[s] = k;
    c->spring.rest[s] = rest;
}

static void test_links(void **state) {
    (void)state;
    scene *s = make();
    colony *c = s->colony;
    uint32_t rod = add(s, 0, (double[6]){0, 0, 1, 2, 0, 1}, 1, 0.5, 2.5); /* compressed: -0.5, strain -0.2 */
    uint32_t ball = add(s, 1, (double[3]){5, 0, 1}, 1, 0.5, 0), alone = add(s, 1, (double[3]){50, 0, 1}, 1, 0.5, 0);
    uint32_t stick = colony_add_link(c, LINK_STICK, c->cell.id[rod], c->cell.id[ball], 2);
    set_spring(c, c->link.first[stick], 0, 2, 100, 4);     /* 5 long: stretch 1, strain 0.25 */
    set_spring(c, c->link.first[stick] + 1, 1, 2, 100, 2); /* 3 long: stretch 1, strain 0.5 */
    uint32_t anchor = colony_add_link(c, LINK_ANCHOR, c->cell.id[ball], 0, 1);
    uint32_t a = c->link.first[anchor];
    set_spring(c, a, 2, SPRING_ANCHOR, 10, 0.25);
    c->spring.glides[a] = 1;
    c->spring.anchor[3 * a] = 99; /* a gliding anchor is below its particle wherever that is: 1 long, 0.75 over */
    s->forces.term[FORCE_SPRINGS].on = true;
    s->forces.term[FORCE_COLLISION].on = false;
    c->version++;
    assert_near(cell_value(s, "stretch", rod), 1, 1e-15);
    assert_near(cell_value(s, "strain", rod), 0.5, 1e-15);
    assert_near(cell_value(s, "stretch", ball), 1, 1e-15);
    assert_near(cell_value(s, "strain", ball), 3, 1e-15);
    assert_near(cell_value(s, "strain", alone), 0, 0);
    assert_near(cell_value(s, "stuck", rod), 1, 0);
    assert_near(cell_value(s, "stuck", ball), 1, 0);
    assert_near(cell_value(s, "anchored", ball), 1, 0);
    assert_near(cell_value(s, "anchored", rod), 0, 0);
    assert_near(cell_value(s, "cluster", ball), 1, 0);
    assert_near(cell_value(s, "cluster", alone), 3, 0);
    assert_near(scene_value(s, "energy", "stick"), 0.5 * 100 * (1 + 1), 1e-12);
    assert_near(scene_value(s, "energy", "anchor"), 0.5 * 10 * 0.75 * 0.75, 1e-13);
    assert_near(scene_value(s, "energy", "internal"), 0.5 * 5e4 * 0.25, 1e-11);
    /* the parts by link are what the mechanics give for all springs */
    view v = scene_view(s);
    assert_near(mechanics_energy(v.mechanics, FORCE_SPRINGS, c->particle.x),
                scene_value(s, "energy", "stick") + scene_value(s, "energy", "anchor"), 1e-12);
    scene_free(s);
}

/* A view keeps what it has computed, but a changed scene shows itself as it is. */
static void test_values_follow_the_scene(void **state) {
    (void)state;
    scene *s = make();
    add(s, 1, (double[3]){0, 0, 0}, 0.5, 1, 0);
    add(s, 1, (double[3]){0.9, 0, 0}, 0.5, 1, 0);
    assert_near(cell_value(s, "overlap", 0), 0.1, 1e-15);
    relax_result r;
    assert_int_equal(scene_relax(s, 1, 0, &r, NULL), SARCINA_OK);
    assert_true(cell_value(s, "overlap", 0) < 0.01);
    add(s, 1, (double[3]){0, 0.5, 0}, 0.5, 1, 0);
    assert_true(cell_value(s, "overlap", 0) > 0.4);
    scene_free(s);
}

/* Same bits for any order of rows: all values, per cell and of the whole. */
static void test_no_value_depends_on_the_order_of_rows(void **state) {
    (void)state;
    scene *s = make();
    for (int i = 0; i < 30; i++)
        add(s, i % 3 == 0, (double[6]){0.7 * (i % 6), 0.8 * (i / 6), 0.1 * i, 0.7 * (i % 6) + 1, 0.8 * (i / 6), 0.5},
            1 + 0.01 * i, 0.75 + 0.003 * i, 1.1);
    uint32_t rows[30];
    for (uint32_t i = 0; i < 30; i++)
        rows[i] = 7 * i % 30;
    for (size_t i = 0; i < value_style_count; i++) {
        const value_style *style = &value_styles[i];
        double before[64], after[64];
        for (int turn = 0; turn < 2; turn++) {
            double *out = turn ? after : before;
            memset(out, 0, sizeof before);
            view v = scene_view(s);
            if (style->measure)
                assert_int_equal(style->measure(&v, NULL, out, NULL), SARCINA_OK);
            for (uint64_t id = 1; id <= 30 && style->cell; id++)
                out[id] = style->cell(&v, colony_row(s->colony, id));
            colony_arrange(s->colony, rows, 30);
        }
        if (strcmp(style->name, "wall") != 0)
            assert_memory_equal(before, after, sizeof before);
    }
    scene_free(s);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_records_are_whole),       cmocka_unit_test(test_every_value_of_an_empty_scene),
        cmocka_unit_test(test_identity_and_shape),      cmocka_unit_test(test_quaternions),
        cmocka_unit_test(test_contacts_and_forces),     cmocka_unit_test(test_links),
        cmocka_unit_test(test_values_follow_the_scene), cmocka_unit_test(test_no_value_depends_on_the_order_of_rows),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}

/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Every record of the force table against what its caps promise, by loops over the table: nothing here knows a law.
 *
 * Contacts are torque-free under both laws: the force acts along p - q between the points p and q, and the lever rule
 * keeps force and moment. What differs is the gradient: the published law has none where two rods are parallel, so its
 * scene keeps rods out of parallel. */
#include "check.h"
#include "packing.h"

#include "mechanics/force_style.h"

typedef struct vector {
    double x, y, z;
} vector;

/* A crowd near the plane in which every term acts; anchors only where the test can bear them. */
static packing make_crowd(contact_law law, bool anchored) {
    packing p = packing_create(11);
    packing_fill(&p, &(packing_recipe){14, {5, 5, 0.6}, 0.7, 1, 3, 0.6, 1.1, 0.5});
    for (int i = 0; i < 2; i++)
        packing_coil(&p, (double[]){0.5 * i, 0.7 * i - 0.5, 0.6}, 0.6, 0.5, 0.1);
    packing_on(&p, FORCE_COLLISION, FORCE_GRAVITY);
    p.forces.term[FORCE_COLLISION].p[COLLISION_CONTACT] = law;
    for (uint32_t i = 0; i + 1 < 8; i++)
        packing_spring(&p, i, 0, i + 1, p.c->cell.nparticles[i + 1] - 1, 5e3 + 100 * i, 1.5 + 0.1 * i);
    for (uint32_t i = 0; anchored && i < 6; i++) {
        uint32_t s = packing_spring(&p, i, 0, SPRING_ANCHOR, 0, 1e4, 0.5);
        p.c->spring.glides[s] = i % 2;
        p.c->spring.anchor[3 * s] = packing_draw(&p, -1, 1);
    }
    return p;
}

static double largest(const double *f, size_t n) {
    double most = 0;
    for (size_t i = 0; i < n; i++)
        most = fmax(most, fabs(f[i]));
    return most;
}

static bool is_active(const packing *p, force_kind term) {
    return term == FORCE_INTERNAL || term == FORCE_SPRINGS || p->forces.term[term].on;
}

/* Central differences of the energy, over every coordinate. */
static void check_gradient(mechanics *m, const packing *p, force_kind term) {
    size_t n = 3 * p->c->particle.count;
    double *x = malloc(n * sizeof *x), *f = malloc(n * sizeof *f), h = 1e-5;
    memcpy(x, p->c->particle.x, n * sizeof *x);
    mechanics_force_of(m, term, x, NULL, f);
    double scale = largest(f, n);
    if (!(scale > 0))
        fail_msg("the scene does not exercise %s", force_styles[term]->name);
    for (size_t i = 0; i < n; i++) {
        double at = x[i];
        x[i] = at + h;
        double above = mechanics_energy(m, term, x);
        x[i] = at - h;
        double below = mechanics_energy(m, term, x);
        x[i] = at;
        assert_near((below - above) / (2 * h), f[i], 2e-6 * scale);
    }
    free(x);
    free(f);
}

static void test_gradient(void **state) {
    (void)state;
    for (int law = CONTACT_REGULARISED; law <= CONTACT_CLOSEST; law++) {
        packing p = make_crowd((contact_law)law, true);
        mechanics *m = packing_mechanics(&p, NEIGHBOR_CELLS, 1);
        for (int term = 0; term < FORCE_COUNT; term++)
            if (force_styles[term]->caps & FORCE_CONSERVATIVE)
                check_gradient(m, &p, (force_kind)term);
        mechanics_free(m);
        packing_free(&p);
    }
}

static void test_records(void **state) {
    (void)state;
    for (int term = 0; term < FORCE_COUNT; term++) {
        const force_style *s = force_styles[term];
        assert_non_null(s->name);
        for (int other = 0; other < term; other++)
            assert_string_not_equal(force_styles[other]->name, s->name);
        assert_true(s->summary && s->formula && s->source && s->example && (s->add || s->add_chain));
        assert_true(s->nparams <= PARAM_COUNT_MAX);
        assert_true(!(s->caps & FORCE_CONSERVATIVE) || s->energy || s->energy_chain);
        assert_true(!(s->caps & FORCE_WITHIN_CHAINS) || (s->add_chain && s->energy_chain && s->stiffness_chain));
        assert_true(!(s->caps & FORCE_CENTRAL) || s->caps & FORCE_BALANCED);
    }
}

/* Total force, and torque about a point off the centre, relative to the forces that cancel in them. */
static void check_balance(mechanics *m, const packing *p, force_kind term) {
    size_t n = p->c->particle.count;
    double *f = malloc(3 * n * sizeof *f), sum[3] = {0}, torque[3] = {0}, magnitude = 0;
    mechanics_force_of(m, term, p->c->particle.x, NULL, f);
    for (size_t i = 0; i < n; i++) {
        const double *x = p->c->particle.x + 3 * i, *g = f + 3 * i;
        double r[3] = {x[0] - 1, x[1] + 2, x[2] - 0.5};
        for (int k = 0; k < 3; k++) {
            sum[k] += g[k];
            torque[k] += r[(k + 1) % 3] * g[(k + 2) % 3] - r[(k + 2) % 3] * g[(k + 1) % 3];
            magnitude += fabs(g[k]);
        }
    }
    assert_true(magnitude > 0);
    for (int k = 0; k < 3; k++) {
        assert_near(sum[k], 0, 1e-14 * magnitude);
        if (force_styles[term]->caps & FORCE_CENTRAL)
            assert_near(torque[k], 0, 1e-13 * magnitude);
    }
    free(f);
}

static void test_balance(void **state) {
    (void)state;
    for (int law = CONTACT_REGULARISED; law <= CONTACT_CLOSEST; law++) {
        packing p = make_crowd((contact_law)law, false);
        mechanics *m = packing_mechanics(&p, NEIGHBOR_CELLS, 1);
        for (int term = 0; term < FORCE_COUNT; term++)
            if (force_styles[term]->caps & FORCE_BALANCED)
                check_balance(m, &p, (force_kind)term);
        mechanics_free(m);
        packing_free(&p);
    }
}

/* Turns about z, or about an oblique axis (1, 2, 2)/3, by one radian. */
static void rotate(double *v, bool oblique) {
    const double axis[3] = {oblique ? 1.0 / 3 : 0, oblique ? 2.0 / 3 : 0, oblique ? 2.0 / 3 : 1};
    double along = axis[0] * v[0] + axis[1] * v[1] + axis[2] * v[2], out[3];
    for (int k = 0; k < 3; k++)
        out[k] = v[k] * cos(1) + (axis[(k + 1) % 3] * v[(k + 2) % 3] - axis[(k + 2) % 3] * v[(k + 1) % 3]) * sin(1) +
                 axis[k] * along * (1 - cos(1));
    memcpy(v, out, sizeof out);
}

static void check_rotation(const packing *p, mechanics *m, force_kind term, bool oblique) {
    size_t n = p->c->particle.count;
    double *x = malloc(3 * n * sizeof *x), *v = malloc(3 * n * sizeof *v), *f = malloc(3 * n * sizeof *f),
           *g = malloc(3 * n * sizeof *g);
    memcpy(x, p->c->particle.x, 3 * n * sizeof *x);
    memcpy(v, p->c->particle.v, 3 * n * sizeof *v);
    mechanics_force_of(m, term, x, v, f);
    for (size_t i = 0; i < n; i++) {
        rotate(x + 3 * i, oblique);
        rotate(v + 3 * i, oblique);
        rotate(f + 3 * i, oblique);
    }
    mechanics_force_of(m, term, x, v, g);
    for (size_t i = 0; i < 3 * n; i++)
        assert_near(g[i], f[i], 1e-10 * largest(f, 3 * n));
    free(x);
    free(v);
    free(f);
    free(g);
}

static void test_rotation(void **state) {
    (void)state;
    for (int law = CONTACT_REGULARISED; law <= CONTACT_CLOSEST; law++) {
        packing p = make_crowd((contact_law)law, false);
        mechanics *m = packing_mechanics(&p, NEIGHBOR_CELLS, 1);
        for (int term = 0; term < FORCE_COUNT; term++) {
            check_rotation(&p, m, (force_kind)term, false);
            if (force_styles[term]->caps & FORCE_BALANCED)
                check_rotation(&p, m, (force_kind)term, true);
        }
        mechanics_free(m);
        packing_free(&p);
    }
}

/* Terms between cells feel no translation, terms of the plane none along it. */
static void test_translation(void **state) {
    (void)state;
    packing p = make_crowd(CONTACT_REGULARISED, false);
    mechanics *m = packing_mechanics(&p, NEIGHBOR_CELLS, 1);
    size_t n = 3 * p.c->particle.count;
    double *x = malloc(n * sizeof *x), *f = malloc(n * sizeof *f), *g = malloc(n * sizeof *g);
    for (int term = 0; term < FORCE_COUNT; term++) {
        bool balanced = force_styles[term]->caps & FORCE_BALANCED;
        const double shift[3] = {1000, -70, balanced ? 33 : 0};
        for (size_t i = 0; i < n; i++)
            x[i] = p.c->particle.x[i] + shift[i % 3];
        mechanics_force_of(m, (force_kind)term, p.c->particle.x, p.c->particle.v, f);
        mechanics_force_of(m, (force_kind)term, x, p.c->particle.v, g);
        for (size_t i = 0; i < n; i++)
            assert_near(g[i], f[i], 1e-9 * largest(f, n));
    }
    free(x);
    free(f);
    free(g);
    mechanics_free(m);
    packing_free(&p);
}

/* Rows in another order: the same bits for every cell, all terms together and each alone. */
static void test_renumbering(void **state) {
    (void)state;
    packing p = make_crowd(CONTACT_REGULARISED, true);
    size_t cells = p.c->cell.count, n = p.c->particle.count;
    mechanics *m = packing_mechanics(&p, NEIGHBOR_CELLS, 1);
    double *f = malloc((FORCE_COUNT + 1) * 3 * n * sizeof *f), *g = malloc(3 * n * sizeof *g);
    uint32_t *rows = malloc(cells * sizeof *rows), *first = malloc(cells * sizeof *first);
    for (int term = 0; term < FORCE_COUNT; term++)
        mechanics_force_of(m, (force_kind)term, p.c->particle.x, p.c->particle.v, f + 3 * n * (size_t)term);
    mechanics_force(m, p.c->particle.x, p.c->particle.v, f + 3 * n * FORCE_COUNT);
    memcpy(first, p.c->cell.first, cells * sizeof *first); /* row = id - 1 */
    for (uint32_t i = 0; i < cells; i++)
        rows[i] = i * 5 % (uint32_t)cells; /* 5 and 16 have no common divisor */
    colony_arrange(p.c, rows, cells);
    assert_int_equal(packing_bind(&p, m, NEIGHBOR_CELLS, 1, NULL), SARCINA_OK);
    for (int term = 0; term <= FORCE_COUNT; term++) {
        if (term < FORCE_COUNT)
            mechanics_force_of(m, (force_kind)term, p.c->particle.x, p.c->particle.v, g);
        else
            mechanics_force(m, p.c->particle.x, p.c->particle.v, g);
        for (size_t i = 0; i < cells; i++)
            assert_memory_equal(g + 3 * p.c->cell.first[i], f + 3 * (n * (size_t)term + first[p.c->cell.id[i] - 1]),
                                3 * p.c->cell.nparticles[i] * sizeof *g);
    }
    free(f);
    free(g);
    free(rows);
    free(first);
    mechanics_free(m);
    packing_free(&p);
}

/* Only what the script names acts. */
static void test_inactive(void **state) {
    (void)state;
    packing p = packing_create(3);
    packing_fill(&p, &(packing_recipe){5, {2, 2, 1}, 0, 0, 0, 1, 1, 1});
    mechanics *m = packing_mechanics(&p, NEIGHBOR_CELLS, 1);
    double f[15];
    mechanics_force(m, p.c->particle.x, p.c->particle.v, f);
    assert_true(largest(f, 15) == 0);
    assert_int_equal(mechanics_statistics(m).builds, 0);
    for (int term = 0; term < FORCE_COUNT; term++)
        assert_true(mechanics_energy(m, (force_kind)term, p.c->particle.x) == 0);
    assert_true(is_active(&p, FORCE_SPRINGS) && mechanics_stiffness(m, p.c->particle.x) == 0);
    mechanics_free(m);
    packing_free(&p);
}

/* What a term needs and the scene lacks is an error that says what to write. */
static void test_prepare(void **state) {
    (void)state;
    packing p = packing_create(3);
    mechanics *m = mechanics_create();
    diag d = {0};
    p.forces.term[FORCE_DLVO].on = true;
    assert_int_equal(packing_bind(&p, m, NEIGHBOR_CELLS, 1, &d), SARCINA_ERROR);
    assert_non_null(strstr(d.message, "dlvo"));
    assert_non_null(strstr(d.help, "substratum plane"));
    p.forces.term[FORCE_SUBSTRATUM].on = true;
    assert_int_equal(packing_bind(&p, m, NEIGHBOR_CELLS, 1, &d), SARCINA_OK);
    p.species.list[PACKING_ROD].internal_k = 0;
    packing_rod(&p, (double[]){0, 0, 1}, (double[]){2, 0, 1}, 2, 0.8);
    assert_int_equal(packing_bind(&p, m, NEIGHBOR_CELLS, 1, &d), SARCINA_ERROR);
    assert_non_null(strstr(d.message, "species rod is a rod without link internal"));
    assert_non_null(strstr(d.help, "link internal rod"));
    mechanics_free(m);
    packing_free(&p);
}

/* Springs and contacts without a direction act all the same, with opposite forces, and never give a NaN. */
static void test_zero_length(void **state) {
    (void)state;
    packing p = packing_create(3);
    p.forces.term[FORCE_COLLISION].on = true;
    packing_rod(&p, (double[]){0, 0, 1}, (double[]){0, 0, 1}, 2, 0.8);
    packing_coccus(&p, (double[]){9, 0, 1}, 1);
    packing_coccus(&p, (double[]){9, 0, 1}, 1);
    packing_rod(&p, (double[]){19, 0, 1}, (double[]){21, 0, 1}, 2, 0.8); /* two axes that cross */
    packing_rod(&p, (double[]){20, -1, 1}, (double[]){20, 1, 1}, 2, 0.8);
    packing_spring(&p, 1, 0, 2, 0, 1e3, 1.5);
    mechanics *m = packing_mechanics(&p, NEIGHBOR_CELLS, 1);
    double f[24];
    mechanics_force(m, p.c->particle.x, p.c->particle.v, f);
    for (int i = 0; i < 24; i++)
        assert_true(isfinite(f[i]));
    double rod = 0, cocci = 0, crossing = 0;
    for (int k = 0; k < 3; k++) {
        assert_true(f[k] == -f[3 + k]);
        assert_true(f[6 + k] == -f[9 + k]);
        assert_near(f[12 + k] + f[15 + k] + f[18 + k] + f[21 + k], 0, 1e-9);
        rod += f[k] * f[k];
        cocci += f[6 + k] * f[6 + k];
        crossing += (f[12 + k] + f[15 + k]) * (f[12 + k] + f[15 + k]);
    }
    assert_near(sqrt(rod), 5e4 * 2, 1e-6);
    assert_near(sqrt(cocci), 1e5 * 1.01, 1e3 * 1.5); /* contact and spring, along directions of their own */
    assert_true(sqrt(crossing) > 0.9 * 1e5 * 0.8);
    mechanics_free(m);
    packing_free(&p);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_records),  cmocka_unit_test(test_gradient),    cmocka_unit_test(test_balance),
        cmocka_unit_test(test_rotation), cmocka_unit_test(test_translation), cmocka_unit_test(test_renumbering),
        cmocka_unit_test(test_inactive), cmocka_unit_test(test_prepare),     cmocka_unit_test(test_zero_length),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}

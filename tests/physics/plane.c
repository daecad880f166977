/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Two dimensions: the same bits as three have where every z is 0, no z ever, a third less of every vector, fallback
 * directions in the plane. What work it saves is counted by tests/bench/term_cost. */
#include "check.h"
#include "packing.h"

#include "base/rng.h"
#include "mechanics/kernel.h"
#include "mechanics/remodel.h"
#include "relax/integrator.h"

static mechanics *bind(const packing *p, bool flat, neighbor_method method) {
    mechanics_input in = packing_input(p, method, 1);
    in.flat = flat;
    mechanics *m = mechanics_create();
    assert_int_equal(mechanics_prepare(m, &in, NULL), SARCINA_OK);
    return m;
}

/* Rods (a part of them; the rest cocci) in the plane, that overlap, move in it, and stick. */
static packing make(double rods, uint64_t seed) {
    packing p = packing_create(seed);
    const packing_recipe r = {60, {9, 9, 0}, rods, 1, 2.5, 0.7, 0.9, 0};
    packing_fill(&p, &r);
    for (size_t i = 0; i < p.c->particle.count; i++)
        p.c->particle.x[3 * i + 2] = p.c->particle.v[3 * i + 2] = 0;
    packing_on(&p, FORCE_COLLISION, FORCE_COLLISION);
    packing_on(&p, FORCE_DAMPING, FORCE_DAMPING);
    const double stick[LINK_PARAMS_MAX] = {1e4, 0.1, 0.3};
    packing_rule(&p, LINK_STICK, PACKING_ROD, PACKING_COCCUS, stick);
    packing_rule(&p, LINK_STICK, PACKING_ROD, PACKING_ROD, stick);
    return p;
}

static void relax(packing *p, bool flat, neighbor_method method, int kind, const char *kernel) {
    mechanics *m = bind(p, flat, method);
    assert_true(mechanics_kernel(m, kernel));
    const relax_settings how = {.integrator = (integrator_kind)kind, .tolerance = 1e-2};
    bool minimises = integrator_styles[kind]->caps & INTEGRATOR_MINIMISES;
    const relax_goal goal = minimises ? (relax_goal){.time = INFINITY, .force = 10} : (relax_goal){.time = 0.05};
    assert_int_equal(relax_run(m, &how, &goal, NULL, NULL), SARCINA_OK);
    mechanics_free(m);
}

/* Each integrator, mixtures of rods and cocci, both methods of finding neighbours. */
static void test_same_bits(void **state) {
    (void)state;
    for (int kind = 0; kind < INTEGRATOR_COUNT; kind++)
        for (int rods = 0; rods <= 2; rods++) {
            neighbor_method method = kind % 2 ? NEIGHBOR_PAIRS : NEIGHBOR_CELLS;
            packing space = make(0.5 * rods, 3), plane = make(0.5 * rods, 3);
            relax(&space, false, method, kind, "base");
            relax(&plane, true, method, kind, kind % 2 ? "base" : kernel_best()->name);
            const colony *a = space.c, *b = plane.c;
            size_t bytes = 3 * a->particle.count * sizeof(double);
            assert_memory_equal(a->particle.x, b->particle.x, bytes);
            assert_int_equal(a->link.count, b->link.count);
            assert_true(rods == 0 || a->link.count > 0);
            for (size_t i = 0; i < 3 * b->particle.count; i++)
                assert_true(i % 3 < 2 ? a->particle.v[i] == b->particle.v[i]
                                      : b->particle.x[i] == 0 && b->particle.v[i] == 0);
            packing_free(&space);
            packing_free(&plane);
        }
}

/* Cells in one place, and rods without length, go apart in the plane; in space they leave it. */
static void test_coincident(void **state) {
    (void)state;
    for (int flat = 0; flat <= 1; flat++) {
        packing p = packing_create(1);
        const double at[3] = {1, 2, 0};
        for (int i = 0; i < 6; i++) {
            packing_coccus(&p, at, 0.8);
            packing_rod(&p, at, at, 2, 0.8);
        }
        packing_on(&p, FORCE_COLLISION, FORCE_COLLISION);
        packing_on(&p, FORCE_DAMPING, FORCE_DAMPING);
        relax(&p, flat, NEIGHBOR_CELLS, INTEGRATOR_VERLET, "base");
        double apart = 0, out = 0;
        for (size_t i = 0; i < p.c->particle.count; i++) {
            apart = fmax(apart, fabs(p.c->particle.x[3 * i] - at[0]));
            out = fmax(out, fabs(p.c->particle.x[3 * i + 2]));
        }
        assert_true(apart > 0.1);
        assert_true(flat ? out == 0 : out > 0.01);
        packing_free(&p);
    }
}

/* What is measured of the colony is the same, too, and leaves it as it was; so does a relaxation that fails. */
static void test_measures(void **state) {
    (void)state;
    packing p = make(0.5, 5);
    mechanics *m[2] = {bind(&p, false, NEIGHBOR_CELLS), bind(&p, true, NEIGHBOR_CELLS)};
    const size_t ncells = p.c->cell.count, bytes = 3 * p.c->particle.count * sizeof(double);
    double *x = malloc(bytes), *v = malloc(bytes), *force[2], *overlap[2];
    uint32_t *contacts[2];
    memcpy(x, p.c->particle.x, bytes);
    memcpy(v, p.c->particle.v, bytes);
    for (int i = 0; i < 2; i++) {
        force[i] = calloc(3 * ncells, sizeof(double));
        overlap[i] = calloc(ncells, sizeof(double));
        contacts[i] = calloc(ncells, sizeof(uint32_t));
        mechanics_contacts(m[i], overlap[i], contacts[i], force[i]);
    }
    assert_memory_equal(force[0], force[1], 3 * ncells * sizeof(double));
    assert_memory_equal(overlap[0], overlap[1], ncells * sizeof(double));
    assert_memory_equal(contacts[0], contacts[1], ncells * sizeof(uint32_t));
    assert_true(mechanics_fmax(m[0]) > 0 && mechanics_fmax(m[0]) == mechanics_fmax(m[1]));
    assert_true(mechanics_kinetic(m[0]) > 0 && mechanics_kinetic(m[0]) == mechanics_kinetic(m[1]));
    for (int term = 0; term < FORCE_COUNT; term++)
        assert_true(mechanics_energy(m[0], (force_kind)term, NULL) == mechanics_energy(m[1], (force_kind)term, NULL));
    assert_true(mechanics_energy(m[1], FORCE_COLLISION, NULL) > 0 && mechanics_energy(m[1], FORCE_INTERNAL, NULL) > 0);
    const relax_settings how = {.integrator = INTEGRATOR_VERLET};
    const volatile sig_atomic_t stop = 1;
    relax_result r;
    assert_int_equal(relax_run(m[1], &how, &(relax_goal){.time = 1, .interrupt = &stop}, &r, NULL), SARCINA_OK);
    assert_int_equal(r.stop, RELAX_INTERRUPTED);
    assert_memory_equal(p.c->particle.x, x, bytes);
    assert_memory_equal(p.c->particle.v, v, bytes);
    for (int i = 0; i < 2; i++) {
        free(force[i]);
        free(overlap[i]);
        free(contacts[i]);
        mechanics_free(m[i]);
    }
    free(x);
    free(v);
    packing_free(&p);
}

static size_t part(const mechanics *m, const char *name) {
    mechanics_part parts[MECHANICS_PARTS];
    mechanics_memory(m, parts);
    for (int i = 0; i < MECHANICS_PARTS; i++)
        if (strcmp(parts[i].name, name) == 0)
            return parts[i].bytes;
    fail_msg("no part %s", name);
    return 0;
}

/* Of every vector a third is not there, exactly: a number a particle in the forces, two a body in its capsule, two in
 * where it was when the list was built. */
static void test_memory(void **state) {
    (void)state;
    for (int rods = 0; rods <= 1; rods++) {
        packing p = make(rods, 5);
        mechanics *space = bind(&p, false, NEIGHBOR_CELLS), *plane = bind(&p, true, NEIGHBOR_CELLS);
        mechanics_fmax(space);
        mechanics_fmax(plane);
        const size_t bodies = p.c->cell.count + CAPSULES_NOWHERE + p.c->cell.count / 2, number = sizeof(double);
        const size_t particles = p.c->particle.count + p.c->particle.count / 2;
        assert_int_equal(part(space, "bodies") - part(plane, "bodies"), particles * number);
        assert_int_equal(part(space, "capsules") - part(plane, "capsules"), bodies * 4 * number);
        assert_int_equal(part(space, "capsules"), bodies * (12 + 2) * number);
        mechanics_input in = packing_input(&p, NEIGHBOR_CELLS, 1);
        assert_int_equal(mechanics_prepare(space, &in, NULL), SARCINA_OK);
        assert_int_equal(mechanics_prepare(plane, &in, NULL), SARCINA_OK); /* and is there again in space */
        mechanics_fmax(plane);
        assert_int_equal(part(space, "capsules"), part(plane, "capsules"));
        assert_int_equal(part(space, "bodies"), part(plane, "bodies"));
        assert_true(mechanics_fmax(space) == mechanics_fmax(plane));
        mechanics_free(space);
        mechanics_free(plane);
        packing_free(&p);
    }
}

static void test_directions(void **state) {
    (void)state;
    enum { N = 20000 };
    double sum[2] = {0}, square = 0;
    for (uint64_t i = 0; i < N; i++) {
        double u[3], back[3];
        rng_direction_flat(11, i, i + 1 + i % 7, u);
        rng_direction_flat(11, i + 1 + i % 7, i, back);
        assert_true(u[2] == 0 && back[0] == -u[0] && back[1] == -u[1]);
        assert_near(u[0] * u[0] + u[1] * u[1], 1, 1e-14);
        sum[0] += u[0];
        sum[1] += u[1];
        square += u[0] * u[0];
    }
    assert_near(sum[0] / N, 0, 5 * sqrt(0.5 / N));
    assert_near(sum[1] / N, 0, 5 * sqrt(0.5 / N));
    assert_near(square / N, 0.5, 5 * sqrt(0.125 / N)); /* variance of cos^2: 3/8 - 1/4 */
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_same_bits), cmocka_unit_test(test_coincident), cmocka_unit_test(test_measures),
        cmocka_unit_test(test_memory),    cmocka_unit_test(test_directions),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}

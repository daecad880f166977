/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Whole relaxations: crowds that overlap come to rest without blowing up, extremes are borne or refused with a reason,
 * and neither threads nor the order of rows change a bit. */
#include "check.h"
#include "packing.h"

#include "relax/integrator.h"

static const packing_recipe crowd = {150, {9, 9, 3}, 0.6, 1, 3.5, 0.5, 1, 0.6};

static packing make(uint64_t seed, const packing_recipe *recipe) {
    packing p = packing_create(seed);
    packing_fill(&p, recipe);
    packing_on(&p, FORCE_COLLISION, FORCE_DAMPING);
    return p;
}

static double potential(mechanics *m, const packing *p) {
    double sum = 0;
    for (int term = 0; term < FORCE_COUNT; term++)
        sum += mechanics_energy(m, (force_kind)term, p->c->particle.x);
    return sum;
}

static double farthest(const packing *p) {
    double most = 0;
    for (size_t i = 0; i < 3 * p->c->particle.count; i++)
        most = fmax(most, isfinite(p->c->particle.x[i]) ? fabs(p->c->particle.x[i]) : (double)INFINITY);
    return most;
}

/* Every preset, crowds with overlaps of whole diameters. */
static void test_dense_crowds(void **state) {
    (void)state;
    for (size_t preset = 0; preset < accuracy_preset_count; preset++)
        for (uint64_t seed = 1; seed <= 2; seed++) {
            packing p = make(seed, &crowd);
            mechanics *m = packing_mechanics(&p, NEIGHBOR_CELLS, 1);
            double before = potential(m, &p) + mechanics_kinetic(m);
            relax_result result;
            diag d = {0};
            int status = relax_run(m, &accuracy_presets[preset].settings, &(relax_goal){.time = 1}, &result, &d);
            if (status)
                fail_msg("%s: %s", accuracy_presets[preset].name, d.message);
            assert_true(result.time == 1 && result.stop == RELAX_TIME);
            assert_true(potential(m, &p) + mechanics_kinetic(m) < 0.1 * before);
            assert_true(farthest(&p) < 40);
            mechanics_free(m);
            packing_free(&p);
        }
}

/* Cells that grow by a tenth again and again in a crowd. */
static void test_growing_crowd(void **state) {
    (void)state;
    packing p = make(5, &(packing_recipe){60, {6, 6, 0.5}, 0.7, 1, 2.5, 0.6, 0.8, 0.1});
    mechanics *m = mechanics_create();
    for (int step = 0; step < 12; step++) {
        for (uint32_t i = 0; i < p.c->cell.count; i++) {
            p.c->cell.mass[i] *= 1.1;
            p.species.list[PACKING_ROD].diameter = spread_fixed(0.7);
            species_shape_cell(&p.species.list[p.c->cell.species[i]], p.c, i);
        }
        assert_int_equal(packing_bind(&p, m, NEIGHBOR_CELLS, 1, NULL), SARCINA_OK);
        const relax_settings how = {.integrator = INTEGRATOR_VERLET, .most = 1e-3};
        assert_int_equal(relax_run(m, &how, &(relax_goal){.time = 1}, NULL, NULL), SARCINA_OK);
        assert_true(farthest(&p) < 60);
    }
    double overlap[60], deepest = 0;
    mechanics_contacts(m, overlap, NULL, NULL);
    for (int i = 0; i < 60; i++)
        deepest = fmax(deepest, overlap[i]);
    assert_true(deepest < 0.1);
    mechanics_free(m);
    packing_free(&p);
}

static int relax_scaled(double stiffer, double lighter, diag *d) {
    packing p = make(1, &(packing_recipe){20, {4, 4, 1}, 0.6, 1, 3, 0.5, 1, 0.6});
    p.forces.term[FORCE_COLLISION].p[COLLISION_K] *= stiffer;
    for (size_t i = 0; i < p.c->cell.count; i++)
        p.c->cell.mass[i] /= lighter;
    mechanics *m = packing_mechanics(&p, NEIGHBOR_CELLS, 1);
    const relax_settings how = {.integrator = INTEGRATOR_VERLET, .most = 1e-3};
    relax_result result = {0};
    int status = relax_run(m, &how, &(relax_goal){.time = 0.05}, &result, d);
    assert_true(status || farthest(&p) < 100);
    mechanics_free(m);
    packing_free(&p);
    return status;
}

/* The step comes from the stiffness: what a fixed step does not bear; beyond the shortest step a reason is given. */
static void test_extremes(void **state) {
    (void)state;
    diag d = {0};
    assert_int_equal(relax_scaled(1e3, 1, &d), SARCINA_OK);
    assert_int_equal(relax_scaled(1, 1e3, &d), SARCINA_OK);
    assert_int_equal(relax_scaled(1e13, 1, &d), SARCINA_NUMERICAL);
    assert_non_null(strstr(d.message, "collision k 1e+03 N/m"));
    assert_non_null(strstr(d.message, "needs steps below"));
    assert_non_null(strstr(d.help, "steps below 0.25 us"));
}

/* Coincident cells come apart, each pair in a direction of its own. */
static void test_coincident(void **state) {
    (void)state;
    packing p = packing_create(2);
    packing_on(&p, FORCE_COLLISION, FORCE_DAMPING);
    for (int i = 0; i < 10; i++)
        packing_coccus(&p, (double[]){0, 0, 3}, 0.8);
    mechanics *m = packing_mechanics(&p, NEIGHBOR_CELLS, 1);
    const relax_settings how = {.integrator = INTEGRATOR_VERLET, .most = 1e-3};
    assert_int_equal(relax_run(m, &how, &(relax_goal){.time = 1}, NULL, NULL), SARCINA_OK);
    double overlap[10];
    mechanics_contacts(m, overlap, NULL, NULL);
    for (int i = 0; i < 10; i++)
        assert_true(overlap[i] < 0.05);
    mechanics_free(m);
    packing_free(&p);
}

/* Some steps of an integrator; of a minimiser, which knows no time, some evaluations. */
static relax_goal goal_of(integrator_kind kind, double time) {
    if (integrator_styles[kind]->caps & INTEGRATOR_MINIMISES)
        return (relax_goal){.time = INFINITY, .force = 1e-3, .evaluations = 20};
    return (relax_goal){.time = time};
}

static void relax_threads(packing *p, integrator_kind kind, int threads) {
    mechanics *m = packing_mechanics(p, NEIGHBOR_CELLS, threads);
    const relax_settings how = {.integrator = kind, .most = 1e-3};
    const relax_goal goal = goal_of(kind, 0.012);
    relax_result r;
    assert_int_equal(relax_run(m, &how, &goal, &r, NULL), SARCINA_OK);
    assert_true(r.steps >= 5);
    mechanics_free(m);
}

/* One and two threads, and rows in another order: the same bits after many steps of every integrator. */
static void test_same_bits(void **state) {
    (void)state;
    const packing_recipe large = {600, {20, 20, 4}, 0.6, 1, 3.5, 0.5, 1, 0.6};
    for (int kind = 0; kind < INTEGRATOR_COUNT; kind++) {
        packing one = make(3, &large), two = make(3, &large), other = make(3, &large);
        uint32_t rows[600];
        for (uint32_t i = 0; i < 600; i++)
            rows[i] = i * 7 % 600;
        colony_arrange(other.c, rows, 600);
        relax_threads(&one, (integrator_kind)kind, 1);
        relax_threads(&two, (integrator_kind)kind, 2);
        relax_threads(&other, (integrator_kind)kind, 1);
        size_t bytes = 3 * one.c->particle.count * sizeof(double);
        assert_memory_equal(one.c->particle.x, two.c->particle.x, bytes);
        assert_memory_equal(one.c->particle.v, two.c->particle.v, bytes);
        for (size_t i = 0; i < 600; i++) {
            const double *x = other.c->particle.x + 3 * (size_t)other.c->cell.first[i];
            size_t same = one.c->cell.first[other.c->cell.id[i] - 1];
            assert_memory_equal(x, one.c->particle.x + 3 * same, 3 * other.c->cell.nparticles[i] * sizeof *x);
        }
        packing_free(&one);
        packing_free(&two);
        packing_free(&other);
    }
}

enum { RODS = 64 };

/* Relaxes an array of rods that have grown by a twentieth where they lay; their positions into x (nparticles x 3).
 * Returns evaluations. */
static uint64_t relax_grown(const relax_settings *how, double drag, double *x) {
    packing p = packing_create(1);
    for (int i = 0; i < RODS; i++) {
        int row = i / 8;
        double left = 2.8 * (i % 8) + 1.4 * (row % 2), y = 0.75 * row, z = 0.375 + 0.02 * (i * 7 % 5);
        packing_rod(&p, (double[]){left, y, z}, (double[]){left + 2, y, z}, 2.1, 0.75);
    }
    packing_on(&p, FORCE_COLLISION, FORCE_DAMPING);
    p.forces.term[FORCE_DAMPING].on = drag > 0;
    p.forces.term[FORCE_DAMPING].p[0] = drag;
    mechanics *m = packing_mechanics(&p, NEIGHBOR_CELLS, 1);
    relax_result result;
    assert_int_equal(relax_run(m, how, &(relax_goal){.time = 1}, &result, NULL), SARCINA_OK);
    memcpy(x, p.c->particle.x, 3 * p.c->particle.count * sizeof *x);
    mechanics_free(m);
    packing_free(&p);
    return result.evaluations;
}

static double distance_rms(const double *a, const double *b, size_t n) {
    double sum = 0;
    for (size_t i = 0; i < n; i++)
        sum += (a[i] - b[i]) * (a[i] - b[i]);
    return sqrt(3 * sum / (double)n);
}

/* Inertia that fades saves steps and little else: the end is as near the converged one as without it. Where nothing
 * damps, and with a fixed step, it changes no bit. */
static void test_inertia(void **state) {
    (void)state;
    static double best[3 * 2 * RODS], plain[3 * 2 * RODS], faded[3 * 2 * RODS];
    const relax_settings converged = {.integrator = INTEGRATOR_VERLET, .most = 1e-4};
    relax_settings how = {.integrator = INTEGRATOR_VERLET, .most = 2e-3}, fading = how;
    fading.inertia = 0.07;
    relax_grown(&converged, 100, best);
    uint64_t steps = relax_grown(&how, 100, plain), fewer = relax_grown(&fading, 100, faded);
    assert_true((double)fewer < 0.6 * (double)steps);
    assert_true(distance_rms(faded, best, 3 * 2 * RODS) < 1.1 * distance_rms(plain, best, 3 * 2 * RODS));
    assert_true(distance_rms(faded, plain, 3 * 2 * RODS) > 0);
    assert_int_equal(relax_grown(&how, 0, plain), relax_grown(&fading, 0, faded));
    assert_memory_equal(plain, faded, sizeof plain);
    how.step = fading.step = 1e-3;
    relax_grown(&how, 100, plain);
    relax_grown(&fading, 100, faded);
    assert_memory_equal(plain, faded, sizeof plain);
}

/* Stops: by force, by interruption, at once; and a scene without cells. */
static void test_stops(void **state) {
    (void)state;
    packing p = make(1, &(packing_recipe){10, {3, 3, 1}, 0.5, 1, 2, 0.5, 1, 0.6});
    mechanics *m = packing_mechanics(&p, NEIGHBOR_CELLS, 1);
    relax_result result;
    const volatile sig_atomic_t raised = 1;
    for (int kind = 0; kind < INTEGRATOR_COUNT; kind++) {
        const relax_settings how = {.integrator = (integrator_kind)kind, .most = 1e-3};
        relax_goal goal = goal_of((integrator_kind)kind, 1);
        goal.interrupt = &raised;
        assert_int_equal(relax_run(m, &how, &goal, &result, NULL), SARCINA_OK);
        assert_int_equal(result.stop, RELAX_INTERRUPTED);
        assert_int_equal(result.steps, 0);
    }
    const relax_settings how = {.integrator = INTEGRATOR_VERLET, .most = 1e-3};
    assert_int_equal(relax_run(m, &how, &(relax_goal){.time = 60, .force = 200}, &result, NULL), SARCINA_OK);
    assert_int_equal(result.stop, RELAX_FORCE);
    assert_true(result.time < 60 && result.fmax < 200);
    assert_near(mechanics_fmax(m), result.fmax, 1e-6 * result.fmax);
    assert_int_equal(relax_run(m, &how, &(relax_goal){.time = 0}, &result, NULL), SARCINA_OK);
    assert_true(result.time == 0 && result.stop == RELAX_TIME);
    mechanics_free(m);
    packing_free(&p);

    packing empty = packing_create(1);
    m = packing_mechanics(&empty, NEIGHBOR_CELLS, 1);
    assert_int_equal(relax_run(m, &how, &(relax_goal){.time = 2}, &result, NULL), SARCINA_OK);
    assert_true(result.time == 2 && mechanics_fmax(m) == 0);
    mechanics_free(m);
    packing_free(&empty);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_dense_crowds), cmocka_unit_test(test_growing_crowd), cmocka_unit_test(test_extremes),
        cmocka_unit_test(test_coincident),   cmocka_unit_test(test_same_bits),     cmocka_unit_test(test_inertia),
        cmocka_unit_test(test_stops),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}

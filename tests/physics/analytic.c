/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Cases with a solution on paper: damped oscillators of contacts and rods, their overdamped limit, the gap over the
 * substratum, the force and moment of an off-centre contact, sinking. */
#include "check.h"
#include "packing.h"

#include "relax/relax.h"

/* x'' = -g x' - w2 x from x0 at rest. */
static double oscillator(double x0, double w2, double g, double t) {
    double a = 0.5 * g, square = w2 - a * a;
    if (square > 0) {
        double w = sqrt(square);
        return x0 * exp(-a * t) * (cos(w * t) + a / w * sin(w * t));
    }
    double b = sqrt(-square), slow = -a + b, fast = -a - b;
    return x0 * (slow * exp(fast * t) - fast * exp(slow * t)) / (slow - fast);
}

static void relax_for(packing *p, integrator_kind kind, double time, double most) {
    mechanics *m = packing_mechanics(p, NEIGHBOR_CELLS, 1);
    const relax_settings how = {.integrator = kind, .tolerance = 1e-7, .most = most};
    assert_int_equal(relax_run(m, &how, &(relax_goal){.time = time}, NULL, NULL), SARCINA_OK);
    mechanics_free(m);
}

/* Two overlapping cocci: their overlap d obeys m d'' = -k_d d' - 2 k d while they touch. */
static void check_cocci(double drag, double time, integrator_kind kind) {
    packing p = packing_create(1);
    p.forces.term[FORCE_COLLISION].on = p.forces.term[FORCE_DAMPING].on = true;
    p.forces.term[FORCE_DAMPING].p[DAMPING_K] = drag;
    double reach = 1.01, d0 = 0.3, mass = shape_coccus_mass(1, 1.01);
    packing_coccus(&p, (double[]){0, 0, 5}, 1);
    packing_coccus(&p, (double[]){0, reach - d0, 5}, 1);
    relax_for(&p, kind, time, fmin(2e-5, 0.02 * mass / drag));
    double d = reach - (p.c->particle.x[4] - p.c->particle.x[1]);
    double wanted = oscillator(d0, 2e5 / mass, drag / mass, time);
    assert_true(wanted > 0); /* they still touch */
    assert_near(d, wanted, 2e-6);
    assert_near(p.c->particle.x[4] + p.c->particle.x[1], reach - d0, 1e-12);
    if (drag > 1e3)
        assert_near(d, d0 * exp(-2e5 * time / drag), 2e-3 * d0);
    packing_free(&p);
}

static void test_two_cocci(void **state) {
    (void)state;
    static const integrator_kind kinds[] = {INTEGRATOR_DOPRI5, INTEGRATOR_VERLET, INTEGRATOR_RK8PD};
    for (int i = 0; i < 3; i++) {
        check_cocci(100, 0.002, kinds[i]);
        check_cocci(1e4, 0.03, kinds[i]);
    }
}

static void test_stretched_rod(void **state) {
    (void)state;
    packing p = packing_create(1);
    p.forces.term[FORCE_DAMPING].on = true;
    double rest = 2, stretch = 0.1, half_mass = 0.5 * shape_rod_mass(rest, 0.75, 1.01), time = 0.015;
    packing_rod(&p, (double[]){0, 0, 0}, (double[]){0, 0, rest + stretch}, rest, 0.75);
    relax_for(&p, INTEGRATOR_VERLET, time, 2e-5);
    double seen = p.c->particle.x[5] - p.c->particle.x[2] - rest;
    assert_near(seen, oscillator(stretch, 2 * 5e4 / half_mass, 100 / half_mass, time), 2e-6);
    packing_free(&p);
}

/* Root of C_ES kappa exp(-kappa d) = C_vdW / d^2 beyond the clamp. */
static double equilibrium_gap(void) {
    double low = 0.12, high = 0.2;
    for (int i = 0; i < 100; i++) {
        double d = 0.5 * (low + high);
        (1e5 * 50 * exp(-50 * d) > 100 / (d * d) ? &low : &high)[0] = d;
    }
    return low;
}

static void test_gap(void **state) {
    (void)state;
    packing p = packing_create(1);
    packing_on(&p, FORCE_SUBSTRATUM, FORCE_DAMPING);
    packing_coccus(&p, (double[]){0, 0, 0.6}, 1);
    packing_rod(&p, (double[]){3, 0, 0.5}, (double[]){5, 0, 0.53}, 2, 0.8);
    mechanics *m = packing_mechanics(&p, NEIGHBOR_CELLS, 1);
    const relax_settings how = {.integrator = INTEGRATOR_VERLET, .most = 1e-3};
    relax_result result;
    assert_int_equal(relax_run(m, &how, &(relax_goal){.time = 100, .force = 1e-6}, &result, NULL), SARCINA_OK);
    assert_int_equal(result.stop, RELAX_FORCE);
    assert_near(equilibrium_gap(), 0.137, 5e-4);
    assert_near(p.c->particle.x[2] - 0.5, equilibrium_gap(), 1e-6);
    assert_near(p.c->particle.x[5] - 0.4, equilibrium_gap(), 1e-6);
    assert_near(p.c->particle.x[8] - 0.4, equilibrium_gap(), 1e-6);
    mechanics_free(m);
    packing_free(&p);
}

/* A coccus beside a rod at 80 % of its length: k d, shared 20 : 80, so that the moment is that of the contact. */
static void test_off_centre_contact(void **state) {
    (void)state;
    for (int law = 0; law < 2; law++) {
        packing p = packing_create(1);
        p.forces.term[FORCE_COLLISION].on = true;
        p.forces.term[FORCE_COLLISION].p[COLLISION_CONTACT] = law;
        packing_rod(&p, (double[]){0, 0, 0}, (double[]){2, 0, 0}, 2, 0.8);
        packing_coccus(&p, (double[]){1.6, 0, 0.7}, 1);
        mechanics *m = packing_mechanics(&p, NEIGHBOR_CELLS, 1);
        double f[9], force = 1e5 * (1.01 * 0.9 - 0.7);
        mechanics_force_of(m, FORCE_COLLISION, p.c->particle.x, NULL, f);
        assert_near(f[2], -0.2 * force, 1e-9 * force);
        assert_near(f[5], -0.8 * force, 1e-9 * force);
        assert_near(f[8], force, 1e-9 * force);
        assert_near(2 * f[5], -1.6 * force, 1e-9 * force);
        mechanics_free(m);
        packing_free(&p);
    }
}

/* A ball sinks at its weight over the drag. */
static void test_sinking(void **state) {
    (void)state;
    packing p = packing_create(1);
    p.forces.term[FORCE_DAMPING].on = p.forces.term[FORCE_GRAVITY].on = true;
    packing_coccus(&p, (double[]){0, 0, 0}, 1);
    relax_for(&p, INTEGRATOR_DOPRI5, 0.5, 1e-3);
    double weight = 9.81e6 * (1.01 - 0.998) * shape_coccus_mass(1, 1.01) / 1.01;
    assert_near(p.c->particle.v[2], -weight / 100, 1e-6 * weight / 100);
    packing_free(&p);
}

/* The bound on steps: an isolated rod's 2 k / m, two cocci's in contact, and nothing where nothing acts. */
static void test_stiffness(void **state) {
    (void)state;
    packing p = packing_create(1);
    p.forces.term[FORCE_COLLISION].on = true;
    packing_rod(&p, (double[]){0, 0, 0}, (double[]){2, 0, 0}, 2, 0.8);
    mechanics *m = packing_mechanics(&p, NEIGHBOR_CELLS, 1);
    double rod = 2 * 5e4 / (0.5 * shape_rod_mass(2, 0.8, 1.01));
    assert_near(mechanics_stiffness(m, p.c->particle.x), rod, 0.02 * rod);
    packing_coccus(&p, (double[]){9, 0, 0}, 0.5);
    packing_coccus(&p, (double[]){9.4, 0, 0}, 0.5);
    assert_int_equal(packing_bind(&p, m, NEIGHBOR_CELLS, 1, NULL), SARCINA_OK);
    double pair = 2e5 / shape_coccus_mass(0.5, 1.01);
    assert_near(mechanics_stiffness(m, p.c->particle.x), pair, 0.02 * pair);
    mechanics_free(m);
    packing_free(&p);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_two_cocci), cmocka_unit_test(test_stretched_rod),
        cmocka_unit_test(test_gap),       cmocka_unit_test(test_off_centre_contact),
        cmocka_unit_test(test_sinking),   cmocka_unit_test(test_stiffness),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}

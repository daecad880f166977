/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The velocities that a relaxation leaves: under a constant force and any drag exact to the bits that numbers have, of
 * cells in contact those that positions change by, of flexible cells the one at which they drift. */
#include "check.h"
#include "packing.h"

#include "relax/integrator.h"

static void relax_for(const packing *p, relax_settings how, double time) {
    mechanics *m = packing_mechanics(p, NEIGHBOR_CELLS, 1);
    diag d = {0};
    if (relax_run(m, &how, &(relax_goal){.time = time}, NULL, &d) != SARCINA_OK)
        fail_msg("%s: %s", integrator_styles[how.integrator]->name, d.message);
    mechanics_free(m);
}

/* Drag, and a force along -z that accelerates at first by `acceleration` (um/s2) what weighs nothing in a liquid. */
static void set_forces(packing *p, double drag, double acceleration) {
    p->forces.term[FORCE_DAMPING].on = true;
    p->forces.term[FORCE_DAMPING].p[0] = drag;
    p->forces.term[FORCE_GRAVITY].on = true;
    memcpy(p->forces.term[FORCE_GRAVITY].p, (double[]){acceleration, 0}, 2 * sizeof(double));
}

/* The path of m dv/dt = F - k v: x and v after t, from 0 at v0; a = F/m, g = k/m. */
static void find_path(double a, double g, double t, double v0, double *x, double *v) {
    const double flight = -expm1(-g * t) / g;
    const double fallen =
        g * t < 1e-2 ? t * t * (1. / 2 - g * t * (1. / 6 - g * t * (1. / 24 - g * t / 120))) : (t - flight) / g;
    *x = v0 * flight + a * fallen;
    *v = v0 * exp(-g * t) + a * flight;
}

static const double falls = 10, radius = 0.5, lasts = 0.25;

/* A sphere of a micrometre, thrown, with drag such that g h is this in each of five steps; and one of half its size. */
static void check_path(double z) {
    enum { STEPS = 5 };
    packing p = packing_create(1);
    packing_coccus(&p, (double[]){0, 0, 0}, 2 * radius);
    packing_coccus(&p, (double[]){9, 0, 0}, radius);
    const double *mass = p.c->cell.mass, h = lasts / STEPS, drag = z * mass[0] / h, thrown[3] = {1, 0.5, -0.7};
    set_forces(&p, drag, falls);
    memcpy(p.c->particle.v, thrown, sizeof thrown);
    relax_for(&p, (relax_settings){.integrator = INTEGRATOR_VERLET, .step = h}, lasts);
    for (int i = 0; i < 2; i++)
        for (int k = 0; k < 3; k++) {
            double x, v, a = k == 2 ? -falls : 0;
            find_path(a, drag / mass[i], lasts, i ? 0 : thrown[k], &x, &v);
            const double scale = 1e-12 * (fabs(v) + 1e-3 * (z < 100));
            assert_near(p.c->particle.v[3 * i + k], v, scale);
            assert_near(p.c->particle.x[3 * i + k] - (i && k == 0 ? 9 : 0), x, 1e-13 * 9);
        }
    packing_free(&p);
}

static void test_constant_force_is_exact(void **state) {
    (void)state;
    static const double drags[] = {1e-6, 1e-3, 0.1, 0.2499999, 0.25, 0.2500001, 0.3, 0.6, 1, 5, 30, 800, 1e6, 1e12};
    for (size_t i = 0; i < sizeof drags / sizeof *drags; i++)
        check_path(drags[i]);
}

/* Whoever follows time leaves a driven cell at F/k. Masses that grow leave it so, too. */
static void test_terminal_velocity(void **state) {
    (void)state;
    for (int kind = 0; kind < INTEGRATOR_COUNT; kind++)
        for (int i = 0; i < 4; i++) {
            const double strength = pow(10, i);
            const bool exact = integrator_styles[kind]->caps & INTEGRATOR_EXACT_DAMPING;
            if (integrator_styles[kind]->caps & INTEGRATOR_MINIMISES || (!exact && strength > 10))
                continue;
            packing p = packing_create(1);
            packing_coccus(&p, (double[]){0, 0, 0}, 1);
            const double drag = 100 * strength, due = -falls * p.c->cell.mass[0] / drag;
            set_forces(&p, drag, falls);
            relax_settings how = {.integrator = (integrator_kind)kind, .tolerance = exact ? 0 : 1e-6};
            if (exact)
                how.most = 2e-3;
            if (kind == INTEGRATOR_VERLET)
                how.inertia = 0.07;
            for (int cycle = 0; cycle < 2; cycle++) {
                relax_for(&p, how, 0.5);
                if (!(fabs(p.c->particle.v[2] / due - 1) < (exact ? 1e-5 : 1e-3)))
                    fail_msg("%s, drag %g: velocity %g, not %g", integrator_styles[kind]->name, drag,
                             p.c->particle.v[2], due);
            }
            packing_free(&p);
        }
}

/* Two cells that push each other apart in drag as strong as their contact: by every method each has the velocity F/k of
 * the force where it is, but for how fast that fades (stiffness x mass / drag^2, half a percent). */
static void check_pair(int kind) {
    packing p = packing_create(1);
    const double drag = 5000;
    packing_coccus(&p, (double[]){0, 0, 0}, 1);
    packing_coccus(&p, (double[]){0.9, 0.1, 0}, 1.1);
    packing_on(&p, FORCE_COLLISION, FORCE_COLLISION);
    set_forces(&p, drag, 0);
    const bool exact = integrator_styles[kind]->caps & INTEGRATOR_EXACT_DAMPING;
    relax_for(&p, (relax_settings){.integrator = (integrator_kind)kind, .tolerance = exact ? 0 : 1e-6}, 0.02);
    mechanics *m = packing_mechanics(&p, NEIGHBOR_CELLS, 1);
    double force[6];
    mechanics_force_undamped(m, p.c->particle.x, force);
    assert_true(force[0] < -1000);
    for (int i = 0; i < 6; i++)
        assert_near(p.c->particle.v[i], force[i] / drag, 0.01 * fabs(force[0] / drag));
    mechanics_free(m);
    packing_free(&p);
}

static void test_pair_in_strong_drag(void **state) {
    (void)state;
    for (int kind = 0; kind < INTEGRATOR_COUNT; kind++)
        if (!(integrator_styles[kind]->caps & INTEGRATOR_MINIMISES))
            check_pair(kind);
}

/* A flexible cell drifts as a whole at its weight by the drag of all its particles; its own flight is implicit. */
static void test_flexible_drift(void **state) {
    (void)state;
    for (int exponent = 2; exponent <= 5; exponent++) {
        const double drag = pow(10, exponent);
        packing p = packing_create(1);
        uint32_t row = packing_coil(&p, (double[]){0, 0, 0}, 0.6, 0.8, 0);
        const size_t n = p.c->particle.count;
        set_forces(&p, drag, falls);
        packing_on(&p, FORCE_INTERNAL, FORCE_TWIST);
        relax_for(&p, (relax_settings){.integrator = INTEGRATOR_VERLET, .step = 0.02}, 4);
        const double due = -falls * p.c->cell.mass[row] / ((double)n * drag);
        double sum = 0;
        for (size_t i = 0; i < n; i++)
            sum += p.c->particle.v[3 * i + 2] / (double)n;
        assert_near(sum, due, 1e-3 * fabs(due));
        packing_free(&p);
    }
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_constant_force_is_exact),
        cmocka_unit_test(test_terminal_velocity),
        cmocka_unit_test(test_pair_in_strong_drag),
        cmocka_unit_test(test_flexible_drift),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}

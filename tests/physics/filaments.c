/* SPDX-License-Identifier: GPL-3.0-or-later */
/* A filament of linked rods as a beam: the curvature of a joint's energy in its turning angle is the stiffness that the
 * filament's deflection shows.
 *
 * The two springs of a straight link (k_f/2 each) cannot both have their rest lengths: in the straight filament the one
 * between facing ends is stretched and the one between far ends pressed together, each by half of
 * b - a = (l_long - l_short) D, and the gap is (a + b)/2. Two rods of length L turned by theta against each other bring
 * their far ends nearer by c = 2 L (1 - cos(theta/2)); with the gap at its best, E = k_f/8 (b - a + c)^2, so
 * kappa = d2E/dtheta2 at 0 = k_f (b - a) L / 8. */
#include "check.h"
#include "packing.h"

#include "model/link.h"
#include "relax/relax.h"

static const link_rule rule = {true, {2e4, 2, 0.5, 1.7, 1.1}}; /* sludge, Table 1 */
static const double diameter = 1, rod = 4;

/* Rods along x, linked end to end with the gap of the straight filament at rest; stiff ones: it is the links that
 * bend. Row i is rod i, its particles 2 i and 2 i + 1. */
static double make_filament(packing *p, uint32_t n) {
    double gap = 0.5 * (rule.p[FILIAL_SHORT] + rule.p[FILIAL_LONG]) * diameter;
    p->species.list[PACKING_ROD].internal_k = 1e7;
    for (uint32_t i = 0; i < n; i++) {
        double at = i * (rod + gap);
        packing_rod(p, (double[]){at, 0, 0}, (double[]){at + rod, 0, 0}, rod, diameter);
        if (i > 0)
            link_add_filial(p->c, &rule, LINK_STRAIGHT, i - 1, LINK_LAST_END, i, LINK_FIRST_END, 0);
    }
    return gap;
}

static double kappa_of_formula(void) {
    return rule.p[FILIAL_K] * (rule.p[FILIAL_LONG] - rule.p[FILIAL_SHORT]) * diameter * rod / 8;
}

/* Energy of one joint turned by theta, at the gap where it is least (golden section). */
static double joint_energy(double theta) {
    packing p = packing_create(1);
    double lo = 0.5 * diameter, hi = 2 * diameter, best = INFINITY;
    make_filament(&p, 2);
    mechanics *m = packing_mechanics(&p, NEIGHBOR_CELLS, 1);
    for (int i = 0; i < 60; i++) {
        double energy[2], gap[2] = {hi - 0.6180339887498949 * (hi - lo), lo + 0.6180339887498949 * (hi - lo)};
        for (int k = 0; k < 2; k++) {
            double c = cos(0.5 * theta), s = sin(0.5 * theta), g = 0.5 * gap[k];
            const double x[12] = {-g - rod * c, -rod * s, 0, -g, 0, 0, g, 0, 0, g + rod * c, -rod * s, 0};
            energy[k] = mechanics_energy(m, FORCE_SPRINGS, x);
            best = fmin(best, energy[k]);
        }
        if (energy[0] < energy[1])
            hi = gap[1];
        else
            lo = gap[0];
    }
    mechanics_free(m);
    packing_free(&p);
    return best;
}

static double kappa_of_energy(void) {
    const double h = 0.02;
    return (joint_energy(h) - 2 * joint_energy(0) + joint_energy(-h)) / (h * h);
}

static void test_curvature_of_the_energy(void **state) {
    (void)state;
    assert_near(kappa_of_energy(), kappa_of_formula(), 1e-3 * kappa_of_formula());
}

/* A constant force along y on a particle: a spring to a point far away. */
static void pull_along_y(packing *p, uint32_t particle, double force) {
    const double far = 1e4;
    uint32_t spring = packing_spring(p, 0, particle, SPRING_ANCHOR, 0, fabs(force) / far, 0);
    double *anchor = p->c->spring.anchor + 3 * spring;
    memcpy(anchor, p->c->particle.x + 3 * (size_t)particle, 3 * sizeof *anchor);
    anchor[1] += force < 0 ? -far : far;
}

/* Pushed down in its middle rod and up at both tips, a filament is two cantilevers: under F at the tip, a joint at the
 * distance d from it turns by F d / kappa, and the tip goes up by F sum d^2 / kappa. */
static void test_deflection(void **state) {
    (void)state;
    enum { HALF = 4, N = 2 * HALF + 1 };
    packing p = packing_create(1);
    double gap = make_filament(&p, N), squares = 0;
    for (int j = 0; j < HALF; j++) {
        double d = rod + 0.5 * gap + j * (rod + gap);
        squares += d * d;
    }
    const double wanted = 0.4, load = wanted * kappa_of_energy() / squares;
    p.forces.term[FORCE_DAMPING].on = true;
    p.forces.term[FORCE_DAMPING].p[0] = 8; /* near critical for the slowest mode */
    pull_along_y(&p, 0, load);
    pull_along_y(&p, 2 * HALF, -load);
    pull_along_y(&p, 2 * HALF + 1, -load);
    pull_along_y(&p, 2 * N - 1, load);
    mechanics *m = packing_mechanics(&p, NEIGHBOR_CELLS, 1);
    const relax_settings how = {.integrator = INTEGRATOR_VERLET, .most = 1e-3};
    const relax_goal goal = {.time = 20};
    diag d = {0};
    if (relax_run(m, &how, &goal, NULL, &d) != SARCINA_OK)
        fail_msg("%s", d.message);
    const double *x = p.c->particle.x, middle = 0.5 * (x[6 * HALF + 1] + x[6 * HALF + 4]);
    assert_near(x[1] - middle, wanted, 0.05 * wanted);
    assert_near(x[6 * N - 2] - middle, wanted, 0.05 * wanted);
    mechanics_free(m);
    packing_free(&p);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_curvature_of_the_energy),
        cmocka_unit_test(test_deflection),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}

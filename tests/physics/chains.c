/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Flexible cells against the mechanics of rods: forces at every angle, beam and column, the helix through growth and
 * division, and the same pairs by the list and by all pairs. */
#include "check.h"
#include "packing.h"

#include "base/rng.h"
#include "base/vec3.h"
#include "biology/division.h"
#include "relax/relax.h"

static species *flexible_of(packing *p) {
    return &p->species.list[PACKING_FLEXIBLE];
}

/* A straight chain along x from the origin. */
static uint32_t make_straight(packing *p, uint32_t n, double segment, double diameter) {
    double *x = calloc(3 * n, sizeof *x);
    for (uint32_t i = 0; i < n; i++)
        x[3 * i] = segment * i;
    flexible_of(p)->particles = n;
    flexible_of(p)->coil.radius = 0;
    uint32_t row = packing_chain(p, x, n, segment, diameter);
    free(x);
    return row;
}

static double *place_of(packing *p, uint32_t i) {
    return p->c->particle.x + 3 * (size_t)i;
}

/* The gradient of bending and twisting on a chain of random shape; turning angles of up to `bend`. */
static void check_random_shape(packing *p, double bend) {
    uint32_t n = flexible_of(p)->particles;
    double u[3], *x = p->c->particle.x;
    packing_direction(p, u);
    for (uint32_t i = 1; i < n; i++) {
        double turn[3];
        packing_direction(p, turn);
        for (int k = 0; k < 3; k++)
            u[k] += bend * packing_draw(p, 0, 1) * turn[k];
        double norm = sqrt(u[0] * u[0] + u[1] * u[1] + u[2] * u[2]);
        for (uint32_t k = 0; k < 3; k++)
            x[3 * i + k] = x[3 * (i - 1) + k] + 0.6 * (u[k] /= norm);
    }
    mechanics *m = packing_mechanics(p, NEIGHBOR_CELLS, 1);
    for (int term = FORCE_BEND; term <= FORCE_TWIST; term++) {
        double *f = calloc(3 * n, sizeof *f), *y = calloc(3 * n, sizeof *y), h = 1e-6, scale = 0;
        memcpy(y, x, 3 * n * sizeof *y);
        mechanics_force_of(m, (force_kind)term, y, NULL, f);
        for (uint32_t i = 0; i < 3 * n; i++)
            scale = fmax(scale, fabs(f[i]));
        for (uint32_t i = 0; i < 3 * n; i++) {
            double at = y[i];
            y[i] = at + h;
            double above = mechanics_energy(m, (force_kind)term, y);
            y[i] = at - h;
            double below = mechanics_energy(m, (force_kind)term, y);
            y[i] = at;
            assert_near((below - above) / (2 * h), f[i], 2e-5 * scale + 1e-4);
        }
        free(f);
        free(y);
    }
    mechanics_free(m);
}

/* From nearly straight, where the torsion fades out, to crumpled. */
static void test_gradient_at_every_angle(void **state) {
    (void)state;
    packing p = packing_create(5);
    flexible_of(&p)->particles = 9;
    packing_coil(&p, (double[]){0, 0, 0}, 0.6, 0.3, 0);
    for (int i = 0; i < 40; i++)
        check_random_shape(&p, i < 10 ? 0.05 : i < 20 ? 0.3 : 1.5);
    packing_free(&p);
}

/* Straight, folded back and without length: finite forces that sum to zero, and straight is at rest only where the rest
 * shape is. */
static void test_degenerate_shapes(void **state) {
    (void)state;
    for (int shape = 0; shape < 3; shape++)
        for (int coiled = 0; coiled < 2; coiled++) {
            packing p = packing_create(5);
            make_straight(&p, 6, 0.5, 0.3);
            flexible_of(&p)->coil.radius = coiled ? 0.3 : 0;
            for (uint32_t i = 0; i < 6 && shape; i++)
                place_of(&p, i)[0] = shape == 1 ? 0.5 * (i % 2) : 0;
            mechanics *m = packing_mechanics(&p, NEIGHBOR_CELLS, 1);
            double f[18], sum[3] = {0}, most = 0;
            for (int term = FORCE_BEND; term <= FORCE_TWIST; term++) {
                mechanics_force_of(m, (force_kind)term, p.c->particle.x, NULL, f);
                for (int i = 0; i < 18; i++) {
                    assert_true(isfinite(f[i]));
                    sum[i % 3] += f[i];
                    most = fmax(most, fabs(f[i]));
                }
            }
            for (int k = 0; k < 3; k++)
                assert_near(sum[k], 0, 1e-9 * (1 + most));
            assert_true((most > 0) == (shape == 1 || (shape == 0 && coiled)));
            mechanics_free(m);
            packing_free(&p);
        }
}

static void relax_for(packing *p, double time) {
    mechanics *m = packing_mechanics(p, NEIGHBOR_CELLS, 1);
    const relax_settings how = {.integrator = INTEGRATOR_VERLET, .most = 1e-3};
    const relax_goal goal = {.time = time};
    diag d = {0};
    if (relax_run(m, &how, &goal, NULL, &d) != SARCINA_OK)
        fail_msg("%s", d.message);
    mechanics_free(m);
}

/* A constant force along y on a particle: a spring to a point far away. */
static void pull_along_y(packing *p, uint32_t i, double force) {
    const double far = 1e4;
    uint32_t spring = packing_spring(p, 0, i, SPRING_ANCHOR, 0, fabs(force) / far, 0);
    double *anchor = p->c->spring.anchor + 3 * spring;
    memcpy(anchor, place_of(p, i), 3 * sizeof(double));
    anchor[1] += force < 0 ? -far : far;
}

/* A beam pushed down in its middle and up at both ends is two cantilevers, clamped to each other: each tip under a
 * force F goes up by F L^3 / (3 E I), E I = k_b l. */
static void test_tip_deflection(void **state) {
    (void)state;
    enum { HALF = 40, N = 2 * HALF + 1 };
    packing p = packing_create(5);
    const double segment = 0.25, bending = 1e7, stiffness = bending * segment, length = HALF * segment;
    species *s = flexible_of(&p);
    s->internal_k = 1e7;
    s->bend_k = bending;
    s->twist_k = 0;
    make_straight(&p, N, segment, 0.3);
    p.forces.term[FORCE_DAMPING].on = true;
    const double wanted = 0.05 * length, load = 3 * stiffness * wanted / (length * length * length);
    pull_along_y(&p, 0, load);
    pull_along_y(&p, HALF, -2 * load);
    pull_along_y(&p, N - 1, load);
    relax_for(&p, 2);
    for (uint32_t end = 0; end < N; end += N - 1)
        assert_near(place_of(&p, end)[1] - place_of(&p, HALF)[1], wanted, 0.05 * wanted);
    packing_free(&p);
}

/* Amplitude of a column's first mode after a while under a load, over the one at the beginning. The load is a spring
 * between its ends, which so are free to turn. */
static double column_growth(double load_by_euler) {
    enum { N = 41 };
    packing p = packing_create(5);
    const double segment = 0.25, bending = 2e6, stiffness = bending * segment, length = (N - 1) * segment;
    species *s = flexible_of(&p);
    s->internal_k = 1e8;
    s->bend_k = bending;
    s->twist_k = 0;
    make_straight(&p, N, segment, 0.3);
    p.forces.term[FORCE_DAMPING].on = true;
    const double load = load_by_euler * M_PI * M_PI * stiffness / (length * length);
    packing_spring(&p, 0, 0, 0, N - 1, load / length, 0);
    for (uint32_t i = 0; i < N; i++)
        place_of(&p, i)[1] = 0.01 * sin(M_PI * i / (N - 1));
    relax_for(&p, 1);
    double grown = place_of(&p, N / 2)[1] - 0.5 * (place_of(&p, 0)[1] + place_of(&p, N - 1)[1]);
    packing_free(&p);
    return grown / 0.01;
}

static void test_buckling_load(void **state) {
    (void)state;
    double below = column_growth(0.9), above = column_growth(1.1);
    if (!(below < 0.7 && above > 1.5))
        fail_msg("amplitudes at 0.9 and 1.1 of Euler's load: %g, %g of the first", below, above);
}

/* Rise over turn of the helix that a chain forms, negative for a left-handed one, by its second differences, which
 * stand at right angles to the axis.
 */
static double pitch_of(const double *x, uint32_t n) {
    vec3 axis = {0, 0, 0};
    double rise = 0, angle = 0;
    for (uint32_t i = 0; i + 3 < n; i++) {
        vec3 t[3];
        for (uint32_t k = 0; k < 3; k++)
            t[k] = vec3_sub(vec3_load(x + 3 * (i + k + 1)), vec3_load(x + 3 * (i + k)));
        axis = vec3_add(axis, vec3_cross(vec3_sub(t[1], t[0]), vec3_sub(t[2], t[1])));
    }
    axis = vec3_scale(1 / vec3_norm(axis), axis);
    for (uint32_t i = 0; i + 2 < n; i++) {
        vec3 a = vec3_sub(vec3_load(x + 3 * (i + 1)), vec3_load(x + 3 * i)),
             b = vec3_sub(vec3_load(x + 3 * (i + 2)), vec3_load(x + 3 * (i + 1)));
        rise += vec3_dot(a, axis);
        a = vec3_axpy(a, -vec3_dot(a, axis), axis);
        b = vec3_axpy(b, -vec3_dot(b, axis), axis);
        angle += chain_turn(a, b);
    }
    return 2 * M_PI * rise / angle;
}

/* Ten times grown to twice its mass and divided: the pitch of mother and daughter stays within 2 %. */
static void test_pitch_after_divisions(void **state) {
    (void)state;
    packing p = packing_create(5);
    species *s = flexible_of(&p);
    *s = (species){.name = "helix", .shape = SHAPE_FLEXIBLE, .density = 1.01, .particles = 20, .coil = {0.3, 2, true}};
    s->diameter = spread_fixed(0.4);
    s->aspect = spread_fixed(0);
    s->internal_k = 5e4;
    s->bend_k = s->twist_k = 1e8;
    s->bend_angle = s->twist_angle = NAN;
    for (int i = 0; i < PARAM_COUNT_MAX; i++)
        s->division.values[i] = spread_fixed(0);
    s->division.values[DIVISION_SIZE] = spread_fixed(NAN);
    s->division.values[DIVISION_JITTER] = spread_fixed(0.01);
    p.forces.term[FORCE_DAMPING].on = p.forces.term[FORCE_COLLISION].on = true;
    packing_coil(&p, (double[]){0, 0, 0}, 0.25, 0.4, 0);
    assert_near(pitch_of(p.c->particle.x, 20), -2, 1e-9);
    const double limit = 2 * p.c->cell.mass[0];
    s->division.values[DIVISION_MASS] = spread_fixed(limit);
    rng *r = rng_create(3);
    for (int round = 0; round < 10; round++) {
        p.c->cell.limit[0] = limit;
        for (int step = 0; step < 12; step++) {
            p.c->cell.mass[0] *= step < 11 ? pow(2, 1.0 / 11) : 1.001;
            species_shape_cell(s, p.c, 0);
            p.c->version++;
            relax_for(&p, 0.2);
        }
        assert_near(pitch_of(p.c->particle.x, 20), -2, 0.04);
        const division_context x = {.colony = p.c, .species = &p.species, .rng = r};
        assert_int_equal(division_step(&x), 1);
        for (uint32_t half = 0; half < 2; half++)
            assert_near(pitch_of(p.c->particle.x + 60 * half, 20), -2, 0.04);
        relax_for(&p, 0.2);
        for (uint32_t half = 0; half < 2; half++)
            assert_near(pitch_of(p.c->particle.x + 60 * half, 20), -2, 0.04);
        colony_arrange(p.c, &(uint32_t){0}, 1);
    }
    rng_free(r);
    packing_free(&p);
}

/* What a flight of length h minimises, at x: it has begun at rest at `from`. */
static double flight_value(mechanics *m, double h, const double *from, const double *x) {
    const double *mass = mechanics_mass(m), drag = mechanics_drag(m);
    double sum = 0;
    for (size_t i = 0; i < 3 * mechanics_particles(m); i++)
        sum += 0.5 * mass[i / 3] * (1 + drag * h / mass[i / 3]) / (h * h) * (x[i] - from[i]) * (x[i] - from[i]);
    for (int term = 0; term < FORCE_COUNT; term++)
        sum += mechanics_energy(m, (force_kind)term, x);
    return sum;
}

/* A crumpled coil whose joints are 100,000 times as stiff as its segments: each flight ends lower than it began, no
 * segment collapses on the way, and it comes to rest as the coil that it is. */
static void test_stiff_joints_crumpled(void **state) {
    (void)state;
    size_t never = 0;
    for (uint64_t seed = 1; seed <= 20; seed++) {
        packing p = packing_create(seed);
        species *s = flexible_of(&p);
        s->particles = 12;
        s->coil = (chain_coil){0.15, 0.6, false};
        s->internal_k = 5e4;
        s->bend_k = s->twist_k = 1e9;
        p.forces.term[FORCE_DAMPING].on = true;
        packing_coil(&p, (double[]){0, 0, 0}, 0.2, 0.2, 0.04);
        mechanics *m = packing_mechanics(&p, NEIGHBOR_CELLS, 1);
        double before[36], *x = p.c->particle.x, *v = p.c->particle.v, h = seed % 2 ? 1e-4 : 2e-3;
        size_t held = 0, unsolved = 0;
        for (int i = 0; i < 400; i++) {
            memcpy(before, x, sizeof before);
            memset(v, 0, sizeof before);
            double value = flight_value(m, h, before, before);
            mechanics_hits hits = mechanics_flight(m, h, x, v);
            held += hits.held;
            unsolved += hits.unsolved;
            if (!hits.held &&
                !(flight_value(m, h, before, x) <= value * (1 + 1e-9) + 1e-4)) /* k (1 - cos) rounds to 1e-7 k */
                fail_msg("seed %d: flight %d goes up, from %.12g by %g, unsolved %d", (int)seed, i, value,
                         flight_value(m, h, before, x) - value, (int)hits.unsolved);
            for (size_t k = 0; k < 11; k++)
                assert_true(vec3_norm(vec3_sub(vec3_load(x + 3 * k + 3), vec3_load(x + 3 * k))) > 0.02);
        }
        double left = mechanics_energy(m, FORCE_BEND, x) + mechanics_energy(m, FORCE_TWIST, x);
        print_message("seed %d, h %g: held %d, unsolved %d, energy of joints %g\n", (int)seed, h, (int)held,
                      (int)unsolved, left);
        never += unsolved;
        assert_true(left < 1 && held <= 10);
        mechanics_free(m);
        packing_free(&p);
    }
    assert_true(never <= 3); /* of 8,000 */
}

/* The list and all pairs give the same bits, by one thread and by three. */
static void test_list_and_all_pairs(void **state) {
    (void)state;
    packing p = packing_create(9);
    packing_fill(&p, &(packing_recipe){60, {8, 8, 3}, 0.5, 1, 3, 0.5, 1, 1});
    for (int i = 0; i < 30; i++)
        packing_coil(&p, (double[]){packing_draw(&p, -4, 4), packing_draw(&p, -4, 4), packing_draw(&p, 0, 3)}, 0.5, 0.5,
                     0.1);
    packing_on(&p, FORCE_COLLISION, FORCE_SUBSTRATUM);
    size_t n = 3 * p.c->particle.count;
    double *f = malloc(n * sizeof *f), *g = malloc(n * sizeof *g);
    mechanics *all = packing_mechanics(&p, NEIGHBOR_PAIRS, 1);
    mechanics_force(all, p.c->particle.x, p.c->particle.v, f);
    for (int threads = 1; threads <= 3; threads += 2) {
        mechanics *listed = packing_mechanics(&p, NEIGHBOR_CELLS, threads);
        mechanics_force(listed, p.c->particle.x, p.c->particle.v, g);
        assert_memory_equal(f, g, n * sizeof *f);
        mechanics_free(listed);
    }
    mechanics_free(all);
    free(f);
    free(g);
    packing_free(&p);
}

/* A chain bent back upon itself collides; segments that share a particle, or are joined by a sharp bend, do not. */
static void test_a_chain_collides_with_itself(void **state) {
    (void)state;
    packing p = packing_create(5);
    double x[24] = {0, 0, 0, 1, 0, 0, 2, 0, 0, 3, 0, 0, 3, 0.4, 0, 2, 0.4, 0, 1, 0.4, 0, 0, 0.4, 0};
    flexible_of(&p)->particles = 8;
    flexible_of(&p)->coil.radius = 0;
    packing_chain(&p, x, 8, 1, 0.5);
    p.forces.term[FORCE_COLLISION].on = true;
    mechanics *m = packing_mechanics(&p, NEIGHBOR_CELLS, 1);
    double f[24];
    mechanics_force_of(m, FORCE_COLLISION, p.c->particle.x, NULL, f);
    double lower = 0, upper = 0;
    for (int i = 0; i < 4; i++) {
        lower += f[3 * i + 1];
        upper += f[12 + 3 * i + 1];
    }
    assert_true(lower < -1e4 * 0.1 && upper == -lower);
    uint32_t contacts;
    double overlap;
    mechanics_contacts(m, &overlap, &contacts, NULL);
    assert_true(contacts == 0 && overlap == 0); /* of other cells */
    mechanics_free(m);
    packing_free(&p);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_gradient_at_every_angle), cmocka_unit_test(test_degenerate_shapes),
        cmocka_unit_test(test_tip_deflection),          cmocka_unit_test(test_buckling_load),
        cmocka_unit_test(test_pitch_after_divisions),   cmocka_unit_test(test_stiff_joints_crumpled),
        cmocka_unit_test(test_list_and_all_pairs),      cmocka_unit_test(test_a_chain_collides_with_itself),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}

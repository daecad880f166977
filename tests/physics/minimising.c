/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The minimiser: to rest where dynamics rests, from every extreme and to any force, in fewer evaluations; and an honest
 * end where there is no rest. SARCINA_TEST_TIER=full adds the comparison with accuracy paper where that takes long. */
#include "check.h"
#include "packing.h"

#include "mechanics/remodel.h"
#include "relax/integrator.h"

static const relax_settings newton = {.integrator = INTEGRATOR_NEWTON};

/* 1e-19 N and 1e-24 N. */
static const double near_rest = 100, rest = 1e-3;

static relax_result settle(const packing *p, const relax_settings *how, double force) {
    mechanics *m = packing_mechanics(p, NEIGHBOR_CELLS, 1);
    const relax_goal goal = {.time = INFINITY, .force = force};
    relax_result result = {0};
    diag d = {0};
    if (relax_run(m, how, &goal, &result, &d) != SARCINA_OK)
        fail_msg("%s", d.message);
    if (result.stop == RELAX_FORCE)
        assert_true(result.fmax < force && mechanics_fmax(m) < force * (1 + 1e-9));
    mechanics_free(m);
    return result;
}

/* By the minimiser, which must get there; no time passes and nothing moves afterwards. */
static relax_result minimise(const packing *p, double force) {
    relax_result r = settle(p, &newton, force);
    if (r.stop != RELAX_FORCE)
        fail_msg("stopped at %g, not %g, after %g evaluations", r.fmax, force, (double)r.evaluations);
    assert_true(r.time == 0 && r.least_step == 0 && r.largest_step == 0);
    for (size_t i = 0; i < 3 * p->c->particle.count; i++)
        assert_true(p->c->particle.v[i] == 0 && isfinite(p->c->particle.x[i]));
    return r;
}

static double energy_of(const packing *p) {
    mechanics *m = packing_mechanics(p, NEIGHBOR_CELLS, 1);
    double sum = 0;
    for (int i = 0; i < FORCE_COUNT; i++)
        sum += mechanics_energy(m, (force_kind)i, p->c->particle.x);
    mechanics_free(m);
    return sum;
}

/* Collisions and damping alone; or with a plane and DLVO, too. */
static packing make_free(uint64_t seed) {
    packing p = packing_create(seed);
    p.forces.term[FORCE_COLLISION].on = p.forces.term[FORCE_DAMPING].on = true;
    return p;
}

static packing make_contacts(uint64_t seed) {
    packing p = packing_create(seed);
    packing_on(&p, FORCE_COLLISION, FORCE_DAMPING);
    return p;
}

static packing make_pair(void) {
    packing p = make_free(1);
    packing_coccus(&p, (double[]){0, 0, 3}, 1);
    packing_coccus(&p, (double[]){0.4, 0.5, 3.2}, 1);
    return p;
}

/* The same, pulled together by a link. */
static packing make_held(double k) {
    packing p = make_pair();
    packing_spring(&p, 0, 0, 1, 0, k, 0.8);
    return p;
}

static packing make_crowd(uint64_t seed) {
    packing p = make_contacts(seed);
    packing_fill(&p, &(packing_recipe){150, {9, 9, 3}, 1, 1, 3.5, 0.5, 1, 0.6});
    return p;
}

/* The same in free space. */
static packing make_cloud(uint64_t seed) {
    packing p = make_free(seed);
    packing_fill(&p, &(packing_recipe){150, {9, 9, 3}, 1, 1, 3.5, 0.5, 1, 0.6});
    return p;
}

/* Cocci on a line that is bent in places, linked one to the next. */
static packing make_row(int n) {
    packing p = make_contacts(1);
    for (int i = 0; i < n; i++)
        packing_coccus(&p, (double[]){0.9 * i, 0.2 * (i % 3), 3 + 0.3 * (i % 2)}, 1);
    for (int i = 1; i < n; i++)
        packing_spring(&p, (uint32_t)i - 1, 0, (uint32_t)i, 0, 1e5, 1.3);
    return p;
}

static packing make_linked(uint64_t seed) {
    (void)seed;
    return make_row(60);
}

static packing make_long_row(uint64_t seed) {
    (void)seed;
    return make_row(1000);
}

static packing make_flexible(uint64_t seed) {
    packing p = make_contacts(seed);
    for (int i = 0; i < 12; i++)
        packing_coil(&p, (double[]){1.5 * (i % 4), 1.5 * floor(i / 4.0), 4}, 0.5, 0.3, 0.02);
    return p;
}

/* Four rods, a thousand diameters long, that cross and overlap. */
static packing make_needles(uint64_t seed) {
    packing p = make_free(seed);
    for (int i = 0; i < 4; i++) {
        double c = cos(0.7 * i), s = sin(0.7 * i), z = 0.3 * i;
        packing_rod(&p, (double[]){-500 * c, -500 * s, z}, (double[]){500 * c, 500 * s, z}, 1000, 1);
    }
    return p;
}

static packing make_cocci_in_point(uint64_t seed) {
    packing p = make_free(seed);
    for (int i = 0; i < 100; i++)
        packing_coccus(&p, (double[]){0, 0, 60}, 0.8);
    return p;
}

static packing make_rods_in_point(uint64_t seed) {
    packing p = make_free(seed);
    for (int i = 0; i < 100; i++)
        packing_rod(&p, (double[]){0, 0, 60}, (double[]){2, 0, 60}, 2, 0.8);
    return p;
}

/* When a comparison is made: never where dynamics takes minutes or does not come to rest. */
enum { NEVER, QUICK, FULL };
typedef struct case_record {
    const char *name;
    packing (*make)(uint64_t seed);
    int balanced, paper;
} case_record;

static const case_record cases[] = {
    {"150 rods on a plane", make_crowd, QUICK, FULL},
    {"150 rods", make_cloud, QUICK, FULL},
    {"60 linked cocci", make_linked, QUICK, QUICK},
    {"12 flexible cells", make_flexible, QUICK, NEVER},
    {"rods of 1 mm", make_needles, FULL, FULL},
    {"1,000 linked cocci", make_long_row, QUICK, FULL},
    {"100 cocci in a point", make_cocci_in_point, QUICK, FULL},
    {"100 rods in a point", make_rods_in_point, FULL, FULL},
};

static double distance(const packing *p) {
    const double *x = p->c->particle.x;
    return sqrt(pow(x[3] - x[0], 2) + pow(x[4] - x[1], 2) + pow(x[5] - x[2], 2));
}

/* Two cocci rest where contact ends, at 1.01 D, and their centre where it was. Two that a link holds in contact rest
 * where every integrator brings them; those have no end in time either. */
static void test_pair(void **state) {
    (void)state;
    packing loose = make_pair(), p = make_held(1e4);
    static const double twice_centre[3] = {0.4, 0.5, 6.2};
    minimise(&loose, rest);
    assert_near(distance(&loose), 1.01, 1e-6);
    for (int i = 0; i < 3; i++)
        assert_near(loose.c->particle.x[i] + loose.c->particle.x[i + 3], twice_centre[i], 1e-9);
    minimise(&p, rest);
    for (int kind = 0; kind < INTEGRATOR_COUNT; kind++) {
        packing q = make_held(1e4);
        const relax_settings how = {.integrator = (integrator_kind)kind};
        assert_int_equal(settle(&q, &how, 0.05).stop, RELAX_FORCE);
        for (int i = 0; i < 6; i++)
            assert_near(p.c->particle.x[i], q.c->particle.x[i], 1e-6);
        packing_free(&q);
    }
    packing_free(&p);
    packing_free(&loose);
}

/* A rod held to a plane by springs at both ends, one of them too short: it leans where dynamics leans it. */
static packing make_anchored(void) {
    packing p = make_contacts(1);
    packing_rod(&p, (double[]){0, 0, 0.6}, (double[]){1.8, 0.6, 1.4}, 2, 0.75);
    const double anchors[2][3] = {{0.1, 0, 0}, {2.2, 0.1, 0}};
    for (uint32_t i = 0; i < 2; i++) {
        uint32_t spring = packing_spring(&p, 0, i, SPRING_ANCHOR, 0, 1e5, i ? 0.9 : 0.4);
        memcpy(p.c->spring.anchor + 3 * (size_t)spring, anchors[i], sizeof anchors[i]);
    }
    return p;
}

/* Twelve linked cocci between two anchors farther apart than they are long. */
static packing make_stretched(void) {
    packing p = make_free(1);
    for (int i = 0; i < 12; i++)
        packing_coccus(&p, (double[]){1.1 * i, 0.3 * (i % 3), 5 + 0.2 * (i % 2)}, 1);
    for (uint32_t i = 1; i < 12; i++)
        packing_spring(&p, i - 1, 0, i, 0, 5e4 * (1 + i % 3), 1.1);
    for (uint32_t i = 0; i < 2; i++) {
        uint32_t spring = packing_spring(&p, 11 * i, 0, SPRING_ANCHOR, 0, 1e5, 0.5);
        memcpy(p.c->spring.anchor + 3 * (size_t)spring, (double[]){i ? 17 : -2, i, 5}, 3 * sizeof(double));
    }
    return p;
}

/* Where there is one minimum alone it is where the reference integrator ends, with a tolerance that shows nothing. */
static void test_unique(void **state) {
    (void)state;
    relax_settings exact = accuracy_presets[4].settings;
    exact.tolerance = 1e-8;
    packing (*const make[])(void) = {make_anchored, make_stretched};
    for (size_t i = 0; i < 2; i++) {
        packing p = make[i](), q = make[i]();
        relax_result r = minimise(&p, rest);
        mechanics *m = packing_mechanics(&q, NEIGHBOR_CELLS, 1);
        assert_int_equal(relax_run(m, &exact, &(relax_goal){.time = 3}, NULL, NULL), SARCINA_OK);
        mechanics_free(m);
        for (size_t k = 0; k < 3 * p.c->particle.count; k++)
            assert_near(p.c->particle.x[k], q.c->particle.x[k], 1e-6);
        double energy = energy_of(&q);
        print_message("%g evaluations, energy %.15g and %.15g\n", (double)r.evaluations, energy_of(&p), energy);
        assert_true(r.evaluations < 60 && energy_of(&p) <= energy + 1e-12 * fabs(energy));
        packing_free(&p);
        packing_free(&q);
    }
}

/* Stiffness and mass from a millionth to a million times change nothing but the unit of force. */
static void test_scales(void **state) {
    (void)state;
    packing plain = make_held(1e4);
    minimise(&plain, rest);
    for (int power = -6; power <= 6; power += 2) {
        double factor = pow(10, power);
        packing stiff = make_held(1e4), heavy = make_held(1e4), mixed = make_row(60);
        stiff.forces.term[FORCE_COLLISION].p[COLLISION_K] *= factor;
        stiff.c->spring.k[0] *= factor;
        minimise(&stiff, rest * factor);
        assert_near(distance(&stiff), distance(&plain), 1e-6);
        heavy.c->cell.mass[1] *= factor;
        minimise(&heavy, rest);
        assert_near(distance(&heavy), distance(&plain), 1e-6);
        mixed.forces.term[FORCE_COLLISION].p[COLLISION_K] *= factor; /* the links are as they were */
        relax_result r = minimise(&mixed, near_rest);
        r.evaluations += minimise(&mixed, rest * fmax(1, factor)).evaluations;
        print_message("collision k x 1e%+d, 60 linked: %g evaluations\n", power, (double)r.evaluations);
        packing_free(&stiff);
        packing_free(&heavy);
        packing_free(&mixed);
    }
    packing_free(&plain);
}

static bool is_due(int when) {
    const char *tier = getenv("SARCINA_TEST_TIER");
    return when == QUICK || (when == FULL && tier && strcmp(tier, "quick") != 0);
}

/* Evaluations that a preset takes to 1e-19 N; 0: it has not been tried. The minimiser's must be fewer. */
static void compare(const case_record *c, int when, size_t preset, double fewer) {
    if (!is_due(when))
        return;
    packing p = c->make(1);
    relax_result r = settle(&p, &accuracy_presets[preset].settings, near_rest);
    print_message(", %s %g", accuracy_presets[preset].name, (double)r.evaluations);
    assert_true(fewer < (double)r.evaluations);
    packing_free(&p);
}

/* Every case to 1e-19 N and on to 1e-24 N, in fewer evaluations than dynamics takes to the first, and without more
 * energy at the end than at the beginning of either. The table on the page of integrators is made of this. */
static void test_cases(void **state) {
    (void)state;
    for (size_t i = 0; i < sizeof cases / sizeof *cases; i++) {
        packing p = cases[i].make(1);
        double first = energy_of(&p);
        relax_result r = minimise(&p, near_rest);
        double second = energy_of(&p);
        relax_result more = minimise(&p, rest);
        assert_true(second < first && energy_of(&p) <= second);
        print_message("%s: %g + %g products; to 1e-24 N %g + %g", cases[i].name, (double)r.evaluations,
                      (double)r.products, (double)(r.evaluations + more.evaluations),
                      (double)(r.products + more.products));
        compare(&cases[i], cases[i].balanced, 2, (double)r.evaluations);
        compare(&cases[i], cases[i].paper, 3, (double)r.evaluations);
        print_message("\n");
        packing_free(&p);
    }
}

/* Rods whose contacts are 1e6 times as stiff as they are themselves slide and turn along them. The bound is a third
 * of what straight steps took for the first of these alone. */
static void test_stiff_contacts(void **state) {
    (void)state;
    double evaluations = 0;
    for (uint64_t seed = 1; seed <= 3; seed++) {
        packing p = packing_create(seed);
        p.forces.term[FORCE_INTERNAL].on = p.forces.term[FORCE_COLLISION].on = p.forces.term[FORCE_SUBSTRATUM].on =
            true;
        p.forces.term[FORCE_COLLISION].p[COLLISION_K] *= 1e6;
        packing_fill(&p, &(packing_recipe){20, {10, 10, 0.3}, 1, 2.5, 5, 0.75, 0.75, 0});
        relax_result r = minimise(&p, 10);
        print_message("20 rods, contacts 1e6 times as stiff: %g + %g products\n", (double)r.evaluations,
                      (double)r.products);
        evaluations += (double)r.evaluations;
        packing_free(&p);
    }
    assert_true(evaluations < 8000);
}

/* Links form and break before it begins and where it comes to rest, until none does. */
static void test_links(void **state) {
    (void)state;
    static const double stick_rule[LINK_PARAMS_MAX] = {1e4, 0.3, 0.5, HANDOVER_NEARER};
    packing p = make_free(1);
    packing_rule(&p, LINK_STICK, PACKING_COCCUS, PACKING_COCCUS, stick_rule);
    packing_coccus(&p, (double[]){0, 0, 0}, 1);
    packing_coccus(&p, (double[]){0.4, 0, 0}, 1); /* is pushed to within reach of the next */
    packing_coccus(&p, (double[]){1.95, 0, 0}, 1);
    packing_coccus(&p, (double[]){5, 0, 0}, 1); /* a link too long: it breaks, and pulls nothing */
    packing_spring(&p, 2, 0, 3, 0, 1e3, 1);
    p.c->link.kind[0] = LINK_STICK;
    minimise(&p, rest);
    assert_int_equal(p.c->link.count, 2);
    assert_near(p.c->particle.x[9], 5, 1e-9);
    assert_near(p.c->particle.x[3] - p.c->particle.x[0], 1.01, 0.01);
    mechanics *m = packing_mechanics(&p, NEIGHBOR_CELLS, 1);
    remodel_change change;
    assert_false(mechanics_remodel(m, &change));
    mechanics_free(m);
    packing_free(&p);
}

/* Where there is no rest it says so, and whose force is left: cells that fall for ever, a law that jumps, and less than
 * rounding leaves. */
static void test_no_rest(void **state) {
    (void)state;
    packing p = make_pair(), q = make_free(2), s = make_held(1e4);
    p.forces.term[FORCE_COLLISION].on = false;
    p.forces.term[FORCE_GRAVITY].on = true;
    p.c->cell.mass[1] *= 2;
    relax_result r = settle(&p, &newton, 1);
    assert_int_equal(r.stop, RELAX_STALLED);
    assert_true(r.cell == 2 && r.term == FORCE_GRAVITY && r.fmax > 1 && r.steps <= 20001);

    packing_fill(&q, &(packing_recipe){8, {5, 5, 3}, 1, 1, 3.5, 0.5, 1, 0.6});
    q.forces.term[FORCE_COLLISION].p[COLLISION_CONTACT] = CONTACT_CLOSEST;
    for (uint32_t i = 0; i + 1 < q.c->cell.count; i += 2) /* held in pairs: rods that are drawn together lie parallel */
        for (uint32_t k = 0; k < 2; k++)
            packing_spring(&q, i, k, i + 1, k, 1e5, 0.3);
    r = settle(&q, &newton, rest);
    print_message("contact closest: stop %d, %g, %g evaluations\n", (int)r.stop, r.fmax, (double)r.evaluations);
    assert_true(r.stop == RELAX_STALLED && r.fmax >= rest && r.term <= FORCE_COLLISION && r.evaluations < 10000);

    r = settle(&s, &newton, 1e-20);
    assert_true(r.stop == RELAX_STALLED && r.fmax < 1e-8 && r.evaluations < 1000);
    packing_free(&p);
    packing_free(&q);
    packing_free(&s);
}

/* A time, or none to go to, is refused, and nothing has happened. */
static void test_refused(void **state) {
    (void)state;
    packing p = make_pair();
    double before[6];
    memcpy(before, p.c->particle.x, sizeof before);
    mechanics *m = packing_mechanics(&p, NEIGHBOR_CELLS, 1);
    const relax_goal goals[] = {{.time = 1}, {.time = INFINITY}, {.time = 1, .force = 10}};
    for (int i = 0; i < 3; i++) {
        diag d = {0};
        relax_result r;
        assert_int_equal(relax_run(m, &newton, &goals[i], &r, &d), SARCINA_ERROR);
        assert_non_null(strstr(d.message, i < 2 ? "cannot relax for one" : "'within'"));
        assert_true(r.steps == 0);
    }
    assert_memory_equal(before, p.c->particle.x, sizeof before);
    mechanics_free(m);
    packing_free(&p);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_pair),    cmocka_unit_test(test_unique),         cmocka_unit_test(test_scales),
        cmocka_unit_test(test_cases),   cmocka_unit_test(test_stiff_contacts), cmocka_unit_test(test_links),
        cmocka_unit_test(test_no_rest), cmocka_unit_test(test_refused),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}

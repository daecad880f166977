/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Every record of the integrator table: its order on springs and damping, and what a step promises. */
#include "check.h"
#include "packing.h"

#include "relax/integrator.h"

#include <malloc.h>

/* A rod that spins, is stretched and drags on an anchor: springs and damping, and no two directions alike. */
static packing make_rod(void) {
    packing p = packing_create(1);
    packing_rod(&p, (double[]){0, 0, 1}, (double[]){2.3, 0.4, 1.1}, 2, 0.8);
    const double v[6] = {0, 30, 5, 0, -20, 10};
    memcpy(p.c->particle.v, v, sizeof v);
    uint32_t s = packing_spring(&p, 0, 0, SPRING_ANCHOR, 0, 2e4, 0.7);
    p.c->spring.anchor[3 * s] = 0.2;
    p.forces.term[FORCE_DAMPING].on = true;
    return p;
}

static const double duration = 0.01;

static int run(packing *p, relax_settings how, double time, relax_result *result) {
    mechanics *m = packing_mechanics(p, NEIGHBOR_CELLS, 1);
    int status = relax_run(m, &how, &(relax_goal){.time = time}, result, NULL);
    mechanics_free(m);
    return status;
}

static double distance(const double *a, const double *b) {
    double sum = 0;
    for (int i = 0; i < 6; i++)
        sum += (a[i] - b[i]) * (a[i] - b[i]);
    return sqrt(sum);
}

static double distance_from(const packing *p, const double reference[6]) {
    return distance(p->c->particle.x, reference);
}

typedef struct errors {
    double x, v; /* um, um/s */
} errors;

static errors errors_at(int kind, int steps, const packing *reference) {
    packing p = make_rod();
    relax_result result;
    assert_int_equal(
        run(&p, (relax_settings){.integrator = (integrator_kind)kind, .step = duration / steps}, duration, &result),
        SARCINA_OK);
    assert_int_equal(result.steps, steps);
    assert_int_equal(result.rejected, 0);
    assert_true(result.time == duration);
    errors e = {distance(p.c->particle.x, reference->c->particle.x),
                distance(p.c->particle.v, reference->c->particle.v)};
    packing_free(&p);
    return e;
}

static void check_slope(int kind, const char *of, double coarse, double fine, double above) {
    double slope = log2(coarse / fine) - integrator_styles[kind]->order;
    if (slope < -0.35 || slope > above)
        fail_msg("%s: order of %s %.2f, not %d (errors %.3g, %.3g)", integrator_styles[kind]->name, of,
                 slope + integrator_styles[kind]->order, integrator_styles[kind]->order, coarse, fine);
}

static void test_order(void **state) {
    (void)state;
    packing p = make_rod();
    const relax_settings exact = {.integrator = INTEGRATOR_RK8PD, .step = duration / 400};
    assert_int_equal(run(&p, exact, duration, NULL), SARCINA_OK);
    for (int kind = 0; kind < INTEGRATOR_COUNT; kind++) {
        if (integrator_styles[kind]->caps & INTEGRATOR_MINIMISES)
            continue;
        int order = integrator_styles[kind]->order, steps = order >= 8 ? 6 : order >= 4 ? 24 : order >= 2 ? 64 : 512;
        errors coarse = errors_at(kind, steps, &p), fine = errors_at(kind, 2 * steps, &p);
        check_slope(kind, "positions", coarse.x, fine.x, 0.35);
        check_slope(kind, "velocities", coarse.v, fine.v, 1);
    }
    packing_free(&p);
}

/* Adaptive methods: smaller tolerance, smaller error, both of about the size asked for. */
static void test_tolerance(void **state) {
    (void)state;
    packing p = make_rod();
    assert_int_equal(run(&p, (relax_settings){.integrator = INTEGRATOR_RK8PD, .step = duration / 400}, duration, NULL),
                     SARCINA_OK);
    for (int kind = 0; kind < INTEGRATOR_COUNT; kind++) {
        if (!(integrator_styles[kind]->caps & INTEGRATOR_ADAPTIVE))
            continue;
        double before = INFINITY;
        for (int digits = 2; digits < 9; digits += 3) {
            const double tolerance = pow(10, -digits);
            packing q = make_rod();
            relax_result result;
            relax_settings how = {.integrator = (integrator_kind)kind, .tolerance = tolerance};
            assert_int_equal(run(&q, how, duration, &result), SARCINA_OK);
            double error = distance_from(&q, p.c->particle.x);
            assert_true(error < before && error < 10 * tolerance);
            assert_true(result.time == duration && result.steps > 1);
            before = error;
            packing_free(&q);
        }
    }
    packing_free(&p);
}

/* One second; minimisers know none. */
static const relax_goal *goal_of(int kind) {
    static const relax_goal second = {.time = 1}, rest = {.time = INFINITY, .force = 1};
    return integrator_styles[kind]->caps & INTEGRATOR_MINIMISES ? &rest : &second;
}

/* A step that can never be accepted: the state is to the bit as before, and the message names the cell. */
static void test_failure_restores(void **state) {
    (void)state;
    for (int kind = 0; kind < INTEGRATOR_COUNT; kind++) {
        packing p = make_rod();
        p.forces.term[FORCE_GRAVITY].on = true;
        p.forces.term[FORCE_GRAVITY].p[GRAVITY_G] = 1e306; /* any step ends beyond all numbers */
        double before[12];
        memcpy(before, p.c->particle.x, 6 * sizeof *before);
        memcpy(before + 6, p.c->particle.v, 6 * sizeof *before);
        mechanics *m = packing_mechanics(&p, NEIGHBOR_CELLS, 1);
        diag d = {0};
        relax_result result;
        relax_settings how = {.integrator = (integrator_kind)kind, .most = 1e-3};
        assert_int_equal(relax_run(m, &how, goal_of(kind), &result, &d), SARCINA_NUMERICAL);
        assert_memory_equal(p.c->particle.x, before, 6 * sizeof *before);
        assert_memory_equal(p.c->particle.v, before + 6, 6 * sizeof *before);
        bool at_once = integrator_styles[kind]->caps & INTEGRATOR_MINIMISES; /* the force itself is beyond them */
        assert_true(result.time == 0 && result.steps == 0 && (at_once || result.rejected > 3));
        if (!strstr(d.message, "cell 1: gravity"))
            fail_msg("%s: %s", integrator_styles[kind]->name, d.message);
        mechanics_free(m);
        packing_free(&p);
    }
}

/* A splitting that refuses steps and halves them goes where one goes that was told the smaller step at once. */
static void test_refused_steps_leave_no_trace(void **state) {
    (void)state;
    for (int kind = INTEGRATOR_VERLET; kind <= INTEGRATOR_EULER; kind += INTEGRATOR_EULER - INTEGRATOR_VERLET) {
        packing p = make_rod(), q = make_rod();
        relax_result smooth;
        double h = 0.16;
        relax_settings how = {.integrator = (integrator_kind)kind, .step = h};
        mechanics *m = packing_mechanics(&p, NEIGHBOR_CELLS, 1);
        double *x = p.c->particle.x, *v = p.c->particle.v;
        motion mo = {.m = m, .n = 2, .dimensions = 3, .components = 6, .x = x, .v = v, .home = {x, v}};
        const integrator_style *style = integrator_styles[kind];
        void *self = style->create(style, &how, &mo);
        assert_int_equal(style->step(self, &mo, h, NULL), SARCINA_OK);
        assert_true(mo.rejected >= 1);
        if (style->finish)
            style->finish(self, &mo);
        motion_settle(&mo);
        style->destroy(self);
        mechanics_free(m);
        how.step = mo.time;
        assert_int_equal(run(&q, how, mo.time, &smooth), SARCINA_OK);
        assert_int_equal(smooth.steps, 1);
        assert_memory_equal(p.c->particle.x, q.c->particle.x, 6 * sizeof(double));
        assert_memory_equal(p.c->particle.v, q.c->particle.v, 6 * sizeof(double));
        packing_free(&p);
        packing_free(&q);
    }
}

static void test_records(void **state) {
    (void)state;
    for (int kind = 0; kind < INTEGRATOR_COUNT; kind++) {
        const integrator_style *s = integrator_styles[kind];
        assert_true(s->name && s->summary && s->source && s->order > 0);
        assert_true(s->create && s->step && s->reset && s->destroy);
        for (int other = 0; other < kind; other++)
            assert_string_not_equal(integrator_styles[other]->name, s->name);
        assert_true(!(s->caps & INTEGRATOR_ADAPTIVE) || s->tolerance > 0);
    }
    for (size_t i = 0; i < accuracy_preset_count; i++)
        assert_true(accuracy_presets[i].name && accuracy_presets[i].summary &&
                    accuracy_presets[i].settings.integrator < INTEGRATOR_COUNT);
}

/* Segments: every method begins anew in each, and ends exactly at the end. */
static void test_segments(void **state) {
    (void)state;
    for (int kind = 0; kind < INTEGRATOR_COUNT; kind++) {
        unsigned caps = integrator_styles[kind]->caps;
        if (caps & INTEGRATOR_MINIMISES)
            continue;
        packing p = make_rod(), q = make_rod();
        relax_result whole, parts;
        relax_settings how = {.integrator = kind, .tolerance = caps & INTEGRATOR_ADAPTIVE ? 1e-3 : 0};
        assert_int_equal(run(&p, how, 0.1, &whole), SARCINA_OK);
        how.segment = 0.02;
        assert_int_equal(run(&q, how, 0.1, &parts), SARCINA_OK);
        assert_true(whole.time == 0.1 && parts.time == 0.1);
        assert_near(distance_from(&p, q.c->particle.x), 0, 1e-2);
        if (kind == INTEGRATOR_DOPRI5) /* each start: first slope and first step */
            assert_true(parts.evaluations >= whole.evaluations + 4 * 2);
        packing_free(&p);
        packing_free(&q);
    }
}

static size_t allocated(void) {
    struct mallinfo2 now = mallinfo2();
    return now.uordblks + now.hblkhd;
}

/* The memory that info and -check tell is what a method takes, in space and, a third less, in the plane. */
static void check_memory(bool flat) {
    packing p = packing_create(1);
    for (int i = 0; i < 2000; i++)
        packing_coccus(&p, (double[]){2 * i, 0, 0}, 1);
    mechanics_input in = packing_input(&p, NEIGHBOR_CELLS, 1);
    in.flat = flat;
    mechanics *m = mechanics_create();
    assert_int_equal(mechanics_prepare(m, &in, NULL), SARCINA_OK);
    const size_t n = mechanics_particles(m), dimensions = (size_t)mechanics_dimensions(m);
    assert_int_equal(dimensions, flat ? 2 : 3);
    for (int kind = 0; kind < INTEGRATOR_COUNT; kind++) {
        const integrator_style *style = integrator_styles[kind];
        const relax_settings how = {.integrator = (integrator_kind)kind};
        const motion mo = {.m = m, .n = n, .dimensions = (int)dimensions, .components = dimensions * n};
        size_t before = allocated();
        void *method = style->create(style, &how, &mo);
        double vectors = (double)(allocated() - before) / (double)(mo.components * sizeof(double));
        style->destroy(method);
        if (fabs(vectors - style->vectors) > 0.4)
            fail_msg("%s holds %.2f arrays, not %d", style->name, vectors, style->vectors);
    }
    mechanics_free(m);
    packing_free(&p);
}

static void test_memory(void **state) {
    (void)state;
    if (allocated() == 0)
        skip(); /* the sanitizers' allocator does not count */
    check_memory(false);
    check_memory(true);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_records),
        cmocka_unit_test(test_order),
        cmocka_unit_test(test_tolerance),
        cmocka_unit_test(test_failure_restores),
        cmocka_unit_test(test_refused_steps_leave_no_trace),
        cmocka_unit_test(test_segments),
        cmocka_unit_test(test_memory),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}

/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The neighbour list against all pairs, and the evaluation against itself: the same bits whatever the list, the number
 * of threads, the vector width and the skin. SARCINA_TEST_TIER=full adds scenes of 20,000 cells. */
#include "check.h"
#include "packing.h"

#include "base/rng.h"
#include "mechanics/kernel.h"

static bool is_full(void) {
    const char *tier = getenv("SARCINA_TEST_TIER");
    return tier && strcmp(tier, "quick") != 0;
}

typedef struct crowd {
    const char *name;
    double volume; /* um3 a cell */
    packing_recipe recipe;
} crowd;

static const crowd crowds[] = {
    {"dense rods", 0.8, {.rods = 1, .shortest = 2, .longest = 5, .thinnest = 0.7, .thickest = 0.8, .flatness = 1}},
    {"sparse rods", 200, {.rods = 1, .shortest = 2, .longest = 5, .thinnest = 0.7, .thickest = 0.8, .flatness = 1}},
    {"elongated", 8, {.rods = 1, .shortest = 0.5, .longest = 40, .thinnest = 0.3, .thickest = 0.5, .flatness = 0.3}},
    {"mixed", 0.6, {.rods = 0.5, .shortest = 0, .longest = 6, .thinnest = 0.2, .thickest = 1.2, .flatness = 1}},
    {"cocci", 0.3, {.rods = 0, .thinnest = 0.3, .thickest = 1.1, .flatness = 1}},
    {"layer", 0, {.rods = 1, .shortest = 2, .longest = 5, .thinnest = 0.7, .thickest = 0.8, .flatness = 0}},
};
enum { CROWDS = sizeof crowds / sizeof crowds[0] };

static packing make(const crowd *from, size_t n, uint64_t seed) {
    packing p = packing_create(seed);
    packing_recipe r = from->recipe;
    double side = from->volume > 0 ? cbrt((double)n * from->volume) : sqrt((double)n * 2.5);
    r.n = n;
    r.box[0] = r.box[1] = side;
    r.box[2] = from->volume > 0 ? side : 0;
    packing_fill(&p, &r);
    packing_on(&p, FORCE_COLLISION, FORCE_DAMPING);
    return p;
}

static double *evaluate(mechanics *m, const packing *p, const double *x) {
    double *f = malloc(3 * p->c->particle.count * sizeof *f);
    mechanics_force(m, x, p->c->particle.v, f);
    return f;
}

static void assert_same(const packing *p, double *a, double *b) {
    assert_memory_equal(a, b, 3 * p->c->particle.count * sizeof *a);
    free(b);
}

/* List and pairs on the scene, and again after moves within the skin and out of it. */
static void check_against_pairs(const crowd *from, size_t n) {
    packing p = make(from, n, 100 + n);
    mechanics *list = packing_mechanics(&p, NEIGHBOR_CELLS, 1), *pairs = packing_mechanics(&p, NEIGHBOR_PAIRS, 1);
    size_t count = 3 * p.c->particle.count;
    double *x = malloc(count * sizeof *x);
    memcpy(x, p.c->particle.x, count * sizeof *x);
    const double moves[] = {0, 0.02, 0.02, 0.3};
    for (size_t i = 0; i < (n > 5000 ? 1 : 4); i++) {
        for (size_t j = 0; j < count; j++)
            x[j] += packing_draw(&p, -moves[i], moves[i]);
        double *f = evaluate(pairs, &p, x);
        assert_same(&p, f, evaluate(list, &p, x));
        free(f);
    }
    free(x);
    mechanics_free(list);
    mechanics_free(pairs);
    packing_free(&p);
}

static void test_pairs(void **state) {
    (void)state;
    static const size_t sizes[] = {1, 2, 3, 10, 100, 500, 2000, 20000};
    for (int c = 0; c < CROWDS; c++)
        for (int i = 0; i < (is_full() ? 8 : 7); i++)
            check_against_pairs(&crowds[c], sizes[i]);
}

static void test_threads(void **state) {
    (void)state;
    for (int c = 0; c < CROWDS; c++) {
        packing p = make(&crowds[c], 1500, 5);
        mechanics *one = packing_mechanics(&p, NEIGHBOR_CELLS, 1);
        double *f = evaluate(one, &p, p.c->particle.x);
        for (int threads = 2; threads <= 5; threads += 3) {
            mechanics *many = packing_mechanics(&p, NEIGHBOR_CELLS, threads);
            assert_same(&p, f, evaluate(many, &p, p.c->particle.x));
            mechanics_free(many);
        }
        free(f);
        mechanics_free(one);
        packing_free(&p);
    }
}

static void test_widths(void **state) {
    (void)state;
    static const char *const widths[] = {"base", "avx2", "avx512"};
    for (int c = 0; c < CROWDS; c++) {
        packing p = make(&crowds[c], 700, 5);
        mechanics *m = packing_mechanics(&p, NEIGHBOR_CELLS, 1);
        assert_true(mechanics_kernel(m, "base"));
        assert_false(mechanics_kernel(m, "mmx"));
        double *f = evaluate(m, &p, p.c->particle.x);
        for (int w = 1; w < 3; w++)
            if (mechanics_kernel(m, widths[w])) {
                assert_string_equal(mechanics_statistics(m).kernel, widths[w]);
                assert_same(&p, f, evaluate(m, &p, p.c->particle.x));
            }
        free(f);
        mechanics_free(m);
        packing_free(&p);
    }
}

/* The widths' exponentials, over and beyond the ranges of DLVO and of damping in a step. */
static void test_exponentials(void **state) {
    (void)state;
    static const char *const widths[] = {"avx2", "avx512"};
    enum { N = 1 << 14 };
    double *x = malloc(N * sizeof *x), *y = malloc(N * sizeof *y), *z = malloc(N * sizeof *z);
    for (int i = 0; i < N; i++)
        x[i] = i < 16 ? -1e5 * i : -800.0 * i / N;
    kernel_find("base")->exponential(N, x, y);
    for (int w = 0; w < 2; w++) {
        const contact_kernel *k = kernel_find(widths[w]);
        if (!k)
            continue;
        k->exponential(N, x, z);
        assert_memory_equal(y, z, N * sizeof *y);
    }
    for (int i = 0; i < N; i++)
        assert_near(y[i], exp(x[i]), 4e-16 * exp(x[i]));
    for (int i = 0; i < N; i++)
        x[i] = i < 16 ? -1e5 * i : -pow(10, 3 - 20.0 * i / N);
    kernel_find("base")->exponential_less_one(N, x, y);
    for (int w = 0; w < 2; w++) {
        const contact_kernel *k = kernel_find(widths[w]);
        if (!k)
            continue;
        k->exponential_less_one(N, x, z);
        assert_memory_equal(y, z, N * sizeof *y);
    }
    for (int i = 0; i < N; i++)
        assert_near(y[i], expm1(x[i]), 4e-16 * fabs(expm1(x[i])));
    free(x);
    free(y);
    free(z);
}

/* The skin decides how often lists are built, never a bit. */
static void test_skin(void **state) {
    (void)state;
    packing p = make(&crowds[3], 400, 9);
    double *first = NULL, most_builds = 0;
    for (double skin = 0; skin < 3; skin += 0.7) {
        mechanics *m = mechanics_create();
        const mechanics_input in = {.colony = p.c,
                                    .species = &p.species,
                                    .forces = &p.forces,
                                    .neighbor = {.skin = skin},
                                    .seed = 7,
                                    .threads = 1};
        assert_int_equal(mechanics_prepare(m, &in, NULL), SARCINA_OK);
        size_t count = 3 * p.c->particle.count;
        double *x = malloc(count * sizeof *x), *f = NULL;
        memcpy(x, p.c->particle.x, count * sizeof *x);
        for (int i = 0; i < 20; i++) {
            for (size_t j = 0; j < count; j++)
                x[j] += 0.01 * sin((double)j);
            free(f);
            f = evaluate(m, &p, x);
        }
        double builds = (double)mechanics_statistics(m).builds;
        if (first) {
            assert_true(builds < most_builds);
            assert_memory_equal(f, first, count * sizeof *f);
            free(f);
        } else {
            assert_true(builds == 20);
            first = f;
            most_builds = builds;
        }
        free(x);
        mechanics_free(m);
    }
    free(first);
    packing_free(&p);
}

/* States that are no states give NaN, at once and without a build. */
static void test_lost_states(void **state) {
    (void)state;
    packing p = make(&crowds[0], 50, 9);
    mechanics *m = packing_mechanics(&p, NEIGHBOR_CELLS, 1);
    size_t count = 3 * p.c->particle.count;
    double *x = malloc(count * sizeof *x), *f = evaluate(m, &p, p.c->particle.x);
    const double bad[] = {(double)NAN, (double)INFINITY, -1e300};
    for (int i = 0; i < 3; i++) {
        memcpy(x, p.c->particle.x, count * sizeof *x);
        x[7] = bad[i];
        double *g = evaluate(m, &p, x);
        assert_true(isnan(g[7]));
        free(g);
    }
    assert_same(&p, f, evaluate(m, &p, p.c->particle.x));
    free(f);
    free(x);
    mechanics_free(m);
    packing_free(&p);
}

/* Far from the origin the same contacts are found. */
static void test_far_away(void **state) {
    (void)state;
    packing p = make(&crowds[0], 200, 9);
    for (size_t i = 0; i < 3 * p.c->particle.count; i++)
        p.c->particle.x[i] += 1e9;
    mechanics *list = packing_mechanics(&p, NEIGHBOR_CELLS, 1), *pairs = packing_mechanics(&p, NEIGHBOR_PAIRS, 1);
    double *f = evaluate(pairs, &p, p.c->particle.x);
    assert_same(&p, f, evaluate(list, &p, p.c->particle.x));
    free(f);
    mechanics_free(list);
    mechanics_free(pairs);
    packing_free(&p);
}

/* Overlaps and contacts as a plain double loop finds them. */
static void test_contacts(void **state) {
    (void)state;
    packing p = make(&crowds[4], 150, 21); /* cocci: distance needs no other code */
    mechanics *m = packing_mechanics(&p, NEIGHBOR_CELLS, 1);
    double overlap[150], force[450];
    uint32_t contacts[150];
    mechanics_contacts(m, overlap, contacts, force);
    for (size_t i = 0; i < 150; i++) {
        double deepest = 0;
        uint32_t count = 0;
        for (size_t j = 0; j < 150; j++) {
            const double *a = p.c->particle.x + 3 * i, *b = p.c->particle.x + 3 * j;
            double d =
                sqrt((a[0] - b[0]) * (a[0] - b[0]) + (a[1] - b[1]) * (a[1] - b[1]) + (a[2] - b[2]) * (a[2] - b[2]));
            double radii = 0.5 * (p.c->cell.diameter[i] + p.c->cell.diameter[j]);
            if (i == j)
                continue;
            deepest = fmax(deepest, radii - d);
            count += d < 1.01 * radii;
        }
        assert_near(overlap[i], deepest, 1e-12);
        assert_int_equal(contacts[i], count);
    }
    double most = 0;
    for (size_t i = 0; i < 150; i++)
        most = fmax(most, sqrt(force[3 * i] * force[3 * i] + force[3 * i + 1] * force[3 * i + 1] +
                               force[3 * i + 2] * force[3 * i + 2]));
    assert_near(mechanics_fmax(m), most, 1e-9 * most);
    mechanics_free(m);
    packing_free(&p);
}

/* Rows sorted by space: other rows, the same cells, the same bits. */
static void test_arrange(void **state) {
    (void)state;
    packing p = make(&crowds[0], 800, 4);
    mechanics *m = packing_mechanics(&p, NEIGHBOR_CELLS, 1);
    double *f = evaluate(m, &p, p.c->particle.x), *g;
    mechanics_arrange(p.c);
    assert_int_equal(packing_bind(&p, m, NEIGHBOR_CELLS, 1, NULL), SARCINA_OK);
    g = evaluate(m, &p, p.c->particle.x);
    size_t moved = 0;
    for (size_t i = 0; i < 800; i++) {
        moved += p.c->cell.id[i] != i + 1;
        assert_memory_equal(g + 6 * i, f + 6 * (p.c->cell.id[i] - 1), 6 * sizeof *g);
    }
    assert_true(moved > 700);
    free(f);
    free(g);
    mechanics_free(m);
    packing_free(&p);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_pairs),        cmocka_unit_test(test_threads),  cmocka_unit_test(test_widths),
        cmocka_unit_test(test_exponentials), cmocka_unit_test(test_skin),     cmocka_unit_test(test_lost_states),
        cmocka_unit_test(test_far_away),     cmocka_unit_test(test_contacts), cmocka_unit_test(test_arrange),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}

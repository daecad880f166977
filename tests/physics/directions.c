/* SPDX-License-Identifier: GPL-3.0-or-later */
/* What has no direction of its own takes one from the seed: the same at every replay, opposite at the two ends, even
 * over seeds; and the stiffness that bounds steps is that of the very direction. Bounds are five standard deviations at
 * fixed seeds. */
#include "check.h"
#include "packing.h"

#include "mechanics/force_style.h"

enum { SEEDS = 2000 };

static const double origin[3] = {0, 0, 0}, right[3] = {2, 0, 0};

static void make_cocci(packing *p) {
    packing_coccus(p, origin, 1);
    packing_coccus(p, origin, 1);
    packing_on(p, FORCE_COLLISION, FORCE_COLLISION);
}

static void make_rods(packing *p) {
    p->species.list[PACKING_ROD].internal_k = 1; /* nothing beside the contact */
    packing_rod(p, origin, right, 2, 1);
    packing_rod(p, origin, right, 2, 1);
    packing_on(p, FORCE_COLLISION, FORCE_COLLISION);
}

static void make_rods_closest(packing *p) {
    make_rods(p);
    p->forces.term[FORCE_COLLISION].p[COLLISION_CONTACT] = CONTACT_CLOSEST;
}

static void make_rod_without_length(packing *p) {
    packing_rod(p, origin, origin, 2, 1);
}

static void make_spring_without_length(packing *p) {
    packing_coccus(p, origin, 1);
    packing_coccus(p, origin, 1);
    packing_spring(p, 0, 0, 1, 0, 1e4, 1);
}

static void make_anchor_without_length(packing *p) {
    packing_coccus(p, origin, 1);
    packing_spring(p, 0, 0, SPRING_ANCHOR, 0, 1e4, 1);
}

static void make_gliding_anchor(packing *p) {
    make_anchor_without_length(p);
    p->c->spring.glides[0] = true;
}

/* Straight, though it would be bent; its first end is judged. */
static void make_straight_chain(packing *p) {
    double x[21] = {0};
    for (size_t i = 0; i < 7; i++)
        x[3 * i] = 0.5 * (double)i;
    packing_chain(p, x, 7, 0.5, 0.5);
}

static void make_collapsed_chain(packing *p) {
    packing_chain(p, (double[21]){0}, 7, 0.5, 0.5);
}

/* What moves is the first particle; `pair`: the particle that moves the opposite way, 0: none. Means of its direction
 * over seeds, and of its square, by component. */
typedef struct kind {
    const char *name;
    void (*make)(packing *p);
    force_kind term;
    size_t pair;
    bool stiff; /* the stiffest mode is that of the pair */
    double mean[3], square[3];
} kind;

#define SPHERE                                                                                                         \
    {0, 0, 0}, {                                                                                                       \
        1.0 / 3, 1.0 / 3, 1.0 / 3                                                                                      \
    }
static const kind kinds[] = {
    {"cocci in one place", make_cocci, FORCE_COLLISION, 1, true, SPHERE},
    {"rods in one place", make_rods, FORCE_COLLISION, 2, true, SPHERE},
    {"rods in one place, published law", make_rods_closest, FORCE_COLLISION, 2, true, SPHERE},
    {"a rod without length", make_rod_without_length, FORCE_INTERNAL, 1, true, SPHERE},
    {"a link without length", make_spring_without_length, FORCE_SPRINGS, 1, true, SPHERE},
    {"an anchor without length",
     make_anchor_without_length,
     FORCE_SPRINGS,
     0,
     true,
     {0, 0, 0.5},
     {1.0 / 3, 1.0 / 3, 1.0 / 3}},
    {"a gliding anchor", make_gliding_anchor, FORCE_SPRINGS, 0, true, {0, 0, 1}, {0, 0, 1}},
    {"a straight chain", make_straight_chain, FORCE_BEND, 0, false, {0, 0, 0}, {0, 0.5, 0.5}},
    {"a chain in a point", make_collapsed_chain, FORCE_INTERNAL, 0, false, SPHERE},
};

typedef struct bench {
    packing p;
    mechanics *m;
    size_t n; /* 3 x particles */
    double *f, *again, *mode;
} bench;

static bench bench_open(const kind *k) {
    bench b = {.p = packing_create(1), .m = mechanics_create()};
    k->make(&b.p);
    b.n = 3 * b.p.c->particle.count;
    b.f = calloc(3 * b.n, sizeof *b.f);
    b.again = b.f + b.n;
    b.mode = b.again + b.n;
    return b;
}

static void bench_close(bench *b) {
    free(b->f);
    mechanics_free(b->m);
    packing_free(&b->p);
}

static void bind(bench *b, uint64_t seed) {
    mechanics_input in = packing_input(&b->p, NEIGHBOR_CELLS, 1);
    in.seed = seed;
    assert_int_equal(mechanics_prepare(b->m, &in, NULL), SARCINA_OK);
}

/* The direction with one seed. */
static void look(bench *b, const kind *k, uint64_t seed, double u[3]) {
    const double *x = b->p.c->particle.x;
    bind(b, seed);
    mechanics_force_of(b->m, k->term, x, NULL, b->f);
    double length = vec3_norm(vec3_load(b->f));
    assert_true(length > 0);
    vec3_store(u, vec3_scale(1 / length, vec3_load(b->f)));
    for (size_t i = 0; i < 3 && k->pair; i++)
        assert_true(b->f[i] == -b->f[3 * k->pair + i]);
}

/* The stiffest mode moves the first particle along the force, or against it. */
static void check_mode(bench *b, const double u[3]) {
    memset(b->mode, 0, b->n * sizeof *b->mode);
    assert_true(mechanics_stiffness_from(b->m, b->p.c->particle.x, b->mode) > 0);
    double length = vec3_norm(vec3_load(b->mode));
    assert_near(fabs(vec3_dot(vec3_load(b->mode), vec3_load(u))), length, 1e-3 * length);
}

static void check_replay(bench *b, const kind *k) {
    double u[3];
    look(b, k, 3, u);
    memcpy(b->again, b->f, b->n * sizeof *b->f);
    look(b, k, 4, u);
    bool differs = memcmp(b->f, b->again, b->n * sizeof *b->f) != 0;
    assert_true(differs == (k->square[2] < 1));
    look(b, k, 3, u);
    assert_memory_equal(b->f, b->again, b->n * sizeof *b->f);
}

static void check_even(bench *b, const kind *k) {
    double sum[3] = {0}, square[3] = {0}, u[3];
    for (uint64_t seed = 1; seed <= SEEDS; seed++) {
        look(b, k, seed, u);
        for (int i = 0; i < 3; i++) {
            sum[i] += u[i] / SEEDS;
            square[i] += u[i] * u[i] / SEEDS;
        }
        if (k->stiff && seed % 100 == 0)
            check_mode(b, u);
    }
    for (int i = 0; i < 3; i++) {
        assert_near(sum[i], k->mean[i], 5 * sqrt(1.0 / 3 / SEEDS));
        assert_near(square[i], k->square[i], 5 * sqrt(1.0 / 8 / SEEDS));
    }
}

static void test_directions(void **state) {
    (void)state;
    for (size_t i = 0; i < sizeof kinds / sizeof kinds[0]; i++) {
        print_message("%s\n", kinds[i].name);
        bench b = bench_open(&kinds[i]);
        check_replay(&b, &kinds[i]);
        check_even(&b, &kinds[i]);
        bench_close(&b);
    }
}

/* A coil that has been drawn out straight winds to the side that it is told (at division: a seeded one), which turned
 * about the cell turns the helix with it. */
static void test_straight_coil(void **state) {
    (void)state;
    const chain_coil coil = {0.4, 2, false};
    const vec3 side = {0, 1, 0}, turned = {0, 0, 1};
    double x[9] = {0, 0, 0, 0.5, 0, 0, 1, 0, 0}, most = 0;
    for (int i = 0; i <= 16; i++) {
        const double u = 0.125 * i;
        vec3 a = chain_point(&coil, 0.6, x, 3, u, side), b = chain_point(&coil, 0.6, x, 3, u, turned);
        assert_near(b.x, a.x, 1e-15);
        assert_near(b.y, -a.z, 1e-15);
        assert_near(b.z, a.y, 1e-15);
        most = fmax(most, hypot(a.y, a.z));
    }
    assert_true(most > 0.01);
}

int main(void) {
    const struct CMUnitTest tests[] = {cmocka_unit_test(test_directions), cmocka_unit_test(test_straight_coil)};
    return cmocka_run_group_tests_name("directions", tests, NULL, NULL);
}

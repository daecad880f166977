/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The contacts of many owners at once against the plain sum over all pairs, one after the other in the order of ids:
 * the same bits in every vector width, by either method of finding neighbours, with one thread and with two. Scenes
 * that are hard for it: axes that meet, that are parallel, of length zero, rows of more than 255 partners, one body,
 * none. */
#include "check.h"
#include "packing.h"

#include "base/rng.h"
#include "mechanics/contact.h"
#include "mechanics/kernel.h"

enum { SEED = 7 }; /* packing_input's */

/* A cell of one or two particles as a segment. */
typedef struct segment {
    double x[3], d[3], radius, rest;
    uint64_t id;
    size_t first, last; /* rows of its particles */
} segment;

static segment segment_of(const colony *c, size_t row) {
    segment s = {.id = c->cell.id[row], .first = c->cell.first[row], .rest = c->cell.rest[row]};
    s.last = s.first + c->cell.nparticles[row] - 1;
    s.radius = 0.5 * c->cell.diameter[row];
    for (int k = 0; k < 3; k++) {
        s.x[k] = c->particle.x[3 * s.first + (size_t)k];
        s.d[k] = c->particle.x[3 * s.last + (size_t)k] - s.x[k];
    }
    return s;
}

/* What `other` does to `own`: force, and the part of it on the last particle. */
static void add_contact(contact_law_values law, bool flat, const segment *own, const segment *other, double total[3],
                        double last[3]) {
    bool first = own->id < other->id;
    const segment *a = first ? own : other, *b = first ? other : own;
    contact_pair pair = {.radii = a->radius + b->radius, .rests = a->rest * b->rest};
    for (int k = 0; k < 3; k++) {
        pair.r[k] = a->x[k] - b->x[k];
        pair.d1[k] = a->d[k];
        pair.d2[k] = b->d[k];
    }
    contact_result c = contact_compute(law, pair);
    if (c.square < CONTACT_COINCIDENT * CONTACT_COINCIDENT && c.g < c.reach) {
        (flat ? rng_direction_flat : rng_direction)(SEED, a->id, b->id, c.delta);
        c.scale = law.k * (sqrt(c.reach) - sqrt(c.g));
    }
    for (int k = 0; k < 3; k++) {
        double force = (first ? c.scale : -c.scale) * c.delta[k];
        total[k] += force;
        last[k] += (first ? c.s : c.t) * force;
    }
}

/* Rows of the colony stand in the order of ids. */
static double *plain_forces(const packing *p, bool flat) {
    const double *t = p->forces.term[FORCE_COLLISION].p;
    const contact_law_values law = {t[COLLISION_K], t[COLLISION_REACH],
                                    (contact_law)t[COLLISION_CONTACT] == CONTACT_CLOSEST ? 0 : t[COLLISION_EPSILON]};
    size_t n = p->c->cell.count;
    double *f = calloc(3 * p->c->particle.count + 1, sizeof *f);
    for (size_t i = 0; i < n; i++) {
        segment own = segment_of(p->c, i);
        double total[3] = {0}, last[3] = {0};
        for (size_t j = 0; j < n; j++) {
            segment other = segment_of(p->c, j);
            if (i != j)
                add_contact(law, flat, &own, &other, total, last);
        }
        for (size_t k = 0; k < 3; k++) {
            f[3 * own.first + k] += total[k] - last[k];
            f[3 * own.last + k] += last[k];
        }
    }
    return f;
}

static void check_scene(packing *p, bool flat) {
    static const char *const widths[] = {"base", "avx2", "avx512"};
    size_t bytes = 3 * p->c->particle.count * sizeof(double);
    packing_on(p, FORCE_COLLISION, FORCE_COLLISION);
    double *expected = plain_forces(p, flat), *f = malloc(bytes + 1);
    for (int variant = 0; variant < 12; variant++) {
        mechanics_input in = packing_input(p, variant % 2 ? NEIGHBOR_PAIRS : NEIGHBOR_CELLS, 1 + variant / 2 % 2);
        in.flat = flat;
        mechanics *m = mechanics_create();
        assert_int_equal(mechanics_prepare(m, &in, NULL), SARCINA_OK);
        if (mechanics_kernel(m, widths[variant / 4])) {
            double *x, *v;
            mechanics_take_state(m, &x, &v);
            mechanics_force_of(m, FORCE_COLLISION, x, NULL, f);
            mechanics_return_state(m);
            if (!flat)
                assert_memory_equal(f, expected, bytes);
            for (size_t i = 0; flat && i < p->c->particle.count; i++)
                assert_true(f[2 * i] == expected[3 * i] && f[2 * i + 1] == expected[3 * i + 1]);
        }
        mechanics_free(m);
    }
    free(f);
    free(expected);
    packing_free(p);
}

static packing fill(size_t n, double side, double rods, uint64_t seed) {
    packing p = packing_create(seed);
    const packing_recipe r = {n, {side, side, side}, rods, 0.5, 4, 0.4, 1.1, 1};
    packing_fill(&p, &r);
    return p;
}

/* Cocci, rods, and both, under both laws; sizes about the width of a group and of a window. */
static void test_packings(void **state) {
    (void)state;
    static const size_t sizes[] = {1, 2, 7, 8, 9, 127, 128, 129, 600};
    for (size_t i = 0; i < sizeof sizes / sizeof sizes[0]; i++)
        for (int rods = 0; rods <= 2; rods++) {
            packing p = fill(sizes[i], cbrt(1.5 * (double)sizes[i]), 0.5 * rods, 11 + i);
            p.forces.term[FORCE_COLLISION].p[COLLISION_CONTACT] = i % 2 ? CONTACT_CLOSEST : CONTACT_REGULARISED;
            check_scene(&p, false);
        }
}

static void test_nobody(void **state) {
    (void)state;
    packing p = packing_create(1);
    check_scene(&p, false);
}

/* More partners than fit in a block, and than rows are sorted by, beside rows of one or two. */
static void test_long_rows(void **state) {
    (void)state;
    packing p = fill(400, 1.5, 0.5, 3);
    for (int i = 0; i < 40; i++)
        packing_coccus(&p, (double[]){20 + 0.9 * i, 0, 1}, 1);
    check_scene(&p, false);
}

/* Axes that meet in one point, cells in one place, rods on one line and side by side, rods without a length. */
static void add_degenerate(packing *p) {
    for (int i = 0; i < 6; i++) {
        double angle = 0.5 * i, a[3] = {cos(angle), sin(angle), 0}, b[3] = {-a[0], -a[1], 0};
        packing_rod(p, a, b, 2, 0.8); /* a star */
        packing_rod(p, (double[]){5, 0, 0}, (double[]){7, 0, 0}, 2, 0.8);
        packing_rod(p, (double[]){0.7 * i, 5, 0}, (double[]){0.7 * i, 7, 0}, 2, 0.8);
        packing_rod(p, (double[]){1.5 * i, -5, 0}, (double[]){1.5 * i + 2, -5, 0}, 2, 0.8);
        packing_rod(p, (double[]){0.3 * i, -9, 0}, (double[]){0.3 * i, -9, 0}, 1, 0.8);
        packing_coccus(p, (double[]){9, 9, 0}, 1);
    }
}

static void test_degenerate(void **state) {
    (void)state;
    for (int flat = 0; flat <= 1; flat++) {
        packing p = packing_create(1);
        add_degenerate(&p);
        check_scene(&p, flat);
    }
    packing cocci = packing_create(1);
    for (int i = 0; i < 20; i++)
        packing_coccus(&cocci, (double[]){i % 10, 0, 0}, 1);
    check_scene(&cocci, false);
}

static void test_plane(void **state) {
    (void)state;
    for (int rods = 0; rods <= 2; rods++) {
        packing p = packing_create(5);
        const packing_recipe r = {300, {16, 16, 0}, 0.5 * rods, 0.5, 3, 0.5, 0.9, 0};
        packing_fill(&p, &r);
        for (size_t i = 0; i < p.c->particle.count; i++)
            p.c->particle.x[3 * i + 2] = 0;
        check_scene(&p, true);
    }
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_packings),   cmocka_unit_test(test_nobody), cmocka_unit_test(test_long_rows),
        cmocka_unit_test(test_degenerate), cmocka_unit_test(test_plane),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}

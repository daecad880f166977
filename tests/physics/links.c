/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Links as the constructors make them, by loops over kinds and shapes: they pull on both cells alike, hold them where
 * the formulas say, and follow growth. */
#include "check.h"
#include "packing.h"

#include "model/link.h"
#include "model/link_check.h"
#include "relax/relax.h"

enum { SHAPES = PACKING_FLEXIBLE + 1 };

static const link_rule filial = {true, {2e4, 2, 0.5, 1.7, 1.1}};
static const link_rule stick = {true, {1e4, 0.5, 1, HANDOVER_NEARER}};

/* A cell of a shape about a centre, in a random direction. */
static uint32_t add_shape(packing *p, int shape, const double centre[3]) {
    double u[3], a[3], b[3];
    packing_direction(p, u);
    for (int k = 0; k < 3; k++) {
        a[k] = centre[k] - 1.1 * u[k];
        b[k] = centre[k] + 1.1 * u[k];
    }
    if (shape == PACKING_COCCUS)
        return packing_coccus(p, centre, 0.9);
    if (shape == PACKING_ROD)
        return packing_rod(p, a, b, 2, 0.7);
    return packing_coil(p, centre, 0.5, 0.6, 0.05);
}

/* Sums of forces and torques over all particles, relative to the forces that cancel in them. */
static void check_balance(const packing *p) {
    size_t n = p->c->particle.count;
    mechanics *m = packing_mechanics(p, NEIGHBOR_CELLS, 1);
    double *f = calloc(3 * n, sizeof *f), sum[3] = {0}, torque[3] = {0}, magnitude = 0;
    mechanics_force_of(m, FORCE_SPRINGS, p->c->particle.x, NULL, f);
    for (size_t i = 0; i < n; i++) {
        const double *x = p->c->particle.x + 3 * i, *g = f + 3 * i;
        for (int k = 0; k < 3; k++) {
            sum[k] += g[k];
            torque[k] += x[(k + 1) % 3] * g[(k + 2) % 3] - x[(k + 2) % 3] * g[(k + 1) % 3];
            magnitude += fabs(g[k]);
        }
    }
    assert_true(magnitude > 0);
    for (int k = 0; k < 3; k++) {
        assert_near(sum[k], 0, 1e-14 * magnitude);
        assert_near(torque[k], 0, 1e-13 * magnitude);
    }
    free(f);
    mechanics_free(m);
}

static uint32_t add_link(packing *p, link_kind kind, link_joint joint, uint32_t a, uint32_t b) {
    uint32_t link = kind == LINK_FILIAL ? link_add_filial(p->c, &filial, joint, a, LINK_FIRST_END, b, LINK_LAST_END, 0)
                                        : link_add_stick(p->c, &stick, a, b, 0);
    /* under tension, whatever it was formed with */
    for (uint32_t i = 0; i < p->c->link.nsprings[link]; i++)
        p->c->spring.rest[p->c->link.first[link] + i] *= 0.9;
    return link;
}

/* Every kind of link between cells, every pair of shapes. */
static void test_momentum(void **state) {
    (void)state;
    static const struct {
        link_kind kind;
        link_joint joint;
    } kinds[] = {{LINK_FILIAL, LINK_STRAIGHT}, {LINK_FILIAL, LINK_BRANCHED}, {LINK_STICK, LINK_STRAIGHT}};
    for (int a = 0; a < SHAPES; a++)
        for (int b = 0; b < SHAPES; b++)
            for (size_t k = 0; k < sizeof kinds / sizeof *kinds; k++) {
                packing p = packing_create((uint64_t)(a * 10 + b));
                uint32_t one = add_shape(&p, a, (double[]){0, 0, 3});
                uint32_t two = add_shape(&p, b, (double[]){1, 1.5, 3.5});
                add_link(&p, kinds[k].kind, kinds[k].joint, one, two);
                assert_null(link_check(p.c).what);
                check_balance(&p);
                packing_free(&p);
            }
}

/* A gliding anchor pulls straight down and nowhere else; a fixed one towards its point. */
static void test_anchors(void **state) {
    (void)state;
    for (int glides = 0; glides < 2; glides++)
        for (int shape = 0; shape < SHAPES; shape++) {
            packing p = packing_create((uint64_t)shape + 1);
            const link_rule rule = {true, {1e4, 0.5, 1, glides, 0}};
            uint32_t row = add_shape(&p, shape, (double[]){0, 0, 2});
            link_add_anchor(p.c, &rule, row, 0, 0);
            for (size_t i = 0; i < p.c->particle.count; i++) {
                p.c->particle.x[3 * i] += 0.3;
                p.c->particle.x[3 * i + 2] += 0.2;
            }
            mechanics *m = packing_mechanics(&p, NEIGHBOR_CELLS, 1);
            size_t n = p.c->particle.count;
            double *f = calloc(3 * n, sizeof *f);
            mechanics_force_of(m, FORCE_SPRINGS, p.c->particle.x, NULL, f);
            for (size_t i = 0; i < n; i++) {
                assert_true(f[3 * i + 2] < 0);
                assert_true(glides ? f[3 * i] == 0 : f[3 * i] < 0);
                assert_true(f[3 * i + 1] == 0);
                if (glides)
                    assert_near(f[3 * i + 2], -1e4 / (double)n * 0.2, 1e-8);
            }
            free(f);
            mechanics_free(m);
            packing_free(&p);
        }
}

static void relax_long(const packing *p) {
    mechanics *m = packing_mechanics(p, NEIGHBOR_CELLS, 1);
    relax_result result;
    const relax_settings how = {.integrator = INTEGRATOR_VERLET};
    assert_int_equal(relax_run(m, &how, &(relax_goal){.time = 600, .force = 1e-9}, &result, NULL), SARCINA_OK);
    assert_int_equal(result.stop, RELAX_FORCE);
    mechanics_free(m);
}

/* At rest without contact two linked cocci are ratio D apart. Of rods, the short spring pulls the facing ends together
 * as the long one pushes the far ends apart, and the rods' own springs (k_i, one a rod) give way between them:
 *   distance of the facing ends = short D + 2 (long - short) D / (4 + rods k/k_i). */
static void test_gap(void **state) {
    (void)state;
    for (int a = 0; a < PACKING_FLEXIBLE; a++)
        for (int b = 0; b <= a; b++) {
            packing p = packing_create(1);
            packing_on(&p, FORCE_DAMPING, FORCE_DAMPING);
            for (int i = 0; i < 2; i++) {
                double at = 4.1 * i;
                if ((i ? b : a) == PACKING_ROD)
                    packing_rod(&p, (double[]){at, 0, 3}, (double[]){at + 2, 0, 3}, 2, 0.8);
                else
                    packing_coccus(&p, (double[]){at, 0, 3}, 0.8);
            }
            uint32_t link = link_add_filial(p.c, &filial, LINK_STRAIGHT, 0, LINK_LAST_END, 1, LINK_FIRST_END, 0);
            relax_long(&p);
            int rods = (a == PACKING_ROD) + (b == PACKING_ROD);
            double gap = rods ? 0.5 * 0.8 + 2 * 1.2 * 0.8 / (4 + rods * 2e4 / 5e4) : 1.1 * 0.8;
            assert_near(colony_spring_length(p.c, p.c->link.first[link]), gap, 1e-9);
            packing_free(&p);
        }
}

/* Rest lengths follow growth and stiffness follows its rule; what has formed by nearness keeps its length. */
static void test_renew(void **state) {
    (void)state;
    packing p = packing_create(1);
    packing_rule(&p, LINK_FILIAL, PACKING_ROD, PACKING_ROD, (double[LINK_PARAMS_MAX]){2e4, 2, 0.5, 1.7, 1.1});
    packing_rule(&p, LINK_STICK, PACKING_ROD, PACKING_COCCUS, (double[LINK_PARAMS_MAX]){1e4, 0.5, 1});
    packing_rod(&p, (double[]){0, 0, 3}, (double[]){2, 0, 3}, 2, 0.8);
    packing_rod(&p, (double[]){3, 0, 3}, (double[]){5, 0, 3}, 2, 0.8);
    packing_coccus(&p, (double[]){1, 1, 3}, 0.8);
    uint32_t one = link_add_filial(p.c, &filial, LINK_STRAIGHT, 1, LINK_FIRST_END, 0, LINK_LAST_END, 0);
    uint32_t two = link_add_stick(p.c, link_rules_find(&p.links, LINK_STICK, PACKING_ROD, PACKING_COCCUS), 0, 2, 0);
    double stuck = p.c->spring.rest[p.c->link.first[two]];
    p.c->cell.rest[0] = 2.6;
    p.c->cell.diameter[1] = 1;
    packing_rule(&p, LINK_FILIAL, PACKING_ROD, PACKING_ROD, (double[LINK_PARAMS_MAX]){3e4, 2, 0.4, 1.8, 1.1});
    packing_rule(&p, LINK_STICK, PACKING_ROD, PACKING_COCCUS, (double[LINK_PARAMS_MAX]){5e3, 0.5, 1});
    link_renew(p.c, &p.links);
    const double *rest = p.c->spring.rest + p.c->link.first[one], *k = p.c->spring.k;
    assert_near(rest[0], 0.4 * 0.9, 1e-15);
    assert_near(rest[1], 1.8 * 0.9 + 2.6 + 2, 1e-15);
    assert_near(k[p.c->link.first[one]], 1.5e4, 0);
    assert_near(k[p.c->link.first[two]], 2.5e3, 0);
    assert_near(p.c->spring.rest[p.c->link.first[two]], stuck, 0);
    /* a kind whose rule is gone is dropped by name, and no other */
    link_rule none = {false, {0}};
    link_rules_set(&p.links, LINK_STICK, PACKING_ROD, PACKING_COCCUS, &none);
    assert_int_equal(link_drop_unruled(p.c, &p.links, LINK_FILIAL), 0);
    assert_int_equal(link_drop_unruled(p.c, &p.links, LINK_STICK), 1);
    assert_int_equal(p.c->link.count, 1);
    packing_free(&p);
}

/* Rules of pairs are the same either way round, and survive that species are added. */
static void test_rules(void **state) {
    (void)state;
    link_rules r;
    memset(&r, 0, sizeof r);
    link_rules_clear(&r);
    assert_null(link_rules_find(&r, LINK_STICK, 0, 0));
    const link_rule one = {true, {1}}, two = {true, {2}};
    link_rules_set(&r, LINK_STICK, 2, 0, &one);
    link_rules_set(&r, LINK_ANCHOR, 1, 1, &two);
    link_rules_grow(&r, 7);
    assert_near(link_rules_find(&r, LINK_STICK, 0, 2)->p[0], 1, 0);
    assert_near(link_rules_find(&r, LINK_STICK, 2, 0)->p[0], 1, 0);
    assert_near(link_rules_find(&r, LINK_ANCHOR, 1, 1)->p[0], 2, 0);
    assert_null(link_rules_find(&r, LINK_STICK, 2, 2));
    assert_null(link_rules_find(&r, LINK_FILIAL, 9, 9));
    assert_true(link_rules_any(&r, LINK_STICK) && !link_rules_any(&r, LINK_FILIAL));
    link_rules_free(&r);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_momentum), cmocka_unit_test(test_anchors), cmocka_unit_test(test_gap),
        cmocka_unit_test(test_renew),    cmocka_unit_test(test_rules),
    };
    return cmocka_run_group_tests_name("links", tests, NULL, NULL);
}

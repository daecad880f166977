/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The contact of two segments against a slow minimisation: parallel, collinear, crossing, degenerate, nearly parallel
 * and random ones, under both laws. */
#include "check.h"
#include "packing.h"

#include "mechanics/contact.h"

static const contact_law_values published = {1e5, 1.01, 0}, regularised = {1e5, 1.01, 0.01};

static contact_pair pair_of(const double a[6], const double b[6]) {
    contact_pair p = {.radii = 0.8, .rests = 1};
    double la = 0, lb = 0;
    for (int k = 0; k < 3; k++) {
        p.r[k] = a[k] - b[k];
        p.d1[k] = a[3 + k] - a[k];
        p.d2[k] = b[3 + k] - b[k];
        la += p.d1[k] * p.d1[k];
        lb += p.d2[k] * p.d2[k];
    }
    p.rests = sqrt(la * lb);
    return p;
}

static double weight_of(contact_law_values law, const contact_pair *p) {
    double square = law.reach * p->radii * law.reach * p->radii;
    return law.epsilon * fmin(square, p->rests);
}

/* |p(s) - q(t)|^2 + w [...] */
static double value_at(const contact_pair *p, double w, double s, double t) {
    double sum = w * ((s - 0.5) * (s - 0.5) + (t - 0.5) * (t - 0.5));
    for (int k = 0; k < 3; k++) {
        double d = p->r[k] + s * p->d1[k] - t * p->d2[k];
        sum += d * d;
    }
    return sum;
}

/* Least value for one s: a parabola in t, by nested thirds of its own. */
static double least_over_t(const contact_pair *p, double w, double s) {
    double low = 0, high = 1;
    for (int i = 0; i < 120; i++) {
        double a = low + (high - low) / 3, b = high - (high - low) / 3;
        if (value_at(p, w, s, a) < value_at(p, w, s, b))
            high = b;
        else
            low = a;
    }
    return value_at(p, w, s, 0.5 * (low + high));
}

/* Least value over the square: it is convex, so thirds of s find the valley. */
static double least_value(const contact_pair *p, double w) {
    double low = 0, high = 1;
    for (int i = 0; i < 120; i++) {
        double a = low + (high - low) / 3, b = high - (high - low) / 3;
        if (least_over_t(p, w, a) < least_over_t(p, w, b))
            high = b;
        else
            low = a;
    }
    return least_over_t(p, w, 0.5 * (low + high));
}

static void check(const double a[6], const double b[6]) {
    contact_pair p = pair_of(a, b);
    for (int law = 0; law < 2; law++) {
        contact_law_values values = law ? regularised : published;
        double w = weight_of(values, &p), least = least_value(&p, w);
        contact_result c = contact_compute(values, p);
        double seen = value_at(&p, w, c.s, c.t);
        assert_true(c.s >= 0 && c.s <= 1 && c.t >= 0 && c.t <= 1);
        assert_near(sqrt(seen), sqrt(least), 2e-7);
        assert_near(c.square, value_at(&p, 0, c.s, c.t), 1e-12);
        double reach = sqrt(1.01 * 0.8 * 1.01 * 0.8 + w / 4);
        assert_near(contact_overlap(&c), fmax(0, reach - sqrt(seen)), 1e-9);
    }
}

static void test_cases(void **state) {
    (void)state;
    static const double cases[][12] = {
        {0, 0, 0, 3, 0, 0, 0.5, 0.7, 0, 3.5, 0.7, 0},        /* parallel */
        {0, 0, 0, 3, 0, 0, 3.5, 0.7, 0, 0.5, 0.7, 0},        /* antiparallel */
        {0, 0, 0, 3, 0, 0, 3.4, 0, 0, 6, 0, 0},              /* collinear, apart */
        {0, 0, 0, 3, 0, 0, 2.5, 0, 0, 6, 0, 0},              /* collinear, overlapping */
        {0, 0, 0, 3, 0, 0, 1, -1, 0, 1, 1, 0},               /* crossing */
        {0, 0, 0, 3, 0, 0, 1, -1, 0.3, 1, 1, 0.3},           /* skew */
        {0, 0, 0, 3, 0, 0, 3.2, 0.2, 0, 3.2, 2, 0},          /* end against end */
        {0, 0, 0, 0, 0, 0, 0.5, 0, 0, 3, 0, 0},              /* point and segment */
        {1, 0.3, 0, 1, 0.3, 0, 0, 0, 0, 3, 0, 0},            /* point beside segment */
        {0, 0, 0, 0, 0, 0, 0.5, 0.1, 0, 0.5, 0.1, 0},        /* two points */
        {0, 0, 0, 3, 0, 0, 0.5, 0.7, 0, 3.5, 0.7000003, 0},  /* nearly parallel: 1e-7 */
        {0, 0, 0, 3, 0, 0, 3.5, 0.70000001, 0, 0.5, 0.7, 0}, /* 3e-9 */
        {0, 0, 0, 3, 0, 0, 0.5, 0.7, 0, 3.5, 0.7, 1e-12},    /* 3e-13 */
        {0, 0, 0, 3, 1, 2, 0, 0, 0, 3, 1, 2},                /* the same segment twice */
    };
    for (size_t i = 0; i < sizeof cases / sizeof cases[0]; i++) {
        check(cases[i], cases[i] + 6);
        check(cases[i] + 6, cases[i]);
    }
}

static void test_random(void **state) {
    (void)state;
    packing p = packing_create(2);
    for (int i = 0; i < 300; i++) {
        double x[12];
        for (int k = 0; k < 12; k++)
            x[k] = packing_draw(&p, -1.5, 1.5);
        /* every third pair is turned nearly parallel, by 1e-3 ... 1e-12 */
        double tilt = pow(10, -3 - i % 10);
        for (int k = 0; i % 3 == 0 && k < 3; k++)
            x[9 + k] = x[6 + k] + 0.8 * (x[3 + k] - x[k]) + tilt * packing_draw(&p, -1, 1);
        check(x, x + 6);
    }
    packing_free(&p);
}

/* The regularised law moves continuously where the published one jumps: rods turned through parallel. */
static void test_continuity(void **state) {
    (void)state;
    double jump[2] = {0, 0}, before[2] = {0, 0};
    for (int i = -50; i <= 50; i++) {
        double tilt = 1e-5 * i, a[6] = {0, 0, 0, 3, 0, 0}, b[6] = {0.5, 0.7 - tilt, 0, 3.5, 0.7 + tilt, 0};
        for (int law = 0; law < 2; law++) {
            contact_result c = contact_compute(law ? regularised : published, pair_of(a, b));
            if (i > -50)
                jump[law] = fmax(jump[law], fabs(c.s - before[law]));
            before[law] = c.s;
        }
    }
    assert_true(jump[0] > 0.5);
    assert_true(jump[1] < 0.02);
}

static double overlap_of(contact_law_values law, contact_pair p) {
    contact_result c = contact_compute(law, p);
    return contact_overlap(&c);
}

/* w centres the deviation: overlap differs from the plain one by at most epsilon R / 8. */
static void test_bias(void **state) {
    (void)state;
    static const double b[][6] = {{0, 0.79, 0, 3, 0.79, 0}, {1.5, 0.79, 0, 1.5, 3.79, 0}, {3.79, 0, 0, 6.79, 0, 0}};
    const double a[6] = {0, 0, 0, 3, 0, 0}, bound = 0.01 * 1.01 * 0.8 / 8;
    const double wanted[] = {bound, 0, -bound};
    for (int i = 0; i < 3; i++) {
        contact_pair p = pair_of(a, b[i]);
        double shift = overlap_of(regularised, p) - overlap_of(published, p);
        assert_near(shift, wanted[i], 0.1 * bound);
    }
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_cases),
        cmocka_unit_test(test_random),
        cmocka_unit_test(test_continuity),
        cmocka_unit_test(test_bias),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}

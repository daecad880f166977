/* SPDX-License-Identifier: GPL-3.0-or-later */
/* tradeoff: what its statistics find and what they don't, on made-up numbers and on colonies with a bias put into what
 * is observed; that the scene is left as it was, to the bit, however it ends; how honest the reference's error is; and
 * where trajectories diverge. */
#include "script_host.h"

#include "analysis/value.h"
#include "engine/snapshot.h"
#include "engine/tradeoff.h"

#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>

#include <cmocka.h>

#include <gsl/gsl_randist.h>
#include <math.h>
#include <stdio.h>

static script_host host;

SCRIPT_HOST_OF_GROUP(host)

static interp *make(const char *script) {
    interp *in = interp_create(&host.host);
    script_host_clear(&host);
    if (interp_run_source(in, "scene", script) != SARCINA_OK)
        printf("%s\n", host.errors);
    assert_string_equal(host.errors, "");
    return in;
}

static const char rods[] = "species stick rod diameter 0.75um sd 5%\n"
                           "growth stick exponential rate 1.23/h sd 0.277/h\n"
                           "division stick midpoint mass 2.45e-15kg\n"
                           "substratum plane\n"
                           "force collision\n"
                           "force damping\n"
                           "link internal stick\n"
                           "create_cells stick single 0 0 0 orient x gap 10nm\n"
                           "run 30 grow 4min relax 0.2s\n";

enum { TRIALS = 20 };

/* ---- statistics -------------------------------------------------------------------------------------------------- */

/* Three methods (reference, alike, biased) with two quantities each: seeds scatter by 10 %, methods by 2 % within a
 * seed; the third is biased by 5 % in its second quantity. */
static void draw_runs(gsl_rng *g, tradeoff_runs *r) {
    for (size_t seed = 0; seed < r->seeds; seed++)
        for (size_t k = 0; k < r->nobserved; k++) {
            double common = 10 + gsl_ran_gaussian(g, 1);
            for (size_t m = 0; m < r->methods; m++) {
                double bias = m == 2 && k == 1 ? 1.05 : 1;
                r->values[(m * r->seeds + seed) * r->nobserved + k] = common * bias * (1 + gsl_ran_gaussian(g, 0.014));
            }
        }
}

static bool is_biased(const tradeoff_comparison *all, size_t method, size_t nobserved) {
    for (size_t k = 0; k < nobserved; k++)
        if (all[method * nobserved + k].verdict == TRADEOFF_BIASED)
            return true;
    return false;
}

static void test_made_up(void **state) {
    (void)state;
    enum { SEEDS = 8, METHODS = 3, NOBSERVED = 2 };
    double values[METHODS * SEEDS * NOBSERVED];
    tradeoff_cost cost[METHODS] = {{0}};
    bool none[METHODS] = {false};
    tradeoff_runs r = {METHODS, SEEDS, NOBSERVED, values, cost, none};
    tradeoff_comparison all[METHODS * NOBSERVED];
    gsl_rng *g = gsl_rng_alloc(gsl_rng_mt19937);
    int found = 0, flagged = 0;
    for (int i = 0; i < TRIALS; i++) {
        draw_runs(g, &r);
        tradeoff_compare(&r, 0, 0.02, all);
        found += is_biased(all, 2, NOBSERVED);
        flagged += is_biased(all, 1, NOBSERVED);
        assert_int_equal(all[0].verdict, TRADEOFF_EQUIVALENT); /* with itself */
    }
    gsl_rng_free(g);
    printf("made up: a bias of 5 %% found in %d of %d, none flagged in %d\n", found, TRIALS, flagged);
    assert_true(found >= 19);
    assert_true(flagged <= 2);
}

/* Values by hand: differences 1, 2, 3 of 100: mean 2, sd 1, standard error 0.5774, t(0.975, 2) = 4.3027. */
static void test_by_hand(void **state) {
    (void)state;
    double values[] = {100, 100, 100, 101, 102, 103};
    tradeoff_cost cost[2] = {{.evaluations = 1000}, {.evaluations = 500}};
    bool none[2] = {false, false};
    tradeoff_runs r = {2, 3, 1, values, cost, none};
    tradeoff_comparison all[2];
    tradeoff_compare(&r, 0, 0.05, all);
    assert_true(fabs(all[1].difference.value - 2) < 1e-12 && fabs(all[1].width - 2.4841) < 1e-3);
    assert_true(fabs(all[1].margin - 5) < 1e-12);
    /* one-sided: (5 - 2) / 0.5774 = 5.196, p = 0.01754 at 2 degrees of freedom: equivalent within 5 %, not within 3 */
    assert_true(fabs(all[1].p - 0.01754) < 1e-4);
    assert_int_equal(all[1].verdict, TRADEOFF_EQUIVALENT);
    assert_int_equal(tradeoff_cheapest(&r, 0, all), 1);
    tradeoff_compare(&r, 0, 0.03, all);
    assert_int_equal(all[1].verdict, TRADEOFF_OPEN);
    assert_int_equal(tradeoff_cheapest(&r, 0, all), 0);
    assert_true(all[1].seeds == 4); /* what it would take, by the table of powers: at least one more */
    /* surely not 0, and surely small: equivalent; surely large: biased */
    for (int i = 3; i < 6; i++)
        values[i] = 101 + 0.01 * i;
    tradeoff_compare(&r, 0, 0.02, all);
    assert_int_equal(all[1].verdict, TRADEOFF_EQUIVALENT);
    assert_true(all[1].difference.value > all[1].width);
    tradeoff_compare(&r, 0, 0.005, all);
    assert_int_equal(all[1].verdict, TRADEOFF_BIASED);
    none[1] = true;
    tradeoff_compare(&r, 0, 0.005, all);
    assert_int_equal(all[1].verdict, TRADEOFF_UNDEFINED);
    assert_int_equal(tradeoff_cheapest(&r, 0, all), 0);
}

/* The numbers of pairs, tried out: their power is 80 %, within what 4,000 trials can say. */
static void test_pairs(void **state) {
    (void)state;
    gsl_rng *g = gsl_rng_alloc(gsl_rng_mt19937);
    double equivalent = inference_pairs_equivalent(1, 1.2), different = inference_pairs_different(1, 0.8, 0.95);
    int same = 0, apart = 0;
    assert_true(equivalent > 4 && equivalent < 30 && different > 8 && different < 30);
    for (int i = 0; i < 4000; i++) {
        double x[30];
        for (int k = 0; k < 30; k++)
            x[k] = gsl_ran_gaussian(g, 1);
        same += inference_p_equivalent(inference_paired(inference_sample_of(x, (size_t)equivalent)), 1.2) < 0.05;
        inference_difference d = inference_paired(inference_sample_of(x, (size_t)different));
        d.value += 0.8;
        apart += d.value > inference_width(d, 0.95);
    }
    gsl_rng_free(g);
    printf("power: %.3f with %g pairs (equivalent), %.3f with %g (different)\n", same / 4000.0, equivalent,
           apart / 4000.0, different);
    assert_true(same > 0.77 * 4000 && same < 0.92 * 4000); /* whole pairs: more than 80 % */
    assert_true(apart > 0.77 * 4000 && apart < 0.90 * 4000);
    assert_true(isinf(inference_pairs_equivalent(1, 1e-6)) && isnan(inference_pairs_equivalent(NAN, 1)));
}

/* ---- a real experiment ------------------------------------------------------------------------------------------- */

/* Observes gyration and nematic order; what the last method is seen to do is 5 % off in the first. */
typedef struct watcher {
    interp *in;
    size_t biased;
} watcher;

static int watch(void *self, size_t method, size_t seed, double *values, diag *d) {
    (void)seed;
    const watcher *w = self;
    static const char *const names[] = {"gyration", "nematic"};
    for (int i = 0; i < 2; i++) {
        double out[1 + VALUE_FIELDS_MAX];
        view v = scene_view(interp_scene(w->in));
        int status = value_find(names[i])->measure(&v, NULL, out, d);
        if (status)
            return status;
        values[i] = out[0];
    }
    if (method == w->biased)
        values[0] *= 1.05;
    return SARCINA_OK;
}

static void test_colonies(void **state) {
    (void)state;
    interp *in = make(rods);
    scene *s = interp_scene(in);
    const relax_settings fine = {.integrator = INTEGRATOR_VERLET, .most = 1e-3},
                         coarse = {.integrator = INTEGRATOR_VERLET, .most = 2e-3};
    const tradeoff_method methods[] = {{"fine", fine}, {"coarse", coarse}, {"coarse and seen amiss", coarse}};
    watcher w = {in, 2};
    tradeoff_study study = {.plan = {240, 0.2}, .cycles = 12, .seeds = 5, .nobserved = 2, .self = &w, .observe = watch};
    int found = 0, flagged = 0;
    double widest = 0;
    for (uint64_t i = 0; i < TRIALS; i++) {
        tradeoff_runs runs;
        tradeoff_comparison all[6];
        rng_seed(s->rng, 1000 * i);
        assert_int_equal(tradeoff_cycles(s, &study, methods, 3, &runs, NULL), SARCINA_OK);
        assert_int_equal(rng_get_seed(s->rng), 1000 * i);
        tradeoff_compare(&runs, 0, 0.02, all);
        found += is_biased(all, 2, 2);
        flagged += is_biased(all, 1, 2);
        widest = fmax(widest, all[2].difference.error);
        assert_true(runs.cost[1].evaluations < runs.cost[0].evaluations);
        tradeoff_runs_free(&runs);
    }
    printf("colonies: a bias of 5 %% found in %d of %d, none flagged in %d\n", found, TRIALS, flagged);
    assert_true(widest > 0); /* the two methods are not the same */
    assert_true(found >= 19);
    assert_true(flagged <= 2);
    interp_free(in);
}

/* ---- the scene is as it was -------------------------------------------------------------------------------------- */

static archive *state_of(scene *s) {
    archive *a = archive_create();
    snapshot_save(s, a);
    return a;
}

static void assert_same(scene *s, archive *before) {
    archive *now = state_of(s);
    assert_true(archive_share(now, before));
    archive_free(now);
    archive_free(before);
}

/* Interrupts from within: at the second run's end. */
static volatile sig_atomic_t raised;

static int watch_and_raise(void *self, size_t method, size_t seed, double *values, diag *d) {
    (void)self, (void)seed, (void)d;
    raised = method == 1;
    values[0] = 1;
    return SARCINA_OK;
}

static int refuse_to_watch(void *self, size_t method, size_t seed, double *values, diag *d) {
    (void)self, (void)method, (void)seed, (void)values;
    return diag_error(d, "not to be seen");
}

static void test_untouched(void **state) {
    (void)state;
    interp *in = make(rods);
    scene *s = interp_scene(in);
    const tradeoff_method methods[] = {{"a", {.integrator = INTEGRATOR_VERLET, .most = 1e-3}},
                                       {"b", {.integrator = INTEGRATOR_BS32}}};
    tradeoff_row rows[2];
    tradeoff_reference reference;
    tradeoff_runs runs;
    tradeoff_study study = {.plan = {240, 0.1}, .cycles = 2, .seeds = 2, .nobserved = 1, .observe = watch_and_raise};
    diag d = {0};
    double wall = s->timing.total;
    uint64_t evaluations = s->tally.evaluations;
    int accuracy = s->accuracy;

    archive *before = state_of(s);
    assert_int_equal(tradeoff_relaxation(s, &study.plan, methods, 2, rows, &reference, &d), SARCINA_OK);
    assert_same(s, before);

    s->interrupt = &raised;
    before = state_of(s);
    assert_int_equal(tradeoff_cycles(s, &study, methods, 2, &runs, &d), SARCINA_INTERRUPTED);
    tradeoff_runs_free(&runs);
    assert_same(s, before);

    before = state_of(s); /* raised still */
    assert_int_equal(tradeoff_relaxation(s, &study.plan, methods, 2, rows, &reference, &d), SARCINA_INTERRUPTED);
    assert_same(s, before);
    assert_string_equal(d.message, "interrupted; the scene is as it was before");
    raised = 0;

    before = state_of(s);
    study.observe = refuse_to_watch;
    assert_int_equal(tradeoff_cycles(s, &study, methods, 2, &runs, &d), SARCINA_ERROR);
    tradeoff_runs_free(&runs);
    assert_same(s, before);

    assert_true(s->timing.total == wall && s->tally.evaluations == evaluations && s->accuracy == accuracy);
    assert_true(s->relax.integrator == accuracy_presets[accuracy].settings.integrator);
    interp_free(in);
}

/* ---- the reference ----------------------------------------------------------------------------------------------- */

/* x'' = -g x' - w2 x from x0 at rest, underdamped. */
static double oscillator(double x0, double w2, double g, double t) {
    double a = 0.5 * g, w = sqrt(w2 - a * a);
    return x0 * exp(-a * t) * (cos(w * t) + a / w * sin(w * t));
}

/* Two cocci that touch: their overlap is a damped oscillator. What a coarse method is off by is known on paper, and
 * found to within the reference's own error. */
static void test_two_cells(void **state) {
    (void)state;
    interp *in = make("species ball coccus\nforce collision\nforce damping\n"
                      "create_cells ball single 0 0 0 mass 5e-16kg\n"
                      "create_cells ball single 0.7um 0 0 mass 5e-16kg overlap yes\n");
    scene *s = interp_scene(in);
    const double time = 5e-4, diameter = s->colony->cell.diameter[0], mass = s->colony->cell.mass[0];
    const double reach = 1.01 * diameter, overlap = reach - 0.7;
    const double wanted = oscillator(overlap, 2e5 / mass, 100 / mass, time);
    assert_true(overlap > 0 && wanted > 0 && 2e5 / mass > 2500 / (mass * mass)); /* they touch to the end */
    const tradeoff_method methods[] = {{"coarse", {.integrator = INTEGRATOR_VERLET, .step = 2.5e-4}},
                                       {"finer", {.integrator = INTEGRATOR_VERLET, .step = 5e-5}}};
    tradeoff_row rows[2];
    tradeoff_reference reference;
    const tradeoff_plan plan = {0, time};
    assert_int_equal(tradeoff_relaxation(s, &plan, methods, 2, rows, &reference, NULL), SARCINA_OK);
    assert_true(reference.tolerance < reference.coarser && !reference.cut);
    for (int i = 0; i < 2; i++) {
        snapshot *before = snapshot_take(s);
        relax_result result;
        s->relax = methods[i].how;
        assert_int_equal(scene_relax(s, time, 0, &result, NULL), SARCINA_OK);
        double seen = reach - (s->colony->particle.x[3] - s->colony->particle.x[0]);
        double error = 0.5 * fabs(seen - wanted); /* each of the two has half of it */
        printf("%s: off by %.3e um, measured %.3e, the reference by at most %.1e\n", methods[i].name, error,
               rows[i].error.most, reference.error.most);
        assert_true(error > 0 && fabs(rows[i].error.most - error) <= reference.error.most);
        assert_true(i > 0 || rows[i].error.most > 10 * reference.error.most);
        assert_int_equal(rows[i].cost.steps, result.steps);
        snapshot_restore(s, before);
        snapshot_free(before);
    }
    assert_true(rows[0].front && rows[1].front);
    interp_free(in);
}

/* Cocci pressed together on one line stay there by any method, to the bit, and leave it with the least push. */
static void test_chaos(void **state) {
    (void)state;
    interp *in = make("species ball coccus\nforce collision\nforce damping\n"
                      "repeat 30\n  create_cells ball single $(cells*0.3um) 0 0 mass 5e-16kg overlap yes\nend\n");
    scene *s = interp_scene(in);
    const tradeoff_method methods[] = {{"fine", {.integrator = INTEGRATOR_VERLET, .most = 1e-4}},
                                       {"coarse", {.integrator = INTEGRATOR_VERLET, .most = 1e-3}}};
    tradeoff_row rows[2];
    tradeoff_reference reference;
    assert_int_equal(tradeoff_relaxation(s, &(tradeoff_plan){0, 1}, methods, 2, rows, &reference, NULL), SARCINA_OK);
    printf("a line of cocci: %.1e um becomes %.1e, methods differ by %.1e and %.1e um\n", reference.displacement,
           reference.divergence.most, rows[0].error.most, rows[1].error.most);
    assert_true(reference.divergence.most > 0.1);
    for (int i = 0; i < 2; i++)
        assert_true(rows[i].state == TRADEOFF_CHAOS && !rows[i].front);
    assert_int_equal(tradeoff_most_exact(rows, 2), -1);
    interp_free(in);
    /* a colony in which nothing is upright: no chaos */
    in = make(rods);
    s = interp_scene(in);
    assert_int_equal(tradeoff_relaxation(s, &(tradeoff_plan){240, 0.2}, methods, 2, rows, &reference, NULL),
                     SARCINA_OK);
    assert_int_equal(rows[1].state, TRADEOFF_MEASURED);
    interp_free(in);
}

/* A method that cannot go on is a row, and the others stand. */
static void test_failed(void **state) {
    (void)state;
    interp *in = make(rods);
    scene *s = interp_scene(in);
    const tradeoff_method methods[] = {{"impossible", {.integrator = INTEGRATOR_DOPRI5, .tolerance = 1e-30}},
                                       {"fine", {.integrator = INTEGRATOR_VERLET, .most = 1e-3}}};
    tradeoff_row rows[2];
    tradeoff_reference reference;
    assert_int_equal(tradeoff_relaxation(s, &(tradeoff_plan){240, 0.2}, methods, 2, rows, &reference, NULL),
                     SARCINA_OK);
    printf("an impossible tolerance: %s\n", rows[0].reason);
    assert_int_equal(rows[0].state, TRADEOFF_FAILED);
    assert_non_null(strstr(rows[0].reason, "cell"));
    assert_true(rows[1].state == TRADEOFF_MEASURED && rows[1].front);
    interp_free(in);
}

int main(void) {
    const struct CMUnitTest tests[] = {cmocka_unit_test(test_made_up),   cmocka_unit_test(test_by_hand),
                                       cmocka_unit_test(test_pairs),     cmocka_unit_test(test_colonies),
                                       cmocka_unit_test(test_untouched), cmocka_unit_test(test_two_cells),
                                       cmocka_unit_test(test_chaos),     cmocka_unit_test(test_failed)};
    return cmocka_run_group_tests_name("tradeoff", tests, open_host, close_host);
}

/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Many cycles by each method from the same seeds, and what the differences say. Growth draws from (seed, cell, step),
 * so that two methods have the same cells grow alike: pairs differ by the motion alone, and far less than seeds do. */
#include "base/alloc.h"
#include "engine/tradeoff.h"
#include "engine/tradeoff_guard.h"

#include <math.h>
#include <stdlib.h>

static double *values_of(const tradeoff_runs *r, size_t method, size_t seed) {
    return r->values + (method * r->seeds + seed) * r->nobserved;
}

/* ---- the runs ---------------------------------------------------------------------------------------------------- */

static int run_cycles(scene *s, const tradeoff_study *study, diag *d) {
    int status = SARCINA_OK;
    for (uint64_t i = 0; i < study->cycles && !status; i++)
        status = scene_cycle(s, study->plan.grow, study->plan.relax, 0, d);
    return status == SARCINA_INTERRUPTED ? tradeoff_guard_interrupted(d) : status;
}

/* From the beginning, with this seed, by the scene's present method. */
static int run_once(const tradeoff_guard *g, const tradeoff_study *study, size_t method, size_t seed, tradeoff_runs *r,
                    diag *d) {
    scene *s = g->s;
    snapshot_restore(s, g->state);
    rng_seed(s->rng, g->seed + seed);
    const scene_tally before = s->tally;
    double begin = tradeoff_guard_seconds();
    int status = run_cycles(s, study, d);
    r->cost[method].seconds += tradeoff_guard_seconds() - begin;
    r->cost[method].evaluations += s->tally.evaluations - before.evaluations;
    r->cost[method].steps += s->tally.steps - before.steps;
    if (status != SARCINA_NUMERICAL)
        return status ? status : study->observe(study->self, method, seed, values_of(r, method, seed), d);
    r->failed[method] = true;
    diag_clear(d);
    return SARCINA_OK;
}

/* Seed by seed, so that what is common to a seed is near in time: a machine's other work falls on all alike. */
static int run_all(const tradeoff_guard *g, const tradeoff_study *study, const tradeoff_method *methods,
                   tradeoff_runs *r, diag *d) {
    int status = SARCINA_OK;
    for (size_t seed = 0; seed < r->seeds; seed++)
        for (size_t m = 0; m < r->methods && !status; m++) {
            g->s->relax = methods[m].how;
            if (!r->failed[m])
                status = run_once(g, study, m, seed, r, d);
        }
    return status;
}

int tradeoff_cycles(scene *s, const tradeoff_study *study, const tradeoff_method *methods, size_t n,
                    tradeoff_runs *runs, diag *d) {
    size_t count = n * study->seeds * study->nobserved;
    diag why = {0};
    *runs = (tradeoff_runs){.methods = n,
                            .seeds = study->seeds,
                            .nobserved = study->nobserved,
                            .values = alloc_zeroed(count, sizeof(double)),
                            .cost = alloc_zeroed(n, sizeof(tradeoff_cost)),
                            .failed = alloc_zeroed(n, sizeof(bool))};
    for (size_t i = 0; i < count; i++)
        runs->values[i] = NAN;
    tradeoff_guard guard = tradeoff_guard_begin(s);
    int status = run_all(&guard, study, methods, runs, &why);
    tradeoff_guard_end(&guard);
    if (status && d)
        *d = why;
    return status;
}

void tradeoff_runs_free(tradeoff_runs *r) {
    free(r->values);
    free(r->cost);
    free(r->failed);
    *r = (tradeoff_runs){0};
}

/* ---- what they say ----------------------------------------------------------------------------------------------- */

/* A small difference that is sure is equivalent: what a margin is for. */
static tradeoff_verdict judge(const tradeoff_comparison *c) {
    if (c->own.n == 0 || c->reference.n == 0)
        return TRADEOFF_UNDEFINED;
    if ((c->difference.value == 0 && c->difference.error == 0) || c->p < 0.05)
        return TRADEOFF_EQUIVALENT;
    return fabs(c->difference.value) > c->width ? TRADEOFF_BIASED : TRADEOFF_OPEN;
}

/* One quantity; level: of its interval. */
static tradeoff_comparison compare_one(const tradeoff_runs *r, size_t method, size_t reference, size_t k, double margin,
                                       double level) {
    double *own = alloc_zeroed(r->seeds, 3 * sizeof *own), *other = own + r->seeds, *change = other + r->seeds;
    for (size_t i = 0; i < r->seeds; i++) {
        own[i] = values_of(r, method, i)[k];
        other[i] = values_of(r, reference, i)[k];
        change[i] = own[i] - other[i];
        if (isnan(change[i])) /* a pair or nothing */
            own[i] = other[i] = NAN;
    }
    inference_sample changes = inference_sample_of(change, r->seeds);
    tradeoff_comparison c = {.own = inference_sample_of(own, r->seeds),
                             .reference = inference_sample_of(other, r->seeds),
                             .difference = inference_paired(changes)};
    free(own);
    c.width = inference_width(c.difference, level);
    c.margin = margin * fabs(c.reference.mean);
    c.p = inference_p_equivalent(c.difference, c.margin);
    c.verdict = r->failed[method] || r->failed[reference] ? TRADEOFF_UNDEFINED : judge(&c);
    c.seeds = fabs(c.difference.value) <= c.margin ? inference_pairs_equivalent(changes.sd, c.margin)
                                                   : inference_pairs_different(changes.sd, c.difference.value, level);
    if (c.seeds <= (double)changes.n)
        c.seeds = (double)changes.n + 1;
    return c;
}

/* Intervals after Bonferroni: 95 % for all quantities of a method. Equivalence asks for all at once, each at 5 %
 * (intersection-union, Berger 1982, Technometrics 24:295), and needs no correction. */
void tradeoff_compare(const tradeoff_runs *r, size_t reference, double margin, tradeoff_comparison *out) {
    double level = 1 - 0.05 / (double)(r->nobserved ? r->nobserved : 1);
    for (size_t m = 0; m < r->methods; m++)
        for (size_t k = 0; k < r->nobserved; k++)
            out[m * r->nobserved + k] = compare_one(r, m, reference, k, margin, level);
}

size_t tradeoff_cheapest(const tradeoff_runs *r, size_t reference, const tradeoff_comparison *all) {
    size_t best = reference;
    for (size_t m = 0; m < r->methods; m++) {
        bool same = !r->failed[m];
        for (size_t k = 0; k < r->nobserved; k++)
            same = same && all[m * r->nobserved + k].verdict == all[reference * r->nobserved + k].verdict;
        if (same && r->cost[m].evaluations < r->cost[best].evaluations)
            best = m;
    }
    return best;
}

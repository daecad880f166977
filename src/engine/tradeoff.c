/* SPDX-License-Identifier: GPL-3.0-or-later */
/* A relaxation by each method from the same beginning, and the reference that they are measured against.
 *
 * The reference's error is what the next coarser tolerance differs by: a method of fifth order gains about a factor of
 * ten with each tenth of the tolerance, so the finer end is nearer to the truth than to the coarser. */
#include "engine/tradeoff.h"

#include "base/alloc.h"
#include "engine/tradeoff_guard.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

enum {
    EVALUATIONS_MAX = 100, /* of one run of the reference, times those of its first */
    REPEATS_MAX = 5        /* of a relaxation too quick for the clock */
};
#define TOLERANCE_FIRST 0.1 /* of the reference, um; a tenth from one to the next */
#define TOLERANCE_LAST 1e-7
#define AGREEMENT 0.05        /* of the reference's error with the least of the methods' */
#define CONVERGENCE 0.7       /* an error that falls to more than this, for a tenth of the tolerance, does not fall */
#define TOLERANCE_JUDGED 1e-4 /* from here on, um */
#define SECONDS_ENOUGH 0.1    /* of computing, for a time that can be told */
#define DISPLACEMENT 1e-9     /* in diameters */
#define GROWTH_OF_CHAOS 100   /* of the displacement; less is no divergence */

typedef struct bench {
    scene *s;
    snapshot *begin; /* rows as mechanics_arrange wants them */
    size_t n;        /* particles */
    double time;
    tradeoff_row *rows; /* (methods) */
    double *ends;       /* what the methods end with (methods x n x 3) */
    size_t methods;
} bench;

/* From the beginning, or from what `displace` makes of it; the end goes to x (n x 3). */
static int relax_by(bench *b, const relax_settings *how, uint64_t most, bool displace, double *x, relax_result *result,
                    diag *d) {
    scene *s = b->s;
    const relax_goal goal = {.time = b->time, .interrupt = s->interrupt, .evaluations = most};
    snapshot_restore(s, b->begin);
    if (displace)
        tradeoff_guard_displace(s, DISPLACEMENT);
    int status = scene_prepare(s, d);
    if (!status)
        status = relax_run(s->mechanics, how, &goal, result, d);
    if (!status && result->stop == RELAX_INTERRUPTED)
        status = tradeoff_guard_interrupted(d);
    memcpy(x, s->colony->particle.x, 3 * b->n * sizeof *x);
    return status;
}

static tradeoff_distance distance_of(const double *a, const double *b, size_t n) {
    double most = 0, sum = 0;
    for (size_t p = 0; p < n; p++) {
        double square = 0;
        for (size_t k = 3 * p; k < 3 * p + 3; k++)
            square += (a[k] - b[k]) * (a[k] - b[k]);
        most = fmax(most, square);
        sum += square;
    }
    return (tradeoff_distance){sqrt(most), n ? sqrt(sum / (double)n) : 0};
}

/* ---- the reference ----------------------------------------------------------------------------------------------- */

/* *steps: how many it took; 0: it did not come to its end. */
static int reference_run(bench *b, double tolerance, bool displace, double *x, uint64_t *steps, tradeoff_reference *r,
                         diag *d) {
    relax_result result = {0};
    const relax_settings how = {.integrator = INTEGRATOR_DOPRI5, .tolerance = tolerance};
    int status = relax_by(b, &how, EVALUATIONS_MAX * r->first, displace, x, &result, d);
    r->first = r->first ? r->first : result.evaluations;
    r->evaluations += result.evaluations;
    *steps = result.stop == RELAX_TIME ? result.steps : 0;
    return status;
}

/* By how much two ends of tolerances that follow each other differ. Where both went the same steps that says nothing,
 * and what is known is the finer tolerance. */
static tradeoff_distance difference(const double *finer, const double *coarser, size_t n, bool same_steps,
                                    double tolerance) {
    return same_steps ? (tradeoff_distance){tolerance, tolerance} : distance_of(finer, coarser, n);
}

/* Least rms error of a method against this end; 0 where it meets it. */
static double least_error(bench *b, const double *x) {
    double least = INFINITY;
    for (size_t i = 0; i < b->methods; i++) {
        tradeoff_row *row = &b->rows[i];
        if (row->state == TRADEOFF_FAILED)
            continue;
        row->error = distance_of(b->ends + 3 * b->n * i, x, b->n);
        least = fmin(least, row->error.rms);
    }
    return least;
}

/* Good enough for the methods that are measured by it; or no better to be had. */
static bool is_reached(bench *b, const double *x, double before, const tradeoff_reference *r) {
    bool agrees = r->error.rms <= AGREEMENT * least_error(b, x);
    bool stands = r->tolerance < 1.5 * TOLERANCE_JUDGED && r->error.rms > CONVERGENCE * before;
    return agrees || stands;
}

/* Ends at tolerances, from coarse to fine; x: the last that came to its end. */
static int converge(bench *b, double *x, tradeoff_reference *r, diag *d) {
    double *next = alloc_zeroed(3 * b->n, sizeof *next);
    int status = SARCINA_OK;
    uint64_t steps = 0, before = 0;
    bool reached = false;
    r->error = (tradeoff_distance){INFINITY, INFINITY};
    for (double tolerance = TOLERANCE_FIRST; tolerance > 0.5 * TOLERANCE_LAST && !reached; tolerance /= 10) {
        double error = r->error.rms;
        status = reference_run(b, tolerance, false, next, &steps, r, d);
        r->cut = steps == 0;
        if (status || r->cut)
            break;
        if (before > 0)
            r->error = difference(next, x, b->n, steps == before, tolerance);
        memcpy(x, next, 3 * b->n * sizeof *x);
        r->coarser = r->tolerance;
        r->tolerance = tolerance;
        reached = before > 0 && is_reached(b, x, error, r);
        before = steps;
    }
    least_error(b, x);
    free(next);
    return status;
}

/* What a displacement has become. Where it takes too many evaluations nothing is known but the reference's error. */
static int diverge(bench *b, const double *x, tradeoff_reference *r, diag *d) {
    double *end = alloc_zeroed(3 * b->n, sizeof *end);
    uint64_t steps = 0;
    r->displacement = DISPLACEMENT * tradeoff_guard_diameter(b->s->colony);
    int status = reference_run(b, r->tolerance, true, end, &steps, r, d);
    r->divergence = steps > 0 ? distance_of(end, x, b->n) : r->error;
    free(end);
    return status;
}

/* ---- the methods ------------------------------------------------------------------------------------------------- */

static tradeoff_state judge(const tradeoff_row *row, const tradeoff_reference *r) {
    bool grows = r->divergence.most > GROWTH_OF_CHAOS * r->displacement;
    if (grows && (r->divergence.rms >= row->error.rms / 2 || r->divergence.most >= row->error.most / 2))
        return TRADEOFF_CHAOS;
    return row->error.rms <= 2 * r->error.rms ? TRADEOFF_RESOLVED : TRADEOFF_MEASURED;
}

/* A method that cannot go on is a result (SARCINA_OK); what else goes wrong ends it all. */
static int failed(tradeoff_row *row, const diag *why, diag *d) {
    if (why->status != SARCINA_NUMERICAL) {
        if (d)
            *d = *why;
        return why->status;
    }
    row->state = TRADEOFF_FAILED;
    row->error = (tradeoff_distance){NAN, NAN};
    snprintf(row->reason, sizeof row->reason, "%.*s", (int)sizeof row->reason - 1, why->message);
    return SARCINA_OK;
}

/* Quick ones several times over, for the shortest time: the machine has other things to do too. */
static int measure(bench *b, const relax_settings *how, double *end, tradeoff_row *row, diag *d) {
    double total = 0;
    row->cost.seconds = INFINITY;
    for (int i = 0; i < REPEATS_MAX && total < SECONDS_ENOUGH; i++) {
        relax_result result = {0};
        diag why = {0};
        double begin = tradeoff_guard_seconds();
        if (relax_by(b, how, 0, false, end, &result, &why))
            return failed(row, &why, d);
        double seconds = tradeoff_guard_seconds() - begin;
        total += seconds;
        row->cost.seconds = fmin(row->cost.seconds, seconds);
        row->cost.evaluations = result.evaluations;
        row->cost.steps = result.steps;
    }
    return SARCINA_OK;
}

static bool is_measured(const tradeoff_row *row) {
    return row->state == TRADEOFF_MEASURED || row->state == TRADEOFF_RESOLVED;
}

/* Evaluations, not seconds: the same at every run. */
static void mark_front(tradeoff_row *rows, size_t n) {
    for (size_t i = 0; i < n; i++) {
        rows[i].front = is_measured(&rows[i]);
        for (size_t k = 0; k < n && rows[i].front; k++) {
            const tradeoff_row *a = &rows[i], *b = &rows[k];
            bool no_worse = b->cost.evaluations <= a->cost.evaluations && b->error.rms <= a->error.rms;
            bool better = b->cost.evaluations < a->cost.evaluations || b->error.rms < a->error.rms;
            rows[i].front = !(is_measured(b) && no_worse && better);
        }
    }
}

int tradeoff_most_exact(const tradeoff_row *rows, size_t n) {
    int best = -1;
    for (size_t i = 0; i < n; i++)
        if (is_measured(&rows[i]) && (best < 0 || rows[i].error.rms < rows[best].error.rms))
            best = (int)i;
    return best;
}

/* The methods first: how near the reference must be depends on them. */
static int run_all(bench *b, const tradeoff_method *methods, tradeoff_reference *reference, diag *d) {
    double *x = alloc_zeroed(3 * b->n, sizeof *x);
    int status = SARCINA_OK;
    for (size_t i = 0; i < b->methods && !status; i++)
        status = measure(b, &methods[i].how, b->ends + 3 * b->n * i, &b->rows[i], d);
    if (!status)
        status = converge(b, x, reference, d);
    if (!status)
        status = diverge(b, x, reference, d);
    for (size_t i = 0; i < b->methods && !status; i++)
        if (b->rows[i].state != TRADEOFF_FAILED)
            b->rows[i].state = judge(&b->rows[i], reference);
    mark_front(b->rows, b->methods);
    free(x);
    return status;
}

int tradeoff_relaxation(scene *s, const tradeoff_plan *plan, const tradeoff_method *methods, size_t n,
                        tradeoff_row *rows, tradeoff_reference *reference, diag *d) {
    memset(rows, 0, n * sizeof *rows);
    *reference = (tradeoff_reference){0};
    tradeoff_guard guard = tradeoff_guard_begin(s);
    int status = plan->grow > 0 ? scene_grow(s, plan->grow, d) : SARCINA_OK;
    mechanics_arrange(s->colony);
    reference->cells = s->colony->cell.count;
    bench b = {.s = s,
               .begin = snapshot_take(s),
               .n = s->colony->particle.count,
               .time = plan->relax,
               .rows = rows,
               .methods = n};
    b.ends = alloc_zeroed(3 * b.n, n * sizeof *b.ends);
    if (!status)
        status = run_all(&b, methods, reference, d);
    free(b.ends);
    snapshot_free(b.begin);
    tradeoff_guard_end(&guard);
    return status;
}

/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The driver: steps of the chosen integrator until the time is over, the forces are small, or somebody interrupts. */
#include "relax/relax.h"

#include "base/alloc.h"
#include "mechanics/dimensions.h"
#include "mechanics/remodel.h"
#include "relax/integrator.h"

#include <math.h>
#include <omp.h>
#include <stdlib.h>
#include <string.h>

/* Largest net force on a particle at the present state. */
static double largest_force(motion *mo, const double *known, double *scratch) {
    const double *f = known;
    if (!f) {
        motion_force(mo, mo->x, scratch);
        f = scratch;
    }
    double most = 0;
    for (size_t p = 0; p < mo->n; p++) {
        double square = dimensions_square(f + (size_t)mo->dimensions * p, mo->dimensions);
        most = square > most ? square : most;
    }
    return sqrt(most);
}

/* Next multiple of a period after the present time, at most `end`; a remainder of rounding belongs to the last. */
static double next_multiple(const motion *mo, double period, double end) {
    if (period <= 0)
        return end;
    double next = period * (floor(mo->time / period * (1 + 1e-12)) + 1);
    return next < end * (1 - 1e-9) ? next : end;
}

typedef struct run {
    const integrator_style *style;
    void *method;
    motion mo;
    const relax_settings *how;
    const relax_goal *goal;
    relax_result *result;
    double *scratch; /* (n x dimensions), with a goal of force only */
    bool remodels;   /* links may form or break */
    double every;    /* how often, s; 0: after every accepted step */
    bool minimises;
} run;

/* Whether to stop before the next step, and why. */
static bool is_over(run *r) {
    if (r->scratch) {
        const double *known = r->style->force ? r->style->force(r->method) : NULL;
        r->result->fmax = largest_force(&r->mo, known, r->scratch);
        r->result->stop = RELAX_FORCE;
        if (r->result->fmax < r->goal->force)
            return true;
    }
    r->result->stop = RELAX_INTERRUPTED;
    if (r->goal->interrupt && *r->goal->interrupt)
        return true;
    r->result->stop = RELAX_TIME;
    if (r->mo.time >= r->goal->time)
        return true;
    r->result->stop = RELAX_EVALUATIONS;
    return r->goal->evaluations && r->mo.evaluations >= r->goal->evaluations;
}

/* Lets links form and break (true: some did): at fixed times, so that what forms does not depend on the integrator's
 * steps, or as published after each of them. */
static bool remodel(run *r) {
    remodel_change change;
    motion_settle(&r->mo);
    double begin = omp_get_wtime(), built = mechanics_statistics(r->mo.m).build_seconds;
    bool changed = mechanics_remodel(r->mo.m, &change);
    r->result->remodel_seconds += omp_get_wtime() - begin - (mechanics_statistics(r->mo.m).build_seconds - built);
    if (changed)
        r->style->renew(r->method, change.stiffness);
    return changed;
}

static int advance(run *r, diag *d) {
    double end = next_multiple(&r->mo, r->how->segment, r->goal->time);
    double due = r->remodels ? next_multiple(&r->mo, r->every, r->goal->time) : r->goal->time;
    if (r->remodels && r->every > 0)
        remodel(r); /* else, as published, what a division has stretched pulls for one step before it breaks */
    while (!is_over(r)) {
        if (r->mo.time >= end) {
            r->style->reset(r->method);
            end = next_multiple(&r->mo, r->how->segment, r->goal->time);
        }
        /* times that only rounding parts are one */
        int status = r->style->step(r->method, &r->mo, due < end * (1 - 1e-9) ? due : end, d);
        if (status)
            return status;
        if (r->remodels && (r->every <= 0 || r->mo.time >= due * (1 - 1e-9))) {
            remodel(r);
            due = next_multiple(&r->mo, r->every, r->goal->time);
        }
    }
    return SARCINA_OK;
}

/* Whose force it is that falls no further, and which term's is largest there. */
static bool stall(run *r) {
    r->result->stop = RELAX_STALLED;
    motion_force(&r->mo, r->mo.x, r->scratch);
    const mechanics_culprit c = mechanics_blame(r->mo.m, r->mo.x, motion_worst(&r->mo, r->scratch));
    r->result->cell = c.cell;
    r->result->term = c.strongest;
    return true;
}

/* Of a minimiser: is it over? At rest links form and break; where some did, it goes on. That ends: what forms is not
 * stretched, and what breaks takes energy with it. */
static bool is_at_rest(run *r) {
    bool over = is_over(r);
    while (over && r->result->stop == RELAX_FORCE && r->remodels && remodel(r))
        over = is_over(r);
    return over || (r->mo.stuck && stall(r));
}

/* A minimiser follows no time; all is still where it ends. */
static int descend(run *r, diag *d) {
    if (r->remodels)
        remodel(r);
    while (!is_at_rest(r)) {
        int status = r->style->step(r->method, &r->mo, INFINITY, d);
        if (status)
            return status;
    }
    memset(r->mo.v, 0, r->mo.components * sizeof *r->mo.v);
    return SARCINA_OK;
}

/* The shortest step that a scene may need throughout: 200,000 of them relax a second, or what is less. */
static double least_step(const relax_goal *goal) {
    static const double steps = 2e5;
    return (goal->time < 1 ? goal->time : 1) / steps;
}

static void report(const motion *mo, relax_result *result) {
    result->time = mo->time;
    result->steps = mo->steps;
    result->rejected = mo->rejected;
    result->evaluations = mo->evaluations;
    result->products = mo->products;
    result->least_step = mo->least_step;
    result->largest_step = mo->largest_step;
    cap_add(result->caps, mo->caps);
}

int relax_check(const relax_settings *how, double time, double force, diag *d) {
    const char *name = integrator_styles[how->integrator]->name;
    if (!(integrator_styles[how->integrator]->caps & INTEGRATOR_MINIMISES))
        return SARCINA_OK;
    if (!(force > 0)) {
        diag_error(d, "integrator %s goes to rest and follows no time: it cannot relax for one", name);
        return diag_help(d, "write 'relax to FORCE', as in relax to 1e-15N; or 'accuracy balanced' for a time");
    }
    if (isinf(time))
        return SARCINA_OK;
    diag_error(d, "integrator %s follows no time that 'within' could bound", name);
    return diag_help(d, "write 'relax to FORCE' alone: it ends by itself where the force falls no further");
}

int relax_run(mechanics *m, const relax_settings *how, const relax_goal *goal, relax_result *result, diag *d) {
    relax_result unused;
    run r = {.style = integrator_styles[how->integrator],
             .mo = {.m = m,
                    .n = mechanics_particles(m),
                    .order = mechanics_order(m),
                    .least = least_step(goal),
                    .goal = goal->force},
             .how = how,
             .goal = goal,
             .result = result ? result : &unused};
    *r.result = (relax_result){0};
    r.minimises = r.style->caps & INTEGRATOR_MINIMISES;
    int status = relax_check(how, goal->time, goal->force, d);
    if (status)
        return status;
    r.remodels = mechanics_remodels(m);
    r.every = mechanics_remodel_every(m);
    if (r.mo.n == 0) {
        r.result->stop = r.minimises ? RELAX_FORCE : RELAX_TIME;
        r.result->time = r.minimises ? 0 : goal->time;
        return SARCINA_OK;
    }
    r.mo.dimensions = mechanics_dimensions(m);
    r.mo.components = (size_t)r.mo.dimensions * r.mo.n;
    mechanics_take_state(m, &r.mo.home[0], &r.mo.home[1]);
    r.mo.x = r.mo.home[0];
    r.mo.v = r.mo.home[1];
    r.method = r.style->create(r.style, how, &r.mo);
    r.scratch = goal->force > 0 ? alloc_zeroed(r.mo.components, sizeof *r.scratch) : NULL;
    status = (r.minimises ? descend : advance)(&r, d);
    if (r.style->finish)
        r.style->finish(r.method, &r.mo);
    motion_settle(&r.mo);
    mechanics_return_state(m);
    report(&r.mo, r.result);
    r.style->destroy(r.method);
    free(r.scratch);
    return status;
}

/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Growth, relaxation, and the cycle of both. A cycle is atomic: it happens whole or not at all. */
#include "engine/scene.h"

#include "biology/division.h"
#include "biology/growth.h"
#include "engine/attach.h"
#include "engine/snapshot.h"
#include "model/link_check.h"

#include <math.h>
#include <time.h>

double scene_clock(void) {
    struct timespec t;
    clock_gettime(CLOCK_MONOTONIC, &t);
    return (double)t.tv_sec + 1e-9 * (double)t.tv_nsec;
}

/* sum += by, and the rest what that has rounded off: 1e6 steps of dt come to 1e6 dt, and outputs that are due by the
 * time stay in step with it. Source: Neumaier 1974, Z. Angew. Math. Mech. 54:39, the rest folded in at once. */
static void pass_time(double *sum, double *rest, double by) {
    double due = *rest + by, now = *sum + due;
    *rest = due - (now - *sum);
    *sum = now;
}

/* Adds the seconds since `from` to a stage and returns the present time. */
static double clock_stage(double *stage, double from) {
    double t = scene_clock();
    *stage += t - from;
    return t;
}

/* In builds that look after it: is the graph of links whole? */
static int check_links(const scene *s, diag *d) {
    if (!SARCINA_CHECK_LINKS)
        return SARCINA_OK;
    link_fault fault = link_check(s->colony);
    if (!fault.what)
        return SARCINA_OK;
    return diag_fail(d, SARCINA_NUMERICAL, "link %llu: %s", (unsigned long long)fault.link, fault.what);
}

int scene_grow(scene *s, double dt, diag *d) {
    double t = scene_clock();
    int status = attach_check(s, dt, d);
    if (!status)
        status = growth_step(s->colony, &s->species, s->rng, s->growth_steps, dt, d);
    if (status)
        return status;
    s->growth_steps++;
    pass_time(&s->time, &s->time_rest, dt);
    t = clock_stage(&s->timing.grow, t);
    const division_context x = {.colony = s->colony,
                                .species = &s->species,
                                .links = &s->links,
                                .rng = s->rng,
                                .time = s->time,
                                .flat = s->dimension == 2,
                                .substratum = s->forces.term[FORCE_SUBSTRATUM].on,
                                .substratum_z = s->forces.term[FORCE_SUBSTRATUM].p[SUBSTRATUM_Z]};
    division_step(&x);
    scene_refresh_links(s);
    attach_step(s, s->growth_steps, dt);
    s->colony->version++; /* masses and rest lengths have changed */
    clock_stage(&s->timing.divide, t);
    return check_links(s, d);
}

/* What the mechanics did since `from`, and what the relaxation says of itself. */
static void note_relaxation(scene *s, const mechanics_stats *from, const relax_result *r) {
    mechanics_stats now = mechanics_statistics(s->mechanics);
    scene_tally *t = &s->tally;
    s->timing.force += now.force_seconds - from->force_seconds;
    s->timing.build += now.build_seconds - from->build_seconds;
    s->timing.remodel += r->remodel_seconds;
    s->timing.upkeep += now.upkeep_seconds - from->upkeep_seconds;
    for (int i = 0; i < FORCE_COUNT; i++)
        s->timing.term[i] += now.term_seconds[i] - from->term_seconds[i];
    t->by_time += r->stop == RELAX_TIME;
    t->by_force += r->stop == RELAX_FORCE;
    if (r->stop == RELAX_STALLED) {
        t->stalled++;
        t->stalled_cell = r->cell;
        t->stalled_term = r->term;
        t->stalled_force = r->fmax;
    }
    t->steps += r->steps;
    t->rejected += r->rejected;
    t->evaluations += now.evaluations - from->evaluations;
    t->cell_evaluations += now.cell_evaluations - from->cell_evaluations;
    t->builds += now.builds - from->builds;
    if (!(r->largest_step > 0)) /* none, or those of a minimiser, which take no time */
        return;
    t->least_step = fmin(t->least_step, r->least_step);
    t->largest_step = fmax(t->largest_step, r->largest_step);
}

int scene_relax(scene *s, double time, double force, relax_result *result, diag *d) {
    double t = scene_clock();
    const mechanics_stats from = mechanics_statistics(s->mechanics);
    snapshot *before = snapshot_take(s);
    mechanics_arrange(s->colony); /* rows in the order of space: faster, the same bits */
    const relax_goal goal = {.time = time, .force = force, .interrupt = s->interrupt};
    int status = scene_prepare(s, d);
    if (status == SARCINA_OK)
        status = relax_run(s->mechanics, &s->relax, &goal, result, d);
    if (status == SARCINA_OK)
        status = check_links(s, d);
    if (status == SARCINA_OK) {
        pass_time(&s->relaxed, &s->relaxed_rest, result->time);
        result->caps[CAP_CLAMPED] = mechanics_clamped(s->mechanics);
        cap_add(s->colony->caps, result->caps);
        note_relaxation(s, &from, result);
    } else {
        snapshot_restore(s, before);
    }
    snapshot_free(before);
    clock_stage(&s->timing.relax, t);
    return status;
}

int scene_cycle(scene *s, double dt, double relax_time, double relax_force, diag *d) {
    double t = scene_clock();
    snapshot *before = snapshot_take(s);
    relax_result result = {0};
    bool stopped = s->interrupt && *s->interrupt; /* a run that does not relax looks nowhere else */
    int status = dt > 0 && !stopped ? scene_grow(s, dt, d) : SARCINA_OK;
    if (!status && relax_time > 0 && !stopped)
        status = scene_relax(s, relax_time, relax_force, &result, d);
    if (!status && (stopped || result.stop == RELAX_INTERRUPTED))
        status = diag_fail(d, SARCINA_INTERRUPTED, "interrupted; the scene is as after step %llu",
                           (unsigned long long)s->step);
    if (status)
        snapshot_restore(s, before);
    else
        s->step++;
    snapshot_free(before);
    clock_stage(&s->timing.total, t);
    return status;
}

/* SPDX-License-Identifier: GPL-3.0-or-later */
/* grow DT; relax T; relax to F [within T]: the two primitives a cycle is made of. */
#include "command/commands.h"
#include "command/forecast.h"
#include "command/run_report.h"

#include "base/number.h"
#include "base/table.h"
#include "relax/integrator.h"

#include <math.h>

/* In a check: one cycle of that alone. */
static int forecast_one(interp *in, double grow, double relax, double force) {
    const relax_settings how = interp_scene(in)->relax;
    forecast_note_run(in, &(forecast_run){.cycles = 1, .grow = grow, .relax = relax, .force = force, .how = how});
    return SARCINA_OK;
}

static int run_grow(interp *in, const args *a, diag *d) {
    if (interp_checking(in))
        return forecast_one(in, args_number(a, "DT"), 0, 0);
    return interp_skips_runs(in) ? SARCINA_OK : scene_grow(interp_scene(in), args_number(a, "DT"), d);
}

static int run_relax(interp *in, const args *a, diag *d) {
    relax_result r = {0};
    if (relax_check(&interp_scene(in)->relax, args_number(a, "T"), 0, d))
        return SARCINA_ERROR;
    if (interp_checking(in))
        return forecast_one(in, 0, args_number(a, "T"), 0);
    if (interp_skips_runs(in))
        return SARCINA_OK;
    int status = scene_relax(interp_scene(in), args_number(a, "T"), 0, &r, d);
    if (!status)
        run_report_relaxation(in, &r);
    if (!status && r.stop == RELAX_INTERRUPTED)
        return diag_fail(d, SARCINA_INTERRUPTED, "interrupted after %g s of relaxation", r.time);
    return status;
}

/* How it ended; a minimiser's steps take no time. */
static void tell_end(interp *in, const relax_result *r) {
    unsigned long long steps = r->steps, evaluations = r->evaluations, products = r->products;
    double force = dim_from_engine(r->fmax, DIM_FORCE);
    if (integrator_styles[interp_scene(in)->relax.integrator]->caps & INTEGRATOR_MINIMISES)
        interp_print(in,
                     "minimised in %llu %s (%llu evaluations, %llu products): stopped by %s, largest net force %.3g N",
                     steps, number_noun(steps, "step", "steps"), evaluations, products,
                     r->stop == RELAX_FORCE ? "force" : "no further descent", force);
    else
        interp_print(in, "relaxed for %.6g s in %llu %s (%llu evaluations): stopped by %s, largest net force %.3g N",
                     r->time, steps, number_noun(steps, "step", "steps"), evaluations,
                     r->stop == RELAX_FORCE ? "force" : "time", force);
}

/* Stops when the forces are small, or after `within`; says which. */
static int run_relax_to(interp *in, const args *a, diag *d) {
    relax_result r = {0};
    double within = args_given(a, "within") ? args_number(a, "within") : (double)INFINITY;
    if (relax_check(&interp_scene(in)->relax, within, args_number(a, "F"), d))
        return SARCINA_ERROR;
    if (interp_checking(in))
        return forecast_one(in, 0, within, args_number(a, "F"));
    if (interp_skips_runs(in))
        return SARCINA_OK;
    int status = scene_relax(interp_scene(in), within, args_number(a, "F"), &r, d);
    if (status)
        return status;
    run_report_relaxation(in, &r);
    if (r.stop == RELAX_INTERRUPTED)
        return diag_fail(d, SARCINA_INTERRUPTED, "interrupted after %g s of relaxation", r.time);
    tell_end(in, &r);
    if (r.stop == RELAX_STALLED)
        run_report_stalled(in, 1);
    return SARCINA_OK;
}

static const param grow_params[] = {{"DT:time[0,)", "growth time"}};
static const param relax_params[] = {{"T:time[0,)", "relaxation time"}};
static const param relax_to_params[] = {
    {"F:force(0,)", "largest net force on a particle to reach, damping left out"},
    {"within:time(0,)", "give up after this much relaxation; without it, never"},
};

static const command_form forms[] = {
    {"grow DT:time[0,)", grow_params, 1, "Every cell grows, and those that are due divide",
     "One growth step, whatever its length: rates are drawn once.", "grow 4min", COMMAND_SHADOW, run_grow, NULL, 0},
    {"relax T:time[0,)", relax_params, 1, "Moves the cells under their forces for a time",
     "Newton's equations with damping, by the method of 'accuracy' or 'integrator'. The value caps counts where a "
     "limit "
     "held motion back or refused a step.",
     "relax 0.1s", COMMAND_SHADOW, run_relax, NULL, 0},
    {"relax to F:force(0,)", relax_to_params, TABLE_COUNT(relax_to_params),
     "Moves the cells until their forces are small",
     "Prints why it stopped. 'integrator newton' goes straight to a rest near by, which need not be the one that "
     "motion "
     "leads to.",
     "relax to 1e-15N within 2s\nintegrator newton\nrelax to 1e-19N", COMMAND_SHADOW, run_relax_to, NULL, 0},
};

void command_grow(command_table *t) {
    command_add(t, forms, TABLE_COUNT(forms));
}

/* SPDX-License-Identifier: GPL-3.0-or-later */
/* grow DT; relax T; relax to F [within T]: the two primitives a cycle is made of. */
#include "command/commands.h"
#include "command/forecast.h"
#include "command/run_report.h"

#include "base/table.h"

#include <math.h>

/* In a check: one cycle of that alone. */
static int forecast_one(interp *in, double grow, double relax, double force) {
    forecast_note_run(in, &(forecast_run){.cycles = 1, .grow = grow, .relax = relax, .force = force});
    return SARCINA_OK;
}

static int run_grow(interp *in, const args *a, diag *d) {
    if (interp_checking(in))
        return forecast_one(in, args_number(a, "DT"), 0, 0);
    return interp_skips_runs(in) ? SARCINA_OK : scene_grow(interp_scene(in), args_number(a, "DT"), d);
}

static int run_relax(interp *in, const args *a, diag *d) {
    relax_result r = {0};
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

/* Stops when the forces are small, or after `within`; says which. */
static int run_relax_to(interp *in, const args *a, diag *d) {
    relax_result r = {0};
    double within = args_given(a, "within") ? args_number(a, "within") : (double)INFINITY;
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
    interp_print(in, "relaxed for %.6g s in %llu steps (%llu evaluations): stopped by %s, largest net force %.3g N",
                 r.time, (unsigned long long)r.steps, (unsigned long long)r.evaluations,
                 r.stop == RELAX_FORCE ? "force" : "time", dim_from_engine(r.fmax, DIM_FORCE));
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
     "Moves the cells until their forces are small", "Prints why it stopped.", "relax to 1e-15N within 2s",
     COMMAND_SHADOW, run_relax_to, NULL, 0},
};

void command_grow(command_table *t) {
    command_add(t, forms, TABLE_COUNT(forms));
}

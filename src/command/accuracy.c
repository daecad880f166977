/* SPDX-License-Identifier: GPL-3.0-or-later */
/* accuracy auto: the cheapest preset that keeps within a bound on this scene, as tradeoff measures it. */
#include "command/commands.h"
#include "command/session.h"

#include "base/alloc.h"
#include "base/table.h"
#include "engine/tradeoff.h"

#include <inttypes.h>
#include <math.h>
#include <stdlib.h>

/* The cycle of the last run; 1 s of relaxation where there was none, or none for a time. */
static tradeoff_plan plan_of(const session *s) {
    bool timed = s->relax_time > 0 && isfinite(s->relax_time) && s->relax_force == 0;
    return (tradeoff_plan){.grow = s->grow_time > 0 ? s->grow_time : 0, .relax = timed ? s->relax_time : 1};
}

/* The reference's own error counts against a preset. */
static bool is_within(const tradeoff_row *row, const tradeoff_reference *reference, double bound) {
    bool measured = row->state == TRADEOFF_MEASURED || row->state == TRADEOFF_RESOLVED;
    return measured && row->error.most + reference->error.most <= bound;
}

static int find_cheapest(const tradeoff_row *rows, size_t n, const tradeoff_reference *reference, double bound) {
    int best = -1;
    for (size_t i = 0; i < n; i++)
        if (is_within(&rows[i], reference, bound) &&
            (best < 0 || rows[i].cost.evaluations < rows[best].cost.evaluations))
            best = (int)i;
    return best;
}

/* A restart file replays what was found, not the search. */
static void take(interp *in, const tradeoff_plan *plan, const tradeoff_row *rows, int best) {
    scene *s = interp_scene(in);
    const accuracy_preset *preset = &accuracy_presets[best];
    s->accuracy = best;
    s->relax = preset->settings;
    char *line = alloc_format("accuracy %s", preset->name);
    interp_journal_add(in, line);
    free(line);
    interp_print(in, "accuracy %s: off by %.2g um at most after %g s of relaxation, %" PRIu64 " evaluations",
                 preset->name, rows[best].error.most, plan->relax, rows[best].cost.evaluations);
}

static void tell_none(interp *in, const tradeoff_row *rows, size_t n, const tradeoff_reference *reference,
                      double bound) {
    int nearest = tradeoff_most_exact(rows, n);
    bool chaos = false;
    for (size_t i = 0; i < n; i++)
        chaos = chaos || rows[i].state == TRADEOFF_CHAOS;
    const char *why =
        chaos ? "; where trajectories diverge no positions tell: see 'tradeoff 1s cycles 10 seeds 5'" : "";
    if (nearest >= 0)
        interp_warn(in,
                    "no preset is known to keep within %g um here: %s is off by %.2g um of a reference that is known "
                    "to %.2g um; accuracy stays as it was%s",
                    bound, accuracy_presets[nearest].name, rows[nearest].error.most, reference->error.most, why);
    else
        interp_warn(in, "no preset is known to keep within %g um here; accuracy stays as it was%s", bound, why);
}

static int run_auto(interp *in, const args *a, diag *d) {
    scene *s = interp_scene(in);
    if (interp_checking(in) || interp_skips_runs(in))
        return SARCINA_OK;
    if (s->colony->cell.count == 0) {
        diag_error(d, "there are no cells to choose an accuracy for");
        return diag_help(d, "write it behind create_cells and a run");
    }
    size_t n = accuracy_preset_count;
    tradeoff_method *methods = alloc_zeroed(n, sizeof *methods);
    tradeoff_row *rows = alloc_zeroed(n, sizeof *rows);
    tradeoff_reference reference;
    tradeoff_plan plan = plan_of(session_of(in));
    for (size_t i = 0; i < n; i++)
        methods[i] = (tradeoff_method){accuracy_presets[i].name, accuracy_presets[i].settings};
    int status = tradeoff_relaxation(s, &plan, methods, n, rows, &reference, d);
    double bound = args_number(a, "error");
    int best = status ? -1 : find_cheapest(rows, n, &reference, bound);
    if (best >= 0)
        take(in, &plan, rows, best);
    else if (!status)
        tell_none(in, rows, n, &reference, bound);
    free(methods);
    free(rows);
    return status;
}

static const param params[] = {
    {"error:length!(0,1mm)", "largest error of a particle's position at the end of a relaxation"},
};

static const command_form forms[] = {
    {"accuracy auto", params, TABLE_COUNT(params), "Takes the cheapest preset that keeps within a bound on this scene",
     "Every preset relaxes the scene, behind one growth step, as 'tradeoff' does: with the growth step and relaxation "
     "time of the last run; 1 s where there was none, or one to a force. Of those whose largest error, with the "
     "reference's own, is within the bound, the one with the fewest evaluations counts from here on, and is printed. "
     "Where there is none, or trajectories diverge, nothing changes and a warning says so. It judges the scene as it "
     "stands: a larger colony may need another.",
     "run 2 grow 4min relax 0.1s\naccuracy auto error 0.05um", COMMAND_SHADOW, run_auto, NULL, 0},
};

void command_accuracy(command_table *t) {
    command_add(t, forms, TABLE_COUNT(forms));
}

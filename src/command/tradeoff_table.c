/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "command/tradeoff_table.h"

#include "base/dim.h"
#include "output/field.h"

#include <inttypes.h>
#include <math.h>

/* ---- the screen -------------------------------------------------------------------------------------------------- */

static const char *const states[] = {[TRADEOFF_MEASURED] = "",
                                     [TRADEOFF_RESOLVED] = "as exact as the reference",
                                     [TRADEOFF_CHAOS] = "chaos",
                                     [TRADEOFF_FAILED] = "failed"};

static void print_reference(interp *in, const tradeoff_reference *r) {
    interp_print(in, "  the reference is dopri5 at a tolerance of %.0e um (%" PRIu64 " evaluations with what follows)",
                 r->tolerance, r->evaluations);
    interp_print(in, "  its own error: %.0e um ends %.1e um from it at most, rms %.1e um%s", r->coarser, r->error.most,
                 r->error.rms, r->cut ? "; a tighter tolerance takes more than 100 times as long as the first" : "");
    interp_print(in, "  a displacement of %.1e um becomes %.1e um at most, rms %.1e um", r->displacement,
                 r->divergence.most, r->divergence.rms);
}

static void print_row(interp *in, const tradeoff_method *m, const tradeoff_row *row) {
    if (row->state == TRADEOFF_FAILED) {
        interp_print(in, "  %-10s failed: %s", m->name, row->reason);
        return;
    }
    interp_print(in, "%c %-10s %10.4f %12" PRIu64 " %9" PRIu64 " %11.2e %11.2e  %s", row->front ? '*' : ' ', m->name,
                 row->cost.seconds, row->cost.evaluations, row->cost.steps, row->error.most, row->error.rms,
                 states[row->state]);
}

static size_t count_state(const tradeoff_result *r, tradeoff_state state) {
    size_t count = 0;
    for (size_t i = 0; i < r->n; i++)
        count += r->rows[i].state == state;
    return count;
}

void tradeoff_table_print(interp *in, const tradeoff_result *r) {
    char grow[64] = "";
    if (r->plan.grow > 0)
        snprintf(grow, sizeof grow, "growth for %g s, then ", r->plan.grow);
    interp_print(in, "%sone relaxation of %g s, %zu cells", grow, r->plan.relax, r->reference.cells);
    print_reference(in, &r->reference);
    interp_print(in, "  %-10s %10s %12s %9s %11s %11s", "preset", "CPU s", "evaluations", "steps", "error um",
                 "rms um");
    for (size_t i = 0; i < r->n; i++)
        print_row(in, &r->methods[i], &r->rows[i]);
    if (count_state(r, TRADEOFF_CHAOS))
        interp_print(in, "chaos: a displacement too small to see changes the end about as much as the preset does; its "
                         "positions say nothing of accuracy, quantities over many seeds do (cycles, seeds)");
    if (tradeoff_most_exact(r->rows, r->n) >= 0)
        interp_print(in, "*: Pareto front: no other has fewer evaluations and is as exact (rms)");
}

/* ---- the file ---------------------------------------------------------------------------------------------------- */

static void put_number(FILE *f, double x) {
    char text[FIELD_ROOM];
    fprintf(f, ",%s", isnan(x) ? "" : field_number(x, text));
}

static void put_row(FILE *f, const char *name, const tradeoff_cost *cost, const tradeoff_distance *error,
                    const char *state, bool front) {
    fputs("relaxation,", f);
    field_put_csv(f, name);
    put_number(f, cost->seconds);
    fprintf(f, ",%" PRIu64, cost->evaluations);
    if (cost->steps)
        fprintf(f, ",%" PRIu64, cost->steps);
    else
        fputc(',', f);
    put_number(f, dim_from_engine(error->most, DIM_LENGTH));
    put_number(f, dim_from_engine(error->rms, DIM_LENGTH));
    fprintf(f, ",%s,%d\n", state, front);
}

void tradeoff_table_write(FILE *f, const tradeoff_result *r) {
    static const char *const words[] = {[TRADEOFF_MEASURED] = "measured",
                                        [TRADEOFF_RESOLVED] = "resolved",
                                        [TRADEOFF_CHAOS] = "chaos",
                                        [TRADEOFF_FAILED] = "failed"};
    const tradeoff_cost reference = {.seconds = NAN, .evaluations = r->reference.evaluations};
    fputs("part,preset,cpu_s,evaluations,steps,error_max_m,error_rms_m,state,front\n", f);
    put_row(f, "(reference)", &reference, &r->reference.error, r->reference.cut ? "cut" : "converged", false);
    put_row(f, "(displaced)", &(tradeoff_cost){.seconds = NAN}, &r->reference.divergence, "", false);
    for (size_t i = 0; i < r->n; i++)
        put_row(f, r->methods[i].name, &r->rows[i].cost, &r->rows[i].error, words[r->rows[i].state], r->rows[i].front);
}

/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "command/tradeoff_table.h"

#include "base/dim.h"
#include "base/number.h"
#include "output/field.h"
#include "output/readable.h"

#include <inttypes.h>
#include <math.h>
#include <string.h>

/* ---- one relaxation, on the screen ------------------------------------------------------------------------------- */

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

/* Of the column of names. */
static int width_of(const tradeoff_result *r) {
    size_t width = 10;
    for (size_t i = 0; i < r->n; i++)
        width = strlen(r->methods[i].name) > width ? strlen(r->methods[i].name) : width;
    return (int)width;
}

static void print_row(interp *in, const tradeoff_method *m, int width, const tradeoff_row *row) {
    if (row->state == TRADEOFF_FAILED) {
        interp_print(in, "  %-*s failed: %s", width, m->name, row->reason);
        return;
    }
    const char *state = states[row->state];
    interp_print(in, "%c %-*s %10.4f %12" PRIu64 " %9" PRIu64 " %11.2e %11.2e%s%s", row->front ? '*' : ' ', width,
                 m->name, row->cost.seconds, row->cost.evaluations, row->cost.steps, row->error.most, row->error.rms,
                 *state ? "  " : "", state);
}

void tradeoff_table_relaxation(interp *in, const tradeoff_result *r) {
    char grow[64] = "";
    int width = width_of(r);
    bool chaos = false;
    if (r->plan.grow > 0)
        snprintf(grow, sizeof grow, "growth for %g s, then ", r->plan.grow);
    interp_print(in, "%sone relaxation of %g s, %zu %s", grow, r->plan.relax, r->reference.cells,
                 number_noun(r->reference.cells, "cell", "cells"));
    print_reference(in, &r->reference);
    interp_print(in, "  %-*s %10s %12s %9s %11s %11s", width, "preset", "CPU s", "evaluations", "steps", "error um",
                 "rms um");
    for (size_t i = 0; i < r->n; i++) {
        print_row(in, &r->methods[i], width, &r->rows[i]);
        chaos = chaos || r->rows[i].state == TRADEOFF_CHAOS;
    }
    if (chaos)
        interp_print(in, "chaos: a displacement too small to see changes the end about as much as the preset does; its "
                         "positions say nothing of accuracy, quantities over many seeds do (cycles, seeds)");
    if (tradeoff_most_exact(r->rows, r->n) >= 0)
        interp_print(in, "*: Pareto front: no other has fewer evaluations and is as exact (rms)");
}

/* ---- many cycles, on the screen ---------------------------------------------------------------------------------- */

static void verdict_text(const tradeoff_comparison *c, char text[64]) {
    static const char *const verdicts[] = {[TRADEOFF_EQUIVALENT] = "equivalent",
                                           [TRADEOFF_BIASED] = "biased",
                                           [TRADEOFF_OPEN] = "not enough seeds",
                                           [TRADEOFF_UNDEFINED] = "undefined"};
    if (c->verdict != TRADEOFF_OPEN || isnan(c->seeds))
        snprintf(text, 64, "%s", verdicts[c->verdict]);
    else if (isinf(c->seeds))
        snprintf(text, 64, "not enough seeds: more than a million");
    else
        snprintf(text, 64, "not enough seeds: about %.0f", c->seeds);
}

static void print_comparison(interp *in, const tradeoff_result *r, int width, size_t m, size_t k) {
    const tradeoff_comparison *c = &r->comparison[m * r->runs.nobserved + k];
    const output_column *column = &r->observed[k];
    char suffix[48], name[80], verdict[64], difference[48] = "-";
    double divisor = readable_unit(column->d, suffix), percent = 100 / fabs(c->reference.mean);
    snprintf(name, sizeof name, suffix[0] ? "%.40s (%s)" : "%.40s", column->name, suffix);
    verdict_text(c, verdict);
    if (c->reference.mean != 0)
        snprintf(difference, sizeof difference, "%+.2f +- %.2f", percent * c->difference.value, percent * c->width);
    if (m == r->base)
        interp_print(in, "  %-*s %-24s %11.4g  compared with", width, "", name, c->own.mean / divisor);
    else
        interp_print(in, "  %-*s %-24s %11.4g %18s  %s", width, "", name, c->own.mean / divisor, difference, verdict);
}

void tradeoff_table_cycles(interp *in, const tradeoff_result *r) {
    const tradeoff_runs *runs = &r->runs;
    int width = width_of(r);
    interp_print(in, "%" PRIu64 " %s of growth for %g s and relaxation of %g s, %zu %s", r->cycles,
                 number_noun(r->cycles, "cycle", "cycles"), r->plan.grow, r->plan.relax, runs->seeds,
                 number_noun(runs->seeds, "seed", "seeds"));
    interp_print(in, "  differences from %s, paired by seed, with 95 %% intervals; equivalent within %g %%",
                 r->methods[r->base].name, 100 * r->margin);
    interp_print(in, "  %-*s %-24s %11s %18s  %s", width, "preset", "quantity", "mean", "difference %", "verdict");
    for (size_t m = 0; m < r->n; m++) {
        interp_print(in, "  %-*s %.4g CPU s, %" PRIu64 " evaluations%s", width, r->methods[m].name,
                     runs->cost[m].seconds, runs->cost[m].evaluations, runs->failed[m] ? ": failed" : "");
        for (size_t k = 0; k < runs->nobserved && !runs->failed[m]; k++)
            print_comparison(in, r, width, m, k);
    }
    size_t best = tradeoff_cheapest(runs, r->base, r->comparison);
    if (best == r->base)
        interp_print(in, "no cheaper preset has been shown to be equivalent to %s", r->methods[best].name);
    else
        interp_print(in, "cheapest equivalent preset: %s, with %.3g of the evaluations of %s", r->methods[best].name,
                     (double)runs->cost[best].evaluations / (double)runs->cost[r->base].evaluations,
                     r->methods[r->base].name);
}

/* ---- the file ---------------------------------------------------------------------------------------------------- */

static void put_number(FILE *f, double x) {
    char text[FIELD_ROOM];
    fprintf(f, ",%s", isnan(x) ? "" : field_number(x, text));
}

static void put_head(FILE *f, const char *part, const char *name) {
    fprintf(f, "%s,", part);
    field_put_csv(f, name);
}

static void put_cost(FILE *f, const tradeoff_cost *cost) {
    put_number(f, cost->seconds);
    fprintf(f, ",%" PRIu64, cost->evaluations);
    if (cost->steps)
        fprintf(f, ",%" PRIu64, cost->steps);
    else
        fputc(',', f);
}

static void put_row(FILE *f, const char *name, const tradeoff_cost *cost, const tradeoff_distance *error,
                    const char *state, bool front) {
    put_head(f, "relaxation", name);
    put_cost(f, cost);
    put_number(f, dim_from_engine(error->most, DIM_LENGTH));
    put_number(f, dim_from_engine(error->rms, DIM_LENGTH));
    fprintf(f, ",%s,%d,,,,,,,,,,,\n", state, front);
}

static void write_relaxation(FILE *f, const tradeoff_result *r) {
    static const char *const words[] = {[TRADEOFF_MEASURED] = "measured",
                                        [TRADEOFF_RESOLVED] = "resolved",
                                        [TRADEOFF_CHAOS] = "chaos",
                                        [TRADEOFF_FAILED] = "failed"};
    const tradeoff_cost reference = {.seconds = NAN, .evaluations = r->reference.evaluations};
    put_row(f, "(reference)", &reference, &r->reference.error, r->reference.cut ? "cut" : "converged", false);
    put_row(f, "(displaced)", &(tradeoff_cost){.seconds = NAN}, &r->reference.divergence, "", false);
    for (size_t i = 0; i < r->n; i++)
        put_row(f, r->methods[i].name, &r->rows[i].cost, &r->rows[i].error, words[r->rows[i].state], r->rows[i].front);
}

static void put_quantity(FILE *f, const output_column *column) {
    char suffix[48];
    fputc(',', f);
    field_put_csv(f, column->name);
    fprintf(f, ",%s", dim_suffix(column->d, suffix));
}

static void write_comparison(FILE *f, const tradeoff_result *r, size_t m, size_t k) {
    static const char *const words[] = {[TRADEOFF_EQUIVALENT] = "equivalent",
                                        [TRADEOFF_BIASED] = "biased",
                                        [TRADEOFF_OPEN] = "open",
                                        [TRADEOFF_UNDEFINED] = "undefined"};
    const tradeoff_comparison *c = &r->comparison[m * r->runs.nobserved + k];
    put_head(f, "comparison", r->methods[m].name);
    fprintf(f, ",,,,,,%s,,", m == r->base ? "reference" : words[c->verdict]);
    put_quantity(f, &r->observed[k]);
    put_number(f, c->own.mean);
    put_number(f, c->reference.mean);
    put_number(f, c->difference.value);
    put_number(f, c->difference.value - c->width);
    put_number(f, c->difference.value + c->width);
    put_number(f, c->margin);
    put_number(f, c->p);
    put_number(f, c->verdict == TRADEOFF_OPEN ? c->seeds : (double)NAN);
    fputc('\n', f);
}

static void write_cycles(FILE *f, const tradeoff_result *r) {
    const tradeoff_runs *runs = &r->runs;
    for (size_t m = 0; m < r->n; m++) {
        put_head(f, "cycles", r->methods[m].name);
        put_cost(f, &runs->cost[m]);
        fprintf(f, ",,,%s,,,,,,,,,,,,\n", runs->failed[m] ? "failed" : "");
        for (size_t i = 0; i < runs->seeds; i++)
            for (size_t k = 0; k < runs->nobserved; k++) {
                put_head(f, "run", r->methods[m].name);
                fprintf(f, ",,,,,,,,%zu", i + 1);
                put_quantity(f, &r->observed[k]);
                put_number(f, runs->values[(m * runs->seeds + i) * runs->nobserved + k]);
                fputs(",,,,,,,\n", f);
            }
        for (size_t k = 0; k < runs->nobserved; k++)
            write_comparison(f, r, m, k);
    }
}

void tradeoff_table_write(FILE *f, const tradeoff_result *r) {
    fputs("part,preset,cpu_s,evaluations,steps,error_max_m,error_rms_m,state,front,seed,quantity,unit,value,"
          "reference_value,difference,low,high,margin,p_equivalent,seeds_needed\n",
          f);
    write_relaxation(f, r);
    if (r->cycles)
        write_cycles(f, r);
}

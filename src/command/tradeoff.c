/* SPDX-License-Identifier: GPL-3.0-or-later */
/* tradeoff T [among PRESET...] [cycles N] [seeds K] ...: speed against accuracy, on the scene as it stands. */
#include "command/commands.h"
#include "command/forecast.h"
#include "command/output_list.h"
#include "command/session.h"
#include "command/tradeoff_method.h"
#include "command/tradeoff_table.h"

#include "base/alloc.h"
#include "base/number.h"
#include "base/path.h"
#include "base/table.h"
#include "output/plot.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

enum { METHODS_MAX = 32 };

/* ---- what is compared -------------------------------------------------------------------------------------------- */

static int row_of(const tradeoff_method *methods, size_t n, const char *name) {
    for (size_t i = 0; i < n; i++)
        if (strcmp(methods[i].name, name) == 0)
            return (int)i;
    return -1;
}

/* Row of the method that an argument names; -1: it is not given. */
static int find_among(const args *a, const char *argument, const tradeoff_method *methods, size_t n) {
    return args_given(a, argument) ? row_of(methods, n, args_text(a, argument)) : -1;
}

/* Those named, or all presets. */
static int read_methods(interp *in, const args *a, tradeoff_method methods[METHODS_MAX], size_t *n, diag *d) {
    size_t named = args_given(a, "among") && output_list_knows(a, "among") ? args_count(a, "among") : 0;
    int status = SARCINA_OK;
    for (*n = 0; *n < accuracy_preset_count && !args_given(a, "among"); ++*n)
        methods[*n] = (tradeoff_method){accuracy_presets[*n].name, accuracy_presets[*n].settings};
    for (; *n < named && !status; *n += !status) {
        const char *name = args_text_at(a, "among", *n);
        if (*n == METHODS_MAX)
            status = diag_error(d, "at most %d methods are compared", METHODS_MAX);
        else if (row_of(methods, *n, name) >= 0)
            status = diag_error(d, "'%s' is named twice", name);
        else
            status = tradeoff_method_read(in, name, &methods[*n], d);
        if (status)
            diag_place(d, args_span_at(a, "among", *n));
    }
    return status;
}

static int check_against(const args *a, const tradeoff_method *methods, size_t n, diag *d) {
    if (!args_given(a, "against") || !output_list_knows(a, "against") || !output_list_knows(a, "among") ||
        find_among(a, "against", methods, n) >= 0)
        return SARCINA_OK;
    diag_error(d, "'%s' is not one of those that are compared", args_text(a, "against"));
    diag_place(d, args_span(a, "against"));
    return diag_help(d, "name it behind among, too");
}

/* A colony that has just been relaxed is at rest, and any method keeps it so: what a run solves begins with growth. */
static tradeoff_plan read_plan(interp *in, const args *a) {
    double grow = args_given(a, "grow") ? args_number(a, "grow") : session_of(in)->grow_time;
    return (tradeoff_plan){.grow = isnan(grow) ? 0 : grow, .relax = args_number(a, "T")};
}

/* ---- what is observed -------------------------------------------------------------------------------------------- */

enum { OBSERVED_MAX = 16 };

typedef struct observed {
    interp *in;
    output_column columns[OBSERVED_MAX];
    size_t n;
    size_t methods, seeds; /* for the line that shows how far it is */
} observed;

static int observe(void *self, size_t method, size_t seed, double *values, diag *d) {
    observed *o = self;
    int status = SARCINA_OK;
    for (size_t i = 0; i < o->n && !status; i++)
        status = o->columns[i].number(o->columns[i].self, 0, &values[i], d);
    if (interp_has_progress(o->in)) {
        char line[80];
        snprintf(line, sizeof line, "tradeoff: %zu of %zu %s", seed * o->methods + method + 1, o->seeds * o->methods,
                 number_noun(o->seeds * o->methods, "run", "runs"));
        interp_progress(o->in, line);
    }
    return status;
}

static void free_observed(observed *o) {
    for (size_t i = 0; i < o->n; i++) {
        free(o->columns[i].name);
        if (o->columns[i].release)
            o->columns[i].release(o->columns[i].self);
    }
}

/* Rods and flexible cells have axes, cocci have none. */
static bool has_axes(const colony *c) {
    for (size_t row = 0; row < c->cell.count; row++)
        if (c->cell.nparticles[row] > 1)
            return true;
    return false;
}

static void observe_value(interp *in, observed *o, const char *name, const char *field) {
    o->columns[o->n++] = output_list_plain_column(in, name, field);
}

/* Size; over a substratum and in two dimensions order, of cells that have axes; over a substratum layers, else density;
 * links where there are any. Measures that tell with few seeds: extremes (thickness) and means near zero (orientation
 * of a large colony, or of a floc) take hundreds. */
static void observe_default(interp *in, observed *o) {
    const scene *s = interp_scene(in);
    const bool over = s->forces.term[FORCE_SUBSTRATUM].on, flat = s->dimension == 2;
    observe_value(in, o, "gyration", NULL);
    if ((over || flat) && has_axes(s->colony))
        observe_value(in, o, "nematic", flat ? "plane" : NULL);
    observe_value(in, o, over ? "layering" : "compactness", over ? "mean" : NULL);
    if (s->colony->link.count)
        observe_value(in, o, "links", NULL);
}

static int observe_one(observed *o, const args *a, size_t i, diag *d) {
    expr *e = args_expr_at(a, "observe", i);
    int status = SARCINA_OK;
    if (i >= OBSERVED_MAX)
        status = diag_error(d, "at most %d quantities are observed", OBSERVED_MAX);
    if (!status)
        status = interp_check_repeatable(o->in, e, d);
    if (!status)
        status = interp_column(o->in, e, false, &o->columns[o->n], d);
    if (!status && o->columns[o->n++].is_text)
        status = diag_error(d, "what is observed is a number, and '%s' is a text", expr_text(e));
    if (status)
        diag_place(d, args_span_at(a, "observe", i));
    return status;
}

static int read_observed(const args *a, observed *o, diag *d) {
    int status = SARCINA_OK;
    if (!args_given(a, "observe"))
        observe_default(o->in, o);
    for (size_t i = 0; args_given(a, "observe") && i < args_count(a, "observe") && !status; i++)
        status = observe_one(o, a, i, d);
    return status;
}

/* ---- checks ------------------------------------------------------------------------------------------------------ */

static int check_file(const args *a, const char *name, bool picture, diag *d) {
    if (!args_given(a, name) || !output_list_knows(a, name))
        return SARCINA_OK;
    int status = SARCINA_OK;
    if (picture && !plot_terminal(args_text(a, name)))
        status = diag_error(d, "a diagram's file ends in .svg, .png or .pdf, not '%s'", args_text(a, name));
    if (!status)
        status = path_check(args_text(a, name), d);
    if (status)
        diag_place(d, args_span(a, name));
    return status;
}

/* Words that mean nothing without cycles, and cycles that would all be the same. */
static int check_cycles(interp *in, const args *a, diag *d) {
    static const char *const words[] = {"seeds", "observe", "against", "margin"};
    for (size_t i = 0; i < TABLE_COUNT(words); i++)
        if (!args_given(a, "cycles") && args_given(a, words[i])) {
            diag_error(d, "%s is for what cells do over many cycles, and there are none", words[i]);
            diag_place(d, args_span(a, words[i]));
            return diag_help(d, "tradeoff 1s cycles 10 seeds 5");
        }
    if (args_int(a, "cycles") == 0 || read_plan(in, a).grow > 0 || interp_has_open_world(in))
        return SARCINA_OK;
    diag_error(d, "cycles need growth, and nothing is remembered from a run before");
    return diag_help(d, "tradeoff 1s cycles 10 grow 4min");
}

/* ---- the command ------------------------------------------------------------------------------------------------- */

static int write_file(const char *path, const tradeoff_result *r, diag *d) {
    FILE *f = path_open(path, "w", d);
    if (!f)
        return SARCINA_ERROR;
    tradeoff_table_write(f, r);
    return path_close(f, path, d);
}

static int draw(interp *in, const char *path, const tradeoff_result *r, diag *d) {
    diag missing = {0};
    if (plot_ready(&missing) == SARCINA_OK)
        return tradeoff_plot_draw(path, r, d);
    interp_warn(in, "%s (%s); this diagram is left out", missing.message, missing.help);
    return SARCINA_OK;
}

static int keep(interp *in, const args *a, const tradeoff_result *r, diag *d) {
    int status = args_given(a, "file") ? write_file(args_text(a, "file"), r, d) : SARCINA_OK;
    return !status && args_given(a, "plot") ? draw(in, args_text(a, "plot"), r, d) : status;
}

/* The one that is named (-1: none); else the most exact here; where trajectories diverge, the most exact preset by the
 * order of their table. */
static size_t choose_base(const tradeoff_result *r, int named) {
    if (named >= 0)
        return (size_t)named;
    int best = tradeoff_most_exact(r->rows, r->n), last = -1;
    for (size_t i = 0; i < r->n && best < 0; i++)
        for (int k = last + 1; k < (int)accuracy_preset_count; k++)
            if (strcmp(r->methods[i].name, accuracy_presets[k].name) == 0)
                last = k;
    for (size_t i = 0; i < r->n && best < 0 && last >= 0; i++)
        if (strcmp(r->methods[i].name, accuracy_presets[last].name) == 0)
            best = (int)i;
    return best < 0 ? 0 : (size_t)best;
}

/* Relaxation, cycles where they are asked for, tables. */
static int measure(interp *in, const args *a, tradeoff_result *r, tradeoff_row *rows, observed *o, diag *d) {
    scene *s = interp_scene(in);
    int status = tradeoff_relaxation(s, &r->plan, r->methods, r->n, rows, &r->reference, d);
    if (status)
        return status;
    tradeoff_table_relaxation(in, r);
    if (!r->cycles)
        return keep(in, a, r, d);
    const tradeoff_study study = {.plan = r->plan,
                                  .cycles = r->cycles,
                                  .seeds = (size_t)args_int(a, "seeds"),
                                  .nobserved = o->n,
                                  .self = o,
                                  .observe = observe};
    o->methods = r->n;
    o->seeds = study.seeds;
    status = tradeoff_cycles(s, &study, r->methods, r->n, &r->runs, d);
    interp_progress(in, NULL);
    tradeoff_comparison *all = alloc_zeroed(r->n * o->n, sizeof *all);
    r->base = choose_base(r, find_among(a, "against", r->methods, r->n));
    r->comparison = all;
    if (!status) {
        tradeoff_compare(&r->runs, r->base, r->margin, all);
        tradeoff_table_cycles(in, r);
        status = keep(in, a, r, d);
    }
    free(all);
    tradeoff_runs_free(&r->runs);
    return status;
}

static int run_tradeoff(interp *in, const args *a, diag *d) {
    tradeoff_method methods[METHODS_MAX] = {{0}};
    tradeoff_row rows[METHODS_MAX];
    observed o = {.in = in};
    tradeoff_result r = {.plan = read_plan(in, a),
                         .methods = methods,
                         .rows = rows,
                         .cycles = (uint64_t)args_int(a, "cycles"),
                         .margin = args_number(a, "margin"),
                         .observed = o.columns};
    int status = read_methods(in, a, methods, &r.n, d);
    if (!status)
        status = check_against(a, methods, r.n, d);
    if (!status)
        status = check_file(a, "file", false, d);
    if (!status)
        status = check_file(a, "plot", true, d);
    if (!status)
        status = check_cycles(in, a, d);
    if (!status)
        status = read_observed(a, &o, d);
    if (!status && interp_checking(in))
        forecast_note_tradeoff(in, &(forecast_tradeoff){.grow = r.plan.grow,
                                                        .relax = r.plan.relax,
                                                        .times = (double)r.cycles * (double)args_int(a, "seeds"),
                                                        .methods = methods,
                                                        .n = r.n});
    bool runs = !status && !interp_checking(in) && !interp_skips_runs(in);
    if (runs && interp_scene(in)->colony->cell.count == 0) {
        diag_error(d, "there are no cells to compare the presets on");
        status = diag_help(d, "write it behind create_cells and a run");
    } else if (runs) {
        status = measure(in, a, &r, rows, &o, d);
    }
    free_observed(&o);
    return status;
}

static const param params[] = {
    {"T:time(0,)", "relaxation time, of each cycle too"},
    {"among:word...", "presets of accuracy, or integrators, each with its step, tol or inertia where it is quoted; "
                      "without it, all presets"},
    {"grow:time[0,)", "growth before the relaxation; without it, that of the run before, or none"},
    {"cycles=0:int[0,)", "also runs of this many cycles by each, and compares what they end with"},
    {"seeds=1:int[1,)", "runs by each: from the scene's seed, and from those that follow it"},
    {"observe:value...", "what is compared; without it: gyration; over a substratum and in dimension 2 nematic "
                         "(nematic.plane), where cells have axes; over a substratum layering.mean, else compactness; "
                         "links where there are any"},
    {"against:word", "which of them the others are compared with; without it, the most exact"},
    {"margin=2%:fraction%(0,1)", "differences below this part of the mean are of no interest"},
    {"file:file", "a CSV file for what was found, in SI units"},
    {"plot:file", "a .svg, .png or .pdf file: errors against evaluations; with cycles, also one with .cycles before "
                  "the ending: differences against evaluations"},
};

static const command_form forms[] = {
    {"tradeoff T:time(0,)", params, TABLE_COUNT(params),
     "Measures the error and the cost of each preset, and what they change",
     "First the cells grow once, the same for all, as in a cycle of run: a colony at rest stays so by any method. Then "
     "each preset relaxes it. The error is that of the particles' positions at the end, the largest and the root mean "
     "square, against Dormand-Prince at ever tighter tolerances, from 0.1 um to 1e-7 um, until two that follow each "
     "other "
     "end within a twentieth of the least error measured, come no nearer, or the next takes more than 100 times the "
     "evaluations of the first, as with 'contact closest', whose force jumps; what they differ by is printed as "
     "the reference's own error. A relaxation from particles displaced by 1e-9 diameters shows where trajectories "
     "diverge: rows whose error is less than twice what has become of that say chaos. Costs are seconds of all "
     "processors and evaluations of the force; the Pareto front is that of evaluations, the same at every run.\n\n"
     "With cycles, each preset makes the run from each seed, and every quantity is compared with that of the most "
     "exact preset, or of the one named, seed by seed. It is equivalent where two one-sided tests at 5 % say that the "
     "difference is within "
     "the margin (TOST; then also where it is surely not 0); biased where the interval of the difference excludes 0; "
     "else there are not enough seeds, and about so many are needed for a power of 80 %. Intervals are of 95 % for all "
     "quantities of a preset together (Bonferroni). The cheapest preset all of whose quantities are equivalent is "
     "named.\n\n"
     "The growth step and T are physics, not accuracy: another T is another model, however fast it runs.",
     "tradeoff 0.1s among paper balanced draft grow 4min file tradeoff.csv\n"
     "tradeoff 0.1s among balanced rk4 \"verlet step 1ms\" \"bs32 tol 0.01\" \"euler inertia 0.1\" grow 4min\n"
     "tradeoff 0.1s among balanced draft cycles 2 seeds 3 observe gyration/1um thickness against balanced margin 5% "
     "plot tradeoff.svg "
     "grow 4min",
     COMMAND_SHADOW, run_tradeoff, NULL, 0},
};

void command_tradeoff(command_table *t) {
    command_add(t, forms, TABLE_COUNT(forms));
}

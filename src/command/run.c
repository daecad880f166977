/* SPDX-License-Identifier: GPL-3.0-or-later */
/* run N [upto] [grow DT] [relax T] [until TEST] [every M "command" ...]: cycles of growth and relaxation, and the
 * output that is due. Order in a cycle: grow, relax, output, every, until; until is also looked at before the first. */
#include "command/commands.h"
#include "command/forecast.h"
#include "command/session.h"
#include "command/watch.h"

#include "base/number.h"
#include "base/table.h"
#include "output/progress.h"

#include <inttypes.h>
#include <math.h>

/* What one run is made of. */
typedef struct plan {
    double grow, relax, force;
    uint64_t cycles;
    expr *until;
    const args *a;
} plan;

/* Grow and relax as given; or, when neither is, those of the run before. */
static int read_cycle(session *s, const args *a, plan *p, diag *d) {
    bool has_grow = args_given(a, "grow"), has_relax = args_given(a, "relax");
    if (!has_grow && !has_relax) {
        if (isnan(s->grow_time) && !interp_has_open_world(s->in)) {
            diag_error(d, "run needs grow or relax: nothing is remembered from a run before");
            return diag_help(d, "run 70 grow 4min relax 1s");
        }
        *p = (plan){.grow = s->grow_time, .relax = s->relax_time, .force = s->relax_force};
        return SARCINA_OK;
    }
    *p = (plan){.grow = has_grow ? args_number(a, "grow") : 0};
    if (has_relax)
        args_relaxation(a, "relax", &p->relax, &p->force);
    return SARCINA_OK;
}

/* Whole cycles nearest to a time; said when it is not one exactly. */
static uint64_t cycles_of_time(interp *in, double time, double cycle) {
    double cycles = time / cycle, whole = round(cycles);
    if (fabs(cycles - whole) > 1e-9 * fmax(1, whole))
        interp_print(in, "%g s is %.2f cycles: running %.0f", time, cycles, whole);
    return whole > 0 ? (uint64_t)whole : 0;
}

static int count_cycles(interp *in, const args *a, plan *p, diag *d) {
    const scene *s = interp_scene(in);
    args_cycles_value n = args_cycles(a, "N");
    bool upto = args_given(a, "upto");
    if (!n.is_time) {
        p->cycles = !upto ? n.cycles : n.cycles > s->step ? n.cycles - s->step : 0;
        return SARCINA_OK;
    }
    double cycle = p->grow > 0 ? p->grow : p->relax, done = p->grow > 0 ? s->time : s->relaxed;
    if (!isfinite(cycle) || !(cycle > 0))
        return diag_error(d, "a run for a time needs grow, or relax for a time");
    p->cycles = cycles_of_time(in, upto ? n.time - done : n.time, cycle);
    return SARCINA_OK;
}

static int is_done(interp *in, const plan *p, bool *done, diag *d) {
    *done = false;
    return p->until ? interp_truth(in, p->until, done, d) : SARCINA_OK;
}

/* The commands of `every` that are due at this step. */
static int run_every(interp *in, const plan *p, double before, diag *d) {
    const scene *s = interp_scene(in);
    int status = SARCINA_OK;
    /* the run has been echoed: lines of its commands would stand between the table's rows */
    echo_mode echo = interp_set_echo(in, ECHO_NONE);
    for (size_t i = 0; i < args_every_count(p->a, "every") && !status; i++) {
        command_text *const *commands;
        size_t n;
        args_cycles_value every = args_every(p->a, "every", i, &commands, &n);
        if (!outputs_due(every, s->step, before, s->time))
            continue;
        session_of(in)->in_every = true;
        for (size_t k = 0; k < n && !status; k++)
            status = interp_run_text(in, commands[k], d);
        session_of(in)->in_every = false;
    }
    echo_mode now = interp_set_echo(in, echo);
    if (now != ECHO_NONE) /* one of them said otherwise */
        interp_set_echo(in, now);
    return status;
}

static int write_checkpoint(interp *in, double before, diag *d) {
    restart_schedule *r = &session_of(in)->restart;
    const scene *s = interp_scene(in);
    bool off = !r->every.is_time && r->every.cycles == 0;
    if (off || !r->files[0] || !outputs_due(r->every, s->step, before, s->time))
        return SARCINA_OK;
    return session_write_checkpoint(in, d);
}

/* What is due at this step is written, and the time it takes is kept. */
static int write_step(session *s, scene *sc, bool last, diag *d) {
    double begin = scene_clock();
    int status = outputs_step(s->out, last, d);
    sc->timing.output += scene_clock() - begin;
    return status;
}

/* One cycle and all that follows it; *done: the run ends here. */
static int run_cycle(interp *in, const plan *p, bool last, bool *done, diag *d) {
    session *s = session_of(in);
    scene *sc = interp_scene(in);
    double before = sc->time;
    int status = scene_cycle(sc, p->grow, p->relax, p->force, d);
    if (!status)
        status = write_step(s, sc, last, d);
    if (!status)
        status = write_checkpoint(in, before, d);
    if (!status)
        status = run_every(in, p, before, d);
    if (!status)
        status = is_done(in, p, done, d);
    if (!status && *done && !last)
        status = write_step(s, sc, true, d);
    return status;
}

static double total_mass(const scene *s) {
    double mass = 0;
    for (size_t i = 0; i < s->colony->cell.count; i++)
        mass += s->colony->cell.mass[i];
    return mass;
}

/* On a terminal: how far, and how long yet. */
static void show_progress(interp *in, const plan *p, progress *shown) {
    const scene *s = interp_scene(in);
    char line[200];
    if (!interp_has_progress(in))
        return;
    progress_cycle(shown, scene_clock(), total_mass(s));
    if (!progress_is_due(shown))
        return;
    progress_line(shown, s->step - shown->done, s->colony->cell.count, p->until != NULL, line, sizeof line);
    char *shown_text = watch_text(in, line);
    interp_progress(in, shown_text);
    free(shown_text);
}

static int run_all_cycles(interp *in, const plan *p, diag *d) {
    const scene *s = interp_scene(in);
    bool done = false;
    progress shown = progress_begin(p->cycles, scene_clock(), total_mass(s));
    int status = is_done(in, p, &done, d);
    if (!status)
        status = outputs_begin(session_of(in)->out, d);
    for (uint64_t i = 0; i < p->cycles && !done && !status; i++) {
        status = run_cycle(in, p, i + 1 == p->cycles, &done, d);
        show_progress(in, p, &shown);
    }
    interp_progress(in, NULL);
    outputs_end(session_of(in)->out);
    return status;
}

/* Cells that arrived in a run, and those for which there was no place. */
static void tell_attached(interp *in, uint64_t arrived, uint64_t crowded) {
    const attachment_table *t = &interp_scene(in)->attachments;
    arrived = t->arrived - arrived;
    crowded = t->crowded - crowded;
    if (crowded)
        interp_print(in, "attached %" PRIu64 " %s; %" PRIu64 " found no place", arrived,
                     number_noun(arrived, "cell", "cells"), crowded);
    else if (arrived)
        interp_print(in, "attached %" PRIu64 " %s", arrived, number_noun(arrived, "cell", "cells"));
}

static int run_cycles(interp *in, const plan *p, diag *d) {
    session *s = session_of(in);
    scene *sc = interp_scene(in);
    int status = outputs_open(s->out, d);
    if (status)
        return status;
    run_report_begin(in, &s->report);
    double before = scene_clock();
    uint64_t first = sc->step, stalled = sc->tally.stalled, arrived = sc->attachments.arrived,
             crowded = sc->attachments.crowded;
    status = run_all_cycles(in, p, d);
    run_report_end(in, &s->report, scene_clock() - before, sc->step - first);
    tell_attached(in, arrived, crowded);
    run_report_stalled(in, sc->tally.stalled - stalled);
    return status;
}

/* In a check: how many cycles there will be. */
static void forecast_cycles(interp *in, const plan *p) {
    args_cycles_value n = args_cycles(p->a, "N");
    double cycle = p->grow > 0 ? p->grow : p->relax;
    forecast_run r = {.cycles = !n.is_time  ? (double)n.cycles
                                : cycle > 0 ? n.time / cycle
                                            : 0,
                      .grow = p->grow,
                      .relax = p->relax,
                      .force = p->force,
                      .until = p->until,
                      .upto = args_given(p->a, "upto"),
                      .how = interp_scene(in)->relax};
    forecast_note_run(in, &r);
}

static int run_run(interp *in, const args *a, diag *d) {
    session *s = session_of(in);
    plan p = {0};
    int status = read_cycle(s, a, &p, d);
    p.until = args_expr(a, "until");
    p.a = a;
    if (!status)
        status = count_cycles(in, a, &p, d);
    if (!status && p.relax > 0)
        status = relax_check(&interp_scene(in)->relax, p.relax, p.force, d);
    p.cycles = interp_skips_runs(in) ? 0 : p.cycles;
    if (!status && !interp_checking(in) && p.cycles > 0)
        status = scene_prepare(interp_scene(in), d);
    if (status)
        return status;
    s->grow_time = p.grow;
    s->relax_time = p.relax;
    s->relax_force = p.force;
    if (interp_checking(in))
        forecast_cycles(in, &p);
    return interp_checking(in) ? SARCINA_OK : run_cycles(in, &p, d);
}

static const param params[] = {
    {"N:cycles[0,)", "cycles, or a time: then the nearest whole number of them"},
    {"upto:nothing", "N counts from the beginning of the simulation: no cycles when it is past"},
    {"grow:time(0,)", "growth step of a cycle"},
    {"relax:relaxation", "relaxation of a cycle: a time, or 'to FORCE [within TIME]'"},
    {"until:expr", "stop once this holds, judged before the first cycle and after each"},
    {"every:everycmd", "commands to run after every so many cycles, or every time"},
};

static const command_form forms[] = {
    {"run N:cycles[0,)", params, TABLE_COUNT(params), "Grows and relaxes in cycles, with the output that is due",
     "Without grow and relax, those of the run before. A cycle happens whole or not at all: after an error or an "
     "interruption the scene is that of the last whole cycle. Where a limit held motion back or refused a step (the "
     "value caps), the log says how often, and 'info scene' of all runs together.",
     "run 3 grow 4min relax 0.1s until thickness > 0.75um every 1 \"print '$(cells) cells'\"\nrun 20min upto relax to "
     "1e-15N within 1s",
     COMMAND_SHADOW, run_run, NULL, 0},
};

void command_run(command_table *t) {
    command_add(t, forms, TABLE_COUNT(forms));
}

/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The form of LAMMPS's log (29 Sep 2021), so that lammps_logfile, pymatgen, pizza.py and their like read it: they take
 * what stands between "Per MPI rank memory allocation" and "Loop time of" for a table. */
#include "command/run_report.h"

#include "analysis/view_cache.h"
#include "base/alloc.h"
#include "base/number.h"
#include "base/table.h"
#include "command/info_scene.h"
#include "mechanics/force_style.h"

#include <gsl/gsl_sort.h>
#include <gsl/gsl_statistics_double.h>
#include <inttypes.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>
#include <sys/resource.h>
#include <time.h>

static double processor_seconds(void) {
    struct timespec t;
    clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &t);
    return (double)t.tv_sec + 1e-9 * (double)t.tv_nsec;
}

static double megabytes_held(const scene *s) {
    return 1e-6 * (double)(colony_bytes(s->colony) + mechanics_statistics(s->mechanics).bytes);
}

/* ---- before the table -------------------------------------------------------------------------------------------- */

static void note_start(scene *s, run_report *r) {
    view v = scene_view(s);
    s->tally.least_step = INFINITY;
    s->tally.largest_step = 0;
    r->timing = s->timing;
    r->tally = s->tally;
    r->step = s->step;
    r->formed = v.links_formed;
    r->broken = v.links_broken;
    memcpy(r->caps, s->colony->caps, sizeof r->caps);
    r->wall = scene_clock();
    r->processor = processor_seconds();
}

void run_report_begin(interp *in, run_report *r) {
    scene *s = interp_scene(in);
    bool first = !r->open;
    r->logged = interp_start_log(in);
    r->depth++;
    if (first) {
        note_start(s, r);
        if (r->logged)
            info_scene_show(in, interp_log);
    }
    r->open = interp_in_loop(in);
    double memory = megabytes_held(s);
    if (r->logged)
        interp_log(in, "Per MPI rank memory allocation (min/avg/max) = %.4g | %.4g | %.4g Mbytes", memory, memory,
                   memory);
}

/* ---- behind it --------------------------------------------------------------------------------------------------- */

static void put_performance(interp *in, const run_report *r, double wall, uint64_t cycles) {
    const scene *s = interp_scene(in);
    double cells = (double)(s->tally.cell_evaluations - r->tally.cell_evaluations);
    double force = s->timing.force - r->timing.force;
    interp_log(in, "\nPerformance: %.3f steps/s, %.1f ns a cell and force evaluation",
               wall > 0 ? (double)cycles / wall : 0, cells > 0 ? 1e9 * force / cells : 0);
    interp_log(in, "%.1f%% CPU use with 1 MPI tasks x %d OpenMP threads",
               wall > 0 ? 100 * (processor_seconds() - r->processor) / wall : 0, s->threads);
}

/* One process: least, mean and largest time are the same. */
static void put_stage(interp *in, const char *name, double seconds, double wall) {
    interp_log(in, "%-7s | %-10.5g | %-10.5g | %-10.5g |   0.0 | %5.2f", name, seconds, seconds, seconds,
               wall > 0 ? 100 * seconds / wall : 0);
}

static void put_stages(interp *in, const run_report *r, double wall) {
    const scene_timing *now = &interp_scene(in)->timing, *from = &r->timing;
    double force = now->force - from->force, build = now->build - from->build;
    double remodel = now->remodel - from->remodel;
    const struct {
        const char *name;
        double seconds;
    } stages[] = {{"Grow", now->grow - from->grow},
                  {"Divide", now->divide - from->divide},
                  {"Force", force},
                  {"Neigh", build},
                  {"Remodel", remodel},
                  {"Relax", now->relax - from->relax - force - build - remodel},
                  {"Output", now->output - from->output}};
    double other = wall;
    interp_log(in, "\nMPI task timing breakdown:\nSection |  min time  |  avg time  |  max time  |%%varavg| %%total\n"
                   "---------------------------------------------------------------");
    for (size_t i = 0; i < TABLE_COUNT(stages); i++) {
        put_stage(in, stages[i].name, stages[i].seconds, wall);
        other -= stages[i].seconds;
    }
    interp_log(in, "Other   |            | %-10.4g |            |       | %5.2f", fmax(other, 0),
               wall > 0 ? 100 * fmax(other, 0) / wall : 0);
}

static void put_neighbors(interp *in, const run_report *r, size_t pairs) {
    const scene *s = interp_scene(in);
    size_t cells = s->colony->cell.count;
    interp_log(in,
               "\nNlocal:     %10zu ave %11zu max %11zu min\nHistogram: 1 0 0 0 0 0 0 0 0 0\n"
               "Neighs:     %10zu ave %11zu max %11zu min\nHistogram: 1 0 0 0 0 0 0 0 0 0",
               cells, cells, cells, pairs, pairs, pairs);
    interp_log(in,
               "\nTotal # of neighbors = %zu\nAve neighs/atom = %.8g\nNeighbor list builds = %" PRIu64
               "\nDangerous builds = 0", /* every evaluation looks whether the list still holds */
               pairs, cells ? (double)pairs / (double)cells : 0, s->tally.builds - r->tally.builds);
}

static void put_relaxations(interp *in, const run_report *r, double fmax) {
    const scene_tally *now = &interp_scene(in)->tally, *from = &r->tally;
    uint64_t by_time = now->by_time - from->by_time, by_force = now->by_force - from->by_force;
    uint64_t stalled = now->stalled - from->stalled;
    if (by_time + by_force + stalled == 0)
        return;
    interp_log(in, "\nRelaxation stats:\n  Stopping criterion = %s: time %" PRIu64 ", force %" PRIu64,
               by_force + stalled == 0 ? "time"
               : by_time == 0          ? "force"
                                       : "both",
               by_time, by_force);
    if (stalled)
        interp_log(in, "  No further descent = %" PRIu64, stalled);
    interp_log(in, "  Steps, rejected, force evaluations = %" PRIu64 " %" PRIu64 " %" PRIu64, now->steps - from->steps,
               now->rejected - from->rejected, now->evaluations - from->evaluations);
    if (now->largest_step > 0)
        interp_log(in, "  Least, largest step = %.6g %.6g s", now->least_step, now->largest_step);
    interp_log(in, "  Force max = %.6g N", dim_from_engine(fmax, DIM_FORCE));
}

/* Limits on motion that were met since `from` (CAP_COUNT; NULL: ever); nothing where there is none. */
static void put_caps(interp *in, const uint64_t *now, const uint64_t *from) {
    char text[200];
    cap_describe(now, from, sizeof text, text);
    if (strcmp(text, "none") != 0)
        interp_log(in, "  Limits on motion met = %s", text);
}

/* Median, 99 % and largest of the cells' deepest overlaps; contacts. */
static void put_contacts(interp *in, const view *v) {
    size_t n = v->colony->cell.count, touching = 0;
    if (n == 0 || !v->mechanics)
        return;
    view_contacts c = view_cache_contacts(v);
    double *overlap = alloc_zeroed(n, sizeof *overlap);
    for (size_t i = 0; i < n; i++) {
        overlap[i] = c.overlap[i];
        touching += c.contacts[i];
    }
    gsl_sort(overlap, 1, n);
    double at[3];
    for (int i = 0; i < 3; i++)
        at[i] = dim_from_engine(gsl_stats_quantile_from_sorted_data(overlap, 1, n, (const double[]){0.5, 0.99, 1}[i]),
                                DIM_LENGTH);
    interp_log(in, "\nContacts = %zu, %.4g a cell\nOverlap median, 99 %%, largest = %.6g %.6g %.6g m", touching / 2,
               (double)touching / (double)n, at[0], at[1], at[2]);
    free(overlap);
}

static void put_rest(interp *in, const run_report *r, const view *v) {
    struct rusage usage = {0};
    getrusage(RUSAGE_SELF, &usage);
    interp_log(in, "Links = %zu, formed %" PRIu64 ", broken %" PRIu64, v->colony->link.count,
               v->links_formed - r->formed, v->links_broken - r->broken);
    interp_log(in, "Peak memory = %.1f Mbytes\n", 1.024e-3 * (double)usage.ru_maxrss);
}

static void put_sections(interp *in, const run_report *r, double wall, uint64_t cycles) {
    scene *s = interp_scene(in);
    size_t pairs = mechanics_statistics(s->mechanics).pairs;
    put_performance(in, r, wall, cycles);
    put_stages(in, r, wall);
    put_neighbors(in, r, pairs);
    view v = scene_view(s); /* what follows is measured, which is no part of the run */
    put_relaxations(in, r, v.mechanics && v.colony->particle.count ? mechanics_fmax(v.mechanics) : 0);
    put_caps(in, s->colony->caps, r->caps);
    put_contacts(in, &v);
    put_rest(in, r, &v);
}

static void put_loop_time(interp *in, double seconds, uint64_t cycles) {
    const scene *s = interp_scene(in);
    interp_screen(in, "Loop time of %.6g s on %d %s for %" PRIu64 " %s with %zu %s", seconds, s->threads,
                  number_noun((uint64_t)s->threads, "thread", "threads"), cycles,
                  number_noun(cycles, "cycle", "cycles"), s->colony->cell.count,
                  number_noun(s->colony->cell.count, "cell", "cells"));
}

void run_report_end(interp *in, run_report *r, double seconds, uint64_t cycles) {
    const scene *s = interp_scene(in);
    r->depth--;
    if (r->logged)
        interp_log(in, "Loop time of %.6g on %d procs for %" PRIu64 " steps with %zu atoms", seconds, s->threads,
                   cycles, s->colony->cell.count);
    if (r->open)
        return;
    put_loop_time(in, seconds, cycles);
    if (r->logged)
        put_sections(in, r, scene_clock() - r->wall, cycles);
}

void run_report_end_loop(interp *in, run_report *r) {
    const scene *s = interp_scene(in);
    if (!r->open || r->depth > 0)
        return;
    r->open = false;
    put_loop_time(in, s->timing.total - r->timing.total, s->step - r->step);
    if (r->logged)
        put_sections(in, r, scene_clock() - r->wall, s->step - r->step);
}

void run_report_relaxation(interp *in, const relax_result *result) {
    static const char *const why[] = {[RELAX_TIME] = "time",
                                      [RELAX_FORCE] = "force",
                                      [RELAX_INTERRUPTED] = "interrupt",
                                      [RELAX_STALLED] = "no further descent"};
    if (!interp_start_log(in))
        return;
    interp_log(in, "Relaxation stats:\n  Stopping criterion = %s\n  Time = %.6g s", why[result->stop], result->time);
    interp_log(in, "  Steps, rejected, force evaluations = %" PRIu64 " %" PRIu64 " %" PRIu64, result->steps,
               result->rejected, result->evaluations);
    put_caps(in, result->caps, NULL);
}

/* Why a minimiser may come to no rest. */
static const char *why_stalled(const scene *s) {
    const force_settings *collision = &s->forces.term[FORCE_COLLISION];
    if (collision->on && (int)collision->p[COLLISION_CONTACT] == CONTACT_CLOSEST)
        return "contact closest, whose force jumps where rods lie parallel (contact regularised does not), a pull that "
               "nothing stops, or less than rounding leaves";
    return "a pull that nothing stops, or less than rounding leaves";
}

void run_report_stalled(interp *in, uint64_t n) {
    const scene *s = interp_scene(in);
    const scene_tally *t = &s->tally;
    if (n == 0)
        return;
    interp_warn(in,
                "%" PRIu64 " %s ended before all was at rest; the last with a net force of %.3g N on cell %" PRIu64
                ", most of it by %s: %s",
                n, number_noun(n, "relaxation", "relaxations"), dim_from_engine(t->stalled_force, DIM_FORCE),
                t->stalled_cell, t->stalled_term < FORCE_COUNT ? force_styles[t->stalled_term]->name : "no term",
                why_stalled(s));
}

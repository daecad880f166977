/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The estimate. A population that divides at mass M and grows exponentially has cells of M ln 2 on average, so that
 * N = max(N at first, m / (M ln 2)) for its mass m, which follows its growth law. A relaxation is measured: cells of
 * the script's species, 8 and then 64 of them, are put side by side, grow and relax as it says. */
#include "command/forecast.h"

#include "base/alloc.h"
#include "biology/division.h"
#include "biology/growth.h"
#include "command/session.h"
#include "relax/integrator.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>
#include <sys/resource.h>
#include <time.h>

static forecast *forecast_of(interp *in) {
    session *s = session_of(in);
    if (!s->forecast) {
        s->forecast = alloc_zeroed(1, sizeof *s->forecast);
        s->forecast->least_gap = INFINITY;
        s->forecast->scale = 1;
    }
    return s->forecast;
}

void forecast_create(interp *in, const placement *p, double n, double z) {
    const scene *s = interp_scene(in);
    forecast *f = forecast_of(in);
    if (p->species < 0 || p->species >= FORECAST_SPECIES) {
        f->unknown = true;
        return;
    }
    n *= interp_check_passes(in) / f->scale * (p->filament > 1 ? p->filament : 1);
    f->cells[p->species] += n;
    f->mass[p->species] += n * spread_mean(&p->mass);
    f->filament[p->species] |= p->filament > 1;
    double gap = !isnan(p->gap) ? p->gap : z - s->forces.term[FORCE_SUBSTRATUM].p[SUBSTRATUM_Z];
    if (n > 0)
        f->least_gap = fmin(f->least_gap, isnan(gap) ? 0 : gap);
}

void forecast_note_run(interp *in, const forecast_run *r) {
    forecast *f = forecast_of(in);
    double passes = interp_check_passes(in);
    if (passes == 0)
        return;
    if (f->nruns == FORECAST_RUNS) {
        f->unknown = true;
        return;
    }
    f->runs[f->nruns] = *r;
    if (!isfinite(r->relax)) /* to a force, however long it takes */
        f->runs[f->nruns].relax = 1;
    f->runs[f->nruns++].cycles *= passes / f->scale;
}

void forecast_unknown(interp *in) {
    if (interp_check_passes(in) > 0)
        forecast_of(in)->unknown = true;
}

/* ---- growth ------------------------------------------------------------------------------------------------------ */

static double sum(const double *values, size_t n) {
    double total = 0;
    for (size_t i = 0; i < n; i++)
        total += values[i];
    return total;
}

static size_t species_of(const scene *s) {
    return s->species.count < FORECAST_SPECIES ? s->species.count : FORECAST_SPECIES;
}

/* One growth step of all species: masses, then cells. */
static void grow(const scene *s, double dt, double *mass, double *cells) {
    for (size_t i = 0; i < species_of(s); i++) {
        const species *sp = &s->species.list[i];
        double rate = sp->growth.style < 0 ? 0 : spread_mean(&sp->growth.values[GROWTH_RATE]);
        double each = cells[i] > 0 ? mass[i] / cells[i] : 0, at = division_mean_mass(sp);
        if (rate != 0 && each > 0)
            mass[i] = cells[i] * growth_styles[sp->growth.style].mass_after(each, rate, dt);
        if (at > 0)
            cells[i] = fmax(cells[i], mass[i] / (M_LN2 * at));
    }
    for (size_t i = 0; i < s->attachments.count; i++) {
        const attachment *a = &s->attachments.list[i];
        if (a->placement.species < FORECAST_SPECIES)
            cells[a->placement.species] += a->rate * dt;
    }
}

forecast_end forecast_project(const forecast *f, const scene *s) {
    forecast_end end = {0};
    double mass[FORECAST_SPECIES];
    memcpy(end.of, f->cells, sizeof end.of);
    memcpy(mass, f->mass, sizeof mass);
    end.cells = sum(end.of, species_of(s));
    for (size_t r = 0; r < f->nruns; r++) {
        const forecast_run *run = &f->runs[r];
        double cycles = run->upto ? run->cycles - end.cycles : run->cycles;
        for (double i = 0; i < cycles && i < 1e6 && end.cells < 1e9 && end.cells < run->until; i++) {
            if (run->grow > 0)
                grow(s, run->grow, mass, end.of);
            end.cells = sum(end.of, species_of(s));
            end.cycles++;
            end.relaxations += run->relax > 0;
            end.relaxed += run->relax > 0 ? run->relax : 0;
            end.cell_relaxations += run->relax > 0 ? end.cells : 0;
        }
    }
    return end;
}

/* What a scene took that a clear ends; behind it all begins anew, as often as the loop around it says. */
void forecast_clear(interp *in) {
    forecast *f = forecast_of(in);
    const forecast_end end = forecast_project(f, interp_scene(in));
    forecast next = {.least_gap = INFINITY,
                     .unknown = f->unknown,
                     .scale = fmax(1, interp_check_passes(in)),
                     .cycles = f->cycles + f->scale * end.cycles,
                     .relaxations = f->relaxations + f->scale * end.relaxations,
                     .cell_relaxations = f->cell_relaxations + f->scale * end.cell_relaxations,
                     .relaxed = f->relaxed + f->scale * end.relaxed,
                     .most = fmax(f->most, end.cells)};
    if (interp_check_passes(in) > 0)
        *f = next;
}

/* ---- a sample ---------------------------------------------------------------------------------------------------- */

static double processor_seconds(void) {
    struct timespec t;
    clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &t);
    return (double)t.tv_sec + 1e-9 * (double)t.tv_nsec;
}

/* Side by side on a square, or in a cube, so wide that neighbours about touch. */
static void put_sample(scene *s, const forecast_end *end, double n) {
    double each = 0, total = sum(end->of, species_of(s));
    for (size_t i = 0; i < species_of(s); i++) {
        double mass = division_mean_mass(&s->species.list[i]);
        each += end->of[i] / total * (mass > 0 ? mass : 0.5);
    }
    bool layer = s->dimension == 2 || s->forces.term[FORCE_SUBSTRATUM].on;
    double side = layer ? sqrt(2.5 * n * each) : cbrt(3 * n * each), low = layer ? 0 : -0.5 * side;
    const region box = {.name = "sample",
                        .kind = REGION_BLOCK,
                        .p = {-0.5 * side, 0.5 * side, -0.5 * side, 0.5 * side, low, layer ? 0 : 0.5 * side}};
    for (size_t i = 0; i < species_of(s); i++) {
        double mass = division_mean_mass(&s->species.list[i]);
        const placement p = {.species = (int)i,
                             .orient = layer ? ORIENT_XY : ORIENT_RANDOM,
                             .mass = spread_fixed(mass > 0 ? 0.7 * mass : 0.5),
                             .gap = s->forces.term[FORCE_SUBSTRATUM].on ? 0 : (double)NAN,
                             .maxtry = 200,
                             .may_fail = true};
        size_t created, wanted = (size_t)ceil(n * end->of[i] / total);
        for (size_t k = 0; k < wanted && end->of[i] > 0; k++)
            scene_create_random(s, &p, 1, &box, 0, &created, NULL);
    }
}

/* CPU seconds of a relaxation of about n cells, behind a growth step; their number and memory. */
typedef struct sample {
    double cells, seconds, evaluations, bytes;
} sample;

/* relax: how long the sample does, s; the times of a whole relaxation follow in proportion. */
static bool take_sample(scene *s, const forecast_end *end, const forecast_run *run, double n, double relax, sample *out,
                        diag *d) {
    enum { CYCLES = 3 };
    uint64_t before = 0;
    put_sample(s, end, n);
    *out = (sample){0};
    relax_result unused;
    double begin = 0;
    bool done = true;
    for (int i = 0; i < CYCLES && done; i++) {
        /* the first lets go of how they were put */
        if (i == 1) {
            begin = processor_seconds();
            before = s->tally.evaluations;
        }
        done = (run->grow <= 0 || scene_grow(s, run->grow, d) == SARCINA_OK) &&
               scene_relax(s, relax, 0, &unused, d) == SARCINA_OK;
    }
    size_t integrator = (size_t)integrator_styles[s->relax.integrator]->vectors * 24 * s->colony->particle.count;
    out->cells = (double)s->colony->cell.count;
    out->seconds = (processor_seconds() - begin) / (CYCLES - 1) * run->relax / relax;
    out->evaluations = (double)(s->tally.evaluations - before) / (CYCLES - 1) * run->relax / relax;
    out->bytes = (double)(3 * colony_bytes(s->colony) + mechanics_statistics(s->mechanics).bytes + integrator);
    bool *all = alloc_zeroed(s->colony->cell.count, sizeof *all);
    memset(all, 1, s->colony->cell.count);
    scene_delete(s, all);
    free(all);
    return done && out->cells > 0;
}

/* What a relaxation costs: for each cell, and in any case. */
typedef struct price {
    double fixed, per_cell; /* CPU seconds */
    double evaluations, bytes_per_cell;
} price;

/* From samples of 8 cells and of 64, or of as many as there will be; none takes more than about half a second. */
static bool measure(scene *s, const forecast_end *end, const forecast_run *run, price *out, diag *d) {
    static const double budget = 0.5, probe = 0.02;
    double n = fmin(8, ceil(end->cells)), relax = fmin(run->relax, probe);
    sample few, many;
    if (!take_sample(s, end, run, n, relax, &few, d))
        return false;
    relax = fmin(run->relax, run->relax * budget / fmax(few.seconds, 1e-6));
    if (!take_sample(s, end, run, n, relax, &few, d))
        return false;
    *out = (price){0, few.seconds / few.cells, few.evaluations, few.bytes / few.cells};
    if (end->cells < 16 || few.seconds > budget / 8)
        return true;
    if (!take_sample(s, end, run, fmin(64, end->cells), run->relax, &many, d))
        return false;
    double more = fmax(1, many.cells - few.cells);
    out->per_cell = fmax(0.1 * few.seconds / few.cells, (many.seconds - few.seconds) / more);
    out->fixed = fmax(0, few.seconds - few.cells * out->per_cell);
    out->evaluations = many.evaluations;
    out->bytes_per_cell = many.bytes / many.cells;
    return true;
}

/* ------------------------------------------------------------------------------------------------------------------ */

/* The relaxation that most of the cycles have. */
static const forecast_run *typical_run(const forecast *f) {
    const forecast_run *best = NULL;
    for (size_t i = 0; i < f->nruns; i++)
        if (f->runs[i].relax > 0 && (!best || f->runs[i].cycles > best->cycles))
            best = &f->runs[i];
    return best;
}

/* "about 12 s", "about 3 min", "about 5 h". */
static void say_time(double seconds, char out[32]) {
    const char *in = seconds < 120 ? "s" : seconds < 7200 ? "min" : "h";
    double value = seconds < 120 ? seconds : seconds < 7200 ? seconds / 60 : seconds / 3600;
    snprintf(out, 32, "%.2g %s", value < 0.1 && seconds < 120 ? 0.1 : value, in);
}

/* In a grown colony cells have more neighbours, and take more steps, than in the sample; and there is output: measured
 * on the case studies of E. coli and flocs. */
static const double grown = 2;

static void put_estimate(interp *in, const forecast *f, const forecast_end *end) {
    const forecast_run *run = typical_run(f);
    price cost = {0};
    diag why = {0};
    struct rusage usage = {0};
    char time[32];
    if (run && !measure(interp_scene(in), end, run, &cost, &why)) {
        interp_screen(in, "estimate: %.0f cells after %.0f cycles; a sample of them could not be relaxed: %s",
                      ceil(end->cells), end->cycles, *why.message ? why.message : "no place for it");
        return;
    }
    double share = run && end->relaxations > 0 ? end->relaxed / (end->relaxations * run->relax) : 0;
    double seconds = grown * share * (cost.fixed * end->relaxations + cost.per_cell * end->cell_relaxations);
    getrusage(RUSAGE_SELF, &usage);
    double bytes = 1024 * (double)usage.ru_maxrss + 2 * cost.bytes_per_cell * end->cells;
    say_time(seconds, time);
    interp_screen(in,
                  "estimate, to a factor of 3: %.0f cells after %.0f cycles of %.3g force evaluations, %s of one "
                  "processor without output, %.0f MB%s",
                  ceil(end->cells), end->cycles, share * cost.evaluations, time, 1e-6 * bytes,
                  f->unknown ? "; cells from files are not counted" : "");
}

void forecast_report(interp *in) {
    forecast *f = forecast_of(in);
    forecast_end end = forecast_project(f, interp_scene(in));
    forecast_warn(in, f, &end);
    end.cycles = f->cycles + f->scale * end.cycles;
    end.relaxations = f->relaxations + f->scale * end.relaxations;
    end.cell_relaxations = f->cell_relaxations + f->scale * end.cell_relaxations;
    end.relaxed = f->relaxed + f->scale * end.relaxed;
    if (f->nruns == 0 || end.cycles == 0)
        interp_screen(in, "estimate: no cycles");
    else if (end.cells == 0)
        interp_screen(in, "estimate: %.0f cycles without a cell that the check knows of", end.cycles);
    else
        put_estimate(in, f, &end);
}

/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The estimate. A population that divides at mass M and grows exponentially has cells of M ln 2 on average, so that
 * N = max(N at first, m / (M ln 2)) for its mass m, which follows its growth law. What a relaxation of so many cells
 * takes is measured (forecast_rehearse.c). */
#include "command/forecast.h"

#include "base/alloc.h"
#include "base/number.h"
#include "biology/division.h"
#include "biology/growth.h"
#include "command/output_list.h"
#include "command/session.h"
#include "engine/snapshot.h"
#include "output/render.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>
#include <sys/resource.h>

static forecast *forecast_of(interp *in) {
    session *s = session_of(in);
    if (!s->forecast) {
        s->forecast = alloc_zeroed(1, sizeof *s->forecast);
        s->forecast->least_gap = s->forecast->least_across = INFINITY;
        s->forecast->scale = 1;
    }
    return s->forecast;
}

static double sum(const double *values, size_t n) {
    double total = 0;
    for (size_t i = 0; i < n; i++)
        total += values[i];
    return total;
}

static size_t species_of(const scene *s) {
    return s->species.count < FORECAST_SPECIES ? s->species.count : FORECAST_SPECIES;
}

static void drop_scene(forecast *f) {
    for (size_t i = 0; i < f->ntradeoffs; i++)
        free(f->tradeoffs[i].methods);
    free(f->tradeoffs);
    for (size_t i = 0; i < f->nruns; i++)
        expr_free(f->runs[i].until);
    free(f->runs);
    free(f->creations);
    free(f->restart);
}

void forecast_free(forecast *f) {
    if (f)
        drop_scene(f);
    free(f);
}

void forecast_create(interp *in, const creation *c) {
    const scene *s = interp_scene(in);
    const placement *p = &c->placement;
    forecast *f = forecast_of(in);
    double times = interp_check_passes(in) / f->scale, n = times * creation_count(c);
    if (p->species < 0 || p->species >= FORECAST_SPECIES || !(n >= 0)) {
        forecast_unknown(in, "cells that the check cannot count");
        return;
    }
    n *= p->filament > 1 ? p->filament : 1;
    f->cells[p->species] += n;
    f->mass[p->species] += n * spread_mean(&p->mass);
    f->filament[p->species] |= p->filament > 1;
    double height = c->kind == CREATION_SINGLE ? c->at[2] : (double)NAN;
    double gap = !isnan(p->gap) ? p->gap : height - s->forces.term[FORCE_SUBSTRATUM].p[SUBSTRATUM_Z];
    if (n > 0)
        f->least_gap = fmin(f->least_gap, isnan(gap) ? 0 : gap);
    if (times != 1)
        return; /* of a loop the places are not known */
    f->creations = alloc_grow(f->creations, &f->creation_capacity, f->ncreations + 1, sizeof *f->creations);
    f->creations[f->ncreations++] = *c;
}

/* A build without pictures leaves them out, and they cost nothing; that they are too coarse is said all the same. */
static bool draws(void) {
    return !dump_styles[dump_find("image")]->missing;
}

static void add_picture(forecast *f, forecast_run *r, const image_options *o, double times) {
    double pixels = (double)o->width * (double)o->height;
    f->least_across = fmin(f->least_across, o->zoom * fmin(o->width, o->height));
    if (!draws())
        return;
    r->frames += times;
    r->pixels += times * pixels;
    r->edges += times * sqrt(pixels);
    f->most_pixels = fmax(f->most_pixels, pixels);
}

/* Pictures that the dumps of now make in a cycle of a run. */
static void note_dumps(interp *in, forecast_run *r) {
    const outputs *o = session_of(in)->out;
    double cycle = r->grow > 0 ? r->grow : r->relax;
    for (size_t i = 0; i < o->ndumps; i++) {
        const output_dump *p = &o->dumps[i];
        double every = p->every.is_time ? p->every.time / cycle : (double)p->every.cycles;
        dump_takes takes = dump_styles[dump_style_of(p->file)]->takes;
        if (takes == DUMP_FILM)
            forecast_note_extra(in, FORECAST_ENCODING);
        if (takes != DUMP_COLOR && takes != DUMP_FILM)
            forecast_note_extra(in, FORECAST_TEXT);
        if ((takes != DUMP_COLOR && takes != DUMP_FILM) || !(every > 0))
            continue;
        add_picture(forecast_of(in), r, &p->image, 1 / fmax(1, every));
    }
}

static void note_laws(const scene *s, forecast_law law[FORECAST_SPECIES]) {
    for (size_t i = 0; i < FORECAST_SPECIES; i++)
        law[i].style = -1;
    for (size_t i = 0; i < species_of(s); i++) {
        const species *sp = &s->species.list[i];
        law[i].style = sp->growth.style;
        law[i].rate = sp->growth.style < 0 ? 0 : spread_mean(&sp->growth.values[GROWTH_RATE]);
        law[i].divide = division_mean_mass(sp);
    }
    for (size_t i = 0; i < s->attachments.count; i++) {
        const attachment *a = &s->attachments.list[i];
        if (a->placement.species >= FORECAST_SPECIES)
            continue;
        forecast_law *l = &law[a->placement.species];
        double mass = spread_mean(&a->placement.mass) * (a->mass_is_part ? l->divide : 1);
        l->mass = (l->mass * l->arrive + mass * a->rate) / (l->arrive + a->rate);
        l->arrive += a->rate;
    }
}

static forecast_run *add_run(interp *in, const forecast_run *r) {
    forecast *f = forecast_of(in);
    f->runs = alloc_grow(f->runs, &f->run_capacity, f->nruns + 1, sizeof *f->runs);
    forecast_run *mine = &f->runs[f->nruns++];
    *mine = *r;
    mine->times = interp_check_passes(in) / f->scale;
    mine->until = expr_keep(r->until);
    mine->ends = INFINITY;
    note_laws(interp_scene(in), mine->law);
    return mine;
}

void forecast_note_run(interp *in, const forecast_run *r) {
    if (interp_check_passes(in) > 0)
        note_dumps(in, add_run(in, r));
}

void forecast_note_picture(interp *in, const image_options *o) {
    if (interp_check_passes(in) > 0)
        add_picture(forecast_of(in), add_run(in, &(forecast_run){.cycles = 1, .still = true}), o, 1);
}

void forecast_note_tradeoff(interp *in, const forecast_tradeoff *t) {
    forecast *f = forecast_of(in);
    double passes = interp_check_passes(in);
    if (passes == 0)
        return;
    f->tradeoffs = alloc_grow(f->tradeoffs, &f->tradeoff_capacity, f->ntradeoffs + 1, sizeof *f->tradeoffs);
    forecast_tradeoff *mine = &f->tradeoffs[f->ntradeoffs++];
    *mine = *t;
    mine->times *= passes / f->scale;
    mine->methods = alloc_zeroed(t->n, sizeof *t->methods);
    memcpy(mine->methods, t->methods, t->n * sizeof *t->methods);
    mine->cells = forecast_project(in, f).cells;
}

void forecast_unknown(interp *in, const char *why) {
    if (interp_check_passes(in) > 0)
        forecast_of(in)->unknown = why;
}

void forecast_note_extra(interp *in, forecast_extra what) {
    if (interp_check_passes(in) > 0)
        forecast_of(in)->extra[what] = true;
}

/* The cells are looked at and go again: a check makes none. */
int forecast_note_restart(interp *in, const char *path, const archive *a, diag *d) {
    scene *s = interp_scene(in);
    forecast *f = forecast_of(in);
    snapshot *before = snapshot_take(s);
    int status = snapshot_load(s, a, d);
    if (!status && interp_check_passes(in) > 0) {
        const colony *c = s->colony;
        free(f->restart);
        f->restart = alloc_copy(path);
        f->step = (double)s->step;
        f->time = s->time;
        f->relaxed = s->relaxed;
        for (size_t row = 0; row < c->cell.count; row++)
            if (c->cell.species[row] < FORECAST_SPECIES) {
                f->held[c->cell.species[row]]++;
                f->cells[c->cell.species[row]]++;
                f->mass[c->cell.species[row]] += c->cell.mass[row];
                f->least_gap = 0; /* where it is is not looked at */
            }
    }
    snapshot_restore(s, before);
    snapshot_free(before);
    return status;
}

/* ---- growth ------------------------------------------------------------------------------------------------------ */

/* One growth step of all species: masses, then cells. */
static void grow(const forecast_law *law, double dt, double *mass, double *cells) {
    for (size_t i = 0; i < FORECAST_SPECIES; i++) {
        const forecast_law *l = &law[i];
        double each = cells[i] > 0 ? mass[i] / cells[i] : 0;
        if (l->style >= 0 && l->rate != 0 && each > 0)
            mass[i] = cells[i] * growth_styles[l->style].mass_after(each, l->rate, dt);
        cells[i] += l->arrive * dt;
        mass[i] += l->arrive * dt * l->mass;
        if (l->divide > 0)
            cells[i] = fmax(cells[i], mass[i] / (M_LN2 * l->divide));
    }
}

int forecast_bin(double cells) {
    int bin = cells > 1 ? (int)floor(2 * log2(cells)) : 0;
    return bin < FORECAST_BINS ? bin : FORECAST_BINS - 1;
}

static void add_cycle(forecast_end *end, const forecast_run *run) {
    forecast_load *l = &end->load;
    double relax = isfinite(run->relax) ? run->relax : 1; /* to a force, however long it takes */
    int bin = forecast_bin(end->cells);
    l->cycles += !run->still;
    l->frames += run->frames;
    l->pixels += run->pixels;
    l->edges += run->edges * sqrt(end->cells);
    l->relaxations += relax > 0;
    l->relaxed[bin] += relax;
    l->cells[bin] += relax * end->cells;
    end->time += run->grow;
    end->relaxed += relax;
}

static void add_load(forecast_load *to, double times, const forecast_load *l) {
    for (int i = 0; i < FORECAST_BINS; i++) {
        to->relaxed[i] += times * l->relaxed[i];
        to->cells[i] += times * l->cells[i];
    }
    to->relaxations += times * l->relaxations;
    to->cycles += times * l->cycles;
    to->frames += times * l->frames;
    to->pixels += times * l->pixels;
    to->edges += times * l->edges;
}

/* One run, or all of those of a loop: without a test they follow one another; with one, the loop takes back what made
 * it hold, and each is as the first. */
static void project_run(interp *in, const forecast_run *run, double mass[FORECAST_SPECIES], forecast_end *end) {
    static const double most_cycles = 1e6, most_cells = 1e9, tests = 1000;
    const scene *s = interp_scene(in);
    const forecast_load before = end->load;
    double cycles = run->upto    ? run->cycles - end->step - end->load.cycles
                    : run->until ? run->cycles
                                 : run->cycles * run->times;
    cycles = fmin(cycles, run->ends);
    double stride = fmax(1, ceil(cycles / tests));
    bool known = true;
    for (double i = 0; i < cycles && i < most_cycles && end->cells < most_cells; i++) {
        if (run->until && known && fmod(i, stride) == 0 &&
            forecast_until(in, run->until, end->cells, end->step + end->load.cycles, end->time, end->relaxed, &known))
            break;
        if (run->grow > 0)
            grow(run->law, run->grow, mass, end->of);
        end->cells = sum(end->of, species_of(s));
        add_cycle(end, run);
    }
    if (isfinite(run->ends)) { /* known to the cell */
        memcpy(end->of, run->ended, sizeof end->of);
        memcpy(mass, run->mass, sizeof run->mass);
        end->cells = sum(end->of, species_of(interp_scene(in)));
    }
    if (run->until && run->times > 1) {
        add_load(&end->load, run->times - 1, &end->load);
        add_load(&end->load, 1 - run->times, &before);
    }
    end->open = run->until && !known && !isfinite(run->ends) ? run->until : end->open;
}

forecast_end forecast_project(interp *in, const forecast *f) {
    forecast_end end = {.step = f->step, .time = f->time, .relaxed = f->relaxed};
    double mass[FORECAST_SPECIES];
    memcpy(end.of, f->cells, sizeof end.of);
    memcpy(mass, f->mass, sizeof mass);
    end.cells = sum(end.of, species_of(interp_scene(in)));
    for (size_t r = 0; r < f->nruns; r++)
        project_run(in, &f->runs[r], mass, &end);
    return end;
}

/* What a scene took that a clear ends; behind it all begins anew, as often as the loop around it says. */
void forecast_clear(interp *in) {
    forecast *f = forecast_of(in);
    if (interp_check_passes(in) == 0)
        return;
    const forecast_end end = forecast_project(in, f);
    forecast next = {.least_gap = INFINITY,
                     .unknown = f->unknown,
                     .scale = fmax(1, interp_check_passes(in)),
                     .past = f->past,
                     .most_pixels = f->most_pixels,
                     .least_across = f->least_across,
                     .most = fmax(f->most, end.cells),
                     .open = f->open || end.open};
    memcpy(next.extra, f->extra, sizeof next.extra);
    add_load(&next.past, f->scale, &end.load);
    drop_scene(f);
    *f = next;
}

/* ------------------------------------------------------------------------------------------------------------------ */

/* "12 s", "3 min", "5 h". */
static void say_time(double seconds, char out[32]) {
    const char *in = seconds < 120 ? "s" : seconds < 7200 ? "min" : "h";
    double value = seconds < 120 ? seconds : seconds < 7200 ? seconds / 60 : seconds / 3600;
    snprintf(out, 32, "%.2g %s", value < 0.1 && seconds < 120 ? 0.1 : value, in);
}

/* CPU seconds, and force evaluations, of relaxations. */
static double price_of(const forecast_price *price, const forecast_load *load, double *evaluations) {
    double seconds = 0;
    *evaluations = 0;
    for (int i = 0; i < FORECAST_BINS; i++) {
        double each, took;
        if (load->relaxed[i] == 0)
            continue;
        forecast_cost(price, load->cells[i] / load->relaxed[i], &each, &took);
        *evaluations += load->relaxed[i] * each;
        seconds += load->relaxed[i] * took;
    }
    return seconds;
}

static double bytes_of(const forecast *f, const forecast_price *price, double cells) {
    struct rusage usage = {0};
    getrusage(RUSAGE_SELF, &usage);
    return 1024 * (double)usage.ru_maxrss + 2 * price->bytes_per_cell * fmax(f->most, cells) +
           f->most_pixels * (double)render_pixel_bytes();
}

static const char *cells_noun(double n) {
    return number_noun((uint64_t)ceil(n), "cell", "cells");
}

static const char *cycles_noun(double n) {
    return number_noun((uint64_t)ceil(n), "cycle", "cycles");
}

static void put_unknown(interp *in, const forecast *f, const forecast_end *end, const forecast_price *price) {
    double evaluations, seconds;
    char time[32];
    static const char *const extras[FORECAST_EXTRAS] = {
        [FORECAST_ENCODING] = "encoding of films, by ffmpeg",
        [FORECAST_DIAGRAMS] = "diagrams, by gnuplot",
        [FORECAST_TEXT] = "what dumps write as text, in time and in bytes",
    };
    if (f->unknown)
        interp_screen(in, "not counted: %s", f->unknown);
    for (int i = 0; i < FORECAST_EXTRAS; i++)
        if (f->extra[i])
            interp_screen(in, "not counted: %s", extras[i]);
    if (!end->open)
        return;
    forecast_cost(price, end->cells, &evaluations, &seconds);
    say_time(seconds, time);
    interp_screen(in, "not known before the run: when '%s' holds; a relaxation of 1 s of %.0f %s takes %s",
                  expr_text(end->open), ceil(end->cells), cells_noun(end->cells), time);
}

static void put_estimate(interp *in, const forecast *f, const forecast_end *end, const forecast_price *price) {
    double evaluations;
    char time[32], drawing[32];
    forecast_load load = f->past;
    add_load(&load, f->scale, &end->load);
    double seconds = price_of(price, &load, &evaluations);
    double tradeoffs = f->scale * forecast_tradeoffs(interp_scene(in), f, price);
    double pictures = load.pixels * price->pixel + load.edges * price->edge;
    const char *most = end->open || f->open ? "at most " : "";
    say_time(seconds + pictures + tradeoffs, time);
    say_time(pictures, drawing);
    interp_screen(in,
                  "estimate, to a factor of 3: %s%.0f %s after %s%.0f %s of %.3g force evaluations, %s of one "
                  "processor, %.0f MB",
                  most, ceil(end->cells), cells_noun(end->cells), most, load.cycles, cycles_noun(load.cycles),
                  load.relaxations > 0 ? evaluations / load.relaxations : 0, time,
                  1e-6 * bytes_of(f, price, end->cells));
    if (load.frames > 0)
        interp_screen(in, "of it %.0f %s: %s", ceil(load.frames),
                      number_noun((uint64_t)ceil(load.frames), "picture", "pictures"), drawing);
    if (tradeoffs > 0) {
        say_time(tradeoffs, time);
        interp_screen(in, "of it tradeoff: %s", time);
    }
    if (interp_forecast_runs(in) > 1) {
        say_time((double)interp_forecast_runs(in) * (seconds + pictures + tradeoffs), time);
        interp_screen(in, "that is one run; %zu of them take %s", interp_forecast_runs(in), time);
    }
    put_unknown(in, f, end, price);
}

void forecast_report(interp *in) {
    forecast *f = forecast_of(in);
    forecast_end end = forecast_project(in, f);
    forecast_price price;
    diag why = {0};
    double cycles = f->past.cycles + f->scale * end.load.cycles;
    forecast_warn(in, f, &end);
    if (cycles == 0) {
        interp_screen(in, "estimate: no cycles");
    } else if (end.cells == 0) {
        interp_screen(in, "estimate: %.0f %s without a cell that the check knows of", cycles, cycles_noun(cycles));
    } else if (forecast_rehearse(in, f, &end, &price, &why) != SARCINA_OK) {
        interp_screen(in, "estimate: %.0f %s after %.0f %s; the beginning could not be relaxed: %s", ceil(end.cells),
                      cells_noun(end.cells), cycles, cycles_noun(cycles),
                      *why.message ? why.message : "no place for the cells");
    } else {
        end = forecast_project(in, f);
        put_estimate(in, f, &end, &price);
    }
}

/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The beginning of a script, rehearsed: the cells that it creates are created, and grow and relax as it says, until all
 * is done or the time for it is up. Beyond the cells seen so far, an evaluation of the forces takes time in proportion
 * to them, and a relaxation as many evaluations as the last ones did. */
#include "command/forecast.h"

#include "base/alloc.h"
#include "biology/division.h"
#include "engine/archive.h"
#include "engine/snapshot.h"
#include "output/image.h"
#include "relax/integrator.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>
#include <time.h>

static const double budget = 0.4; /* CPU seconds */

double forecast_clock(void) {
    struct timespec t;
    clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &t);
    return (double)t.tv_sec + 1e-9 * (double)t.tv_nsec;
}

/* ---- the cells --------------------------------------------------------------------------------------------------- */

static size_t species_count(const scene *s) {
    return s->species.count < FORECAST_SPECIES ? s->species.count : FORECAST_SPECIES;
}

/* So many more of each species side by side on a square, or in a cube, so wide that neighbours about touch. */
static void put_aside(scene *s, const double more[FORECAST_SPECIES]) {
    double volume = 0, masses[FORECAST_SPECIES] = {0};
    for (size_t i = 0; i < species_count(s); i++) {
        double mass = division_mean_mass(&s->species.list[i]);
        masses[i] = mass > 0 ? 0.7 * mass : 0.5;
        volume += more[i] * masses[i] / 0.7;
    }
    bool on = s->forces.term[FORCE_SUBSTRATUM].on, layer = s->dimension == 2 || on;
    double side = layer ? sqrt(2.5 * volume) : cbrt(3 * volume), low = layer ? 0 : -0.5 * side;
    const region box = {.name = "sample",
                        .kind = REGION_BLOCK,
                        .p = {-0.5 * side, 0.5 * side, -0.5 * side, 0.5 * side, low, layer ? 0 : 0.5 * side}};
    for (size_t i = 0; i < species_count(s); i++) {
        const placement p = {.species = (int)i,
                             .orient = layer ? ORIENT_XY : ORIENT_RANDOM,
                             .mass = spread_fixed(masses[i]),
                             .gap = on ? 0 : (double)NAN,
                             .maxtry = 200,
                             .may_fail = true};
        size_t created;
        for (long k = 0, n = lround(ceil(more[i])); k < n; k++)
            scene_create_random(s, &p, 1, &box, 0, &created, NULL);
    }
}

/* Those of a restart file, as they are in it, unless they are too many to relax here. */
static bool load_cells(scene *s, const forecast *f) {
    static const double most = 20000;
    double held = 0;
    archive *a;
    for (size_t i = 0; i < FORECAST_SPECIES; i++)
        held += f->held[i];
    if (!f->restart || held > most || archive_read(f->restart, &a, NULL))
        return false;
    int status = snapshot_load(s, a, NULL);
    archive_free(a);
    return status == SARCINA_OK;
}

/* Those whose places are known, there; of the others, and of too many, a sample. */
static void put_cells(scene *s, const forecast *f, const forecast_end *end) {
    const bool loaded = load_cells(s, f);
    static const double most = 5000, sample = 200;
    double more[FORECAST_SPECIES], wanted = 0, all = 0;
    for (size_t i = 0; i < FORECAST_SPECIES; i++)
        more[i] = f->cells[i] - (loaded ? f->held[i] : 0);
    for (size_t i = 0; i < f->ncreations; i++) {
        const creation *c = &f->creations[i];
        double n = creation_count(c);
        size_t created = 0;
        if (isfinite(c->at[0] + c->at[1] + c->at[2]) && wanted + n <= most)
            creation_make(s, c, &created, NULL);
        wanted += n;
        more[c->placement.species] -= (double)created;
    }
    for (size_t i = 0; i < species_count(s); i++)
        all += more[i] = fmax(0, more[i]);
    for (size_t i = 0; all > sample && i < species_count(s); i++)
        more[i] *= sample / all;
    put_aside(s, more);
    if (s->colony->cell.count == 0) /* they arrive later */
        for (size_t i = 0; i < species_count(s); i++)
            more[i] = ceil(8 * end->of[i] / end->cells);
    if (s->colony->cell.count == 0)
        put_aside(s, more);
}

/* ---- relaxations ------------------------------------------------------------------------------------------------- */

typedef struct rehearsal {
    scene *s;
    interp *in;
    forecast_price *price;
    double spent; /* CPU seconds */
    double mass;  /* of all cells when they were relaxed last, pg */
} rehearsal;

static double mass_of(const scene *s) {
    double mass = 0;
    for (size_t i = 0; i < s->colony->cell.count; i++)
        mass += s->colony->cell.mass[i];
    return mass;
}

static void count_cells(const scene *s, double cells[FORECAST_SPECIES], double mass[FORECAST_SPECIES]) {
    for (size_t i = 0; i < s->colony->cell.count; i++)
        if (s->colony->cell.species[i] < FORECAST_SPECIES) {
            cells[s->colony->cell.species[i]]++;
            mass[s->colony->cell.species[i]] += s->colony->cell.mass[i];
        }
}

/* Once an eighth of the time has gone, not every growth step is relaxed: so more cells are seen. */
static bool is_due(const rehearsal *r) {
    static const double faithful = 0.125, growth = 1.12;
    return r->s->colony->cell.count && (r->spent < faithful * budget || mass_of(r->s) > growth * r->mass);
}

/* So long by the run's integrator, whatever the script has chosen since; a minimiser goes all the way to rest. */
static int relax_piece(scene *s, const forecast_run *run, double time, relax_result *result, diag *d) {
    const relax_settings now = s->relax;
    bool minimises = integrator_styles[run->how.integrator]->caps & INTEGRATOR_MINIMISES;
    s->relax = run->how;
    int status = scene_relax(s, minimises ? (double)INFINITY : time, run->force, result, d);
    s->relax = now;
    if (minimises && !status)
        result->stop = RELAX_FORCE;
    return status;
}

/* A relaxation, or as much of it as there is time for. *whole: all of it. */
static int relax(rehearsal *r, const forecast_run *run, bool *whole, diag *d) {
    enum { PIECES = 20, LARGE = 300 };
    scene *s = r->s;
    size_t n = s->colony->cell.count;
    double time = isfinite(run->relax) ? run->relax : 1, done = 0, begin = forecast_clock(), took = 0;
    double piece = n > LARGE ? time / PIECES : time;
    uint64_t before = s->tally.evaluations;
    relax_result result = {0};
    int status = SARCINA_OK;
    while (done < time * (1 - 1e-9) && took + r->spent < budget && !status && result.stop != RELAX_FORCE) {
        status = relax_piece(s, run, fmin(piece, time - done), &result, d);
        done += piece;
        took = forecast_clock() - begin;
    }
    *whole = done >= time * (1 - 1e-9) || result.stop == RELAX_FORCE;
    int bin = forecast_bin((double)n);
    double part = result.stop == RELAX_FORCE ? time : done; /* it takes no more for the rest */
    r->spent += took;
    r->price->relaxed[bin] += part;
    r->price->cells[bin] += part * (double)n;
    r->price->evaluations[bin] += (double)(s->tally.evaluations - before);
    r->price->seconds[bin] += took;
    return status;
}

/* The cycles of a run, as far as there is time; *on: there is more. */
static int rehearse_run(rehearsal *r, forecast_run *run, bool *on, diag *d) {
    scene *s = r->s;
    double cycles = run->upto ? run->cycles - (double)s->step : run->cycles * (run->until ? 1 : run->times);
    int status = SARCINA_OK;
    for (double i = 0; i < cycles && *on && !status; i++) {
        bool done = false;
        if (run->until && interp_truth(r->in, run->until, &done, NULL) == SARCINA_OK && done) {
            run->ends = i;
            count_cells(s, run->ended, run->mass);
            break;
        }
        double begin = forecast_clock();
        if (run->grow > 0)
            status = scene_grow(s, run->grow, d);
        r->spent += forecast_clock() - begin;
        if (!status && run->relax > 0 && (run->grow <= 0 || is_due(r))) {
            r->mass = mass_of(s);
            status = relax(r, run, on, d);
        }
        s->step++;
        *on = *on && r->spent < budget;
    }
    return status;
}

static void measure_memory(const scene *s, forecast_price *out) {
    double integrator =
        (double)integrator_styles[s->relax.integrator]->vectors * 8 * s->dimension * (double)s->colony->particle.count;
    double bytes = 3 * (double)colony_bytes(s->colony) + (double)mechanics_statistics(s->mechanics).bytes + integrator;
    out->bytes_per_cell = bytes / fmax(1, (double)s->colony->cell.count);
}

static double draw(scene *s, int width, int height) {
    view v = scene_view(s);
    image_options how = image_defaults();
    const dump_frame f = {.view = &v, .options = &how, .threads = 1};
    canvas *c = NULL;
    how.has_color = true;
    how.width = width;
    how.height = height;
    double begin = forecast_clock();
    image_draw(&f, &how, &c, NULL);
    canvas_free(c);
    return forecast_clock() - begin;
}

/* A picture costs by the pixel, and more where surfaces end, whose length grows as the root of the cells: from two
 * small ones, behind one that starts the library. */
static void measure_picture(scene *s, forecast_price *out) {
    enum { WIDTH = 200, HEIGHT = 150 };
    static const double pixels = WIDTH * HEIGHT;
    draw(s, WIDTH / 10, HEIGHT / 10);
    double few = draw(s, WIDTH, HEIGHT), many = draw(s, 2 * WIDTH, 2 * HEIGHT);
    out->pixel = fmin(fmax(0, many - 2 * few) / (2 * pixels), many / (4 * pixels));
    out->edge = fmax(0, few - out->pixel * pixels) / sqrt(pixels * (double)s->colony->cell.count);
}

int forecast_rehearse(interp *in, forecast *f, const forecast_end *end, forecast_price *out, diag *d) {
    scene *s = interp_scene(in);
    rehearsal r = {s, in, out, 0, 0};
    bool on = true;
    int status = SARCINA_OK;
    *out = (forecast_price){0};
    put_cells(s, f, end);
    if (s->colony->cell.count == 0)
        return SARCINA_ERROR;
    for (size_t i = 0; i < f->nruns && on && !status; i++)
        status = rehearse_run(&r, &f->runs[i], &on, d);
    measure_memory(s, out);
    if (!status && (f->past.pixels > 0 || end->load.pixels > 0))
        measure_picture(s, out);
    return status;
}

/* ---- the price --------------------------------------------------------------------------------------------------- */

/* Bin that has been measured nearest to this; -1: none. */
static int nearest_bin(const forecast_price *p, int bin) {
    int best = -1;
    for (int i = 0; i < FORECAST_BINS; i++)
        if (p->relaxed[i] > 0 && (best < 0 || abs(i - bin) <= abs(best - bin)))
            best = i;
    return best;
}

/* v = a - b n^(-1/3), fitted to the bins with at least a sixteenth of the cells of the last; returns b, which is not
 * negative: cells at the surface of a colony have fewer neighbours than those within, and their share falls so. */
static double surface_slope(const forecast_price *p, int last, double value(const forecast_price *p, int bin)) {
    double w = 0, x = 0, y = 0, xx = 0, xy = 0;
    for (int i = last > 8 ? last - 8 : 0; i <= last; i++)
        if (p->relaxed[i] > 0) {
            double each = p->relaxed[i], at = cbrt(p->relaxed[i] / p->cells[i]), v = value(p, i);
            w += each, x += each * at, y += each * v, xx += each * at * at, xy += each * at * v;
        }
    double apart = w * xx - x * x;
    return apart > 0 ? fmax(0, -(w * xy - x * y) / apart) : 0;
}

static double evaluations_of(const forecast_price *p, int bin) {
    return p->evaluations[bin] / p->relaxed[bin];
}

/* Of a cell in an evaluation, less what an evaluation costs in any case: about what it does with the fewest cells. */
static double seconds_of(const forecast_price *p, int bin) {
    int first = nearest_bin(p, 0);
    double n = p->cells[bin] / p->relaxed[bin], least = p->cells[first] / p->relaxed[first];
    double last = p->seconds[bin] / fmax(1, p->evaluations[bin]);
    double fixed = fmax(0, p->seconds[first] / fmax(1, p->evaluations[first]) - last * least / n);
    return (last - fmin(fixed, last)) / n;
}

void forecast_cost(const forecast_price *p, double cells, double *evaluations, double *seconds) {
    int bin = forecast_bin(cells), best = nearest_bin(p, bin);
    *evaluations = *seconds = 0;
    if (best < 0)
        return;
    double n = p->cells[best] / p->relaxed[best], fewer = fmax(0, cbrt(1 / n) - cbrt(1 / cells));
    double more = fewer * surface_slope(p, best, evaluations_of), dearer = fewer * surface_slope(p, best, seconds_of);
    double known = evaluations_of(p, best);
    *evaluations = known + more;
    *seconds = (p->seconds[best] / p->relaxed[best] / n * cells + known * dearer * cells) * (1 + more / fmax(1, known));
}

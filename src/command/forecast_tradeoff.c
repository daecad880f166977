/* SPDX-License-Identifier: GPL-3.0-or-later */
/* What a tradeoff will take: the beginning of a relaxation by each of its methods, measured beside the same by the
 * method of the script, whose price by the number of cells is known. */
#include "command/forecast.h"

#include "engine/snapshot.h"
#include "relax/integrator.h"

#include <math.h>
#include <string.h>

/* CPU seconds of `part` of the relaxation by these settings, from the scene as it stands, which is left untouched. */
static double try_method(scene *s, const relax_settings *how, const forecast_tradeoff *t, double part) {
    snapshot *before = snapshot_take(s);
    const relax_settings usual = s->relax;
    relax_result result;
    s->relax = *how;
    double begin = forecast_clock();
    if (t->grow > 0)
        scene_grow(s, t->grow, NULL);
    scene_relax(s, t->relax * part, 0, &result, NULL);
    double took = forecast_clock() - begin;
    s->relax = usual;
    snapshot_restore(s, before);
    snapshot_free(before);
    return took;
}

/* The reference is solved again at ever tighter tolerances: some so many times the work of the tightest preset. */
static double reference_work(scene *s, const forecast_tradeoff *t, double part) {
    static const double times = 6;
    for (size_t i = 0; i < accuracy_preset_count; i++)
        if (strcmp(accuracy_presets[i].name, "reference") == 0)
            return times * try_method(s, &accuracy_presets[i].settings, t, part);
    return 0;
}

static double take(scene *s, const forecast_tradeoff *t, const forecast_price *p) {
    static const double budget = 0.02; /* CPU seconds a method */
    double evaluations, here, then;
    forecast_cost(p, (double)s->colony->cell.count, &evaluations, &here);
    forecast_cost(p, t->cells, &evaluations, &then);
    if (!(here > 0))
        return 0;
    double part = fmin(1, budget / (here * t->relax)), sum = 0;
    double usual = fmax(1e-9, try_method(s, &s->relax, t, part));
    for (size_t i = 0; i < t->n; i++)
        sum += (1 + t->times) * try_method(s, &t->methods[i].how, t, part);
    sum += reference_work(s, t, part);
    return then * t->relax * sum / usual;
}

double forecast_tradeoffs(scene *s, const forecast *f, const forecast_price *p) {
    double seconds = 0;
    for (size_t i = 0; i < f->ntradeoffs; i++)
        seconds += take(s, &f->tradeoffs[i], p);
    return seconds;
}

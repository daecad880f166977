/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Warnings of -check: what is finer than what it is to show, and steps that are longer than what they are to follow. */
#include "command/forecast.h"

#include "base/table.h"
#include "biology/growth.h"
#include "command/analyze_bins.h"

#include <math.h>
#include <string.h>

/* Of the cells that there are in the end the thinnest, um; infinite: none is known. */
static double least_diameter(const forecast_subject *u) {
    double least = INFINITY;
    for (size_t i = 0; i < u->s->species.count && i < FORECAST_SPECIES; i++)
        if (u->end->of[i] > 0)
            least = fmin(least, forecast_diameter(&u->s->species.list[i]));
    return least;
}

/* Its extent is that of a ball where nothing makes it flat: so large it is at least. */
static void warn_picture(const forecast_subject *u) {
    double across = 2 * forecast_radius(u->s, u->end, false), pixel = across / u->f->least_across;
    if (pixel > least_diameter(u))
        interp_warn(u->in,
                    "a picture's pixel is %.2g um, a cell %.2g um thick: give the colony of some %.2g um more pixels "
                    "(size), or zoom",
                    pixel, least_diameter(u), across);
}

/* Of places: a profile's, and a histogram's of a coordinate. At most so far they reach: a heap is a ball in height. */
static double extent_of(const forecast_subject *u, const output_analysis *p) {
    const char *along = analyze_bins_along(p);
    bool layer = u->s->dimension == 2 || u->s->forces.term[FORCE_SUBSTRATUM].on;
    double low, high;
    if (strlen(along) != 1 || !strchr("xyzr", *along))
        return INFINITY;
    analyze_bins_ends(p, &low, &high);
    if (isfinite(high - low))
        return dim_to_engine(high - low, DIM_LENGTH);
    double radius = forecast_radius(u->s, u->end, layer && *along != 'z');
    return *along == 'r' || (layer && *along == 'z') ? radius : 2 * radius;
}

static void warn_bins(const forecast_subject *u) {
    const outputs *o = output_list_of(u->in);
    for (size_t i = 0; i < o->nanalyses && !u->f->unknown; i++) {
        const output_analysis *p = &o->analyses[i];
        double width = p->bins ? extent_of(u, p) / (double)analyze_bins_count(p) : (double)INFINITY;
        if (width < 0.5 * least_diameter(u))
            interp_warn(u->in, "analyze %s: its bins are some %.2g um wide, a cell is %.2g um thick: at most %.0f bins",
                        p->id, width, least_diameter(u), fmax(1, floor(extent_of(u, p) / least_diameter(u))));
    }
}

/* A cell divides once in a growth step: its daughters come too late to. */
static void warn_growth(const forecast_subject *u) {
    for (size_t i = 0; i < u->f->nruns; i++)
        for (size_t k = 0; k < u->s->species.count && k < FORECAST_SPECIES; k++) {
            const forecast_run *run = &u->f->runs[i];
            const forecast_law *law = &run->law[k];
            double from = M_LN2 * law->divide;
            if (run->grow <= 0 || law->style < 0 || !(from > 0) || !(u->end->of[k] > 0))
                continue;
            double to = growth_styles[law->style].mass_after(from, law->rate, run->grow);
            if (to <= 2 * from)
                continue;
            interp_warn(u->in, "grow %g min makes a cell of %s %.3g times as heavy: it can divide once a growth step",
                        run->grow / 60, u->s->species.list[k].name, to / from);
            return;
        }
}

static bool has_rules(const scene *s) {
    for (int kind = 0; kind < LINK_STYLES; kind++)
        for (size_t a = 0; a < s->species.count; a++)
            for (size_t b = 0; b <= a; b++)
                if (kind != LINK_FILIAL && link_rules_find(&s->links, (link_kind)kind, (int)a, (int)b))
                    return true;
    return false;
}

static void warn_remodelling(const forecast_subject *u) {
    double every = u->s->links.every;
    for (size_t i = 0; i < u->f->nruns && every > 0 && has_rules(u->s); i++) {
        double time = u->f->runs[i].relax;
        if (!(time > 0 && time < every))
            continue;
        interp_warn(u->in,
                    "relax %g s is shorter than the %g s between looks at links: they form and break at its end alone",
                    time, every);
        return;
    }
    if (every > 0 && u->s->relax.step > every && has_rules(u->s))
        interp_warn(u->in, "integrator step %g s is cut to the %g s between looks at links: link remodel every ...",
                    u->s->relax.step, every);
}

void forecast_warn_sizes(interp *in, const forecast *f, const forecast_end *end) {
    static void (*const all[])(const forecast_subject *u) = {warn_picture, warn_bins, warn_growth, warn_remodelling};
    const forecast_subject u = {in, interp_scene(in), f, end};
    for (size_t i = 0; i < TABLE_COUNT(all); i++)
        all[i](&u);
}

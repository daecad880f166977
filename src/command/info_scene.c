/* SPDX-License-Identifier: GPL-3.0-or-later */
/* What acts is taken from the mechanics as bound to the scene; time is what the relaxations so far have measured. */
#include "command/info_scene.h"

#include "command/style_values.h"

#include "base/number.h"
#include "base/table.h"
#include "biology/division.h"
#include "biology/growth.h"
#include "mechanics/force_style.h"
#include "mechanics/remodel.h"
#include "relax/integrator.h"

#include <inttypes.h>
#include <math.h>
#include <stdarg.h>
#include <stdio.h>
#include <string.h>

/* A line that grows. */
typedef struct line {
    char text[400];
    size_t used;
} line;

static void add(line *l, const char *format, ...) __attribute__((format(printf, 2, 3)));
static void add(line *l, const char *format, ...) {
    va_list values;
    va_start(values, format);
    int n = vsnprintf(l->text + l->used, sizeof l->text - l->used, format, values);
    va_end(values);
    l->used += n > 0 ? (size_t)n : 0;
    l->used = l->used < sizeof l->text ? l->used : sizeof l->text - 1;
}

/* ---- what is there ----------------------------------------------------------------------------------------------- */

static size_t cells_of(const scene *s, size_t row) {
    size_t n = 0;
    for (size_t i = 0; i < s->colony->cell.count; i++)
        n += (size_t)s->colony->cell.species[i] == row;
    return n;
}

static const char *const shape_names[] = {
    [SHAPE_COCCUS] = "coccus", [SHAPE_ROD] = "rod", [SHAPE_FLEXIBLE] = "flexible"};

static void show_species(interp *in, const scene *s, info_put put) {
    for (size_t i = 0; i < s->species.count; i++) {
        const species *sp = &s->species.list[i];
        put(in, "species     %s: %s, %zu %s, growth %s, division %s", sp->name, shape_names[sp->shape], cells_of(s, i),
            number_noun(cells_of(s, i), "cell", "cells"),
            sp->growth.style < 0 ? "off" : growth_styles[sp->growth.style].name,
            sp->division.style < 0 ? "off" : division_styles[sp->division.style]->name);
    }
}

/* ---- what acts --------------------------------------------------------------------------------------------------- */

/* " k 1e-10 reach 1.01": parameters in SI, choices by name. */
static void add_parameters(line *l, const param *params, size_t n, const double *p) {
    for (size_t i = 0; i < n; i++) {
        char name[64], kind[64];
        style_values_name(&params[i], name);
        const char *colon = strchr(params[i].spec, ':') + 1;
        snprintf(kind, sizeof kind, "%.*s", (int)strcspn(colon, "[(~%!{"), colon);
        dim d = DIM_NONE;
        if (kind[0] == '\0') { /* a choice: its row counts */
            const char *word = colon + 1;
            for (int k = 0; k < (int)p[i]; k++)
                word = strchr(word, '|') + 1;
            add(l, " %s %.*s", name, (int)strcspn(word, "|}"), word);
        } else if (strcmp(kind, "flag") == 0) {
            add(l, " %s %s", name, p[i] > 0 ? "yes" : "no");
        } else {
            char suffix[48];
            dim_by_name(kind, &d);
            add(l, " %s %g%s", name, dim_from_engine(p[i], d), dim_suffix(d, suffix));
        }
    }
}

/* As the mechanics have it where the scene can be bound; else as the script named it. */
static bool is_active(const scene *s, bool bound, int term) {
    return bound ? mechanics_is_active(s->mechanics, (force_kind)term) : s->forces.term[term].on;
}

/* What a species says of a term that it has by `link`: " ecoli k 5e-11N/m". */
static void add_species(line *l, const scene *s, int term) {
    for (size_t i = 0; i < s->species.count; i++) {
        const species *sp = &s->species.list[i];
        double k = term == FORCE_INTERNAL ? sp->internal_k
                   : term == FORCE_BEND   ? sp->bend_k
                   : term == FORCE_TWIST  ? sp->twist_k
                                          : 0;
        dim d = term == FORCE_INTERNAL ? DIM_STIFFNESS : DIM_ENERGY;
        char suffix[48];
        if (k > 0 && cells_of(s, i) > 0)
            add(l, " %s k %g%s", sp->name, dim_from_engine(k, d), dim_suffix(d, suffix));
    }
}

static void show_forces(interp *in, const scene *s, bool bound, info_put put) {
    line idle = {0};
    for (int i = 0; i < FORCE_COUNT; i++) {
        const force_style *style = force_styles[i];
        if (!is_active(s, bound, i)) {
            add(&idle, " %s", style->name);
            continue;
        }
        line l = {0};
        add_species(&l, s, i);
        add_parameters(&l, style->params, style->nparams, s->forces.term[i].p);
        put(in, "force       %s%s", style->name, l.text);
    }
    put(in, "not active %s", idle.used ? idle.text : " none");
}

static size_t links_between(const scene *s, int kind, size_t a, size_t b) {
    size_t n = 0;
    for (size_t i = 0; i < s->colony->link.count; i++) {
        if ((int)s->colony->link.kind[i] != kind)
            continue;
        size_t of_a = (size_t)s->colony->cell.species[colony_row(s->colony, s->colony->link.cell_a[i])], of_b = of_a;
        if (s->colony->link.cell_b[i])
            of_b = (size_t)s->colony->cell.species[colony_row(s->colony, s->colony->link.cell_b[i])];
        n += (of_a == a && of_b == b) || (of_a == b && of_b == a);
    }
    return n;
}

static void show_rule(interp *in, const scene *s, int kind, size_t a, size_t b, info_put put) {
    const link_style *style = &link_rules_styles[kind];
    const link_rule *rule = link_rules_find(&s->links, (link_kind)kind, (int)a, (int)b);
    if (!rule)
        return;
    line l = {0};
    add(&l, "%s %s", style->name, s->species.list[a].name);
    if (style->pairs)
        add(&l, " %s", s->species.list[b].name);
    add_parameters(&l, style->params, style->nparams, rule->p);
    put(in, "link        %s: %zu %s", l.text, links_between(s, kind, a, b),
        number_noun(links_between(s, kind, a, b), "link", "links"));
}

/* Rules for links, and how often links form and break. */
static void show_links(interp *in, const scene *s, bool bound, info_put put) {
    for (int kind = 0; kind < LINK_STYLES; kind++)
        for (size_t a = 0; a < s->species.count; a++)
            for (size_t b = 0; b <= (link_rules_styles[kind].pairs ? a : 0); b++)
                show_rule(in, s, kind, a, link_rules_styles[kind].pairs ? b : a, put);
    if (!bound)
        return;
    if (!mechanics_remodels(s->mechanics))
        put(in, "remodelling none: no link can form or break here");
    else if (s->links.every > 0)
        put(in, "remodelling every %gs of relaxation", s->links.every);
    else
        put(in, "remodelling after every step");
}

/* ---- by which means ---------------------------------------------------------------------------------------------- */

/* Field by field: padding between them need not agree. */
static bool is_preset(const relax_settings *r, const accuracy_preset *preset) {
    const relax_settings *p = &preset->settings;
    return r->integrator == p->integrator && r->step == p->step && r->tolerance == p->tolerance &&
           r->segment == p->segment && r->most == p->most && r->inertia == p->inertia;
}

static void show_relaxation(interp *in, const scene *s, info_put put) {
    const relax_settings *r = &s->relax;
    const integrator_style *style = integrator_styles[r->integrator];
    double tolerance = r->tolerance > 0 ? r->tolerance : style->tolerance;
    line l = {0};
    if (is_preset(r, &accuracy_presets[s->accuracy]))
        add(&l, ", accuracy %s", accuracy_presets[s->accuracy].name);
    if (r->step > 0)
        add(&l, ", steps of %gs", r->step);
    else if (style->caps & INTEGRATOR_MINIMISES)
        add(&l, ", to rest, by steps that take no time");
    else if (style->caps & INTEGRATOR_ADAPTIVE)
        add(&l, ", steps by their error: %gm and %gm/s", 1e-6 * tolerance, 1e-6 * tolerance);
    else
        add(&l, ", steps from the stiffness");
    if (r->step <= 0 && r->most > 0)
        add(&l, ", at most %gs", r->most);
    if (r->inertia > 0)
        add(&l, " at first, inertia %g", r->inertia);
    if (r->segment > 0)
        add(&l, ", begun anew every %gs", r->segment);
    put(in, "relaxation  %s%s", style->name, l.text);
    const scene_tally *t = &s->tally;
    uint64_t relaxations = t->by_time + t->by_force + t->stalled;
    if (t->steps == 0)
        put(in, "steps       not measured yet");
    else if (!(t->largest_step > 0))
        put(in, "steps       take no time, %.4g force evaluations a relaxation",
            relaxations ? (double)t->evaluations / (double)relaxations : (double)t->evaluations);
    else
        put(in, "steps       %.3gs to %.3gs, %.4g force evaluations a relaxation", t->least_step, t->largest_step,
            relaxations ? (double)t->evaluations / (double)relaxations : (double)t->evaluations);
    char caps[200];
    cap_describe(s->colony->caps, NULL, sizeof caps, caps);
    put(in, "limits      %s met", caps);
}

static void show_contacts(interp *in, const scene *s, bool bound, info_put put) {
    const mechanics_stats m = mechanics_statistics(s->mechanics);
    if (!is_active(s, bound, FORCE_COLLISION)) {
        put(in, "contacts    none: no neighbour list, no contact kernel");
        return;
    }
    put(in, "contacts    of %s%s, kernel %s", bound && m.spheres ? "spheres" : "segments",
        bound && m.flat ? " in x and y alone" : "", m.kernel);
    put(in, "neighbours  %zu %s, skin %.3g um, method %s", m.pairs, number_noun(m.pairs, "entry", "entries"), m.skin,
        s->neighbor.method == NEIGHBOR_CELLS ? "cells" : "pairs");
}

/* ---- what it costs ----------------------------------------------------------------------------------------------- */

static void add_part(line *l, const char *name, size_t bytes) {
    if (bytes)
        add(l, "%s %s %.3g", l->used ? "," : "", name, 1e-6 * (double)bytes);
}

/* Columns of the state by table, parts of the mechanics, and what the integrator holds while it relaxes. */
static void show_memory(interp *in, const scene *s, info_put put) {
    static const char *const tables[COLONY_TABLES] = {"particles", "cells", "links", "springs"};
    size_t state[COLONY_TABLES], sum = 0;
    mechanics_part parts[MECHANICS_PARTS];
    line l = {0};
    colony_memory(s->colony, state);
    mechanics_memory(s->mechanics, parts);
    for (int i = 0; i < COLONY_TABLES; sum += state[i++])
        add_part(&l, tables[i], state[i]);
    for (int i = 0; i < MECHANICS_PARTS; sum += parts[i++].bytes)
        add_part(&l, parts[i].name, parts[i].bytes);
    size_t vectors = (size_t)integrator_styles[s->relax.integrator]->vectors;
    size_t integrator = vectors * (size_t)s->dimension * sizeof(double) * s->colony->particle.count;
    add_part(&l, "integrator", integrator);
    put(in, "memory      %.3g MB:%s", 1e-6 * (double)(sum + integrator), l.text);
}

/* Shares of a whole, in tenths of a percent. */
typedef struct shares {
    line text;
    double whole, done;
    long told;
} shares;

/* Each is what it adds to the rounded sum: those told make 100.0 together. */
static void add_share(shares *all, const char *name, double seconds) {
    if (!(seconds > 0))
        return;
    all->done += seconds;
    long now = lround(1000 * all->done / all->whole), share = now - all->told;
    add(&all->text, "%s %s %.1f", all->text.used ? "," : "", name, 0.1 * (double)share);
    all->told = now;
}

/* Shares of the time by stage and, of that of the forces, by term. */
static void show_time(interp *in, const scene *s, info_put put) {
    const scene_timing *t = &s->timing;
    const double rest = t->relax - t->force - t->build - t->remodel;
    const double whole = t->grow + t->divide + t->relax + t->output;
    shares stages = {.whole = whole}, terms = {.whole = t->upkeep};
    if (s->tally.evaluations == 0 || !(whole > 0)) {
        put(in, "time        not measured yet");
        return;
    }
    add_share(&stages, "forces", t->force);
    add_share(&stages, "neighbours", t->build);
    add_share(&stages, "integration", rest);
    add_share(&stages, "remodelling", t->remodel);
    add_share(&stages, "growth", t->grow);
    add_share(&stages, "division", t->divide);
    add_share(&stages, "output", t->output);
    put(in, "time        %.3gs so far, in %%:%s", whole, stages.text.text);
    for (int i = 0; i < FORCE_COUNT; i++)
        terms.whole += t->term[i];
    for (int i = 0; i < FORCE_COUNT; i++)
        add_share(&terms, force_styles[i]->name, t->term[i]);
    add_share(&terms, "capsules", t->upkeep);
    put(in, "forces      %.1f ns a cell and evaluation, in %%:%s", 1e9 * t->force / (double)s->tally.cell_evaluations,
        terms.whole > 0 ? terms.text.text : " too few for shares");
}

/* ------------------------------------------------------------------------------------------------------------------ */

void info_scene_species(interp *in, info_put put) {
    show_species(in, interp_scene(in), put);
}

void info_scene_forces(interp *in, info_put put) {
    scene *s = interp_scene(in);
    bool bound = scene_prepare(s, NULL) == SARCINA_OK;
    show_forces(in, s, bound, put);
}

void info_scene_show(interp *in, info_put put) {
    scene *s = interp_scene(in);
    diag problem = {0};
    bool bound = scene_prepare(s, &problem) == SARCINA_OK;
    put(in, "scene       %zu %s of %zu %s%s, %zu %s, step %" PRIu64 ", time %g s, relaxed %g s", s->colony->cell.count,
        number_noun(s->colony->cell.count, "cell", "cells"), s->colony->particle.count,
        number_noun(s->colony->particle.count, "particle", "particles"), s->dimension == 2 ? " in the plane" : "",
        s->colony->link.count, number_noun(s->colony->link.count, "link", "links"), s->step, s->time, s->relaxed);
    show_species(in, s, put);
    show_forces(in, s, bound, put);
    show_links(in, s, bound, put);
    show_relaxation(in, s, put);
    show_contacts(in, s, bound, put);
    show_memory(in, s, put);
    show_time(in, s, put);
    put(in, "seed        %" PRIu64 ", %d %s", rng_get_seed(s->rng), s->threads,
        number_noun((uint64_t)s->threads, "thread", "threads"));
    if (!bound)
        put(in, "cannot run  %s", problem.message);
}

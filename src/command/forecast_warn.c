/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Warnings of -check: what a script names that can never act there, and what is at odds with itself. Each is one
 * function of the table at the end. */
#include "command/forecast.h"

#include "base/table.h"
#include "biology/division.h"
#include "command/style_values.h"
#include "model/shape.h"

#include <math.h>

static const double nm_each_um = 1e3;

double forecast_diameter(const species *sp) {
    double mass = division_mean_mass(sp);
    if (sp->shape == SHAPE_COCCUS)
        return shape_coccus_diameter(mass, sp->density);
    return spread_mean(&sp->diameter) > 0 ? spread_mean(&sp->diameter) : (double)NAN;
}

static size_t species_count(const scene *s) {
    return s->species.count < FORECAST_SPECIES ? s->species.count : FORECAST_SPECIES;
}

/* Lightest particle of all, at birth, pg. */
static double least_mass(const forecast_subject *u) {
    double least = INFINITY;
    for (size_t i = 0; i < species_count(u->s); i++) {
        const species *sp = &u->s->species.list[i];
        double mass = division_mean_mass(sp);
        mass = mass > 0 ? 0.5 * mass : u->f->cells[i] > 0 ? u->f->mass[i] / u->f->cells[i] : (double)NAN;
        if (u->end->of[i] > 0 && mass > 0)
            least = fmin(least, mass / (double)species_particles(sp));
    }
    return least;
}

static bool has_cells(const forecast_subject *u, size_t species_row) {
    for (size_t i = 0; i < u->s->attachments.count; i++)
        if (u->s->attachments.list[i].placement.species == (int)species_row)
            return true;
    return u->f->unknown || u->end->of[species_row] > 0;
}

/* ---- what never acts --------------------------------------------------------------------------------------------- */

/* Flexible cells may touch themselves. */
static void warn_collision(const forecast_subject *u) {
    bool alone = u->end->cells > 0 && u->end->cells < 2 && !u->f->unknown && u->s->attachments.count == 0;
    for (size_t i = 0; i < species_count(u->s); i++)
        alone = alone && !(u->s->species.list[i].shape == SHAPE_FLEXIBLE && u->end->of[i] > 0);
    if (u->s->forces.term[FORCE_COLLISION].on && alone)
        interp_warn(u->in, "force collision never acts: there is one cell, and it does not divide");
}

static void warn_links(const forecast_subject *u) {
    const scene *s = u->s;
    for (int kind = 0; kind < LINK_STYLES; kind++)
        for (size_t a = 0; a < species_count(s); a++)
            for (size_t b = 0; b <= a; b++) {
                if ((kind != LINK_STICK && a != b) || !link_rules_find(&s->links, (link_kind)kind, (int)a, (int)b))
                    continue;
                size_t lacks = has_cells(u, a) ? b : a;
                if (!has_cells(u, lacks))
                    interp_warn(u->in, "link %s never acts: no cells of species %s are created",
                                link_rules_styles[kind].name, s->species.list[lacks].name);
                else if (kind == LINK_FILIAL && s->species.list[a].division.style < 0 && !u->f->filament[a] &&
                         !u->f->unknown)
                    interp_warn(u->in, "link filial never acts: species %s does not divide, and no filament is created",
                                s->species.list[a].name);
            }
}

double forecast_radius(const scene *s, const forecast_end *end, bool layer) {
    double volume = 0, area = 0;
    for (size_t i = 0; i < species_count(s); i++) {
        const species *sp = &s->species.list[i];
        double mass = division_mean_mass(sp), diameter = forecast_diameter(sp);
        double all = end->of[i] * (mass > 0 ? mass : 1) / sp->density;
        volume += all;
        area += diameter > 0 ? all / diameter : 0;
    }
    return layer ? sqrt(2 * area / M_PI) : cbrt(3 * 2 * volume / (4 * M_PI));
}

static void warn_substratum(const forecast_subject *u) {
    double radius = forecast_radius(u->s, u->end, false);
    if (u->s->forces.term[FORCE_SUBSTRATUM].on && !u->s->forces.term[FORCE_GRAVITY].on && !u->f->unknown &&
        isfinite(u->f->least_gap) && u->f->least_gap > 3 * radius + 5)
        interp_warn(u->in,
                    "substratum never acts: the lowest cell is created %.3g um above it, and the colony reaches some "
                    "%.3g um",
                    u->f->least_gap, radius);
}

/* ---- the step ---------------------------------------------------------------------------------------------------- */

/* Largest spring constants of each cause, times how many act on a particle in a dense colony, pg/s2. */
enum { CAUSES = 6 };
static void find_stiffness(const forecast_subject *u, const char *name[CAUSES], double k[CAUSES], double own[CAUSES]) {
    static const char *const names[CAUSES] = {"force collision", "link internal", "substratum",
                                              "link filial",     "link stick",    "link anchor"};
    const force_settings *t = u->s->forces.term;
    for (int i = 0; i < CAUSES; i++) {
        name[i] = names[i];
        k[i] = own[i] = 0;
    }
    own[0] = t[FORCE_COLLISION].on ? t[FORCE_COLLISION].p[COLLISION_K] : 0;
    own[2] = t[FORCE_SUBSTRATUM].on ? t[FORCE_SUBSTRATUM].p[SUBSTRATUM_K] : 0;
    for (size_t a = 0; a < species_count(u->s); a++) {
        own[1] = u->end->of[a] > 0 ? fmax(own[1], u->s->species.list[a].internal_k) : own[1];
        for (int kind = 0; kind < LINK_STYLES; kind++)
            for (size_t b = 0; b <= a; b++) {
                const link_rule *rule = link_rules_find(&u->s->links, (link_kind)kind, (int)a, (int)b);
                own[3 + kind] = rule && u->end->of[a] > 0 ? fmax(own[3 + kind], rule->p[0]) : own[3 + kind];
            }
    }
    static const double times[CAUSES] = {4, 2, 1, 2, 4, 1};
    for (int i = 0; i < CAUSES; i++)
        k[i] = times[i] * own[i];
}

/* A term that makes every step four times as short as the others would. */
static void warn_stiffness(const forecast_subject *u) {
    const char *name[CAUSES];
    double k[CAUSES], own[CAUSES], mass = least_mass(u), all = 0;
    int worst = 0;
    find_stiffness(u, name, k, own);
    for (int i = 0; i < CAUSES; i++) {
        all += k[i];
        worst = k[i] > k[worst] ? i : worst;
    }
    double rest = all - k[worst];
    if (!isfinite(mass) || !(rest > 0) || all < 16 * rest)
        return;
    interp_warn(u->in,
                "%s k %g N/m sets the step: about %.2g us; without it, %.2g us, %.2g times fewer force evaluations",
                name[worst], dim_from_engine(own[worst], DIM_STIFFNESS), 1e6 * 1.4 / sqrt(all / mass),
                1e6 * 1.4 / sqrt(rest / mass), sqrt(all / rest));
}

/* ---- lengths ----------------------------------------------------------------------------------------------------- */

/* Of a division's new link: facing ends touch, and both daughters are as long as their rest length. */
static void warn_filial(const forecast_subject *u) {
    for (size_t a = 0; a < species_count(u->s); a++) {
        const link_rule *rule = link_rules_find(&u->s->links, LINK_FILIAL, (int)a, (int)a);
        const species *sp = &u->s->species.list[a];
        double d = forecast_diameter(sp);
        if (!rule || !(d > 0))
            continue;
        double least =
            sp->shape == SHAPE_COCCUS ? rule->p[FILIAL_RATIO] : fmin(rule->p[FILIAL_SHORT], rule->p[FILIAL_LONG]);
        if ((1 - least) * d > rule->p[FILIAL_BREAK])
            interp_warn(
                u->in,
                "link filial %s breaks as it forms: it is %.3g nm longer than at rest then, and break is %.3g nm",
                sp->name, nm_each_um * (1 - least) * d, nm_each_um * rule->p[FILIAL_BREAK]);
    }
}

/* Neighbours in a growing colony lie some hundredths of a diameter in each other, which pushes out what holds them. */
static void warn_break(const forecast_subject *u) {
    static const double overlap = 0.02;
    for (int kind = 0; kind < LINK_STYLES; kind++)
        for (size_t a = 0; a < species_count(u->s); a++)
            for (size_t b = 0; b <= a; b++) {
                const link_rule *rule = link_rules_find(&u->s->links, (link_kind)kind, (int)a, (int)b);
                double d = forecast_diameter(&u->s->species.list[a]);
                if (!rule || (kind != LINK_STICK && a != b) || !(link_rules_break((link_kind)kind, rule) < overlap * d))
                    continue;
                interp_warn(u->in, "link %s %s: break %.3g nm is less than cells overlap in a colony, some %.3g nm",
                            link_rules_styles[kind].name, u->s->species.list[a].name,
                            nm_each_um * link_rules_break((link_kind)kind, rule), nm_each_um * overlap * d);
            }
}

static void warn_clamp(const forecast_subject *u) {
    const force_settings *dlvo = &u->s->forces.term[FORCE_DLVO];
    double clamp = dlvo->on ? dlvo->p[DLVO_CLAMP] / dlvo->p[DLVO_KAPPA] : 0;
    for (size_t a = 0; a < species_count(u->s); a++)
        if (clamp > 0.5 * forecast_diameter(&u->s->species.list[a])) {
            interp_warn(u->in, "force dlvo is held from a gap of %.3g nm down, which is more than the radius of %s",
                        nm_each_um * clamp, u->s->species.list[a].name);
            return;
        }
}

static void warn_jitter(const forecast_subject *u) {
    for (size_t a = 0; a < species_count(u->s); a++) {
        const species *sp = &u->s->species.list[a];
        double jitter = sp->division.style < 0 ? 0 : sp->division.values[DIVISION_JITTER].a;
        if (jitter > 0.5 * forecast_diameter(sp))
            interp_warn(u->in, "division %s jitter %.3g um is more than a radius of its cells", sp->name, jitter);
    }
}

void forecast_warn(interp *in, const forecast *f, const forecast_end *end) {
    static void (*const all[])(const forecast_subject *u) = {
        warn_collision, warn_links, warn_substratum, warn_stiffness, warn_filial, warn_break, warn_clamp, warn_jitter};
    const forecast_subject u = {in, interp_scene(in), f, end};
    if (f->nruns == 0 || end->load.cycles == 0)
        return; /* a part of a script, which others include */
    for (size_t i = 0; i < TABLE_COUNT(all); i++)
        all[i](&u);
    forecast_warn_sizes(in, f, end);
}

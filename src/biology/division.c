/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Both halves of a division have half the mass. The mother keeps her id, place and size; the daughter gets the next id
 * and draws her own diameter. Newborns are numbered in the order of their mothers' ids. */
#include "biology/division.h"

#include "base/alloc.h"
#include "base/table.h"
#include "biology/division/rules.h"
#include "biology/handover.h"
#include "model/shape.h"

#include <math.h>
#include <stdlib.h>

const division_style *const division_styles[] = {&division_midpoint, &division_random, &division_planes};
const size_t division_style_count = TABLE_COUNT(division_styles);

/* Mass of a cell of the species whose size (rod: total length; coccus: diameter) is given. */
static double mass_of_size(const species *s, double size, double diameter, double aspect) {
    if (s->shape == SHAPE_COCCUS)
        return shape_coccus_mass(size, s->density);
    if (aspect > 0)
        diameter = size / aspect;
    return shape_rod_mass(size - diameter, diameter, s->density);
}

/* The first draw above 0; a spread so wide that a thousand draws fail gives its mean. */
static double draw_positive(const spread *s, gsl_rng *stream) {
    for (int i = 0; i < 1000; i++) {
        double drawn = spread_draw(s, stream);
        if (drawn > 0)
            return drawn;
    }
    return spread_mean(s);
}

double division_limit(const species *s, rng *r, uint64_t id, double diameter, double aspect) {
    if (s->division.style < 0)
        return INFINITY;
    const spread *mass = &s->division.values[DIVISION_MASS], *size = &s->division.values[DIVISION_SIZE];
    bool by_mass = !isnan(mass->a);
    double drawn = draw_positive(by_mass ? mass : size, rng_stream(r, RNG_SIZE, id, 0));
    return by_mass ? drawn : mass_of_size(s, drawn, diameter, aspect);
}

double division_mean_mass(const species *s) {
    if (s->division.style < 0)
        return NAN;
    const spread *mass = &s->division.values[DIVISION_MASS], *size = &s->division.values[DIVISION_SIZE];
    if (!isnan(mass->a))
        return spread_mean(mass);
    return mass_of_size(s, spread_mean(size), spread_mean(&s->diameter), spread_mean(&s->aspect));
}

bool division_walls(const species *s) {
    int style = s->division.style;
    return style >= 0 && division_styles[style] == &division_planes && s->division.values[DIVISION_PLANES].a > 1;
}

const char *division_leaves_plane(const species *s) {
    const style_choice *rule = &s->division;
    if (rule->style < 0)
        return NULL;
    if ((int)rule->values[DIVISION_AXIS].a == AXIS_Z)
        return "with jitter along z";
    bool planes = division_styles[rule->style] == &division_planes;
    return planes && rule->values[DIVISION_PLANES].a > 2 ? "along three axes" : NULL;
}

bool division_pairs(const species *s) {
    int style = s->division.style;
    bool knows = style >= 0 && division_styles[style] != &division_random;
    return knows && s->division.values[DIVISION_PAIRS].a != 0;
}

double division_branch(const species *s) {
    int style = s->division.style;
    bool branches = style >= 0 && division_styles[style] == &division_midpoint;
    return branches ? s->division.values[DIVISION_BRANCH].a : 0;
}

/* Do the particles of a cell about to divide still show its coil, with more than two of them a turn? */
static int check_coil(const species *s, double mass, diag *d) {
    double rest = species_rest(s, mass, spread_mean(&s->diameter), 0), turn = chain_coil_turn(&s->coil);
    double turns = rest / turn;
    if (s->particles - 1 > 2 * turns)
        return SARCINA_OK;
    diag_error(d, "species %s would divide with %.3g turns of its coil, which %u particles do not show", s->name, turns,
               s->particles);
    return diag_help(d, "it takes more than %.0f particles, a longer pitch or a smaller mass", 2 * turns + 1);
}

int division_check(const species *s, diag *d) {
    if (s->division.style < 0)
        return SARCINA_OK;
    const division_style *rule = division_styles[s->division.style];
    if (!(rule->shapes >> s->shape & 1)) {
        diag_error(d, "division %s is for %s; species %s is %s", rule->name,
                   rule->shapes == DIVISION_COCCI ? "cocci" : "rods and flexible cells", s->name,
                   species_shape_name(s->shape));
        return diag_help(d, s->shape == SHAPE_COCCUS ? "a coccus divides by 'random' or 'planes N'"
                                                     : "a rod or a flexible cell divides by 'midpoint'");
    }
    double mass = division_mean_mass(s);
    if (s->shape == SHAPE_FLEXIBLE && check_coil(s, mass, d))
        return SARCINA_ERROR;
    double rest = species_rest(s, mass / 2, spread_mean(&s->diameter), spread_mean(&s->aspect));
    if (rest >= 0)
        return SARCINA_OK;
    double diameter = spread_mean(&s->diameter);
    diag_error(d, "species %s would divide at %.3g kg into rods shorter than wide (rest length %.3g um)", s->name,
               mass * 1e-15, rest);
    return diag_help(d, "with diameter %.3g um, mass must be at least %.3g kg", diameter,
                     2e-15 * shape_rod_mass(0, diameter, s->density));
}

void division_draw_size(const species *s, colony *c, uint32_t row, rng *r) {
    if (s->shape == SHAPE_COCCUS)
        return;
    gsl_rng *stream = rng_stream(r, RNG_DIAMETER, c->cell.id[row], 0);
    if (spread_mean(&s->aspect) > 0)
        c->cell.aspect[row] = draw_positive(&s->aspect, stream);
    else
        c->cell.diameter[row] = draw_positive(&s->diameter, stream);
}

/* The daughter's columns; both halves have their mass and shape afterwards. */
static uint32_t add_daughter(const division_context *x, uint32_t mother) {
    colony *c = x->colony;
    const species *s = &x->species->list[c->cell.species[mother]];
    double *place = alloc_zeroed(3 * species_particles(s), sizeof *place);
    uint32_t daughter = colony_add_cell(c, species_particles(s), place);
    free(place);
    c->cell.parent[daughter] = c->cell.id[mother];
    c->cell.founder[daughter] = c->cell.founder[mother];
    c->cell.species[daughter] = c->cell.species[mother];
    c->cell.groups[daughter] = c->cell.groups[mother];
    c->cell.generation[daughter] = ++c->cell.generation[mother];
    c->cell.birth[daughter] = x->time;
    c->cell.rate[daughter] = c->cell.rate[mother];
    c->cell.own_rate[daughter] = c->cell.own_rate[mother];
    c->cell.stiffness[daughter] = c->cell.stiffness[mother];
    c->cell.mass[daughter] = c->cell.mass[mother] /= 2;
    division_draw_size(s, c, daughter, x->rng);
    species_shape_cell(s, c, mother);
    species_shape_cell(s, c, daughter);
    c->cell.limit[daughter] =
        division_limit(s, x->rng, c->cell.id[daughter], c->cell.diameter[daughter], c->cell.aspect[daughter]);
    return daughter;
}

static void turn_mother(const division_context *x, const handover *links, uint32_t mother) {
    const species *s = &x->species->list[x->colony->cell.species[mother]];
    const division_style *rule = division_styles[s->division.style];
    uint32_t neighbours[HANDOVER_NEIGHBOURS];
    if (rule->turn)
        rule->turn(x, mother, neighbours, handover_neighbours(links, mother, neighbours));
}

size_t division_step(const division_context *x) {
    colony *c = x->colony;
    size_t n = c->cell.count, due = 0;
    uint32_t *mothers = alloc_zeroed(n, sizeof *mothers);
    const uint32_t *order = colony_by_id(c);
    for (size_t i = 0; i < n; i++)
        if (c->cell.mass[order[i]] > c->cell.limit[order[i]])
            mothers[due++] = order[i]; /* rows stay where they are: daughters are appended */
    handover *links = due ? handover_begin(x) : NULL;
    for (size_t i = 0; i < due; i++)
        turn_mother(x, links, mothers[i]); /* by neighbours that have not divided yet */
    for (size_t i = 0; i < due; i++) {
        uint32_t mother = mothers[i];
        const species *s = &x->species->list[c->cell.species[mother]];
        uint32_t daughter = add_daughter(x, mother);
        division_styles[s->division.style]->place(x, mother, daughter);
        handover_divide(links, mother, daughter);
    }
    handover_end(links);
    free(mothers);
    return due;
}

/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Both halves of a division have half the mass. The mother keeps her id, place and size; the daughter gets the next id
 * and draws her own diameter. Newborns are numbered in the order of their mothers' ids. */
#include "biology/division.h"

#include "base/alloc.h"
#include "base/table.h"
#include "base/vec3.h"
#include "model/axis.h"
#include "model/shape.h"

#include <gsl/gsl_randist.h>
#include <math.h>
#include <stdlib.h>

#define JITTER_PARAMS                                                                                                  \
    {"jitter=10nm:length[0,)",                                                                                         \
     "displacement of one new particle, without which exactly aligned daughters stay aligned"},                        \
    {                                                                                                                  \
        "axis=auto:{auto|x|y|z}", "its direction; auto: drawn, horizontal on a substratum"                             \
    }

static const param midpoint_params[] = {
    {"mass:mass~!1(0,1e-9kg)", "mass above which a cell divides"},
    {"length:length~!1(0,1mm)", "or its total length"},
    JITTER_PARAMS,
};
static const param random_params[] = {
    {"mass:mass~!1(0,1e-9kg)", "mass above which a cell divides"},
    {"diameter:length~!1(0,)", "or its diameter"},
    JITTER_PARAMS,
    {"tries=100:int[1,)", "directions drawn in search of one without overlap"},
};

static double *particle(const colony *c, uint32_t cell, uint32_t i) {
    return c->particle.x + 3 * ((size_t)c->cell.first[cell] + i);
}

static double *velocity(const colony *c, uint32_t cell, uint32_t i) {
    return c->particle.v + 3 * ((size_t)c->cell.first[cell] + i);
}

/* The displacement that breaks the symmetry of the daughters (model: "jitter"). */
static vec3 draw_jitter(const division_context *x, const style_choice *rule, uint64_t id) {
    double length = rule->values[DIVISION_JITTER].a;
    int axis = (int)rule->values[DIVISION_AXIS].a;
    vec3 u = {axis == AXIS_X, axis == AXIS_Y, axis == AXIS_Z};
    if (axis == AXIS_AUTO) {
        gsl_rng *stream = rng_stream(x->rng, RNG_JITTER, id, 0);
        if (x->substratum)
            gsl_ran_dir_2d(stream, &u.x, &u.y);
        else
            gsl_ran_dir_3d(stream, &u.x, &u.y, &u.z);
    }
    return vec3_scale(length, u);
}

static void lift(const division_context *x, uint32_t cell, uint32_t i) {
    double *p = particle(x->colony, cell, i), lowest = x->substratum_z + 0.5 * x->colony->cell.diameter[cell];
    if (x->substratum && p[2] < lowest)
        p[2] = lowest;
}

/* A rod divides in the middle: the mother keeps her first particle, the daughter the last; between them stand two new
 * particles whose balls touch. Velocities go with the particles' places. */
static void place_midpoint(const division_context *x, uint32_t mother, uint32_t daughter) {
    colony *c = x->colony;
    const style_choice *rule = &x->species->list[c->cell.species[mother]].division;
    vec3 a = vec3_load(particle(c, mother, 0)), b = vec3_load(particle(c, mother, 1));
    vec3 d = vec3_sub(b, a);
    double length = vec3_norm(d);
    if (length > 0) {
        d = vec3_scale(1 / length, d);
    } else {
        double u[3];
        rng_direction(rng_get_seed(x->rng), c->cell.id[mother], c->cell.id[daughter], u);
        d = vec3_load(u);
    }
    vec3 middle = vec3_scale(0.5, vec3_add(a, b));
    vec3 near_end = vec3_axpy(middle, -0.5 * c->cell.diameter[mother], d);
    vec3 far_end = vec3_axpy(middle, 0.5 * c->cell.diameter[daughter], d);
    far_end = vec3_add(far_end, draw_jitter(x, rule, c->cell.id[daughter]));

    vec3 va = vec3_load(velocity(c, mother, 0)), vb = vec3_load(velocity(c, mother, 1));
    vec3 between = vec3_scale(0.5, vec3_add(va, vb));
    vec3_store(velocity(c, mother, 1), between);
    vec3_store(velocity(c, daughter, 0), between);
    vec3_store(velocity(c, daughter, 1), vb);
    vec3_store(particle(c, mother, 1), near_end);
    vec3_store(particle(c, daughter, 0), far_end);
    vec3_store(particle(c, daughter, 1), b);
    lift(x, mother, 1);
    lift(x, daughter, 0);
}

/* Cells that a daughter placed within two radii of the mother's centre could touch; the caller frees. */
static uint32_t *cells_near(const colony *c, uint32_t mother, uint32_t daughter, const double centre[3],
                            size_t *count) {
    double reach = 2 * c->cell.diameter[mother];
    uint32_t *near = alloc_zeroed(c->cell.count, sizeof *near);
    *count = 0;
    for (uint32_t i = 0; i < c->cell.count; i++)
        if (i != mother && i != daughter && axis_cell_point_distance(c, i, centre) < reach + 0.5 * c->cell.diameter[i])
            near[(*count)++] = i;
    return near;
}

/* Sum of the overlaps that a coccus of radius r at p would have. */
static double overlap_at(const colony *c, const uint32_t *near, size_t n, vec3 p, double r) {
    double sum = 0, at[3];
    vec3_store(at, p);
    for (size_t i = 0; i < n; i++) {
        double overlap = r + 0.5 * c->cell.diameter[near[i]] - axis_cell_point_distance(c, near[i], at);
        sum += overlap > 0 ? overlap : 0;
    }
    return sum;
}

/* A coccus divides into two that touch, in a direction drawn until neither overlaps a neighbour; after `tries` the one
 * with the least overlap counts. */
static void place_random(const division_context *x, uint32_t mother, uint32_t daughter) {
    colony *c = x->colony;
    const style_choice *rule = &x->species->list[c->cell.species[mother]].division;
    vec3 centre = vec3_load(particle(c, mother, 0)), best = {0, 0, 1};
    double r = 0.5 * c->cell.diameter[mother], least = INFINITY;
    size_t count;
    uint32_t *near = cells_near(c, mother, daughter, particle(c, mother, 0), &count);
    gsl_rng *stream = rng_stream(x->rng, RNG_DIRECTION, c->cell.id[daughter], 0);
    for (int i = 0; i < (int)rule->values[DIVISION_TRIES].a && least > 0; i++) {
        vec3 u;
        gsl_ran_dir_3d(stream, &u.x, &u.y, &u.z);
        vec3 p = vec3_axpy(centre, -r, u), q = vec3_axpy(centre, r, u);
        double overlap = overlap_at(c, near, count, p, r) + overlap_at(c, near, count, q, r);
        if (x->substratum && fmin(p.z, q.z) < x->substratum_z + r)
            overlap += x->substratum_z + r - fmin(p.z, q.z);
        if (overlap < least) {
            least = overlap;
            best = u;
        }
    }
    free(near);
    vec3 jitter = draw_jitter(x, rule, c->cell.id[daughter]);
    vec3_store(particle(c, mother, 0), vec3_axpy(centre, -r, best));
    vec3_store(particle(c, daughter, 0), vec3_add(vec3_axpy(centre, r, best), jitter));
    vec3_store(velocity(c, daughter, 0), vec3_load(velocity(c, mother, 0)));
    lift(x, mother, 0);
    lift(x, daughter, 0);
}

const division_style division_styles[] = {
    {"midpoint", "a rod divides in the middle", "Storck et al. 2014, growth and division",
     "division ecoli midpoint mass 2.45e-15kg", SHAPE_ROD, midpoint_params, TABLE_COUNT(midpoint_params),
     place_midpoint},
    {"random", "a coccus divides in a random free direction", "Storck et al. 2014, growth and division",
     "division cf random mass 5.95e-16kg", SHAPE_COCCUS, random_params, TABLE_COUNT(random_params), place_random},
};
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

int division_check(const species *s, diag *d) {
    if (s->division.style < 0)
        return SARCINA_OK;
    const division_style *rule = &division_styles[s->division.style];
    if (rule->shape != s->shape) {
        diag_error(d, "division %s is for %s; species %s is a %s", rule->name,
                   rule->shape == SHAPE_ROD ? "rods" : "cocci", s->name, s->shape == SHAPE_ROD ? "rod" : "coccus");
        return diag_help(d, s->shape == SHAPE_ROD ? "a rod divides by 'midpoint'" : "a coccus divides by 'random'");
    }
    double mass = division_mean_mass(s);
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
    double place[6] = {0};
    uint32_t daughter = colony_add_cell(c, species_particles(s), place);
    c->cell.parent[daughter] = c->cell.id[mother];
    c->cell.founder[daughter] = c->cell.founder[mother];
    c->cell.species[daughter] = c->cell.species[mother];
    c->cell.groups[daughter] = c->cell.groups[mother];
    c->cell.generation[daughter] = ++c->cell.generation[mother];
    c->cell.birth[daughter] = x->time;
    c->cell.rate[daughter] = c->cell.rate[mother];
    c->cell.mass[daughter] = c->cell.mass[mother] /= 2;
    division_draw_size(s, c, daughter, x->rng);
    species_shape_cell(s, c, mother);
    species_shape_cell(s, c, daughter);
    c->cell.limit[daughter] =
        division_limit(s, x->rng, c->cell.id[daughter], c->cell.diameter[daughter], c->cell.aspect[daughter]);
    return daughter;
}

size_t division_step(const division_context *x) {
    colony *c = x->colony;
    size_t n = c->cell.count, due = 0;
    uint32_t *mothers = alloc_zeroed(n, sizeof *mothers);
    const uint32_t *order = colony_by_id(c);
    for (size_t i = 0; i < n; i++)
        if (c->cell.mass[order[i]] > c->cell.limit[order[i]])
            mothers[due++] = order[i]; /* rows stay where they are: daughters are appended */
    for (size_t i = 0; i < due; i++) {
        uint32_t mother = mothers[i];
        const species *s = &x->species->list[c->cell.species[mother]];
        uint32_t daughter = add_daughter(x, mother);
        division_styles[s->division.style].place(x, mother, daughter);
    }
    free(mothers);
    return due;
}

/* SPDX-License-Identifier: GPL-3.0-or-later */
/* A rod divides in the middle: the mother keeps her first particle, the daughter the last; between them stand two new
 * particles whose balls touch. Velocities go with the particles' places.
 * With `snap` the daughter folds over: the outer wall tears on one side only, and on the other holds mother and
 * daughter together as a hinge ("snapping" of corynebacteria and arthrobacters; Krulwich & Pate 1971, J. Bacteriol.
 * 105:408). Source: Storck et al. 2014, growth and division. */
#include "biology/division/rules.h"

#include "base/table.h"

#include <gsl/gsl_randist.h>
#include <math.h>
#include <sleef.h>

/* Direction from a rod's first particle to its last; seeded where it has no length. */
static vec3 direction(const division_context *x, uint32_t mother, uint32_t daughter, vec3 a, vec3 b) {
    const colony *c = x->colony;
    vec3 d = vec3_sub(b, a);
    double length = vec3_norm(d), u[3];
    if (length > 0)
        return vec3_scale(1 / length, d);
    (x->flat ? rng_direction_flat : rng_direction)(rng_get_seed(x->rng), c->cell.id[mother], c->cell.id[daughter], u);
    return vec3_load(u);
}

/* A unit vector at right angles to d, horizontal on a substratum: to where the daughter snaps. */
static vec3 draw_side(const division_context *x, uint64_t id, vec3 d) {
    gsl_rng *stream = rng_stream(x->rng, RNG_SNAP, id, 0);
    vec3 u = {0, 0, 1}, side;
    bool left = gsl_rng_uniform(stream) < 0.5;
    do {
        if (!division_is_horizontal(x) || fabs(d.z) > 0.99)
            gsl_ran_dir_3d(stream, &u.x, &u.y, &u.z);
        side = vec3_cross(u, d);
    } while (vec3_norm(side) < 0.01);
    return vec3_scale((left ? -1 : 1) / vec3_norm(side), side);
}

/* Turns the daughter about the place on the wall, half a diameter beside the middle, where mother and daughter still
 * hang together. */
static void snap(const division_context *x, uint32_t mother, uint32_t daughter, vec3 middle, vec3 d, double angle) {
    colony *c = x->colony;
    vec3 side = draw_side(x, c->cell.id[daughter], d);
    vec3 hinge = vec3_axpy(middle, 0.5 * c->cell.diameter[mother], side);
    double cosine = Sleef_cinz_cosd1_u10purec(angle), sine = Sleef_cinz_sind1_u10purec(angle);
    vec3 new_d = vec3_axpy(vec3_scale(cosine, d), sine, side), new_side = vec3_axpy(vec3_scale(cosine, side), -sine, d);
    vec3 across = vec3_cross(d, side);
    for (uint32_t i = 0; i < 2; i++) {
        double *p = division_place(c, daughter, i);
        vec3 r = vec3_sub(vec3_load(p), hinge);
        vec3 turned = vec3_axpy(vec3_scale(vec3_dot(r, d), new_d), vec3_dot(r, side), new_side);
        vec3_store(p, vec3_add(hinge, vec3_axpy(turned, vec3_dot(r, across), across)));
        division_lift(x, daughter, i);
    }
}

static void place(const division_context *x, uint32_t mother, uint32_t daughter) {
    colony *c = x->colony;
    if (c->cell.nparticles[mother] > 2) {
        division_halve(x, mother, daughter);
        return;
    }
    const style_choice *rule = &x->species->list[c->cell.species[mother]].division;
    vec3 a = vec3_load(division_place(c, mother, 0)), b = vec3_load(division_place(c, mother, 1));
    vec3 d = direction(x, mother, daughter, a, b);
    vec3 middle = vec3_scale(0.5, vec3_add(a, b));
    vec3 near_end = vec3_axpy(middle, -0.5 * c->cell.diameter[mother], d);
    vec3 far_end = vec3_axpy(middle, 0.5 * c->cell.diameter[daughter], d);
    far_end = vec3_add(far_end, division_jitter(x, rule, c->cell.id[daughter]));

    vec3 va = vec3_load(division_velocity(c, mother, 0)), vb = vec3_load(division_velocity(c, mother, 1));
    vec3 between = vec3_scale(0.5, vec3_add(va, vb));
    vec3_store(division_velocity(c, mother, 1), between);
    vec3_store(division_velocity(c, daughter, 0), between);
    vec3_store(division_velocity(c, daughter, 1), vb);
    vec3_store(division_place(c, mother, 1), near_end);
    vec3_store(division_place(c, daughter, 0), far_end);
    vec3_store(division_place(c, daughter, 1), b);
    division_lift(x, mother, 1);
    division_lift(x, daughter, 0);
    if (rule->values[DIVISION_SNAP].a > 0)
        snap(x, mother, daughter, middle, d, rule->values[DIVISION_SNAP].a);
}

static const param params[] = {
    {"mass:mass~!1(0,1e-9kg)", "mass above which a cell divides"},
    {"length:length~!1(0,1mm)", "or its total length"},
    RULES_JITTER_PARAMS,
    {"branch=0:fraction%[0,1]", "of divisions of cells linked filially at both ends: the daughter begins a branch"},
    RULES_PAIRS_PARAM,
    {"snap=0:angle[0,180degree]", "rods: by how much the daughter folds over to her mother's side (palisades)"},
};

const division_style division_midpoint = {
    .name = "midpoint",
    .head = "midpoint",
    .summary = "a rod or a flexible cell divides in the middle",
    .source = "Storck et al. 2014, growth and division",
    .example = "division ecoli midpoint mass 2.45e-15kg jitter 10nm axis auto branch 30%\n"
               "division ecoli midpoint length 5um sd 10% pairs yes snap 160degree",
    .shapes = DIVISION_RODS | DIVISION_FLEXIBLE,
    .params = params,
    .nparams = TABLE_COUNT(params),
    .place = place,
};

/* SPDX-License-Identifier: GPL-3.0-or-later */
/* A rod divides in the middle: the mother keeps her first particle, the daughter the last; between them stand two new
 * particles whose balls touch. Velocities go with the particles' places.
 * Source: Storck et al. 2014, growth and division. */
#include "biology/division/rules.h"

#include "base/table.h"

/* Direction from a rod's first particle to its last; seeded where it has no length. */
static vec3 direction(const division_context *x, uint32_t mother, uint32_t daughter, vec3 a, vec3 b) {
    const colony *c = x->colony;
    vec3 d = vec3_sub(b, a);
    double length = vec3_norm(d), u[3];
    if (length > 0)
        return vec3_scale(1 / length, d);
    rng_direction(rng_get_seed(x->rng), c->cell.id[mother], c->cell.id[daughter], u);
    return vec3_load(u);
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
}

static const param params[] = {
    {"mass:mass~!1(0,1e-9kg)", "mass above which a cell divides"},
    {"length:length~!1(0,1mm)", "or its total length"},
    RULES_JITTER_PARAMS,
    {"branch=0:fraction%[0,1]", "of divisions of cells linked filially at both ends: the daughter begins a branch"},
};

const division_style division_midpoint = {
    .name = "midpoint",
    .head = "midpoint",
    .summary = "a rod or a flexible cell divides in the middle",
    .source = "Storck et al. 2014, growth and division",
    .example = "division ecoli midpoint mass 2.45e-15kg jitter 10nm axis auto branch 30%\n"
               "division ecoli midpoint length 5um sd 10%",
    .shapes = DIVISION_RODS | DIVISION_FLEXIBLE,
    .params = params,
    .nparams = TABLE_COUNT(params),
    .place = place,
};

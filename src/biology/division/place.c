/* SPDX-License-Identifier: GPL-3.0-or-later */
/* How rules put particles. */
#include "biology/division/rules.h"

#include <gsl/gsl_randist.h>

double *division_place(const colony *c, uint32_t cell, uint32_t i) {
    return c->particle.x + 3 * ((size_t)c->cell.first[cell] + i);
}

double *division_velocity(const colony *c, uint32_t cell, uint32_t i) {
    return c->particle.v + 3 * ((size_t)c->cell.first[cell] + i);
}

vec3 division_jitter(const division_context *x, const style_choice *rule, uint64_t id) {
    double length = rule->values[DIVISION_JITTER].a;
    int axis = (int)rule->values[DIVISION_AXIS].a;
    vec3 u = {axis == AXIS_X, axis == AXIS_Y, axis == AXIS_Z};
    if (axis == AXIS_AUTO) {
        gsl_rng *stream = rng_stream(x->rng, RNG_JITTER, id, 0);
        if (division_is_horizontal(x))
            gsl_ran_dir_2d(stream, &u.x, &u.y);
        else
            gsl_ran_dir_3d(stream, &u.x, &u.y, &u.z);
    }
    return vec3_scale(length, u);
}

void division_lift(const division_context *x, uint32_t cell, uint32_t i) {
    double *p = division_place(x->colony, cell, i), lowest = x->substratum_z + 0.5 * x->colony->cell.diameter[cell];
    if (!x->substratum || p[2] >= lowest)
        return;
    p[2] = lowest;
    x->colony->caps[CAP_LIFTED]++;
}

void division_part(const division_context *x, uint32_t mother, uint32_t daughter, vec3 u) {
    colony *c = x->colony;
    const style_choice *rule = &x->species->list[c->cell.species[mother]].division;
    vec3 centre = vec3_load(division_place(c, mother, 0));
    vec3 jitter = division_jitter(x, rule, c->cell.id[daughter]);
    double r = 0.5 * c->cell.diameter[mother];
    vec3_store(division_place(c, mother, 0), vec3_axpy(centre, -r, u));
    vec3_store(division_place(c, daughter, 0), vec3_add(vec3_axpy(centre, r, u), jitter));
    vec3_store(division_velocity(c, daughter, 0), vec3_load(division_velocity(c, mother, 0)));
    division_lift(x, mother, 0);
    division_lift(x, daughter, 0);
}

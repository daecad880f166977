/* SPDX-License-Identifier: GPL-3.0-or-later */
/* A coccus divides into two that touch, in a direction drawn until neither overlaps a neighbour; after `tries` the one
 * with the least overlap counts. Source: Storck et al. 2014, growth and division. */
#include "biology/division/rules.h"

#include "base/alloc.h"
#include "base/table.h"
#include "model/axis.h"

#include <gsl/gsl_randist.h>
#include <math.h>
#include <stdlib.h>

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

static void place(const division_context *x, uint32_t mother, uint32_t daughter) {
    colony *c = x->colony;
    const style_choice *rule = &x->species->list[c->cell.species[mother]].division;
    vec3 centre = vec3_load(division_place(c, mother, 0)), best = {x->flat, 0, !x->flat};
    double r = 0.5 * c->cell.diameter[mother], least = INFINITY;
    size_t count;
    uint32_t *near = cells_near(c, mother, daughter, division_place(c, mother, 0), &count);
    gsl_rng *stream = rng_stream(x->rng, RNG_DIRECTION, c->cell.id[daughter], 0);
    for (int i = 0; i < (int)rule->values[DIVISION_TRIES].a && least > 0; i++) {
        vec3 u = {0, 0, 0};
        if (x->flat)
            gsl_ran_dir_2d(stream, &u.x, &u.y);
        else
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
    division_part(x, mother, daughter, best);
}

static const param params[] = {
    {"mass:mass~!1(0,1e-9kg)", "mass above which a cell divides"},
    {"diameter:length~!1(0,)", "or its diameter"},
    RULES_JITTER_PARAMS,
    {"tries=100:int[1,)", "directions drawn in search of one without overlap"},
};

const division_style division_random = {
    .name = "random",
    .head = "random",
    .summary = "a coccus divides in a random free direction",
    .source = "Storck et al. 2014, growth and division",
    .example = "division cf random mass 6e-16kg sd 5% jitter 10nm axis auto tries 100\n"
               "division cf random diameter 1um",
    .shapes = DIVISION_COCCI,
    .params = params,
    .nparams = TABLE_COUNT(params),
    .place = place,
};

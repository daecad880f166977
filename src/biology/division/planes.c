/* SPDX-License-Identifier: GPL-3.0-or-later */
/* A coccus divides along the axes of a frame of its own, which both halves keep: one axis for ever makes chains, two in
 * turn make tetrads, three make packets of eight.
 *
 * The frame (the cell's column) is a rotation; the next division goes along its x axis. Afterwards it is turned within
 * itself so that the next axis comes to stand there: for two planes by 90 degrees about z, for three by 120 degrees
 * about (1, 1, 1). Each axis so stands at 90 degrees to the one before it. A cell that has no frame yet draws one at
 * its first division: on a substratum x and y lie in the plane.
 * Where cells are filially linked, the frame follows the neighbours as they move: a chain that bends goes on along
 * itself.
 * Source: Storck et al. 2014, growth and division;
 * Tzagoloff & Novick 1977, J. Bacteriol. 129:343 (successive planes). */
#include "biology/division/rules.h"

#include "base/quaternion.h"
#include "base/table.h"

#include <gsl/gsl_randist.h>
#include <math.h>

/* From the present axis to the next, by number of planes. */
static const quaternion turns[] = {
    {{0, 0, 0}, 1},
    {{0, 0, M_SQRT1_2}, M_SQRT1_2},
    {{0.5, 0.5, 0.5}, 0.5},
};

static quaternion draw_frame(const division_context *x, uint64_t id) {
    gsl_rng *stream = rng_stream(x->rng, RNG_FRAME, id, 0);
    double q[4] = {0};
    if (division_is_horizontal(x))
        gsl_ran_dir_2d(stream, &q[2], &q[3]);
    else
        gsl_ran_dir_nd(stream, 4, q);
    return quaternion_load(q);
}

/* The frame's axis of the last division, by number of planes. */
static const vec3 last_axes[] = {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}};

/* Unit vector from one coccus to another cell. */
static vec3 towards(const colony *c, uint32_t from, uint32_t to) {
    double centre[3];
    colony_centre(c, to, centre);
    vec3 d = vec3_sub(vec3_load(centre), vec3_load(division_place(c, from, 0)));
    double length = vec3_norm(d);
    return length > 0 ? vec3_scale(1 / length, d) : vec3_of(0, 0, 0);
}

/* The mean direction, with the sense of u, of the neighbours that lie at less than 45 degrees to the axis u; u itself
 * where there is none. */
static vec3 mean_along(const colony *c, uint32_t cell, const uint32_t *neighbours, size_t n, vec3 u) {
    vec3 sum = {0, 0, 0};
    for (size_t i = 0; i < n; i++) {
        vec3 d = towards(c, cell, neighbours[i]);
        double along = vec3_dot(d, u);
        if (fabs(along) > M_SQRT1_2)
            sum = vec3_axpy(sum, along < 0 ? -1 : 1, d);
    }
    double length = vec3_norm(sum);
    return length > 0 ? vec3_scale(1 / length, sum) : u;
}

/* Along a chain: from one neighbour to the other, or to the only one, with the sense of u. However sharply the chain
 * bends there, the two daughters of such a division have one of the neighbours each. */
static vec3 tangent(const colony *c, uint32_t cell, const uint32_t *neighbours, size_t n, vec3 u) {
    vec3 d = towards(c, cell, neighbours[0]);
    if (n > 1)
        d = vec3_sub(d, towards(c, cell, neighbours[1]));
    double length = vec3_norm(d);
    return length > 0 ? vec3_scale((vec3_dot(d, u) < 0 ? -1 : 1) / length, d) : u;
}

/* Neighbours show how the cell has turned: its last axis goes to those that lie along it, then the frame turns about
 * that axis to those along the others. */
static void turn(const division_context *x, uint32_t mother, const uint32_t *neighbours, size_t n) {
    colony *c = x->colony;
    double *frame = c->cell.frame + 4 * (size_t)mother;
    quaternion q = quaternion_load(frame);
    if (n == 0 || (vec3_norm(q.v) == 0 && q.w == 0))
        return;
    int planes = (int)x->species->list[c->cell.species[mother]].division.values[DIVISION_PLANES].a;
    vec3 last = quaternion_rotate(q, last_axes[planes - 1]);
    vec3 now = planes == 1 ? tangent(c, mother, neighbours, n, last) : mean_along(c, mother, neighbours, n, last);
    q = quaternion_multiply(quaternion_between(last, now), q);
    for (int k = 0; k < 3 && planes > 1; k++) {
        vec3 other = quaternion_rotate(q, last_axes[k]), there = mean_along(c, mother, neighbours, n, other);
        vec3 across = vec3_axpy(there, -vec3_dot(there, now), now);
        if (k == planes - 1 || !(vec3_norm(across) > 0))
            continue;
        q = quaternion_multiply(quaternion_between(other, vec3_scale(1 / vec3_norm(across), across)), q);
    }
    quaternion_store(frame, quaternion_normalise(q));
}

static void place(const division_context *x, uint32_t mother, uint32_t daughter) {
    colony *c = x->colony;
    const style_choice *rule = &x->species->list[c->cell.species[mother]].division;
    double *frame = c->cell.frame + 4 * (size_t)mother;
    quaternion q = quaternion_load(frame);
    if (vec3_norm(q.v) == 0 && q.w == 0)
        q = draw_frame(x, c->cell.id[mother]);
    division_part(x, mother, daughter, quaternion_rotate(q, vec3_of(1, 0, 0)));
    q = quaternion_normalise(quaternion_multiply(q, turns[(int)rule->values[DIVISION_PLANES].a - 1]));
    quaternion_store(frame, q);
    quaternion_store(c->cell.frame + 4 * (size_t)daughter, q);
}

static const param params[] = {
    {"mass:mass~!1(0,1e-9kg)", "mass above which a cell divides"},
    {"diameter:length~!1(0,)", "or its diameter"},
    RULES_JITTER_PARAMS,
    {"N:int[1,3]", "planes in turn: 1 makes chains, 2 tetrads, 3 packets of eight"},
    RULES_PAIRS_PARAM,
};

const division_style division_planes = {
    .name = "planes",
    .head = "planes N:int[1,3]",
    .summary = "a coccus divides in one plane, or in two or three in turn",
    .source = "Storck et al. 2014, growth and division",
    .example = "division cf planes 3 mass 6e-16kg jitter 0 axis x\n"
               "division cf planes 2 diameter 1um pairs yes",
    .shapes = DIVISION_COCCI,
    .params = params,
    .nparams = TABLE_COUNT(params),
    .place = place,
    .turn = turn,
};

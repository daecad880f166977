/* SPDX-License-Identifier: GPL-3.0-or-later */
/* A coccus divides along the axes of a frame of its own, which both halves keep: one axis for ever makes chains, two in
 * turn make tetrads, three make packets of eight.
 *
 * The frame (the cell's column) is a rotation; the next division goes along its x axis. Afterwards it is turned within
 * itself so that the next axis comes to stand there: for two planes by 90 degrees about z, for three by 120 degrees
 * about (1, 1, 1). Each axis so stands at 90 degrees to the one before it. A cell that has no frame yet draws one at
 * its first division: on a substratum x and y lie in the plane. Source: Storck et al. 2014, growth and division;
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
    if (x->substratum)
        gsl_ran_dir_2d(stream, &q[2], &q[3]);
    else
        gsl_ran_dir_nd(stream, 4, q);
    return quaternion_load(q);
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
};

const division_style division_planes = {
    .name = "planes",
    .head = "planes N:int[1,3]",
    .summary = "a coccus divides in one plane, or in two or three in turn",
    .source = "Storck et al. 2014, growth and division",
    .example = "division cf planes 3 mass 6e-16kg jitter 0 axis x\n"
               "division cf planes 2 diameter 1um",
    .shapes = DIVISION_COCCI,
    .params = params,
    .nparams = TABLE_COUNT(params),
    .place = place,
};

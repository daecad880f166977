/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Gravity and buoyancy: F_z = -g (rho - rho_fluid) V per particle, V = m / rho its share of the cell's volume.
 *     E = g (rho - rho_fluid) V z
 * Source: Storck et al. 2014 (off in the paper's cases). */
#include "mechanics/force/forces.h"

/* Weight of a particle in the fluid, 1e-21 N. */
static double weight(const double *p, const force_frame *at, const body *b, uint32_t particle) {
    return p[GRAVITY_G] * (b->density - p[GRAVITY_FLUID]) * (at->mass[particle] / b->density);
}

static void add(const double *p, const force_frame *at, size_t begin, size_t end, double *f) {
    for (size_t slot = begin; slot < end; slot++) {
        const body *b = &at->bodies[slot];
        for (uint32_t i = b->first; i < b->first + b->owned; i++)
            f[3 * (size_t)i + 2] += -weight(p, at, b, i);
    }
}

static double energy(const double *p, const force_frame *at, size_t slot) {
    const body *b = &at->bodies[slot];
    double sum = 0;
    for (uint32_t i = b->first; i < b->first + b->owned; i++)
        sum += weight(p, at, b, i) * at->x[3 * (size_t)i + 2];
    return sum;
}

static const param params[] = {
    {"g=9.81m/s2:acceleration[0,)", "acceleration of free fall, along -z"},
    {"fluid=998kg/m3:density[0,)", "density of the liquid"},
};

const force_style force_gravity = {
    .name = "gravity",
    .command = "force",
    .summary = "weight less buoyancy, along -z",
    .formula = "F_z = -g (rho - rho_fluid) V per particle; E = g (rho - rho_fluid) V z",
    .source = "Storck et al. 2014, gravity and buoyancy",
    .example = "force gravity g 9.81m/s2 fluid 998kg/m3",
    .params = params,
    .nparams = sizeof params / sizeof params[0],
    .caps = FORCE_CONSERVATIVE | FORCE_ALONG_Z,
    .add = add,
    .energy = energy,
};

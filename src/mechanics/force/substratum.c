/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Contact of each particle with the plane z = z0, the bulk above it:
 *     F_z = k (r - h) where h = z - z0 < r,   E = k/2 (r - h)^2
 * Source: Storck et al. 2014, Biophys. J. 106:2037, "Cell-substratum collision". */
#include "mechanics/force/forces.h"

/* Depth of a particle in the plane, um; 0 above it. */
static double depth(const double *p, const force_frame *at, const body *b, uint32_t particle) {
    double d = b->radius - (at->x[3 * (size_t)particle + 2] - p[SUBSTRATUM_Z]);
    return d > 0 ? d : 0;
}

static void add(const double *p, const force_frame *at, size_t begin, size_t end, double *f) {
    for (size_t slot = begin; slot < end; slot++) {
        const body *b = &at->bodies[slot];
        for (uint32_t i = b->first; i < b->first + b->owned; i++)
            f[3 * (size_t)i + 2] += p[SUBSTRATUM_K] * depth(p, at, b, i);
    }
}

static double energy(const double *p, const force_frame *at, size_t slot) {
    const body *b = &at->bodies[slot];
    double sum = 0;
    for (uint32_t i = b->first; i < b->first + b->owned; i++) {
        double d = depth(p, at, b, i);
        sum += 0.5 * p[SUBSTRATUM_K] * d * d;
    }
    return sum;
}

static void stiffness(const double *p, const force_frame *at, const uint32_t *slots, size_t n, stiff_list *out) {
    for (size_t i = 0; i < n; i++) {
        const body *b = &at->bodies[slots[i]];
        for (uint32_t particle = b->first; particle < b->first + b->owned; particle++)
            if (depth(p, at, b, particle) > 0)
                force_spring_along_z(out, i, p[SUBSTRATUM_K], particle);
    }
}

static double contact_stiffness(const double *p) {
    return p[SUBSTRATUM_K];
}

static const param params[] = {
    {"z=0:length", "height of the plane"},
    {"k=1e-10N/m:stiffness(0,)", "spring constant of the contact"},
};

const force_style force_substratum = {
    .name = "substratum",
    .command = "substratum",
    .summary = "a plane that cells lie on; the bulk is above it",
    .formula = "F_z = k (r - h) per particle where h = z - z0 < r; E = k/2 (r - h)^2",
    .source = "Storck et al. 2014, cell-substratum collision",
    .example = "substratum plane z 0 k 1e-10N/m",
    .params = params,
    .nparams = sizeof params / sizeof params[0],
    .caps = FORCE_CONSERVATIVE | FORCE_ALONG_Z,
    .add = add,
    .energy = energy,
    .stiffness = stiffness,
    .contact_stiffness = contact_stiffness,
};

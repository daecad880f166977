/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Drag of the liquid on each particle: F = -k v. Integrators that damp exactly leave it out and use the drag itself.
 * Source: Storck et al. 2014, "Damping". */
#include "mechanics/force/forces.h"

DIMENSIONS_INLINE void drag_particle(double k, const double *v, double *f, int dimensions) {
    for (int i = 0; i < dimensions; i++)
        f[i] += -k * v[i];
}

/* A body owns one particle or two. */
DIMENSIONS_INLINE void add_in(const double *p, const force_frame *at, size_t begin, size_t end, double *f,
                              int dimensions) {
    const double k = p[DAMPING_K];
    for (size_t slot = begin; slot < end; slot++) {
        const body *b = &at->bodies[slot];
        const size_t first = (size_t)dimensions * b->first;
        drag_particle(k, at->v + first, f + first, dimensions);
        if (b->owned > 1)
            drag_particle(k, at->v + first + dimensions, f + first + dimensions, dimensions);
    }
}

static void add(const double *p, const force_frame *at, size_t begin, size_t end, double *f) {
    if (at->flat)
        add_in(p, at, begin, end, f, 2);
    else
        add_in(p, at, begin, end, f, 3);
}

static double drag(const double *p) {
    return p[DAMPING_K];
}

static const param params[] = {
    {"k=1e-13N.s/m:drag[0,)", "drag of a particle"},
};

const force_style force_damping = {
    .name = "damping",
    .command = "force",
    .summary = "drag of the liquid on each particle",
    .formula = "F = -k v per particle",
    .source = "Storck et al. 2014, damping",
    .example = "force damping k 1e-13N.s/m",
    .params = params,
    .nparams = sizeof params / sizeof params[0],
    .caps = FORCE_READS_VELOCITY,
    .add = add,
    .drag = drag,
};

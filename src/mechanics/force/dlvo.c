/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Attraction and repulsion between each particle and the substratum across the gap d = h - r, held at or above
 * d0 = clamp/kappa (nearer, the law would be stiffer than the contact):
 *     F_z = C_ES kappa exp(-kappa d) - C_vdW / d^2
 *     E   = C_ES exp(-kappa d) - C_vdW / d        for d > d0, and E(d0) - F_z(d0) (gap - d0) below
 * C_ES: electrostatic coefficient (energy), C_vdW: Hamaker constant times r/6 (energy x length), kappa: inverse Debye
 * length. Source: Storck et al. 2014, "DLVO". */
#include "mechanics/force/forces.h"
#include "mechanics/kernel.h"

#include <math.h>
#include <sleef.h>

static double repulsion(const double *p, double d) {
    return p[DLVO_CES] * Sleef_cinz_expd1_u10purec(-p[DLVO_KAPPA] * d);
}

static double gap(const force_frame *at, const body *b, uint32_t particle) {
    return at->x[3 * (size_t)particle + 2] - force_floor(at) - b->radius;
}

static double held(const double *p, double d) {
    double least = p[DLVO_CLAMP] / p[DLVO_KAPPA];
    return d > least ? d : least;
}

/* Force along z at a held gap. */
static double force(const double *p, double d) {
    return p[DLVO_KAPPA] * repulsion(p, d) - p[DLVO_CVDW] / (d * d);
}

/* Particles of a few bodies at once: the exponential comes by the vector. */
typedef struct batch {
    size_t n;
    uint32_t particle[KERNEL_BATCH], of[KERNEL_BATCH];
    double gap[KERNEL_BATCH], exponent[KERNEL_BATCH], power[KERNEL_BATCH];
} batch;

/* power = exp(-kappa gap) */
static void raise_power(const double *p, const force_frame *at, batch *b) {
    size_t padded = (b->n + KERNEL_LANES - 1) / KERNEL_LANES * KERNEL_LANES;
    for (size_t i = 0; i < b->n; i++)
        b->exponent[i] = -p[DLVO_KAPPA] * b->gap[i];
    for (size_t i = b->n; i < padded; i++)
        b->exponent[i] = 0;
    at->kernel->exponential(padded, b->exponent, b->power);
}

static void flush(const double *p, const force_frame *at, batch *b, double *f) {
    raise_power(p, at, b);
    for (size_t i = 0; i < b->n; i++) {
        double d = b->gap[i], force_z = p[DLVO_KAPPA] * (p[DLVO_CES] * b->power[i]) - p[DLVO_CVDW] / (d * d);
        f[3 * (size_t)b->particle[i] + 2] += force_z;
    }
    b->n = 0;
}

static void add(const double *p, const force_frame *at, size_t begin, size_t end, double *f) {
    batch b;
    b.n = 0;
    for (size_t slot = begin; slot < end; slot++) {
        const body *owner = &at->bodies[slot];
        for (uint32_t i = owner->first; i < owner->first + owner->owned; i++) {
            if (b.n == KERNEL_BATCH)
                flush(p, at, &b, f);
            b.particle[b.n] = i;
            b.gap[b.n++] = held(p, gap(at, owner, i));
        }
    }
    flush(p, at, &b, f);
}

static double energy(const double *p, const force_frame *at, size_t slot) {
    const body *b = &at->bodies[slot];
    double sum = 0;
    for (uint32_t i = b->first; i < b->first + b->owned; i++) {
        double g = gap(at, b, i), d = held(p, g);
        sum += repulsion(p, d) - p[DLVO_CVDW] / d - force(p, d) * (g - d);
    }
    return sum;
}

/* |dF/dz| where the law is not held: it acts as a spring of that constant. */
static void flush_springs(const double *p, const force_frame *at, batch *b, stiff_list *out) {
    raise_power(p, at, b);
    for (size_t i = 0; i < b->n; i++) {
        double d = b->gap[i];
        double k = p[DLVO_KAPPA] * p[DLVO_KAPPA] * (p[DLVO_CES] * b->power[i]) - 2 * p[DLVO_CVDW] / (d * d * d);
        force_spring_along_z(out, b->of[i], fabs(k), b->particle[i]);
    }
    b->n = 0;
}

static void stiffness(const double *p, const force_frame *at, const uint32_t *slots, size_t n, stiff_list *out) {
    batch b;
    b.n = 0;
    for (size_t i = 0; i < n; i++) {
        const body *owner = &at->bodies[slots[i]];
        for (uint32_t particle = owner->first; particle < owner->first + owner->owned; particle++) {
            double d = gap(at, owner, particle);
            if (d != held(p, d))
                continue;
            if (b.n == KERNEL_BATCH)
                flush_springs(p, at, &b, out);
            b.particle[b.n] = particle;
            b.of[b.n] = (uint32_t)i;
            b.gap[b.n++] = d;
        }
    }
    flush_springs(p, at, &b, out);
}

/* Half the steepest slope, which stands at the clamp alone. */
static double contact_stiffness(const double *p) {
    double d = held(p, 0), k = p[DLVO_KAPPA] * p[DLVO_KAPPA] * repulsion(p, d) - 2 * p[DLVO_CVDW] / (d * d * d);
    return 0.5 * fabs(k);
}

static int prepare(const double *p, const force_scene *scene, diag *d) {
    (void)p;
    if (scene->forces->term[FORCE_SUBSTRATUM].on)
        return SARCINA_OK;
    diag_error(d, "force dlvo acts between cells and a substratum, and the scene has none");
    return diag_help(d, "substratum plane z 0 k 1e-10N/m");
}

static const param params[] = {
    {"ces=1e-22N.m:energy[0,)", "electrostatic coefficient"},
    {"cvdw=1e-31N.m2:energylength[0,)", "van der Waals coefficient"},
    {"kappa=5e7/m:wavenumber(0,)", "inverse Debye length"},
    {"clamp=6:number(0,)", "least gap, in Debye lengths"},
};

const force_style force_dlvo = {
    .name = "dlvo",
    .command = "force",
    .summary = "attraction and repulsion between cells and substratum across the gap",
    .formula = "F_z = C_ES kappa exp(-kappa d) - C_vdW/d^2 per particle, d = max(h - r, clamp/kappa)",
    .source = "Storck et al. 2014, DLVO",
    .example = "force dlvo ces 1e-22N.m cvdw 1e-31N.m2 kappa 5e7/m clamp 6",
    .params = params,
    .nparams = sizeof params / sizeof params[0],
    .caps = FORCE_CONSERVATIVE | FORCE_ALONG_Z,
    .prepare = prepare,
    .add = add,
    .energy = energy,
    .stiffness = stiffness,
    .contact_stiffness = contact_stiffness,
};

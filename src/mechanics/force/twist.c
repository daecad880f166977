/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Resistance of a flexible cell against twisting: for each four consecutive particles E = k w (1 - cos(phi - phi0)),
 * phi the torsion of their three segments a, b, c, phi0 that of the rest shape (model/chain.h). With m = a x b, n = b x
 * c: d phi/da = |b| m / m^2,  d phi/dc = |b| n / n^2,  d phi/db = -(a.b d phi/da + c.b d phi/dc) / b^2 These grow
 * without bound as two segments become parallel and phi loses its meaning. So the term fades out there: w = w1 w2, w_i
 * = u^2 (3 - 2 u) with u = sin^2(theta_i) / s^2 below 1, 1 beyond. s is half the sine of the rest shape's turning angle
 * (0.1 where that is straight): the law is the pure cosine wherever the cell has about its shape. Source: this
 * project's design notes, model, section 3; gradients as in Blondel & Karplus 1996, J. Comput. Chem. 17:1132. */
#include "mechanics/force/forces.h"

#include "model/chain.h"

#include <math.h>

/* Below this sine there is no torsion, whatever s is. */
static const double least_sine = 1e-9;

typedef struct torsion {
    double w, cos_phi, sin_phi; /* weight; of the torsion */
    vec3 phi[4];                /* d phi / dx of the four particles */
    vec3 weight[4];             /* dw / dx */
} torsion;

/* Weight of a turn between segments a and b, and its gradients with respect to both. */
static double weigh(const chain *ch, vec3 a, vec3 b, vec3 *by_a, vec3 *by_b) {
    double aa = vec3_dot(a, a), bb = vec3_dot(b, b), ab = vec3_dot(a, b);
    vec3 m = vec3_cross(a, b);
    double square = vec3_dot(m, m) / (aa * bb), u = square / (ch->straight * ch->straight);
    *by_a = *by_b = vec3_of(0, 0, 0);
    if (u >= 1)
        return 1;
    double slope = 6 * u * (1 - u) / (ch->straight * ch->straight) * (-2 * ab / (aa * bb));
    *by_a = vec3_scale(slope, vec3_axpy(b, -ab / aa, a));
    *by_b = vec3_scale(slope, vec3_axpy(a, -ab / bb, b));
    return u * u * (3 - 2 * u);
}

/* From derivatives by the three segments to those by the four particles. */
static void by_particles(vec3 a, vec3 b, vec3 c, vec3 out[4]) {
    out[0] = vec3_scale(-1, a);
    out[1] = vec3_sub(a, b);
    out[2] = vec3_sub(b, c);
    out[3] = c;
}

/* The torsion of particles i ... i + 3; false where it has none. */
static bool find_torsion(const force_frame *at, const chain *ch, uint32_t i, torsion *t) {
    const double *x = at->x + 3 * ((size_t)ch->first + i);
    vec3 a = vec3_sub(vec3_load(x + 3), vec3_load(x)), b = vec3_sub(vec3_load(x + 6), vec3_load(x + 3)),
         c = vec3_sub(vec3_load(x + 9), vec3_load(x + 6));
    vec3 m = vec3_cross(a, b), n = vec3_cross(b, c);
    double mm = vec3_dot(m, m), nn = vec3_dot(n, n), aa = vec3_dot(a, a), bb = vec3_dot(b, b), cc = vec3_dot(c, c);
    double least = least_sine * least_sine;
    if (!(mm > least * aa * bb && nn > least * bb * cc))
        return false;
    chain_torsion(a, b, c, &t->cos_phi, &t->sin_phi);
    double lb = sqrt(bb);
    vec3 by_a = vec3_scale(lb / mm, m), by_c = vec3_scale(lb / nn, n);
    vec3 by_b = vec3_axpy(vec3_scale(-vec3_dot(a, b) / bb, by_a), -vec3_dot(c, b) / bb, by_c);
    by_particles(by_a, by_b, by_c, t->phi);
    vec3 a1, b1, b2, c2;
    double w1 = weigh(ch, a, b, &a1, &b1), w2 = weigh(ch, b, c, &b2, &c2);
    t->w = w1 * w2;
    by_particles(vec3_scale(w2, a1), vec3_axpy(vec3_scale(w2, b1), w1, b2), vec3_scale(w1, c2), t->weight);
    return true;
}

/* 1 - cos(phi - phi0), and its derivative. */
static double excess(const chain *ch, const torsion *t, double *slope) {
    *slope = t->sin_phi * ch->cos_phi - t->cos_phi * ch->sin_phi;
    return 1 - (t->cos_phi * ch->cos_phi + t->sin_phi * ch->sin_phi);
}

static void add_chain(const double *p, const force_frame *at, size_t begin, size_t end, double *f) {
    (void)p;
    for (const chain *ch = at->chains + begin; ch < at->chains + end; ch++)
        for (uint32_t i = 0; ch->twist_k > 0 && i + 3 < ch->count; i++) {
            torsion t;
            if (!find_torsion(at, ch, i, &t))
                continue;
            double slope, above = excess(ch, &t, &slope), *out = f + 3 * ((size_t)ch->first + i);
            for (int j = 0; j < 4; j++) {
                vec3 g = vec3_axpy(vec3_scale(t.w * slope, t.phi[j]), above, t.weight[j]);
                out[3 * j] -= ch->twist_k * g.x;
                out[3 * j + 1] -= ch->twist_k * g.y;
                out[3 * j + 2] -= ch->twist_k * g.z;
            }
        }
}

static double energy_chain(const double *p, const force_frame *at, size_t index) {
    (void)p;
    const chain *ch = &at->chains[index];
    double sum = 0, slope;
    for (uint32_t i = 0; ch->twist_k > 0 && i + 3 < ch->count; i++) {
        torsion t;
        if (find_torsion(at, ch, i, &t))
            sum += ch->twist_k * t.w * excess(ch, &t, &slope);
    }
    return sum;
}

static void stiffness_chain(const double *p, const force_frame *at, size_t index, stiff_list *out) {
    (void)p;
    const chain *ch = &at->chains[index];
    for (uint32_t i = 0; ch->twist_k > 0 && i + 3 < ch->count; i++) {
        torsion t;
        if (!find_torsion(at, ch, i, &t))
            continue;
        stiff_spring *s = force_spring_add(out, 0, ch->twist_k * t.w);
        for (uint32_t j = 0; j < 4; j++) {
            double g[3];
            vec3_store(g, t.phi[j]);
            force_spring_end(s, ch->first + i + j, 1, g);
        }
    }
}

const force_style force_twist = {
    .name = "twist",
    .summary = "resistance of flexible cells against twisting, which gives a helix its hand and pitch",
    .formula = "E = k (1 - cos(phi - phi0)) for each four consecutive particles, phi their torsion",
    .source = "dihedral term of chain models, e.g. Blondel & Karplus 1996, J. Comput. Chem. 17:1132",
    .example = "link twist spiro k 1e-18N.m",
    .caps = FORCE_CONSERVATIVE | FORCE_BALANCED | FORCE_CENTRAL | FORCE_WITHIN_CHAINS,
    .add_chain = add_chain,
    .energy_chain = energy_chain,
    .stiffness_chain = stiffness_chain,
};

/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Resistance of a flexible cell against bending: at each inner particle E = k/2 (theta - theta0)^2, theta the turning
 * angle between its two segments a and b, theta0 that of the rest shape (model/chain.h). With m the unit normal of
 * their plane, of a x b: d theta/d x(i+1) = m x b / |b|^2,   d theta/d x(i-1) = m x a / |a|^2,   d theta/d x(i) = minus
 * both Straight and folded back segments span no plane: where theta0 asks for one, m is seeded. A segment without
 * length has no direction and bends nothing. k = E I / l gives a chain of segments l the bending stiffness E I. Source:
 * this project's design notes, model, section 3; the discrete elastica, e.g. Audoly & Pomeau, Elasticity and Geometry
 * (2010). */
#include "mechanics/force/forces.h"

#include "model/chain.h"

#include <math.h>

/* Below this sine a plane is rounding noise. */
static const double least_sine = 1e-12;

typedef struct joint {
    double theta, sine;
    vec3 m;             /* unit normal */
    vec3 before, after; /* d theta / d x of the particles before and after */
    double la, lb;
} joint;

/* A unit vector at right angles to a, from the particle's key. */
static vec3 seeded_normal(const force_frame *at, const chain *c, uint32_t i, vec3 a, double length) {
    double u[3];
    force_direction(at, body_chain_key(c, i - 1), body_chain_key(c, i + 1), u);
    vec3 normal = vec3_cross(a, vec3_load(u));
    double size = vec3_norm(normal);
    if (!(size > 1e-6 * length)) { /* drawn along a: another */
        force_direction(at, body_chain_key(c, i - 1), body_chain_key(c, i), u);
        normal = vec3_cross(a, vec3_load(u));
    }
    return vec3_scale(1 / vec3_norm(normal), normal);
}

/* The joint at inner particle i; false where a segment has no length. */
static bool find_joint(const force_frame *at, const chain *c, uint32_t i, joint *j) {
    const double *x = at->x + 3 * ((size_t)c->first + i);
    vec3 a = vec3_sub(vec3_load(x), vec3_load(x - 3)), b = vec3_sub(vec3_load(x + 3), vec3_load(x));
    vec3 normal = vec3_cross(a, b);
    double aa = vec3_dot(a, a), bb = vec3_dot(b, b), size = vec3_norm(normal);
    j->la = sqrt(aa);
    j->lb = sqrt(bb);
    if (!(aa > 0 && bb > 0))
        return false;
    j->theta = chain_turn(a, b);
    j->sine = size / (j->la * j->lb);
    j->m = j->sine > least_sine ? vec3_scale(1 / size, normal) : seeded_normal(at, c, i, a, j->la);
    j->before = vec3_scale(1 / aa, vec3_cross(j->m, a));
    j->after = vec3_scale(1 / bb, vec3_cross(j->m, b));
    return true;
}

static void add_to(double *f, double scale, vec3 g) {
    f[0] += scale * g.x;
    f[1] += scale * g.y;
    f[2] += scale * g.z;
}

static void add_chain(const double *p, const force_frame *at, size_t begin, size_t end, double *f) {
    (void)p;
    for (const chain *c = at->chains + begin; c < at->chains + end; c++)
        for (uint32_t i = 1; c->bend_k > 0 && i + 1 < c->count; i++) {
            joint j;
            if (!find_joint(at, c, i, &j))
                continue;
            double *out = f + 3 * ((size_t)c->first + i), torque = -c->bend_k * (j.theta - c->theta);
            add_to(out - 3, torque, j.before);
            add_to(out, -torque, vec3_add(j.before, j.after));
            add_to(out + 3, torque, j.after);
        }
}

static double energy_chain(const double *p, const force_frame *at, size_t index) {
    (void)p;
    const chain *c = &at->chains[index];
    double sum = 0;
    for (uint32_t i = 1; c->bend_k > 0 && i + 1 < c->count; i++) {
        joint j;
        if (find_joint(at, c, i, &j))
            sum += 0.5 * c->bend_k * (j.theta - c->theta) * (j.theta - c->theta);
    }
    return sum;
}

static void add_end(stiff_spring *s, uint32_t particle, vec3 g) {
    double u[3];
    vec3_store(u, g);
    force_spring_end(s, particle, 1, u);
}

/* In the plane of the joint, the gradient of theta; out of it, the part of the Hessian that is not negative: the
 * difference of the two tilts, by (theta - theta0) / sin theta. */
static void stiffness_chain(const double *p, const force_frame *at, size_t index, stiff_list *out) {
    (void)p;
    const chain *c = &at->chains[index];
    for (uint32_t i = 1; c->bend_k > 0 && i + 1 < c->count; i++) {
        joint j;
        if (!find_joint(at, c, i, &j))
            continue;
        uint32_t row = c->first + i;
        stiff_spring *s = force_spring_add(out, 0, c->bend_k);
        add_end(s, row - 1, j.before);
        add_end(s, row, vec3_scale(-1, vec3_add(j.before, j.after)));
        add_end(s, row + 1, j.after);
        double part = j.sine > least_sine ? (j.theta - c->theta) / j.sine : c->theta > 0 ? 0 : 1;
        if (!(part > 0))
            continue;
        s = force_spring_add(out, 0, c->bend_k * fmin(part, 4));
        add_end(s, row - 1, vec3_scale(1 / j.la, j.m));
        add_end(s, row, vec3_scale(-1 / j.la - 1 / j.lb, j.m));
        add_end(s, row + 1, vec3_scale(1 / j.lb, j.m));
    }
}

const force_style force_bend = {
    .name = "bend",
    .summary = "resistance of flexible cells against bending",
    .formula = "E = k/2 (theta - theta0)^2 at each inner particle, theta the turning angle of its two segments",
    .source = "discrete elastica; k = E I / segment length",
    .example = "link bend spiro k 1e-18N.m",
    .caps = FORCE_CONSERVATIVE | FORCE_BALANCED | FORCE_CENTRAL | FORCE_WITHIN_CHAINS,
    .add_chain = add_chain,
    .energy_chain = energy_chain,
    .stiffness_chain = stiffness_chain,
};

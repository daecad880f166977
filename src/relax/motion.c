/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "relax/motion.h"

#include "mechanics/force_style.h"

#include <math.h>
#include <string.h>

void motion_accelerate(motion *mo, const double *x, const double *v, double *a) {
    const double *mass = mechanics_mass(mo->m);
    mechanics_force(mo->m, x, v, a);
    mo->evaluations++;
    for (size_t p = 0; p < mo->n; p++)
        for (size_t k = 0; k < 3; k++)
            a[3 * p + k] /= mass[p];
}

void motion_force(motion *mo, const double *x, double *f) {
    mechanics_force_undamped(mo->m, x, f);
    mo->evaluations++;
}

void motion_force_outside(motion *mo, const double *x, double *f) {
    mechanics_force_outside(mo->m, x, f);
    mo->evaluations++;
}

void motion_accept(motion *mo, const double *x, const double *v, double h, bool last, double t1) {
    memcpy(mo->x, x, 3 * mo->n * sizeof *x);
    memcpy(mo->v, v, 3 * mo->n * sizeof *v);
    mo->time = last ? t1 : mo->time + h;
    mo->steps++;
    if (mo->steps == 1 || h < mo->least_step)
        mo->least_step = h;
    if (h > mo->largest_step)
        mo->largest_step = h;
}

void motion_refuse(motion *mo, cap_kind why) {
    mo->rejected++;
    if (why < CAP_COUNT)
        mo->caps[why]++;
}

double motion_error(const motion *mo, const double *ex, const double *ev, double tolerance) {
    double sum = 0;
    for (size_t i = 0; i < mo->n; i++) {
        size_t p = 3 * (mo->order ? mo->order[i] : i);
        for (size_t k = 0; k < 3; k++) {
            double x = ex[p + k] / tolerance, v = ev[p + k] / tolerance;
            sum += x * x + v * v;
        }
    }
    return mo->n ? sqrt(sum / (6 * (double)mo->n)) : 0;
}

bool motion_is_sane(const motion *mo, const double *x, const double *v, double farthest) {
    const double *radius = mechanics_radius(mo->m);
    size_t lost = 0;
    for (size_t p = 0; p < mo->n; p++) {
        const double *to = x + 3 * p, *from = mo->x + 3 * p, *u = v + 3 * p, limit = farthest * radius[p];
        double d[3] = {to[0] - from[0], to[1] - from[1], to[2] - from[2]};
        lost += d[0] * d[0] + d[1] * d[1] + d[2] * d[2] <= limit * limit ? 0 : 1;
        lost += fabs(u[0]) < HUGE_VAL && fabs(u[1]) < HUGE_VAL && fabs(u[2]) < HUGE_VAL ? 0 : 1;
    }
    return lost == 0;
}

bool motion_is_gentle(const motion *mo, const double *f0, const double *f1, const double *mass, double h) {
    const double *radius = mechanics_radius(mo->m);
    size_t jolts = 0;
    for (size_t p = 0; p < mo->n; p++) {
        const double *before = f0 + 3 * p, *after = f1 + 3 * p, scale = 0.5 * h * h / (mass ? mass[p] : 1);
        double d[3] = {after[0] - before[0], after[1] - before[1], after[2] - before[2]},
               limit = MOTION_GENTLE * radius[p];
        jolts += scale * scale * (d[0] * d[0] + d[1] * d[1] + d[2] * d[2]) <= limit * limit ? 0 : 1;
    }
    return jolts == 0;
}

size_t motion_worst(const motion *mo, const double *values) {
    size_t worst = 0;
    double most = -1;
    for (size_t i = 0; i < mo->n; i++) {
        size_t p = mo->order ? mo->order[i] : i;
        const double *a = values + 3 * p;
        double square = a[0] * a[0] + a[1] * a[1] + a[2] * a[2];
        if (isfinite(square) && square <= most)
            continue;
        worst = p;
        most = square;
        if (!isfinite(square))
            break;
    }
    return worst;
}

double motion_stable_step(double stiffness) {
    return stiffness > 0 ? 1.4 / sqrt(stiffness) : (double)INFINITY;
}

double motion_careful_step(const motion *mo, double stiffness) {
    static const double bearable = 100, least = 0.25, margin = 0.98;
    const double *mass = mechanics_mass(mo->m);
    double heaviest = 0, step = motion_stable_step(stiffness);
    if (!isfinite(step))
        return step;
    for (size_t p = 0; p < mo->n; p++)
        heaviest = fmax(heaviest, mass[p]);
    double radians = sqrt(stiffness) * heaviest / mechanics_drag(mo->m);
    double care = radians > bearable ? fmax(least, sqrt(sqrt(bearable / radians))) : 1;
    return fmax(care * step, margin * mechanics_drag(mo->m) / (stiffness * heaviest));
}

double motion_contact_step(const motion *mo) {
    static const double shortest = 0.2, to_limit = 2 / 1.4;
    double step = to_limit * motion_careful_step(mo, mechanics_contact_stiffness(mo->m));
    return fmax(step, shortest * mo->least);
}

static const char *term_name(force_kind term) {
    return term < FORCE_COUNT ? force_styles[term]->name : "no force";
}

int motion_fail_stiff(motion *mo, size_t particle, double needed, diag *d) {
    const mechanics_culprit c = mechanics_blame(mo->m, mo->x, particle);
    diag_fail(d, SARCINA_NUMERICAL, "cell %llu: %s k %.3g N/m with mass %.3g kg needs steps below %.2g us",
              (unsigned long long)c.cell, term_name(c.stiffest), c.k * 1e-15, c.mass * 1e-15, needed * 1e6);
    return diag_help(d, "steps below %.2g us are not taken: a smaller k, or a larger mass", mo->least * 1e6);
}

int motion_fail_damped(motion *mo, size_t particle, diag *d) {
    double mass = mechanics_mass(mo->m)[particle], k = mechanics_drag(mo->m);
    diag_fail(d, SARCINA_NUMERICAL, "cell %llu: damping k %.3g N.s/m with mass %.3g kg needs steps below %.2g us",
              (unsigned long long)mechanics_blame(mo->m, mo->x, particle).cell, k * 1e-15, mass * 1e-15,
              2e6 * mass / k);
    diag_help(d, "steps below %.2g us are not taken: a smaller k, or a larger mass", mo->least * 1e6);
    return diag_help(d, "integrators verlet and euler, of accuracy draft to balanced, bear any damping");
}

int motion_fail_thrown(motion *mo, size_t particle, double least, diag *d) {
    const mechanics_culprit c = mechanics_blame(mo->m, mo->x, particle);
    diag_fail(d, SARCINA_NUMERICAL, "cell %llu: %s drives it too far in any step down to %.2g us, after %.6g s",
              (unsigned long long)c.cell, term_name(c.strongest), least * 1e6, mo->time);
    return diag_help(d, "cells that lie deep in each other, or a force without bound, cannot be relaxed");
}

/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "relax/motion.h"

#include "mechanics/dimensions.h"
#include "mechanics/force_style.h"

#include <float.h>
#include <math.h>
#include <string.h>

DIMENSIONS_INLINE void divide(size_t n, const double *mass, double *a, size_t dimensions) {
    for (size_t p = 0; p < n; p++)
        for (size_t k = 0; k < dimensions; k++)
            a[dimensions * p + k] /= mass[p];
}

void motion_accelerate(motion *mo, const double *x, const double *v, double *a) {
    const double *mass = mechanics_mass(mo->m);
    mechanics_force(mo->m, x, v, a);
    mo->evaluations++;
    if (mo->dimensions == 2)
        divide(mo->n, mass, a, 2);
    else
        divide(mo->n, mass, a, 3);
}

void motion_force(motion *mo, const double *x, double *f) {
    mechanics_force_undamped(mo->m, x, f);
    mo->evaluations++;
}

void motion_force_outside(motion *mo, const double *x, double *f) {
    mechanics_force_outside(mo->m, x, f);
    mo->evaluations++;
}

static void pass(motion *mo, double h, bool last, double t1) {
    mo->time = last ? t1 : mo->time + h;
    mo->steps++;
    if (mo->steps == 1 || h < mo->least_step)
        mo->least_step = h;
    if (h > mo->largest_step)
        mo->largest_step = h;
}

void motion_accept(motion *mo, const double *x, const double *v, double h, bool last, double t1) {
    memcpy(mo->x, x, mo->components * sizeof *x);
    memcpy(mo->v, v, mo->components * sizeof *v);
    pass(mo, h, last, t1);
}

void motion_hand_over(motion *mo, double *x, double *v, double h, bool last, double t1) {
    mo->x = x;
    mo->v = v;
    pass(mo, h, last, t1);
}

void motion_settle(motion *mo) {
    if (mo->x == mo->home[0])
        return;
    memcpy(mo->home[0], mo->x, mo->components * sizeof *mo->x);
    memcpy(mo->home[1], mo->v, mo->components * sizeof *mo->v);
    mo->x = mo->home[0];
    mo->v = mo->home[1];
}

void motion_refuse(motion *mo, cap_kind why) {
    mo->rejected++;
    if (why < CAP_COUNT)
        mo->caps[why]++;
}

DIMENSIONS_INLINE double error_in(const motion *mo, const double *ex, const double *ev, double tolerance,
                                  size_t dimensions) {
    double sum = 0;
    for (size_t i = 0; i < mo->n; i++) {
        size_t p = dimensions * (mo->order ? mo->order[i] : i);
        for (size_t k = 0; k < dimensions; k++) {
            double x = ex[p + k] / tolerance, v = ev[p + k] / tolerance;
            sum += x * x + v * v;
        }
    }
    return mo->n ? sqrt(sum / (6 * (double)mo->n)) : 0;
}

double motion_error(const motion *mo, const double *ex, const double *ev, double tolerance) {
    return mo->dimensions == 2 ? error_in(mo, ex, ev, tolerance, 2) : error_in(mo, ex, ev, tolerance, 3);
}

DIMENSIONS_INLINE bool is_finite(const double *u, int dimensions) {
    return fabs(u[0]) < HUGE_VAL && fabs(u[1]) < HUGE_VAL && (dimensions < 3 || fabs(u[2]) < HUGE_VAL);
}

DIMENSIONS_INLINE bool is_sane(const motion *mo, const double *x, const double *v, double farthest, int dimensions) {
    const double *radius = mechanics_radius(mo->m);
    size_t lost = 0;
    for (size_t p = 0; p < mo->n; p++) {
        const size_t row = (size_t)dimensions * p;
        const double limit = farthest * radius[p];
        lost += dimensions_apart(x + row, mo->x + row, dimensions) <= limit * limit ? 0 : 1;
        lost += is_finite(v + row, dimensions) ? 0 : 1;
    }
    return lost == 0;
}

bool motion_is_sane(const motion *mo, const double *x, const double *v, double farthest) {
    return mo->dimensions == 2 ? is_sane(mo, x, v, farthest, 2) : is_sane(mo, x, v, farthest, 3);
}

DIMENSIONS_INLINE bool is_gentle(const motion *mo, const double *f0, const double *f1, const double *mass, double h,
                                 int dimensions) {
    const double *radius = mechanics_radius(mo->m);
    size_t jolts = 0;
    for (size_t p = 0; p < mo->n; p++) {
        const size_t row = (size_t)dimensions * p;
        const double scale = 0.5 * h * h / (mass ? mass[p] : 1), limit = MOTION_GENTLE * radius[p];
        jolts += scale * scale * dimensions_apart(f1 + row, f0 + row, dimensions) <= limit * limit ? 0 : 1;
    }
    return jolts == 0;
}

bool motion_is_gentle(const motion *mo, const double *f0, const double *f1, const double *mass, double h) {
    return mo->dimensions == 2 ? is_gentle(mo, f0, f1, mass, h, 2) : is_gentle(mo, f0, f1, mass, h, 3);
}

size_t motion_worst(const motion *mo, const double *values) {
    size_t worst = 0;
    double most = -1;
    for (size_t i = 0; i < mo->n; i++) {
        size_t p = mo->order ? mo->order[i] : i;
        double square = dimensions_square(values + (size_t)mo->dimensions * p, mo->dimensions);
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

/* Of a particle's numbers the largest; without squares, which overflow. */
static double largest_of(const motion *mo, const double *values, size_t particle) {
    double most = 0;
    for (int k = 0; k < mo->dimensions; k++)
        most = fmax(most, fabs(values[(size_t)mo->dimensions * particle + (size_t)k]));
    return most;
}

/* What is wrong before any force acts: a place where numbers are too coarse for a cell's size, or a speed that no step
 * bears. SARCINA_OK: neither. */
static int fail_state(motion *mo, double least, diag *d) {
    static const double coarse = 1e-3; /* radii between one number and the next */
    size_t far = motion_worst(mo, mo->x), fast = motion_worst(mo, mo->v);
    const double *radius = mechanics_radius(mo->m);
    double distance = largest_of(mo, mo->x, far), speed = largest_of(mo, mo->v, fast);
    if (!(distance * DBL_EPSILON <= coarse * radius[far])) {
        diag_fail(d, SARCINA_NUMERICAL,
                  "cell %llu is %.3g m from the origin, where numbers are too coarse for its size",
                  (unsigned long long)mechanics_blame(mo->m, mo->x, far).cell, distance * 1e-6);
        return diag_help(d, "bring the cells near the origin: set all x (x - ...)");
    }
    if (speed * least <= MOTION_FARTHEST * radius[fast])
        return SARCINA_OK;
    diag_fail(d, SARCINA_NUMERICAL, "cell %llu moves at %.3g m/s, too far in any step down to %.2g us",
              (unsigned long long)mechanics_blame(mo->m, mo->x, fast).cell, speed * 1e-6, least * 1e6);
    return diag_help(d, "at rest: set all vx 0, and vy and vz");
}

int motion_fail_thrown(motion *mo, size_t particle, double least, diag *d) {
    int status = fail_state(mo, least, d);
    if (status)
        return status;
    const mechanics_culprit c = mechanics_blame(mo->m, mo->x, particle);
    diag_fail(d, SARCINA_NUMERICAL, "cell %llu: %s drives it too far in any step down to %.2g us, after %.6g s",
              (unsigned long long)c.cell, term_name(c.strongest), least * 1e6, mo->time);
    return diag_help(d, "cells that lie deep in each other, or a force without bound, cannot be relaxed");
}

int motion_fail_descent(motion *mo, size_t particle, diag *d) {
    const mechanics_culprit c = mechanics_blame(mo->m, mo->x, particle);
    diag_fail(d, SARCINA_NUMERICAL, "cell %llu: %s drives it too far in any step of the minimiser, after %llu of them",
              (unsigned long long)c.cell, term_name(c.strongest), (unsigned long long)mo->steps);
    return diag_help(d, "cells that lie deep in each other, or a force without bound, cannot be relaxed");
}

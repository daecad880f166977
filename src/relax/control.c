/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "relax/control.h"

#include <math.h>
#include <sleef.h>

double control_factor(double error, int order) {
    if (!isfinite(error))
        return 0.2;
    if (error == 0)
        return 10;
    double factor = 0.9 * Sleef_cinz_powd1_u10purec(error, -1.0 / order);
    return factor < 0.2 ? 0.2 : factor > 10 ? 10 : factor;
}

double control_first_step(motion *mo, const double *a, double tolerance, int order, double *trial) {
    size_t n = mo->components;
    double *x = trial, *v = trial + n, *a1 = trial + 2 * n, *change = trial + 3 * n;
    /* a rough step in which the state changes by a hundredth of the tolerance, to see the second derivative */
    double slope = motion_error(mo, mo->v, a, tolerance);
    double rough = slope > 1e-15 ? 0.01 / slope : 1e-6;
    for (size_t i = 0; i < n; i++) {
        x[i] = mo->x[i] + rough * mo->v[i];
        v[i] = mo->v[i] + rough * a[i];
    }
    motion_accelerate(mo, x, v, a1);
    for (size_t i = 0; i < n; i++) {
        change[i] = (a1[i] - a[i]) / rough;
        v[i] = (v[i] - mo->v[i]) / rough;
    }
    double curvature = motion_error(mo, v, change, tolerance);
    double largest = slope > curvature ? slope : curvature;
    double step = largest > 1e-15 ? Sleef_cinz_powd1_u10purec(0.01 / largest, 1.0 / order) : 1e-3;
    return isfinite(step) && step > 0 ? step : rough;
}

/* The lightest particle: damping is fastest there. */
static size_t lightest(const motion *mo) {
    const double *mass = mechanics_mass(mo->m);
    size_t least = 0;
    for (size_t p = 1; p < mo->n; p++)
        least = mass[p] < mass[least] ? p : least;
    return least;
}

int control_look(control_limit *limit, motion *mo, diag *d) {
    size_t light = lightest(mo);
    double drag = mechanics_drag(mo->m), damped = (double)INFINITY;
    double stiff = motion_stable_step(mechanics_stiffness_from(mo->m, mo->x, limit->mode));
    if (drag > 0)
        damped = 2 * mechanics_mass(mo->m)[light] / drag;
    limit->steps = 0;
    limit->step = fmin(fmin(stiff, damped), motion_contact_step(mo));
    if (fmin(stiff, damped) >= mo->least)
        return SARCINA_OK;
    return stiff <= damped ? motion_fail_stiff(mo, motion_worst(mo, limit->mode), stiff, d)
                           : motion_fail_damped(mo, light, d);
}

int control_give_up(control_limit *limit, motion *mo, size_t particle, diag *d) {
    int status = control_look(limit, mo, d);
    return status ? status : motion_fail_thrown(mo, particle, CONTROL_LEAST_STEP, d);
}

void control_count(control_limit *limit, const motion *mo, double h) {
    limit->steps = limit->obeyed || h < mo->least ? limit->steps + 1 : 0;
}

int control_watch(control_limit *limit, motion *mo, diag *d) {
    static const int steps_between_looks = 50, steps_in_a_row = 1000;
    bool due = limit->steps >= (limit->obeyed ? steps_between_looks : steps_in_a_row);
    return due ? control_look(limit, mo, d) : SARCINA_OK;
}

double control_most(const control_limit *limit, double most) {
    if (!limit->obeyed || !isfinite(limit->step))
        return most;
    return most > 0 && most < limit->step ? most : limit->step;
}

double control_cut(const motion *mo, double wanted, double most, double t1, bool *last) {
    double h = most > 0 && wanted > most ? most : wanted;
    /* a remainder of rounding is no step of its own */
    double left = t1 - mo->time;
    *last = h >= left * (1 - 1e-9);
    return *last ? left : h;
}

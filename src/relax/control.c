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
    size_t n = 3 * mo->n;
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

double control_cut(const motion *mo, double wanted, double most, double t1, bool *last) {
    double h = most > 0 && wanted > most ? most : wanted;
    /* a remainder of rounding is no step of its own */
    double left = t1 - mo->time;
    *last = h >= left * (1 - 1e-9);
    return *last ? left : h;
}

/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "analysis/extent.h"

#include <math.h>

int extent_thickness(const view *v, const bool *members, double *out, diag *d) {
    (void)d;
    const colony *c = v->colony;
    out[0] = NAN;
    for (size_t row = 0; row < c->cell.count; row++) {
        const double *x = c->particle.x + 3 * (size_t)c->cell.first[row];
        for (size_t p = 0; p < c->cell.nparticles[row] && (!members || members[row]); p++)
            if (!(x[3 * p + 2] <= out[0]))
                out[0] = x[3 * p + 2];
    }
    return SARCINA_OK;
}

/* Sums, by component, the members' centres, or the squares of their distances from `from` where that is given.
 * Returns how many there are. */
static double sum_centres(const view *v, const bool *members, const double *from, double sum[3]) {
    const uint32_t *order = colony_by_id(v->colony);
    double n = 0;
    sum[0] = sum[1] = sum[2] = 0;
    for (size_t i = 0; i < v->colony->cell.count; i++) {
        double x[3];
        if (members && !members[order[i]])
            continue;
        n += 1;
        colony_centre(v->colony, order[i], x);
        for (int k = 0; k < 3; k++)
            sum[k] += from ? (x[k] - from[k]) * (x[k] - from[k]) : x[k];
    }
    return n;
}

int extent_gyration(const view *v, const bool *members, double *out, diag *d) {
    (void)d;
    double mean[3], square[3];
    double n = sum_centres(v, members, NULL, mean);
    for (int k = 0; k < 3; k++)
        mean[k] /= n;
    sum_centres(v, members, mean, square);
    out[0] = n > 0 ? sqrt((square[0] + square[1] + square[2]) / n) : (double)NAN;
    return SARCINA_OK;
}

/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Storck et al. (2014), eq. for C(t): C = (1/K) sum over pairs j < k of (2 cos^2(theta_jk) - 1), K the number of pairs.
 *
 * With the sum Q of u u' over the n unit axes, the sum of (u_j . u_k)^2 over all ordered pairs is |Q|^2 (Frobenius),
 * n of it from j = k; so C = 2 (|Q|^2 - n) / (n (n - 1)) - 1, in one pass. What j = k gives is summed as it is rounded
 * instead of taken as n, so that the difference keeps its digits for few cells. */
#include "analysis/orientation.h"

#include <math.h>

int orientation_measure(const view *v, const bool *members, double *out, diag *d) {
    (void)d;
    colony *c = v->colony;
    const uint32_t *order = colony_by_id(c);
    double n = 0, own = 0, q[3][3] = {{0}};
    for (size_t i = 0; i < c->cell.count; i++) {
        double u[3];
        if (members && !members[order[i]])
            continue;
        colony_axis(c, order[i], u);
        if (u[0] == 0 && u[1] == 0 && u[2] == 0)
            continue;
        n += 1;
        double norm2 = u[0] * u[0] + u[1] * u[1] + u[2] * u[2];
        own += norm2 * norm2;
        for (int a = 0; a < 3; a++)
            for (int b = 0; b < 3; b++)
                q[a][b] += u[a] * u[b];
    }
    double square = 0;
    for (int a = 0; a < 3; a++)
        for (int b = 0; b < 3; b++)
            square += q[a][b] * q[a][b];
    out[0] = n > 1 ? 2 * (square - own) / (n * (n - 1)) - 1 : (double)NAN;
    return SARCINA_OK;
}

/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "analysis/bridging.h"

#include "analysis/cell.h"
#include "analysis/view_cache.h"
#include "base/alloc.h"
#include "base/statistics.h"
#include "base/vec3.h"

#include <math.h>
#include <stdlib.h>

static vec3 centre_of(const view *v, uint32_t row) {
    double x[3];
    colony_centre(v->colony, row, x);
    return vec3_load(x);
}

/* The floc's centre and radius; false without cells that have no filial links. */
static bool find_floc(const view *v, const bool *members, const uint32_t *filial, vec3 *centre, double *radius) {
    const uint32_t *order = colony_by_id(v->colony);
    double *distances = alloc_zeroed(v->colony->cell.count, sizeof *distances);
    size_t n = 0;
    *centre = vec3_of(0, 0, 0);
    for (int pass = 0; pass < 2; pass++) {
        if (pass == 1)
            *centre = vec3_scale(1 / (double)n, *centre);
        n = 0;
        for (size_t i = 0; i < v->colony->cell.count; i++) {
            uint32_t row = order[i];
            if ((members && !members[row]) || filial[row])
                continue;
            if (pass == 0)
                *centre = vec3_add(*centre, centre_of(v, row));
            else
                distances[n] = vec3_norm(vec3_sub(centre_of(v, row), *centre));
            n++;
        }
    }
    *radius = n ? statistics_quantile(distances, n, 0.95) : 0;
    free(distances);
    return n > 0;
}

int bridging_measure(const view *v, const bool *members, double *out, diag *d) {
    (void)d;
    const uint32_t *filial = view_cache_links(v).filial, *order = colony_by_id(v->colony);
    vec3 centre;
    double radius;
    for (int k = 0; k < 4; k++)
        out[k] = NAN;
    if (!find_floc(v, members, filial, &centre, &radius))
        return SARCINA_OK;
    out[0] = out[1] = out[3] = 0;
    out[2] = radius;
    for (size_t i = 0; i < v->colony->cell.count; i++) {
        uint32_t row = order[i];
        double distance = vec3_norm(vec3_sub(centre_of(v, row), centre));
        if ((members && !members[row]) || !filial[row])
            continue;
        out[3] = fmax(out[3], distance);
        if (distance <= radius)
            continue;
        out[0] += cell_length(v, row);
        out[1] += filial[row] == 1;
    }
    return SARCINA_OK;
}

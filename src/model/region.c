/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "model/region.h"

#include "base/alloc.h"

#include <gsl/gsl_randist.h>
#include <math.h>
#include <string.h>

int region_find(const region_table *t, const char *name) {
    for (size_t i = 0; i < t->count; i++)
        if (strcmp(t->list[i].name, name) == 0)
            return (int)i;
    return -1;
}

region *region_add(region_table *t, const char *name) {
    t->list = alloc_grow(t->list, &t->capacity, t->count + 1, sizeof *t->list);
    region *r = &t->list[t->count++];
    memset(r, 0, sizeof *r);
    strncpy(r->name, name, sizeof r->name - 1);
    return r;
}

void region_remove(region_table *t, int row) {
    size_t i = (size_t)row;
    memmove(&t->list[i], &t->list[i + 1], (t->count - i - 1) * sizeof *t->list);
    t->count--;
}

static bool is_inside(const region *r, const double x[3]) {
    if (r->kind == REGION_SPHERE) {
        double d[3] = {x[0] - r->p[0], x[1] - r->p[1], x[2] - r->p[2]};
        return d[0] * d[0] + d[1] * d[1] + d[2] * d[2] <= r->p[3] * r->p[3];
    }
    for (int i = 0; i < 3; i++)
        if (x[i] < r->p[2 * i] || x[i] > r->p[2 * i + 1])
            return false;
    return true;
}

bool region_contains(const region *r, const double x[3]) {
    return is_inside(r, x) != r->outside;
}

bool region_draw(const region *r, gsl_rng *stream, double x[3]) {
    if (r->outside)
        return false;
    if (r->kind == REGION_SPHERE) {
        /* by rejection: no library function of the processor's choosing is in the way of equal bits */
        double u[3], square;
        do {
            for (int i = 0; i < 3; i++)
                u[i] = gsl_ran_flat(stream, -1, 1);
            square = u[0] * u[0] + u[1] * u[1] + u[2] * u[2];
        } while (square > 1);
        for (int i = 0; i < 3; i++)
            x[i] = r->p[i] + r->p[3] * u[i];
        return true;
    }
    for (int i = 0; i < 3; i++)
        if (!isfinite(r->p[2 * i]) || !isfinite(r->p[2 * i + 1]))
            return false;
    for (int i = 0; i < 3; i++)
        x[i] = gsl_ran_flat(stream, r->p[2 * i], r->p[2 * i + 1]);
    return true;
}

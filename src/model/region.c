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

/* The two coordinates across a cylinder's axis. */
static const int across[3][2] = {{1, 2}, {0, 2}, {0, 1}};

static bool is_in_block(const region *r, const double x[3]) {
    for (int i = 0; i < 3; i++)
        if (x[i] < r->p[2 * i] || x[i] > r->p[2 * i + 1])
            return false;
    return true;
}

static bool is_in_cylinder(const region *r, const double x[3]) {
    double a = x[across[r->axis][0]] - r->p[0], b = x[across[r->axis][1]] - r->p[1];
    return a * a + b * b <= r->p[2] * r->p[2] && x[r->axis] >= r->p[3] && x[r->axis] <= r->p[4];
}

static bool is_inside(const region *r, const double x[3]) {
    double d[3] = {x[0] - r->p[0], x[1] - r->p[1], x[2] - r->p[2]};
    switch (r->kind) {
    case REGION_BLOCK:
        return is_in_block(r, x);
    case REGION_SPHERE:
        return d[0] * d[0] + d[1] * d[1] + d[2] * d[2] <= r->p[3] * r->p[3];
    case REGION_CYLINDER:
        return is_in_cylinder(r, x);
    case REGION_PLANE:
        break;
    }
    return d[0] * r->p[3] + d[1] * r->p[4] + d[2] * r->p[5] >= 0;
}

bool region_contains(const region *r, const double x[3]) {
    return is_inside(r, x) != r->outside;
}

const char *region_unbounded(const region *r) {
    static const char *const open[] = {"it has no end along x", "it has no end along y", "it has no end along z"};
    if (r->outside)
        return "it is everything outside of something (side out)";
    if (r->kind == REGION_PLANE)
        return "it is half of space";
    if (r->kind == REGION_CYLINDER && !(isfinite(r->p[3]) && isfinite(r->p[4])))
        return open[r->axis];
    for (int i = 0; i < 3 && r->kind == REGION_BLOCK; i++)
        if (!isfinite(r->p[2 * i]) || !isfinite(r->p[2 * i + 1]))
            return open[i];
    return NULL;
}

/* A point uniform in the ball of radius 1 in n dimensions, by rejection: no library function of the processor's
 * choosing is in the way of equal bits. */
static void draw_unit_ball(gsl_rng *stream, int n, double u[3]) {
    double square;
    do {
        square = 0;
        for (int i = 0; i < n; i++) {
            u[i] = gsl_ran_flat(stream, -1, 1);
            square += u[i] * u[i];
        }
    } while (square > 1);
}

void region_draw(const region *r, gsl_rng *stream, double x[3]) {
    double u[3];
    if (r->kind == REGION_SPHERE) {
        draw_unit_ball(stream, 3, u);
        for (int i = 0; i < 3; i++)
            x[i] = r->p[i] + r->p[3] * u[i];
    } else if (r->kind == REGION_CYLINDER) {
        draw_unit_ball(stream, 2, u);
        for (int i = 0; i < 2; i++)
            x[across[r->axis][i]] = r->p[i] + r->p[2] * u[i];
        x[r->axis] = gsl_ran_flat(stream, r->p[3], r->p[4]);
    } else {
        for (int i = 0; i < 3; i++)
            x[i] = gsl_ran_flat(stream, r->p[2 * i], r->p[2 * i + 1]);
    }
}

bool region_meets_plane(const region *r) {
    switch (r->kind) {
    case REGION_BLOCK:
        return r->p[4] <= 0 && r->p[5] >= 0;
    case REGION_SPHERE:
        return fabs(r->p[2]) <= r->p[3];
    case REGION_CYLINDER: /* along x or y: the second number is z */
        return r->axis == 2 ? r->p[3] <= 0 && r->p[4] >= 0 : fabs(r->p[1]) <= r->p[2];
    case REGION_PLANE:
        break;
    }
    return true;
}

/* Half the width that a ball or disc of radius r, whose centre is at z, has in the plane z = 0. */
static double half_width(double r, double z) {
    return sqrt(fmax(0, r * r - z * z));
}

void region_draw_flat(const region *r, gsl_rng *stream, double x[3]) {
    double u[3];
    x[2] = 0;
    if (r->kind == REGION_SPHERE) {
        draw_unit_ball(stream, 2, u);
        for (int i = 0; i < 2; i++)
            x[i] = r->p[i] + half_width(r->p[3], r->p[2]) * u[i];
    } else if (r->kind == REGION_CYLINDER && r->axis == 2) {
        draw_unit_ball(stream, 2, u);
        for (int i = 0; i < 2; i++)
            x[i] = r->p[i] + r->p[2] * u[i];
    } else if (r->kind == REGION_CYLINDER) {
        double half = half_width(r->p[2], r->p[1]);
        x[across[r->axis][0]] = r->p[0] + gsl_ran_flat(stream, -half, half);
        x[r->axis] = gsl_ran_flat(stream, r->p[3], r->p[4]);
    } else {
        for (int i = 0; i < 2; i++)
            x[i] = gsl_ran_flat(stream, r->p[2 * i], r->p[2 * i + 1]);
    }
}

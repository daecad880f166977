/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "analysis/defects.h"

#include "analysis/cell.h"
#include "base/alloc.h"

#include <math.h>
#include <stdlib.h>

enum { NODES_MAX = 4096 };
static const double reach = 1.5; /* mean cell lengths */

/* The averaged axes: sums over the cells near a node of weight times (cos 2 theta, sin 2 theta). */
typedef struct order_grid {
    size_t nx, ny;
    double low[2], step;
    double *weight, *c, *s; /* (ny x nx) */
} order_grid;

/* A cell with its centre and the direction of its axis in the plane. */
typedef struct needle {
    double x[2], cosine, sine; /* of twice the angle */
} needle;

/* The members that have an axis in the plane, in the order of their ids; *length: their mean. */
static needle *gather(const view *v, const bool *members, size_t *n, double *length) {
    const uint32_t *order = colony_by_id(v->colony);
    needle *list = alloc_zeroed(v->colony->cell.count, sizeof *list);
    *n = 0;
    *length = 0;
    for (size_t i = 0; i < v->colony->cell.count; i++) {
        double u[3], x[3];
        uint32_t row = order[i];
        colony_axis(v->colony, row, u);
        double flat = u[0] * u[0] + u[1] * u[1];
        if ((members && !members[row]) || !(flat > 0))
            continue;
        colony_centre(v->colony, row, x);
        list[(*n)++] = (needle){{x[0], x[1]}, (u[0] * u[0] - u[1] * u[1]) / flat, 2 * u[0] * u[1] / flat};
        *length += cell_length(v, row);
    }
    *length /= (double)*n;
    return list;
}

static order_grid make_grid(const needle *list, size_t n, double length) {
    double high[2] = {-INFINITY, -INFINITY};
    order_grid g = {.low = {INFINITY, INFINITY}, .step = length};
    for (size_t i = 0; i < n; i++)
        for (int k = 0; k < 2; k++) {
            g.low[k] = fmin(g.low[k], list[i].x[k]);
            high[k] = fmax(high[k], list[i].x[k]);
        }
    g.step = fmax(g.step, fmax(high[0] - g.low[0], high[1] - g.low[1]) / (NODES_MAX - 2));
    g.nx = (size_t)((high[0] - g.low[0]) / g.step) + 2;
    g.ny = (size_t)((high[1] - g.low[1]) / g.step) + 2;
    g.weight = alloc_zeroed(g.nx * g.ny, sizeof *g.weight);
    g.c = alloc_zeroed(g.nx * g.ny, sizeof *g.c);
    g.s = alloc_zeroed(g.nx * g.ny, sizeof *g.s);
    return g;
}

/* Adds a cell to the nodes within reach of it. */
static void add_needle(order_grid *g, const needle *cell) {
    double far = reach * g->step;
    size_t begin[2], end[2], size[2] = {g->nx, g->ny};
    for (int k = 0; k < 2; k++) {
        double low = (cell->x[k] - far - g->low[k]) / g->step, high = (cell->x[k] + far - g->low[k]) / g->step;
        begin[k] = low > 0 ? (size_t)ceil(low) : 0;
        end[k] = (size_t)fmin((double)size[k], floor(high) + 1);
    }
    for (size_t j = begin[1]; j < end[1]; j++)
        for (size_t i = begin[0]; i < end[0]; i++) {
            double dx = g->low[0] + (double)i * g->step - cell->x[0], dy = g->low[1] + (double)j * g->step - cell->x[1];
            double near = 1 - (dx * dx + dy * dy) / (far * far);
            if (near <= 0)
                continue;
            size_t node = j * g->nx + i;
            g->weight[node] += near * near;
            g->c[node] += near * near * cell->cosine;
            g->s[node] += near * near * cell->sine;
        }
}

/* How often the averaged axis turns by half a turn, anticlockwise, around the square above and right of a node; *known:
 * all its corners have cells and an axis. */
static int turns(const order_grid *g, size_t i, size_t j, bool *known) {
    const size_t corners[5] = {j * g->nx + i, j * g->nx + i + 1, (j + 1) * g->nx + i + 1, (j + 1) * g->nx + i,
                               j * g->nx + i};
    double turned = 0;
    *known = true;
    for (int k = 0; k < 4; k++) {
        size_t a = corners[k], b = corners[k + 1];
        if (!(g->weight[a] > 0.1) || (g->c[a] == 0 && g->s[a] == 0))
            *known = false;
        turned += atan2(g->c[a] * g->s[b] - g->s[a] * g->c[b], g->c[a] * g->c[b] + g->s[a] * g->s[b]);
    }
    return *known ? (int)lround(turned / (2 * M_PI)) : 0;
}

int defects_measure(const view *v, const bool *members, double *out, diag *d) {
    (void)d;
    size_t n, squares = 0;
    double length, plus = 0, minus = 0;
    needle *list = gather(v, members, &n, &length);
    out[0] = out[1] = out[2] = out[3] = NAN;
    if (n) {
        order_grid g = make_grid(list, n, length);
        for (size_t i = 0; i < n; i++)
            add_needle(&g, &list[i]);
        for (size_t j = 0; j + 1 < g.ny; j++)
            for (size_t i = 0; i + 1 < g.nx; i++) {
                bool known;
                int q = turns(&g, i, j, &known);
                squares += known;
                plus += q > 0 ? q : 0;
                minus -= q < 0 ? q : 0;
            }
        out[0] = plus + minus;
        out[1] = plus;
        out[2] = minus;
        out[3] = (plus + minus) / ((double)squares * g.step * g.step);
        free(g.weight);
        free(g.c);
        free(g.s);
    }
    free(list);
    return SARCINA_OK;
}

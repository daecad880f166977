/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "analysis/texture.h"

#include "analysis/cell.h"
#include "base/alloc.h"
#include "base/vec3.h"

#include <gsl/gsl_fit.h>
#include <math.h>
#include <stdlib.h>

enum { RADII = 16, PIECES = 8 };

/* The mass of the members as points: each segment of a cell is cut in pieces of equal mass. */
typedef struct mass_points {
    double *x;    /* (n x 3) um; later their distances from the centre, in the first n */
    double *mass; /* (n) pg */
    size_t n;
    double diameter; /* mean over the cells */
} mass_points;

static void add_segment(mass_points *m, vec3 from, vec3 to, double mass, int pieces) {
    for (int i = 0; i < pieces; i++) {
        double t = (i + 0.5) / pieces;
        vec3_store(m->x + 3 * m->n, vec3_axpy(from, t, vec3_sub(to, from)));
        m->mass[m->n++] = mass / pieces;
    }
}

static mass_points gather(const view *v, const bool *members) {
    const colony *c = v->colony;
    const uint32_t *order = colony_by_id(v->colony);
    size_t room = PIECES * c->particle.count, cells = 0;
    mass_points m = {.x = alloc_resize(NULL, 3 * room, sizeof *m.x), .mass = alloc_resize(NULL, room, sizeof *m.mass)};
    for (size_t i = 0; i < c->cell.count; i++) {
        uint32_t row = order[i], count = c->cell.nparticles[row];
        const double *x = c->particle.x + 3 * (size_t)c->cell.first[row];
        if (members && !members[row])
            continue;
        cells++;
        m.diameter += c->cell.diameter[row];
        if (count == 1)
            add_segment(&m, vec3_load(x), vec3_load(x), c->cell.mass[row], 1);
        for (uint32_t s = 0; s + 1 < count; s++)
            add_segment(&m, vec3_load(x + 3 * (size_t)s), vec3_load(x + 3 * (size_t)s + 3),
                        c->cell.mass[row] / (count - 1), PIECES);
    }
    m.diameter /= (double)cells;
    return m;
}

/* Replaces the points by their distances from the centre of mass; returns the radius of gyration. */
static double centre(mass_points *m) {
    vec3 sum = {0, 0, 0};
    double total = 0, square = 0;
    for (size_t i = 0; i < m->n; i++) {
        sum = vec3_axpy(sum, m->mass[i], vec3_load(m->x + 3 * i));
        total += m->mass[i];
    }
    sum = vec3_scale(1 / total, sum);
    for (size_t i = 0; i < m->n; i++) {
        m->x[i] = vec3_norm(vec3_sub(vec3_load(m->x + 3 * i), sum));
        square += m->mass[i] * m->x[i] * m->x[i];
    }
    return sqrt(square / total);
}

int texture_fractal(const view *v, const bool *members, double *out, diag *d) {
    (void)d;
    mass_points m = gather(v, members);
    double outer = m.n ? centre(&m) : 0, inner = 2 * m.diameter;
    out[0] = NAN;
    if (m.n && outer >= 2 * inner) {
        double x[RADII], y[RADII], intercept, slope, unused[4];
        for (int i = 0; i < RADII; i++) {
            double r = inner * pow(outer / inner, i / (RADII - 1.0)), within = 0;
            for (size_t k = 0; k < m.n; k++)
                within += m.x[k] <= r ? m.mass[k] : 0;
            x[i] = log(r);
            y[i] = log(within);
        }
        gsl_fit_linear(x, 1, y, 1, RADII, &intercept, &slope, &unused[0], &unused[1], &unused[2], &unused[3]);
        out[0] = isfinite(slope) ? slope : (double)NAN; /* an empty middle: no mass within the first radius */
    }
    free(m.x);
    free(m.mass);
    return SARCINA_OK;
}

int texture_verticalised(const view *v, const bool *members, double *out, diag *d) {
    (void)d;
    double n = 0, standing = 0;
    for (uint32_t row = 0; row < v->colony->cell.count; row++) {
        double u[3];
        colony_axis(v->colony, row, u);
        if ((members && !members[row]) || (u[0] == 0 && u[1] == 0 && u[2] == 0))
            continue;
        n += 1;
        standing += u[2] * u[2] > 0.5;
    }
    out[0] = standing / n;
    return SARCINA_OK;
}

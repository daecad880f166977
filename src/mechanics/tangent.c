/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "mechanics/tangent.h"

#include "base/alloc.h"
#include "mechanics/banded.h"
#include "mechanics/dimensions.h"
#include "mechanics/state.h"

#include <stdlib.h>
#include <string.h>

struct tangent {
    mechanics *m;
    stiff_list springs;
    double *matrix; /* (nparticles x dimensions x BANDED_WIDTH): the cells' blocks, factorised in place */
};

tangent *tangent_create(mechanics *m) {
    tangent *t = alloc_zeroed(1, sizeof *t);
    t->m = m;
    t->springs.curved = true;
    t->matrix = alloc_zeroed(state_components(m) * BANDED_WIDTH, sizeof *t->matrix);
    return t;
}

void tangent_free(tangent *t) {
    if (!t)
        return;
    free(t->springs.list);
    free(t->matrix);
    free(t);
}

bool tangent_take(tangent *t, const double *x) {
    if (!state_refresh(t->m, x))
        return false;
    state_springs(t->m, x, true, &t->springs);
    return true;
}

/* What a spring does where its points are moved by y: along it, and where it is stretched against being turned. */
DIMENSIONS_INLINE void pull_back(const stiff_spring *s, const double *y, double *out, size_t width) {
    double along = 0;
    for (uint32_t j = 0; j < s->count; j++)
        for (size_t k = 0; k < width; k++)
            along += s->g[j][k] * y[width * s->particle[j] + k];
    for (uint32_t j = 0; j < s->count; j++)
        for (size_t k = 0; k < width; k++)
            out[width * s->particle[j] + k] += (s->k - s->pull) * along * s->g[j][k];
    if (!(s->pull > 0))
        return;
    const double *first = y + width * s->particle[0], *second = s->count > 1 ? y + width * s->particle[1] : NULL;
    for (size_t k = 0; k < width; k++) {
        double push = s->pull * (first[k] - (second ? second[k] : 0));
        out[width * s->particle[0] + k] += push;
        if (second)
            out[width * s->particle[1] + k] -= push;
    }
}

void tangent_apply(const tangent *t, double shift, const double *y, double *out) {
    for (size_t i = 0; i < state_components(t->m); i++)
        out[i] = shift * y[i];
    for (size_t i = 0; i < t->springs.count; i++)
        if (t->m->flat)
            pull_back(&t->springs.list[i], y, out, 2);
        else
            pull_back(&t->springs.list[i], y, out, 3);
}

static uint32_t cell_of(const mechanics *m, uint32_t particle) {
    return m->bodies[m->owner[particle]].row;
}

/* matrix += k a b' at the rows of particle `row` and the columns of `column`, not after it. */
static void add_block(tangent *t, uint32_t row, uint32_t column, double k, const double a[3], const double b[3]) {
    const size_t width = (size_t)state_dimensions(t->m);
    for (size_t i = 0; i < width; i++) {
        size_t r = width * row + i, first = width * column;
        for (size_t j = 0; j < width && first + j <= r; j++)
            *banded_at(t->matrix, r, first + j) += k * a[i] * b[j];
    }
}

/* The parts of a spring that lie in its cells' blocks. Two ends in one cell too far apart for its band are taken as if
 * each had a spring of twice the constant: more than they have together. */
static void add_spring(tangent *t, const stiff_spring *s) {
    for (uint32_t a = 0; a < s->count; a++)
        for (uint32_t b = 0; b < s->count; b++) {
            uint32_t row = s->particle[a], column = s->particle[b];
            if (a == b || (column < row && row - column <= 3 && cell_of(t->m, row) == cell_of(t->m, column)))
                add_block(t, row, column, s->k - s->pull, s->g[a], s->g[b]);
            else if ((row > column ? row - column : column - row) > 3 && cell_of(t->m, row) == cell_of(t->m, column))
                add_block(t, row, row, s->k, s->g[a], s->g[a]);
        }
}

/* pull (1, -1; -1, 1) on two particles, or pull on one. */
static void add_pull(tangent *t, const stiff_spring *s) {
    static const double axes[3][3] = {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
    bool beside = false, far = false;
    if (s->count > 1 && cell_of(t->m, s->particle[0]) == cell_of(t->m, s->particle[1])) {
        far = abs((int)s->particle[0] - (int)s->particle[1]) > 3;
        beside = !far;
    }
    for (int k = 0; k < state_dimensions(t->m); k++) {
        for (uint32_t j = 0; j < s->count; j++)
            add_block(t, s->particle[j], s->particle[j], (far ? 2 : 1) * s->pull, axes[k], axes[k]);
        if (beside) {
            uint32_t late = s->particle[0] > s->particle[1] ? 0 : 1;
            add_block(t, s->particle[late], s->particle[1 - late], -s->pull, axes[k], axes[k]);
        }
    }
}

void tangent_factor(tangent *t, double shift) {
    const size_t n = state_components(t->m), width = (size_t)state_dimensions(t->m);
    const cell_columns *cells = &t->m->colony->cell;
    memset(t->matrix, 0, n * BANDED_WIDTH * sizeof *t->matrix);
    for (size_t i = 0; i < n; i++)
        *banded_at(t->matrix, i, i) = shift;
    for (size_t i = 0; i < t->springs.count; i++) {
        add_spring(t, &t->springs.list[i]);
        if (t->springs.list[i].pull > 0)
            add_pull(t, &t->springs.list[i]);
    }
    for (size_t c = 0; c < cells->count; c++)
        banded_factor(t->matrix + BANDED_WIDTH * width * cells->first[c], width * cells->nparticles[c]);
}

void tangent_solve(const tangent *t, const double *y, double *out) {
    const cell_columns *cells = &t->m->colony->cell;
    const size_t width = (size_t)state_dimensions(t->m);
    for (size_t c = 0; c < cells->count; c++) {
        size_t first = width * cells->first[c];
        banded_solve(t->matrix + BANDED_WIDTH * first, width * cells->nparticles[c], y + first, out + first);
    }
}

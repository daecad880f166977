/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The stiffest mode: the largest eigenvalue of M^-1 K, K the sum of k g g' over the springs that act at a state, by
 * power iteration on the symmetric M^-1/2 K M^-1/2. Only bare spring constants enter, not the geometric part of the
 * Hessian, whose bounded modes explicit steps need not resolve. */
#include "mechanics/state.h"

#include "base/alloc.h"
#include "base/rng.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

enum { ITERATIONS_FRESH = 60, ITERATIONS_AGAIN = 6 };
static const double tolerance = 0.01;

/* Bodies whose springs are found at once: terms take many together, and their springs are then put in order. */
enum { AT_ONCE = 64 };

/* What the terms have to say of some bodies, term after term: body after body, and the terms of one in their order. */
static void order_springs(const stiff_list *found, const size_t *begin, size_t n, stiff_list *out) {
    size_t next[FORCE_COUNT];
    memcpy(next, begin, sizeof next);
    out->list = alloc_grow(out->list, &out->capacity, out->count + found->count, sizeof *out->list);
    for (size_t i = 0; i < n; i++)
        for (int term = 0; term < FORCE_COUNT; term++)
            for (; next[term] < begin[term + 1] && found->list[next[term]].of == i; next[term]++)
                out->list[out->count++] = found->list[next[term]];
}

void state_springs(const mechanics *m, const double *x, bool chains, stiff_list *out) {
    const force_frame at = state_frame(m, x, NULL);
    stiff_list found = {.curved = out->curved};
    out->count = 0;
    for (size_t rank = 0; rank < m->nbodies; rank += AT_ONCE) {
        const size_t n = rank + AT_ONCE < m->nbodies ? AT_ONCE : m->nbodies - rank;
        size_t begin[FORCE_COUNT + 1] = {0};
        found.count = 0;
        for (int i = 0; i < FORCE_COUNT; i++) {
            if (m->forces.term[i].on && force_styles[i]->stiffness)
                force_styles[i]->stiffness(m->forces.term[i].p, &at, m->by_id + rank, n, &found);
            begin[i + 1] = found.count;
        }
        order_springs(&found, begin, n, out);
    }
    free(found.list);
    for (size_t c = 0; chains && c < m->nchains; c++)
        for (int i = 0; i < FORCE_COUNT; i++)
            if (m->forces.term[i].on && force_styles[i]->stiffness_chain)
                force_styles[i]->stiffness_chain(m->forces.term[i].p, &at, c, out);
}

DIMENSIONS_INLINE double dot_in(const double *a, const double *b, int dimensions) {
    double sum = a[0] * b[0] + a[1] * b[1];
    return dimensions > 2 ? sum + a[2] * b[2] : sum;
}

/* Weights divided by the roots of the particles' masses; sums (nparticles, from 0) of their squares. */
DIMENSIONS_INLINE void weigh(stiff_list *springs, const double *root, double *sums, int dimensions) {
    for (size_t i = 0; i < springs->count; i++) {
        stiff_spring *s = &springs->list[i];
        const double weight = fabs(s->k) * s->count;
        for (uint32_t j = 0; j < s->count; j++) {
            const uint32_t p = s->particle[j];
            for (int k = 0; k < dimensions; k++)
                s->g[j][k] /= root[p];
            sums[p] += weight * dot_in(s->g[j], s->g[j], dimensions);
        }
    }
}

/* The springs that act, weighed. Returns what no eigenvalue is larger than: of a spring with n ends (sum of g . x)^2 <=
 * n sum of |g|^2 |x|^2 (Cauchy, Schwarz). */
static double collect(mechanics *m, const double *x, bool chains) {
    double *root = m->scratch, *sums = root + m->nparticles, most = 0;
    for (size_t p = 0; p < m->nparticles; p++) {
        root[p] = sqrt(m->mass[p]);
        sums[p] = 0;
    }
    state_springs(m, x, chains, &m->stiff);
    if (m->flat)
        weigh(&m->stiff, root, sums, 2);
    else
        weigh(&m->stiff, root, sums, 3);
    for (size_t p = 0; p < m->nparticles; p++)
        most = sums[p] > most ? sums[p] : most;
    return most;
}

/* k g g' mode of one spring with that many ends. */
DIMENSIONS_INLINE void apply_spring(const stiff_spring *s, uint32_t ends, const double *mode, double *out,
                                    int dimensions) {
    const size_t width = (size_t)dimensions;
    double along = 0;
    for (uint32_t j = 0; j < ends; j++)
        along += dot_in(s->g[j], mode + width * s->particle[j], dimensions);
    const double pull = s->k * along;
    for (uint32_t j = 0; j < ends; j++)
        for (size_t k = 0; k < width; k++)
            out[width * s->particle[j] + k] += pull * s->g[j][k];
}

/* Springs of rods in contact (four ends) and within rods (two) are most of all: their loops are unrolled. */
DIMENSIONS_INLINE void apply_in(const mechanics *m, const double *mode, double *out, int dimensions) {
    for (size_t i = 0; i < m->stiff.count; i++) {
        const stiff_spring *s = &m->stiff.list[i];
        if (s->count == 4)
            apply_spring(s, 4, mode, out, dimensions);
        else if (s->count == 2)
            apply_spring(s, 2, mode, out, dimensions);
        else
            apply_spring(s, s->count, mode, out, dimensions);
    }
}

/* out = M^-1/2 K M^-1/2 mode */
static void apply(const mechanics *m, const double *mode, double *out) {
    memset(out, 0, state_components(m) * sizeof *out);
    if (m->flat)
        apply_in(m, mode, out, 2);
    else
        apply_in(m, mode, out, 3);
}

DIMENSIONS_INLINE double sum_in(const mechanics *m, const double *a, const double *b, int dimensions) {
    double sum = 0;
    for (size_t i = 0; i < m->nparticles; i++) {
        size_t p = (size_t)dimensions * m->order[i];
        sum += dot_in(a + p, b + p, dimensions);
    }
    return sum;
}

static double dot(const mechanics *m, const double *a, const double *b) {
    return m->flat ? sum_in(m, a, b, 2) : sum_in(m, a, b, 3);
}

/* a . a, a . b and b . b: three sums side by side take no longer than one. */
typedef struct products {
    double aa, ab, bb;
} products;

DIMENSIONS_INLINE products multiply_in(const mechanics *m, const double *a, const double *b, int dimensions) {
    products sum = {0, 0, 0};
    for (size_t i = 0; i < m->nparticles; i++) {
        const size_t p = (size_t)dimensions * m->order[i];
        sum.aa += dot_in(a + p, a + p, dimensions);
        sum.ab += dot_in(a + p, b + p, dimensions);
        sum.bb += dot_in(b + p, b + p, dimensions);
    }
    return sum;
}

static products multiply(const mechanics *m, const double *a, const double *b) {
    return m->flat ? multiply_in(m, a, b, 2) : multiply_in(m, a, b, 3);
}

static void draw_start(mechanics *m) {
    const size_t width = (size_t)state_dimensions(m);
    m->start = alloc_grow(m->start, &m->start_capacity, state_components(m), sizeof *m->start);
    for (size_t slot = 0; slot < m->nbodies; slot++) {
        const body *b = &m->bodies[slot];
        for (uint32_t i = 0; i < b->owned; i++) {
            double u[3];
            rng_direction(0, body_particle_key(b, b->first + i), 0, u);
            memcpy(m->start + width * (b->first + i), u, width * sizeof *u);
        }
    }
    m->started = true;
}

/* A start with a part in every mode, the same for the same cells: drawn once a binding. */
static void start(mechanics *m, double *mode) {
    if (!m->started)
        draw_start(m);
    memcpy(mode, m->start, state_components(m) * sizeof *mode);
}

/* Has something come to act that is far stiffer than `value`, in which the mode has no part yet? A few steps from a new
 * start see that, unless nothing can be. */
static bool is_stiffer(mechanics *m, double value, double bound) {
    enum { STEPS = 3 };
    static const double far = 10;
    double size = 0, before = 0;
    if (bound * (1 + 1e-9) <= far * value)
        return false;
    double *probe = alloc_zeroed(state_components(m), sizeof *probe);
    start(m, probe);
    for (int i = 0; i < STEPS; i++) {
        before = sqrt(dot(m, probe, probe));
        apply(m, probe, m->scratch);
        size = sqrt(dot(m, m->scratch, m->scratch));
        memcpy(probe, m->scratch, state_components(m) * sizeof *probe);
    }
    free(probe);
    return size > far * value * before;
}

/* By power iteration, from the mode that was found before or from a new start. */
static double iterate(mechanics *m, double *mode, bool again) {
    double value = 0;
    int most = again ? ITERATIONS_AGAIN : ITERATIONS_FRESH;
    if (!again)
        start(m, mode);
    for (int i = 0; i < most; i++) {
        apply(m, mode, m->scratch);
        const products of = multiply(m, mode, m->scratch);
        double before = value, norm = sqrt(of.bb);
        value = of.ab / of.aa;
        if (!(norm > 0))
            return 0;
        for (size_t j = 0; j < state_components(m); j++)
            mode[j] = m->scratch[j] / norm;
        if (fabs(value - before) <= tolerance * value)
            break;
    }
    return value;
}

/* With or without what acts within chains. */
static double find(mechanics *m, const double *x, double *mode, bool chains) {
    if (!state_refresh(m, x))
        return NAN;
    const double bound = collect(m, x, chains);
    if (m->stiff.count == 0)
        return 0;
    bool again = dot(m, mode, mode) > 0;
    double value = iterate(m, mode, again);
    return again && is_stiffer(m, value, bound) ? iterate(m, mode, false) : value;
}

double mechanics_stiffness_from(mechanics *m, const double *x, double *mode) {
    return find(m, x, mode, true);
}

double mechanics_stiffness_outside(mechanics *m, const double *x, double *mode) {
    return find(m, x, mode, false);
}

double mechanics_contact_stiffness(const mechanics *m) {
    double lightest = INFINITY, k = 0;
    for (size_t i = 0; i < m->nparticles; i++)
        lightest = fmin(lightest, m->mass[i]);
    for (int i = 0; i < FORCE_COUNT; i++)
        if (m->forces.term[i].on && force_styles[i]->contact_stiffness)
            k = fmax(k, force_styles[i]->contact_stiffness(m->forces.term[i].p));
    return k / lightest;
}

double mechanics_stiffness(mechanics *m, const double *x) {
    double *mode = alloc_zeroed(state_components(m), sizeof *mode);
    double value = mechanics_stiffness_from(m, x, mode);
    free(mode);
    return value;
}

/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Implicit Euler for what acts within flexible cells. A cell's bending and twisting may be a million times as stiff as
 * its contacts; explicit steps would follow modes that are long at rest. Each cell is a problem of its own: with
 * g = k_d / m and s = x + h v / (1 + g h),
 *     x' = argmin over X of  sum of m (1 + g h) / (2 h^2) |X - s|^2 + E(X),   v' = (x' - x) / h
 * whose condition is Newton's law with damping at the end of the step. Newton's method with the Gauss-Newton matrix of
 * the terms' springs (force_style.stiffness_chain), which is banded, and a line search: every iteration ends lower,
 * however far the cell is from rest; where none can, the cell stays where it is lowest and the flight counts as not
 * solved. Where nothing moves, x' is the exact equilibrium whatever h is.
 *
 * A cell whose rest shape has just changed (growth, division) may be so tense that it would snap in one step. It is let
 * go over several: no particle moves by more than 0.4 radii relative to the cell's mean motion, the rest of the tension
 * waits. Shorter steps would turn it into vibration instead, which nothing in the model damps as fast as it arises.
 * Both this and a step whose minimum was not found in 100 iterations are counted. Source: Hairer & Wanner, Solving
 * Ordinary Differential Equations II, IV; the variational form is Ortiz & Stainier 1999, Comput. Methods Appl. Mech.
 * Eng. 171:419. */
#include "mechanics/state.h"

#include "base/alloc.h"
#include "base/vec3.h"
#include "mechanics/banded.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

enum { ITERATIONS = 100, HALVINGS = 12 };

/* An iteration that moves no particle by more than this many radii is the last. */
static const double tolerance = 1e-4;

/* No step moves a particle by more radii than this within its cell. */
static const double longest_move = 0.4;

/* One chain on its way through a step. */
typedef struct flight {
    mechanics *m;
    const chain *c;
    force_frame at;
    size_t n;                              /* 3 x particles */
    const double *aim;                     /* s (n) */
    const double *heavy;                   /* m (1 + g h) / h^2 (n) */
    double *x;                             /* the trial state: rows of the chain in at.x */
    double *f;                             /* and of the forces there */
    const double *here;                    /* where the cell is (n) */
    double *gradient, *move, *from, *gone; /* (n) */
    double *matrix; /* (n x BANDED_WIDTH): no spring touches more than four consecutive particles */
    stiff_list *springs;
    double waits, tense; /* energy of what acts within the cell: where it was last evaluated, and at x */
} flight;

static bool is_within(const mechanics *m, int term) {
    return m->forces.term[term].on && force_styles[term]->caps & FORCE_WITHIN_CHAINS;
}

/* What is minimised. */
static double value(flight *w) {
    size_t index = (size_t)(w->c - w->m->chains);
    double sum = 0;
    w->waits = 0;
    for (size_t i = 0; i < w->n; i++)
        sum += 0.5 * w->heavy[i] * (w->x[i] - w->aim[i]) * (w->x[i] - w->aim[i]);
    for (int term = 0; term < FORCE_COUNT; term++)
        if (is_within(w->m, term))
            w->waits += force_styles[term]->energy_chain(w->m->forces.term[term].p, &w->at, index);
    sum += w->waits;
    return sum;
}

static void find_gradient(flight *w, double *forces) {
    size_t index = (size_t)(w->c - w->m->chains);
    memset(w->f, 0, w->n * sizeof *w->f);
    for (int term = 0; term < FORCE_COUNT; term++)
        if (is_within(w->m, term))
            force_styles[term]->add_chain(w->m->forces.term[term].p, &w->at, index, index + 1, forces);
    for (size_t i = 0; i < w->n; i++)
        w->gradient[i] = w->heavy[i] * (w->x[i] - w->aim[i]) - w->f[i];
}

static void add_to_matrix(flight *w, const stiff_spring *s) {
    for (uint32_t a = 0; a < s->count; a++)
        for (uint32_t b = 0; b <= a; b++) {
            /* springs list their particles from the first on */
            size_t row = 3 * (size_t)(s->particle[a] - w->c->first),
                   column = 3 * (size_t)(s->particle[b] - w->c->first);
            for (size_t i = 0; i < 3; i++)
                for (size_t j = 0; j < 3 && column + j <= row + i; j++)
                    *banded_at(w->matrix, row + i, column + j) += s->k * s->g[a][i] * s->g[b][j];
        }
}

/* Segments are softer than joints by orders of magnitude, and a straight step towards the joints' rest would take them
 * up; a collapsed one has no way back. While energy waits, segments count as stiffer by it, so that joints turn first.
 * As it fades so does this: the convergence stays quadratic (Yamashita & Fukushima 2001, Computing Suppl. 15:239). */
static void stretch_last(flight *w) {
    const double k = w->tense / (w->c->rest * w->c->rest);
    for (uint32_t i = 0; i + 1 < w->c->count; i++) {
        stiff_spring s = {.k = k};
        double u[3];
        vec3 d = vec3_sub(vec3_load(w->x + 3 * i + 3), vec3_load(w->x + 3 * i));
        vec3_store(u, vec3_scale(1 / fmax(vec3_norm(d), 1e-9), d));
        force_spring_end(&s, w->c->first + i, -1, u);
        force_spring_end(&s, w->c->first + i + 1, 1, u);
        add_to_matrix(w, &s);
    }
}

static void find_matrix(flight *w) {
    size_t index = (size_t)(w->c - w->m->chains);
    w->springs->count = 0;
    for (int term = 0; term < FORCE_COUNT; term++)
        if (is_within(w->m, term))
            force_styles[term]->stiffness_chain(w->m->forces.term[term].p, &w->at, index, w->springs);
    memset(w->matrix, 0, w->n * BANDED_WIDTH * sizeof *w->matrix);
    for (size_t i = 0; i < w->n; i++)
        *banded_at(w->matrix, i, i) = w->heavy[i];
    for (size_t i = 0; i < w->springs->count; i++)
        add_to_matrix(w, &w->springs->list[i]);
    stretch_last(w);
}

/* move = -matrix^-1 gradient. Positive definite: heavy is positive. */
static void solve(flight *w) {
    banded_factor(w->matrix, w->n);
    for (size_t i = 0; i < w->n; i++)
        w->move[i] = -w->gradient[i];
    banded_solve(w->matrix, w->n, w->move, w->move);
}

/* Not a number where one is not. */
static double largest_move(const flight *w) {
    double most = 0;
    for (size_t i = 0; i < w->n; i += 3) {
        double size = vec3_norm(vec3_load(w->move + i));
        most = size <= most || isnan(most) ? most : size;
    }
    return most;
}

/* Mean of a motion (n) by mass. */
static vec3 mean_of(const flight *w, const double *motion) {
    const double *mass = w->m->mass + w->c->first;
    vec3 sum = {0, 0, 0};
    double whole = 0;
    for (size_t i = 0; i < w->n / 3; i++) {
        sum = vec3_axpy(sum, mass[i], vec3_load(motion + 3 * i));
        whole += mass[i];
    }
    return vec3_scale(1 / whole, sum);
}

/* How far a particle has moved within the cell, at most; leaves the motions in `gone`. */
static double farthest(const flight *w) {
    double most = 0;
    for (size_t i = 0; i < w->n; i++)
        w->gone[i] = w->x[i] - w->here[i];
    vec3 mean = mean_of(w, w->gone);
    for (size_t i = 0; i < w->n; i += 3)
        most = fmax(most, vec3_norm(vec3_sub(vec3_load(w->gone + i), mean)));
    return most;
}

/* How much of `move` may be gone: to where a segment has changed by half: a joint's angle means nothing beyond a
 * segment turned inside out. */
static double part_smooth(const flight *w) {
    static const double change = 0.5, short_segment = 0.1;
    double part = 1;
    for (size_t i = 0; i + 3 < w->n; i += 3) {
        vec3 segment = vec3_sub(vec3_load(w->x + i + 3), vec3_load(w->x + i));
        double by = vec3_norm(vec3_sub(vec3_load(w->move + i + 3), vec3_load(w->move + i)));
        double limit = change * fmax(vec3_norm(segment), short_segment * w->c->rest);
        part = by > limit ? fmin(part, limit / by) : part;
    }
    return part;
}

/* Is what is minimised at x as far below `now` as it must be? Then it is the new value. */
static bool is_lower(flight *w, double drop, double *now) {
    double after = value(w);
    if (!(after <= *now - drop))
        return false;
    *now = after;
    w->tense = w->waits;
    return true;
}

/* x += what the same matrix makes of the gradient at x: back to the floor of a valley whose walls are steep. */
static void correct(flight *w, double *forces) {
    find_gradient(w, forces);
    for (size_t i = 0; i < w->n; i++)
        w->gone[i] = -w->gradient[i];
    banded_solve(w->matrix, w->n, w->gone, w->gone);
    for (size_t i = 0; i < w->n; i++)
        w->x[i] += w->gone[i];
}

/* Goes along `move` by that part, or as far as leads downhill enough; false: nowhere. A straight way soon leaves a
 * valley that bends, as those of stiff angles do, and the value rises where the next iteration would lower it: so it is
 * judged after that has been corrected to second order (Nocedal & Wright, Numerical Optimization, 15.5). */
static bool descend(flight *w, double part, double *now, double *forces) {
    double slope = 0;
    for (size_t i = 0; i < w->n; i++)
        slope -= w->gradient[i] * w->move[i];
    memcpy(w->from, w->x, w->n * sizeof *w->x);
    for (int i = 0; i <= HALVINGS; i++, part *= 0.5) {
        for (size_t j = 0; j < w->n; j++)
            w->x[j] = w->from[j] + part * w->move[j];
        if (is_lower(w, 1e-4 * part * slope, now))
            return true;
        correct(w, forces);
        if (is_lower(w, 1e-4 * part * slope, now))
            return true;
    }
    memcpy(w->x, w->from, w->n * sizeof *w->x);
    return false;
}

/* From where the cell is or from where it would fly freely, whichever is better: one is near the end where it is held,
 * the other where it moves. */
static double begin(flight *w) {
    memcpy(w->x, w->here, w->n * sizeof *w->x);
    double held = value(w), tense = w->waits;
    memcpy(w->x, w->aim, w->n * sizeof *w->x);
    double free_flight = value(w);
    w->tense = w->waits;
    if (free_flight <= held)
        return free_flight;
    w->tense = tense;
    memcpy(w->x, w->here, w->n * sizeof *w->x);
    return held;
}

/* False: not solved in as many iterations as there are. Every iteration ends lower. */
static bool minimise(flight *w, double *forces) {
    double now = begin(w);
    for (int i = 0; i < ITERATIONS; i++) {
        find_gradient(w, forces);
        find_matrix(w);
        solve(w);
        if (largest_move(w) <= tolerance * w->c->radius) {
            for (size_t j = 0; j < w->n; j++)
                w->x[j] += w->move[j];
            return true;
        }
        if (!descend(w, part_smooth(w), &now, forces))
            break;
    }
    return false;
}

/* Shortens the motion, but for its mean by mass, until no particle moves too far within the cell; whether it had to. */
static bool restrain(flight *w) {
    double limit = longest_move * w->c->radius, most = farthest(w);
    if (most <= limit)
        return false;
    vec3 mean = mean_of(w, w->gone);
    for (size_t i = 0; i < w->n; i += 3) {
        vec3 within = vec3_sub(vec3_load(w->gone + i), mean);
        vec3_store(w->x + i, vec3_add(vec3_load(w->here + i), vec3_axpy(mean, limit / most, within)));
    }
    return true;
}

/* Memory of one thread, for the longest chain. */
typedef struct workspace {
    double *memory;
    stiff_list springs;
} workspace;

static mechanics_hits fly(mechanics *m, const chain *c, double h, double *trial, double *forces, workspace *space,
                          double *x, double *v) {
    size_t n = 3 * (size_t)c->count, first = 3 * (size_t)c->first;
    double *part = space->memory, drag = mechanics_drag(m);
    flight w = {.m = m,
                .c = c,
                .at = state_frame(m, trial, NULL),
                .n = n,
                .aim = part,
                .heavy = part + n,
                .x = trial + first,
                .f = forces + first,
                .here = x + first,
                .gradient = part + 2 * n,
                .move = part + 3 * n,
                .from = part + 4 * n,
                .gone = part + 5 * n,
                .matrix = part + 6 * n,
                .springs = &space->springs};
    for (size_t i = 0; i < n; i++) {
        double mass = m->mass[c->first + i / 3], slowed = 1 + drag * h / mass;
        part[i] = x[first + i] + h * v[first + i] / slowed;
        part[n + i] = mass * slowed / (h * h);
    }
    bool solved = minimise(&w, forces), held = restrain(&w);
    for (size_t i = 0; i < n; i++) {
        v[first + i] = (w.x[i] - x[first + i]) / h;
        x[first + i] = w.x[i];
    }
    return (mechanics_hits){held, !solved};
}

mechanics_hits mechanics_flight(mechanics *m, double h, double *x, double *v) {
    size_t longest = 0, held = 0, unsolved = 0;
    for (size_t i = 0; i < m->nchains; i++)
        longest = m->chains[i].count > longest ? m->chains[i].count : longest;
    double *trial = alloc_zeroed(3 * m->nparticles, sizeof *trial), *forces = m->scratch;
#pragma omp parallel num_threads(state_threads(m))
    {
        workspace space = {.memory = alloc_zeroed((6 + BANDED_WIDTH) * 3 * longest, sizeof(double))};
#pragma omp for schedule(static) reduction(+ : held, unsolved)
        for (size_t i = 0; i < m->nchains; i++) {
            mechanics_hits hits = fly(m, &m->chains[i], h, trial, forces, &space, x, v);
            held += hits.held;
            unsolved += hits.unsolved;
        }
        free(space.memory);
        free(space.springs.list);
    }
    free(trial);
    return (mechanics_hits){held, unsolved};
}

/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Damped Gauss-Newton descent, a minimiser of the energy: pseudo-transient continuation of overdamped motion.
 *     (mu + K) dx = F,   x += a dx
 * K is the stiffness matrix of the springs that act (mechanics/tangent.h), never negative. mu = k_d / tau, of an
 * implicit Euler step of length tau, falls with the largest force (switched evolution relaxation): mu = caution x fmax,
 * caution half as much after a step taken whole, more after one that had to be cut. What nothing holds moves by
 * 1 / caution at most; what springs hold goes where they rest. There is no inertia, so that a contact is left where it
 * ends, and neither masses nor damping enter.
 *
 * The system is solved by conjugate gradients, preconditioned by the blocks of single cells, to a residual that falls
 * with the force. A step that would move a particle by more than half its radius is cut to that (cells never pass
 * through each other): how long a step is is part of the method here, and no limit on a motion (model/cap.h). It is cut
 * further until the energy falls enough (Armijo), or, where rounding hides that, until the force along it has not
 * turned round (Hager & Zhang 2005, SIAM J. Optim. 16:170); but where the energy rises steeply, not before the steps
 * that follow have been tried (go_on).
 * Sources: Kelley & Keyes 1998, SIAM J. Numer. Anal. 35:508; Nocedal & Wright, Numerical Optimization, 7.1, 10.3 and
 * 15.6. */
#include "relax/integrator.h"

#include "base/alloc.h"
#include "mechanics/dimensions.h"
#include "mechanics/tangent.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

/* Parts of a slope: by how much the energy has to fall, and how much of it may have turned round. */
static const double armijo = 1e-4, turned = 0.8;

/* Of the sum of the energies' sizes: smaller changes are rounding. */
static const double rounding = 1e-10;

/* Caution (1 / radius of the smallest particle): as it begins and near the goal, where small steps to a balance of what
 * is there are better than bold ones to where less would be; within how many times the force to reach that is; bounds.
 */
static const double caution_first = 2, near_goal = 100, caution_least = 0.01, caution_most = 1e12;
/* Its factors after a step taken whole, and one that was cut. */
static const double bolder = 0.5, warier = 2;

/* Steps that are taken on trial where the energy has risen by so many times what it was to fall. */
static const double steep = 10;
enum { WATCHED = 40 };

/* How well the linear system is solved: to this part of the largest force, and so that what nothing holds is moved
 * wrongly by no more than this part of the smallest radius. */
static const double residual_force = 0.1, residual_move = 0.02;

/* In so many steps the largest force has to fall by a tenth, or the energy by what it takes that force to move a
 * particle by a hundredth of the smallest radius, or by a thousandth of itself; the force has to in many more. */
enum { PATIENCE = 300, PATIENCE_FORCE = 20000, HALVINGS = 40 };
static const double progress = 0.9, little = 0.01, little_energy = 1e-3;

typedef struct newton {
    size_t n; /* numbers in x: particles x dimensions */
    tangent *matrix;
    double smallest;      /* radius, um */
    double caution;       /* 1/um */
    double fmax, size;    /* largest force on a particle, and root of the sum of all squared: of the present state */
    double energy, sum;   /* of the present state, and the sum of its terms' sizes */
    double least, low;    /* fmax and the energy have been below these by a part that counts */
    uint64_t idle, since; /* steps since either has, and since fmax has */
    bool started;
    double *force, *trial_force, *x, *dx, *far, *r, *z, *p, *q, *all; /* (n) each; the last owns them */
} newton;

static void *create(const integrator_style *style, const relax_settings *how, const motion *mo) {
    (void)style;
    (void)how;
    newton *self = alloc_zeroed(1, sizeof *self);
    const double *radius = mechanics_radius(mo->m);
    self->n = mo->components;
    self->matrix = tangent_create(mo->m);
    self->smallest = (double)INFINITY;
    for (size_t p = 0; p < mo->n; p++)
        self->smallest = fmin(self->smallest, radius[p]);
    self->all = alloc_zeroed(9 * self->n, sizeof *self->all);
    double **parts[] = {&self->force, &self->trial_force, &self->x, &self->dx, &self->far,
                        &self->r,     &self->z,           &self->p, &self->q};
    for (size_t i = 0; i < sizeof parts / sizeof parts[0]; i++)
        *parts[i] = self->all + i * self->n;
    return self;
}

static void destroy(void *of) {
    newton *self = of;
    tangent_free(self->matrix);
    free(self->all);
    free(self);
}

static void reset(void *of) {
    newton *self = of;
    self->started = false;
}

static void renew(void *of, double stiffness) {
    (void)stiffness;
    reset(of);
}

static const double *force(const void *of) {
    const newton *self = of;
    return self->started ? self->force : NULL;
}

/* In the order of ids: the same bits for any order of rows. */
static double dot(const motion *mo, const double *a, const double *b) {
    const size_t width = (size_t)mo->dimensions;
    double sum = 0;
    for (size_t i = 0; i < mo->n; i++) {
        size_t p = width * (mo->order ? mo->order[i] : i);
        double part = a[p] * b[p] + a[p + 1] * b[p + 1];
        sum += width > 2 ? part + a[p + 2] * b[p + 2] : part;
    }
    return sum;
}

static double largest(const motion *mo, const double *f) {
    double most = 0;
    for (size_t p = 0; p < mo->n; p++)
        most = fmax(most, dimensions_square(f + (size_t)mo->dimensions * p, mo->dimensions));
    return sqrt(most);
}

/* The farthest that a step goes, in parts of what it may. */
static double reach_of(const motion *mo, const double *dx) {
    const double *radius = mechanics_radius(mo->m);
    double most = 0;
    for (size_t p = 0; p < mo->n; p++) {
        double limit = MOTION_FARTHEST * radius[p];
        most = fmax(most, dimensions_square(dx + (size_t)mo->dimensions * p, mo->dimensions) / (limit * limit));
    }
    return sqrt(most);
}

static double energy_at(const motion *mo, const double *x, double *sum) {
    double energy = 0;
    *sum = 0;
    for (int i = 0; i < FORCE_COUNT; i++) {
        double part = mechanics_energy(mo->m, (force_kind)i, x);
        energy += part;
        *sum += fabs(part);
    }
    return energy;
}

/* dx of (mu + K) dx = b, with b in r on entry; K was taken at the state it starts from. */
static void solve(newton *self, motion *mo, double mu) {
    double wanted = fmin(residual_force * largest(mo, self->r), residual_move * self->smallest * mu);
    memset(self->dx, 0, self->n * sizeof *self->dx);
    tangent_factor(self->matrix, mu);
    tangent_solve(self->matrix, self->r, self->z);
    memcpy(self->p, self->z, self->n * sizeof *self->p);
    double rz = dot(mo, self->r, self->z);
    for (size_t i = 0; i < self->n + 10; i++) {
        tangent_apply(self->matrix, mu, self->p, self->q);
        mo->products++;
        double curvature = dot(mo, self->p, self->q), part = rz / curvature;
        if (!(curvature > 0) || !isfinite(part))
            return;
        for (size_t k = 0; k < self->n; k++) {
            self->dx[k] += part * self->p[k];
            self->r[k] -= part * self->q[k];
        }
        if (largest(mo, self->r) <= wanted)
            return;
        tangent_solve(self->matrix, self->r, self->z);
        double before = rz;
        rz = dot(mo, self->r, self->z);
        for (size_t k = 0; k < self->n; k++)
            self->p[k] = self->z[k] + rz / before * self->p[k];
    }
}

typedef struct trial {
    double part, gain, slope, energy, sum;
} trial;

/* Tries x + part dx; whether that is far enough down. */
static bool attempt(newton *self, motion *mo, trial *t) {
    for (size_t i = 0; i < self->n; i++)
        self->x[i] = mo->x[i] + t->part * self->dx[i];
    motion_force(mo, self->x, self->trial_force);
    t->slope = dot(mo, self->trial_force, self->dx);
    t->energy = energy_at(mo, self->x, &t->sum);
    if (!isfinite(t->slope) || !isfinite(t->energy))
        return false;
    if (t->part * t->gain > rounding * self->sum)
        return t->energy <= self->energy - armijo * t->part * t->gain;
    return t->slope >= -turned * t->gain;
}

/* A straight step along contacts that are stiff beside all else leaves the valley that they keep to by its square, and
 * closes others: the energy rises where the next steps would lower it (the effect of Maratos). So before a step is cut
 * the next are taken from where it leads, as long as all of them together go no farther than one may, and judged as
 * one, by the energy: a watchdog. False: dx is as before; x and trial_force are not, which the next attempt sets. */
static bool go_on(newton *self, motion *mo, trial *t) {
    const double gain = t->part * t->gain, mu = self->caution * self->fmax;
    double *dx = self->dx;
    bool lower = false;
    if (!(gain > rounding * self->sum) || !(t->energy - self->energy > steep * gain))
        return false;
    self->dx = self->far;
    for (int i = 0; i < WATCHED && !lower; i++) {
        trial next = {.part = 1, .gain = gain};
        if (!isfinite(dot(mo, self->trial_force, self->trial_force)) || !tangent_take(self->matrix, self->x))
            break;
        memcpy(self->r, self->trial_force, self->n * sizeof *self->r);
        solve(self, mo, mu);
        double reach = reach_of(mo, self->dx), part = reach > 1 ? 1 / reach : 1;
        for (size_t k = 0; k < self->n; k++)
            self->dx[k] = self->x[k] - mo->x[k] + part * self->dx[k];
        if (reach_of(mo, self->dx) > 1)
            break;
        lower = attempt(self, mo, &next);
        if (lower)
            *t = (trial){.part = t->part, .energy = next.energy, .sum = next.sum};
    }
    self->far = self->dx;
    self->dx = dx;
    return lower;
}

/* Along dx as far as leads downhill enough; false: nowhere. */
static bool descend(newton *self, motion *mo, trial *t) {
    for (int i = 0; i < HALVINGS; i++) {
        if (attempt(self, mo, t) || (i == 0 && go_on(self, mo, t)))
            return true;
        motion_refuse(mo, CAP_COUNT);
        double next = t->gain / (t->gain - t->slope);
        t->part *= next > 0.1 && next < 0.5 ? next : next <= 0.1 ? 0.1 : 0.5;
    }
    return false;
}

static void measure(newton *self, const motion *mo) {
    self->fmax = largest(mo, self->force);
    self->size = sqrt(dot(mo, self->force, self->force));
}

static void begin(newton *self, motion *mo) {
    motion_force(mo, mo->x, self->force);
    self->energy = energy_at(mo, mo->x, &self->sum);
    self->caution = caution_first / self->smallest;
    measure(self, mo);
    self->least = self->fmax;
    self->low = self->energy;
    self->idle = self->since = 0;
    self->started = true;
    mo->stuck = false;
}

static void accept(newton *self, motion *mo, const trial *t) {
    double *swap = self->force;
    self->force = self->trial_force;
    self->trial_force = swap;
    memcpy(mo->x, self->x, self->n * sizeof *mo->x);
    memset(mo->v, 0, self->n * sizeof *mo->v);
    mo->steps++;
    self->energy = t->energy;
    self->sum = t->sum;
    measure(self, mo);
}

/* Has it come no further for too long? */
static bool is_stuck(newton *self) {
    double counts = fmin(little * self->fmax * self->smallest, little_energy * self->sum);
    bool calmer = self->fmax < progress * self->least, lower = self->energy < self->low - counts;
    self->since = calmer ? 0 : self->since + 1;
    self->idle = calmer || lower ? 0 : self->idle + 1;
    if (calmer)
        self->least = self->fmax;
    if (calmer || lower)
        self->low = self->energy;
    return self->idle >= PATIENCE || self->since >= PATIENCE_FORCE;
}

/* One step down from the present state; t1 is no bound: nothing here takes time. */
static int step(void *of, motion *mo, double t1, diag *d) {
    (void)t1;
    newton *self = of;
    if (!self->started)
        begin(self, mo);
    while (self->caution <= caution_most / self->smallest) {
        if (!isfinite(self->size) || !isfinite(self->energy) || !tangent_take(self->matrix, mo->x))
            return motion_fail_descent(mo, motion_worst(mo, self->force), d);
        memcpy(self->r, self->force, self->n * sizeof *self->r);
        solve(self, mo, self->caution * self->fmax);
        double reach = reach_of(mo, self->dx);
        trial t = {.part = reach > 1 ? 1 / reach : 1, .gain = dot(mo, self->force, self->dx)};
        double whole = t.part;
        if (t.gain > 0 && descend(self, mo, &t)) {
            accept(self, mo, &t);
            self->caution *= t.part == whole ? bolder : t.part > 0.3 * whole ? warier : warier * warier;
            double least = self->fmax < near_goal * mo->goal ? caution_first : caution_least;
            self->caution = fmax(self->caution, least / self->smallest);
            mo->stuck = is_stuck(self);
            return SARCINA_OK;
        }
        self->caution *= 1e3;
    }
    mo->stuck = true;
    return SARCINA_OK;
}

const integrator_style integrator_newton = {
    .name = "newton",
    .summary = "damped Gauss-Newton descent, a minimiser, for 'relax to F': to rest, by no motion",
    .source = "Kelley & Keyes 1998",
    .order = 1,
    .caps = INTEGRATOR_MINIMISES,
    .vectors = 21,
    .create = create,
    .step = step,
    .force = force,
    .reset = reset,
    .renew = renew,
    .destroy = destroy,
};

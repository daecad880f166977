/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Splittings that solve damped flight exactly and take their step from the present stiffness.
 *
 * Velocity Verlet: kick, flight h, kick, with g = k_d / m, E = exp(-g h):
 *     v += A F/m;  x += v (1 - E)/g, v *= E;  v += B F/m
 * Semi-implicit Euler: kick h, flight h. Flight taken exactly (instead of drift, damp, drift: the same to (g h)^2/12)
 * makes both right where damping is fast, too: x moves by h F/k_d then, whatever the mass.
 *
 * The kicks of a step come to h: A = h/(1 - E) - 1/g, B = h - A. Without damping both are h/2; where it is fast B is
 * 1/g, and a cell that a force drives through the liquid has the velocity F/k_d. Under a constant force x and v are
 * exact for any h (a step of the exponential integrators: Hochbruck & Ostermann 2010, Acta Numerica 19:209). With h/2
 * twice x would be the same, but v h F/2m: more than F/k_d by (g h/2) coth(g h/2). Euler's velocity is that of the
 * flight, before the force there has acted; once the relaxation is over it gets B F/m, too.
 *
 * Flexible cells may be far too stiff within for such steps: their flight is implicit (mechanics_flight) and holds what
 * acts within them, the kicks hold what acts from outside, and the step is that of the outside.
 *
 * Masses may grow (relax_settings.inertia). The longest stable step goes as the root of the mass, and what the mass
 * does passes: a mode of rate r moves as without inertia to r m / k_d, and those that have not decayed by the time t
 * have r <= 1/t. With a mass of c t k_d inertia changes what still moves by no more than c, whatever t is; steps become
 * longer as the root of t. This is mass scaling, as explicit finite elements have it (Olovsson, Simonsson & Unosson
 * 2005, Int. J. Numer. Meth. Eng. 63:1436); without damping, and with flexible cells, masses stay as they are.
 *
 * A step is refused when it leaves a number that is not finite, or moves a particle by more than half its radius: cells
 * could then pass through each other untouched. It is then halved, and tried at twice its length again later. */
#include "relax/integrator.h"

#include "base/alloc.h"
#include "mechanics/dimensions.h"
#include "mechanics/kernel.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

/* No step is cut to less than this part of the shortest that a scene may need throughout. */
static const double least_refused = 0.02;

/* Of the step that leaves a margin: up to here a step that the script names is taken (2 / omega is Verlet's limit). */
static const double furthest = 1.3;

/* Accepted steps between looks at the stiffness, and before a halved step is tried at twice its length. */
enum { STEPS_BETWEEN_LOOKS = 50, STEPS_TO_RECOVER = 20 };

/* From here on, in g h, the kicks' difference is no small one between large numbers. */
static const double subtracted = 0.25;

/* Masses grow by steps of a seventh, up to as much as was measured. */
static const double heavier_by = 1.15, heaviest = 10;
/* By this many looks more than the others may find that steps below motion.least are needed: a shock passes. */
enum { SHORT_LOOKS = 20 };

typedef struct splitting {
    double fixed, most;
    double fades;        /* masses are this rate x time as large as at first, 1/s; 0: they stay */
    double heavier;      /* the masses of the present step are this many times the particles' own */
    double due;          /* when they grow again, s */
    double least_radius; /* of all particles, um */
    size_t n;            /* particles x dimensions */
    bool chains;         /* flexible cells fly on their own */
    bool at_once;        /* Euler: one kick of h */
    bool started;
    bool stale;      /* the force is that of links as they were */
    double bearable; /* what the stiffness bears, s */
    double stable;   /* from the stiffness and the particles' own masses (or as told), s */
    double shorter;  /* 1, 1/2, 1/4 ... after refusals */
    double h;        /* the step: divides the time left evenly */
    uint64_t left;   /* steps left of it */
    int since_look, since_refusal, short_looks;
    mechanics_hits hits;           /* of the trial */
    double factors_for[2];         /* the step and growth of masses that the factors hold for */
    double least_landing;          /* the least of landing beside h / (2 m) */
    double *kick, *decay, *flight; /* of each component (n): A / m, of Euler h / m; E; (1 - E)/g */
    double *landing;               /* B / m (n) */
    double *force, *trial_force, *x, *v, *mode, *memory; /* x, v: of the trial */
    double *own[2];                                      /* ... where it is not in the colony's rows */
} splitting;

/* With inertia c: c k_d / m, of the heaviest particle. */
static double fading_rate(const relax_settings *how, const motion *mo) {
    const double *mass = mechanics_mass(mo->m);
    double most = 0;
    for (size_t p = 0; p < mo->n; p++)
        most = mass[p] > most ? mass[p] : most;
    return how->inertia * mechanics_drag(mo->m) / most;
}

static double least_radius(const motion *mo) {
    const double *radius = mechanics_radius(mo->m);
    double least = (double)INFINITY;
    for (size_t p = 0; p < mo->n; p++)
        least = radius[p] < least ? radius[p] : least;
    return least;
}

static void *create(const integrator_style *style, const relax_settings *how, const motion *mo) {
    (void)style;
    splitting *self = alloc_zeroed(1, sizeof *self);
    self->fixed = how->step;
    self->most = how->most;
    self->n = mo->components;
    self->chains = mechanics_has_chains(mo->m);
    self->at_once = how->integrator == INTEGRATOR_EULER;
    self->memory = alloc_zeroed(9 * self->n, sizeof *self->memory);
    self->force = self->memory;
    self->trial_force = self->force + self->n;
    self->own[0] = self->trial_force + self->n;
    self->own[1] = self->own[0] + self->n;
    self->mode = self->own[1] + self->n;
    self->decay = self->mode + self->n;
    self->kick = self->decay + self->n;
    self->flight = self->kick + self->n;
    self->landing = self->flight + self->n;
    self->shorter = 1;
    self->least_radius = least_radius(mo);
    self->fades = self->fixed > 0 || self->chains ? 0 : fading_rate(how, mo);
    return self;
}

static void reset(void *of) {
    splitting *self = of;
    self->started = false;
}

/* Links that are soft beside what is there wait for the next look at the stiffness. */
static void renew(void *of, double stiffness) {
    static const double matters = 0.1;
    splitting *self = of;
    double omega = 1.4 / self->stable;
    self->stale = true;
    if (stiffness > matters * omega * omega)
        self->since_look = STEPS_BETWEEN_LOOKS;
}

static void destroy(void *of) {
    splitting *self = of;
    free(self->memory);
    free(self);
}

static const double *force(const void *of) {
    const splitting *self = of;
    return self->started && !self->stale && !self->chains ? self->force : NULL;
}

/* The masses of the time that has come. */
static void let_fade(splitting *self, const motion *mo) {
    double heavier = self->fades * mo->time;
    self->heavier = heavier < 1 ? 1 : heavier < heaviest ? heavier : heaviest;
    self->due = heavier < 1 ? heavier_by / self->fades : heavier_by * mo->time;
    if (self->fades <= 0 || heavier >= heaviest)
        self->due = (double)INFINITY;
}

static void keep_masses(splitting *self) {
    self->fades = 0;
    self->heavier = 1;
    self->due = (double)INFINITY;
}

/* Even steps to t1, none longer than the stable one; without an end, that one. */
static void plan(splitting *self, const motion *mo, double t1) {
    double wanted = self->stable * self->shorter * sqrt(self->heavier), left = t1 - mo->time;
    if (!isfinite(left)) {
        self->left = UINT64_MAX;
        self->h = wanted;
        return;
    }
    self->left = wanted < left ? (uint64_t)ceil(left / wanted * (1 - 1e-12)) : 1;
    self->h = left / (double)self->left;
}

/* Takes the step from the stiffness at the present state, which also bounds the one that the script names; false when
 * no step that is worth taking bears it. */
static bool look(splitting *self, motion *mo, double t1) {
    self->since_look = 0;
    double stiffness = mechanics_stiffness_outside(mo->m, mo->x, self->mode);
    double bearable = motion_careful_step(mo, stiffness);
    self->bearable = bearable;
    if (bearable > motion_stable_step(stiffness)) /* inertia limits nothing here */
        keep_masses(self);
    double ready = fmin(bearable, motion_contact_step(mo));
    if (self->fixed > 0)
        self->stable = fmin(self->fixed, furthest * ready);
    else
        self->stable = self->most > 0 && self->most < ready ? self->most : ready;
    if (!isfinite(self->stable))
        self->stable = isfinite(t1) ? t1 - mo->time : 1; /* nothing is stiff */
    plan(self, mo, t1);
    self->short_looks += bearable < mo->least ? 1 : self->short_looks > 0 ? -1 : 0;
    return self->short_looks < SHORT_LOOKS && bearable >= least_refused * mo->least;
}

/* B / h, of z = g h and exp(-z) - 1: 1/z - E/(1 - E), near 0 by its series in Bernoulli's numbers. */
static double share_after(double z, double loss) {
    if (z > subtracted)
        return 1 / z + (1 + loss) / loss;
    const double q = z * z;
    return 0.5 - z * (1. / 12 - q * (1. / 720 - q * (1. / 30240 - q * (1. / 1209600 - q / 47900160))));
}

/* The same of flexible cells, whose flight is implicit: v *= 1 / (1 + g h). */
static const double share_after_implicit = 0;

/* Those of particles begin ... end - 1, FACTORS_AT_ONCE at most. */
enum { FACTORS_AT_ONCE = 8 * KERNEL_LANES };
DIMENSIONS_INLINE void set_some_factors(splitting *self, const motion *mo, size_t begin, size_t end, size_t width) {
    const double *mass = mechanics_mass(mo->m), drag = mechanics_drag(mo->m);
    double rate[FACTORS_AT_ONCE], decayed[FACTORS_AT_ONCE] = {0}, loss[FACTORS_AT_ONCE];
    for (size_t p = begin; p < end; p++) {
        rate[p - begin] = drag / (self->heavier * mass[p]);
        decayed[p - begin] = -rate[p - begin] * self->h;
    }
    mechanics_loops(mo->m)->exponential_less_one(FACTORS_AT_ONCE, decayed, loss);
    for (size_t p = begin; p < end; p++) {
        const double flight = rate[p - begin] > 0 ? -loss[p - begin] / rate[p - begin] : self->h;
        const bool chained = self->chains && mechanics_is_chained(mo->m, p);
        const double after = chained ? share_after_implicit : share_after(-decayed[p - begin], loss[p - begin]);
        const double impulse = self->h / (self->heavier * mass[p]);
        self->least_landing = fmin(self->least_landing, 2 * after);
        for (size_t i = width * p; i < width * (p + 1); i++) {
            self->kick[i] = (self->at_once ? 1 : 1 - after) * impulse;
            self->landing[i] = after * impulse;
            self->decay[i] = chained ? 1 : 1 + loss[p - begin];
            self->flight[i] = chained ? 0 : flight;
        }
    }
}

DIMENSIONS_INLINE void set_factors(splitting *self, const motion *mo, size_t width) {
    for (size_t begin = 0; begin < mo->n; begin += FACTORS_AT_ONCE) {
        size_t end = begin + FACTORS_AT_ONCE;
        set_some_factors(self, mo, begin, end < mo->n ? end : mo->n, width);
    }
}

static void prepare_factors(splitting *self, const motion *mo) {
    if (self->factors_for[0] == self->h && self->factors_for[1] == self->heavier)
        return;
    self->least_landing = 1;
    if (mo->dimensions == 2)
        set_factors(self, mo, 2);
    else
        set_factors(self, mo, 3);
    self->factors_for[0] = self->h;
    self->factors_for[1] = self->heavier;
}

/* A kick and a flight, of all components; false: refused. That none has gone far along any axis is seen in passing and
 * suffices; else each particle is looked at. */
static bool fly(splitting *self, const motion *mo) {
    const bool away = mo->x == self->own[0];
    self->x = away ? mo->home[0] : self->own[0];
    self->v = away ? mo->home[1] : self->own[1];
    const kernel_flight q = {.kick = self->kick,
                             .decay = self->decay,
                             .flight = self->flight,
                             .x0 = mo->x,
                             .v0 = mo->v,
                             .force = self->force,
                             .x = self->x,
                             .v = self->v,
                             .near = MOTION_FARTHEST * self->least_radius / sqrt(mo->dimensions) * (1 - 1e-12)};
    size_t far = mechanics_loops(mo->m)->fly(self->n, &q);
    if (!self->chains)
        return far == 0 || motion_is_sane(mo, self->x, self->v, MOTION_FARTHEST);
    self->hits = mechanics_flight(mo->m, self->h, self->x, self->v);
    return motion_is_sane(mo, self->x, self->v, MOTION_FARTHEST);
}

/* The second kick of a step (weight 0: none); false: refused. That the force has changed by little along every axis is
 * seen in passing and suffices. */
static bool land(splitting *self, const motion *mo, double weight) {
    const double *before = self->force, *after = self->trial_force;
    double little = MOTION_GENTLE * self->least_radius / sqrt(mo->dimensions) * (1 - 1e-12) / self->h;
    little *= self->least_landing;
    size_t jolted = mechanics_loops(mo->m)->kick(self->n, weight, self->landing, before, after, little, self->v);
    return jolted == 0 || motion_is_gentle(mo, before, after, mechanics_mass(mo->m), self->h / sqrt(self->heavier));
}

/* One trial of velocity Verlet: what refuses it; CAP_COUNT: nothing. */
static cap_kind try_verlet(splitting *self, motion *mo) {
    if (!fly(self, mo))
        return CAP_FAR;
    motion_force_outside(mo, self->x, self->trial_force);
    return land(self, mo, 1) ? CAP_COUNT : CAP_JOLT;
}

/* The same of semi-implicit Euler. */
static cap_kind try_euler(splitting *self, motion *mo) {
    if (!fly(self, mo))
        return CAP_FAR;
    motion_force_outside(mo, self->x, self->trial_force);
    return land(self, mo, 0) ? CAP_COUNT : CAP_JOLT;
}

static void accept(splitting *self, motion *mo, double t1) {
    motion_hand_over(mo, self->x, self->v, self->h, self->left == 1, t1);
    mo->caps[CAP_HELD] += self->hits.held;
    mo->caps[CAP_UNSOLVED] += self->hits.unsolved;
    double *swap = self->force;
    self->force = self->trial_force;
    self->trial_force = swap;
    self->left--;
    self->since_look++;
    self->since_refusal++;
    if (self->shorter < 1 && self->since_refusal >= STEPS_TO_RECOVER) {
        self->shorter *= 2;
        self->since_refusal = 0;
        self->left = 0; /* plan anew */
    }
}

/* A step to begin with; false when there is none. */
static bool begin(splitting *self, motion *mo, double t1) {
    if (!self->started) {
        motion_force_outside(mo, mo->x, self->force);
        memset(self->mode, 0, self->n * sizeof *self->mode);
        self->shorter = 1;
        self->started = true;
        self->stale = false;
        let_fade(self, mo);
        return look(self, mo, t1);
    }
    if (self->stale)
        motion_force_outside(mo, mo->x, self->force);
    self->stale = false;
    if (self->since_look >= STEPS_BETWEEN_LOOKS)
        return look(self, mo, t1);
    if (mo->time >= self->due) {
        let_fade(self, mo);
        self->left = 0;
    }
    if (self->left == 0)
        plan(self, mo, t1);
    return true;
}

static int step(splitting *self, motion *mo, double t1, cap_kind (*attempt)(splitting *, motion *), diag *d) {
    if (!begin(self, mo, t1))
        return motion_fail_stiff(mo, motion_worst(mo, self->mode), self->bearable, d);
    for (;;) {
        prepare_factors(self, mo);
        cap_kind met = attempt(self, mo);
        if (met == CAP_COUNT) {
            accept(self, mo, t1);
            return SARCINA_OK;
        }
        motion_refuse(mo, met);
        self->shorter *= 0.5;
        self->since_refusal = 0;
        if (!(self->stable * self->shorter >= least_refused * mo->least))
            return motion_fail_thrown(mo, motion_worst(mo, self->force), least_refused * mo->least, d);
        plan(self, mo, t1);
    }
}

static int step_verlet(void *self, motion *mo, double t1, diag *d) {
    return step(self, mo, t1, try_verlet, d);
}

static int step_euler(void *self, motion *mo, double t1, diag *d) {
    return step(self, mo, t1, try_euler, d);
}

/* Of Euler: what the force where the last step ended still owes its velocity. */
static void finish(void *of, motion *mo) {
    const splitting *self = of;
    for (size_t i = 0; mo->steps && i < self->n; i++)
        mo->v[i] += self->landing[i] * self->force[i];
}

const integrator_style integrator_verlet = {
    .name = "verlet",
    .summary = "velocity Verlet with exact damping",
    .source = "Stoermer-Verlet, damped flight exact",
    .order = 2,
    .caps = INTEGRATOR_EXACT_DAMPING,
    .vectors = 9,
    .create = create,
    .step = step_verlet,
    .force = force,
    .reset = reset,
    .renew = renew,
    .destroy = destroy,
};

const integrator_style integrator_euler = {
    .name = "euler",
    .summary = "semi-implicit Euler with exact damping",
    .source = "symplectic Euler, damped flight exact",
    .order = 1,
    .caps = INTEGRATOR_EXACT_DAMPING,
    .vectors = 9,
    .create = create,
    .step = step_euler,
    .finish = finish,
    .force = force,
    .reset = reset,
    .renew = renew,
    .destroy = destroy,
};

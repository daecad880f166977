/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Explicit Runge-Kutta pairs whose last stage is the next step's first: Dormand-Prince 5(4) and Bogacki-Shampine 3(2).
 * Sources: Dormand & Prince 1980, J. Comput. Appl. Math. 6:19; Bogacki & Shampine 1989, Appl. Math. Lett. 2:321. */
#include "relax/integrator.h"

#include "base/alloc.h"
#include "mechanics/dimensions.h"
#include "relax/control.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

enum { STAGES_MAX = 7, AT_ONCE = 8 };

/* A pair: stage i starts from y + h sum_j a[i][j] k_j; the last row of a gives the new state; e its error. */
typedef struct tableau {
    int stages;
    double a[STAGES_MAX][STAGES_MAX - 1];
    double e[STAGES_MAX];
} tableau;

static const tableau dormand_prince = {
    7,
    {{0},
     {1.0 / 5},
     {3.0 / 40, 9.0 / 40},
     {44.0 / 45, -56.0 / 15, 32.0 / 9},
     {19372.0 / 6561, -25360.0 / 2187, 64448.0 / 6561, -212.0 / 729},
     {9017.0 / 3168, -355.0 / 33, 46732.0 / 5247, 49.0 / 176, -5103.0 / 18656},
     {35.0 / 384, 0, 500.0 / 1113, 125.0 / 192, -2187.0 / 6784, 11.0 / 84}},
    {71.0 / 57600, 0, -71.0 / 16695, 71.0 / 1920, -17253.0 / 339200, 22.0 / 525, -1.0 / 40}};

static const tableau bogacki_shampine = {
    4, {{0}, {1.0 / 2}, {0, 3.0 / 4}, {2.0 / 9, 1.0 / 3, 4.0 / 9}}, {-5.0 / 72, 1.0 / 12, 1.0 / 9, -1.0 / 8}};

typedef struct embedded {
    const integrator_style *style;
    const tableau *table;
    double tolerance, most, fixed, h;
    size_t n;                              /* particles x dimensions */
    bool started;                          /* h holds */
    bool stale;                            /* the first stage does not */
    double *v[STAGES_MAX], *a[STAGES_MAX]; /* derivatives of x and v at the stages (n each) */
    double *trial;                         /* (4 n): x, room for a first step, errors of x and v */
    control_limit limit;
    double *memory;
} embedded;

static void *create(const integrator_style *style, const relax_settings *how, const motion *mo) {
    embedded *self = alloc_zeroed(1, sizeof *self);
    self->style = style;
    self->table = style->method;
    self->tolerance = how->tolerance > 0 ? how->tolerance : style->tolerance;
    self->most = how->most;
    self->fixed = how->step;
    self->n = mo->components;
    self->memory = alloc_zeroed((2 * STAGES_MAX + 5) * self->n, sizeof *self->memory);
    for (size_t i = 0; i < STAGES_MAX; i++) {
        self->v[i] = self->memory + 2 * i * self->n;
        self->a[i] = self->memory + (2 * i + 1) * self->n;
    }
    self->trial = self->memory + 2 * STAGES_MAX * self->n;
    self->limit.mode = self->trial + 4 * self->n;
    self->limit.obeyed = self->fixed > 0;
    return self;
}

static void reset(void *of) {
    embedded *self = of;
    self->started = false;
}

/* The error of the steps to come finds a step that the new forces bear. */
static void renew(void *of, double stiffness) {
    (void)stiffness;
    embedded *self = of;
    self->stale = true;
}

static void destroy(void *of) {
    embedded *self = of;
    free(self->memory);
    free(self);
}

/* out = base + h sum_j weight[j] k[j] over the first `count` stages, components begin ... begin + width - 1; base NULL:
 * 0. */
DIMENSIONS_INLINE void combine_some(size_t begin, size_t width, const double *base, double h, const double *weight,
                                    double *const *k, int count, double *out) {
    double sum[AT_ONCE] = {0};
    for (int j = 0; j < count; j++)
        for (size_t i = 0; i < width; i++)
            sum[i] += weight[j] * k[j][begin + i];
    for (size_t i = 0; i < width; i++)
        out[begin + i] = (base ? base[begin + i] : 0) + h * sum[i];
}

/* All n of them, AT_ONCE by AT_ONCE: as many sums as stay in registers. */
static void combine(size_t n, const double *base, double h, const double *weight, double *const *k, int count,
                    double *out) {
    const size_t whole = n - n % AT_ONCE;
    for (size_t begin = 0; begin < whole; begin += AT_ONCE)
        combine_some(begin, AT_ONCE, base, h, weight, k, count, out);
    combine_some(whole, n - whole, base, h, weight, k, count, out);
}

static void compute_first_stage(embedded *self, motion *mo) {
    memcpy(self->v[0], mo->v, self->n * sizeof(double));
    motion_accelerate(mo, mo->x, mo->v, self->a[0]);
    self->stale = false;
}

static int start(embedded *self, motion *mo, diag *d) {
    int status = self->fixed > 0 ? control_look(&self->limit, mo, d) : SARCINA_OK;
    compute_first_stage(self, mo);
    self->h = self->fixed > 0 ? self->fixed
                              : control_first_step(mo, self->a[0], self->tolerance, self->style->order, self->trial);
    self->started = status == SARCINA_OK;
    return status;
}

/* The stages after the first; the last is at the trial state: x in self->trial, v its own. */
static void compute_stages(embedded *self, motion *mo, double h) {
    for (int s = 1; s < self->table->stages; s++) {
        combine(self->n, mo->x, h, self->table->a[s], self->v, s, self->trial);
        combine(self->n, mo->v, h, self->table->a[s], self->a, s, self->v[s]);
        motion_accelerate(mo, self->trial, self->v[s], self->a[s]);
    }
}

/* Error of a trial of length h in tolerances; with a fixed step only whether it is sane. *met: the cap that refuses it.
 */
static double judge(embedded *self, const motion *mo, double h, cap_kind *met) {
    double *ex = self->trial + 2 * self->n, *ev = ex + self->n;
    int stages = self->table->stages;
    combine(self->n, NULL, h, self->table->e, self->v, stages, ex);
    combine(self->n, NULL, h, self->table->e, self->a, stages, ev);
    double error = motion_error(mo, ex, ev, self->tolerance);
    double farthest = self->fixed > 0 ? MOTION_FARTHEST : MOTION_FARTHEST_ESTIMATED;
    *met = CAP_FAR;
    if (!isfinite(error) || !motion_is_sane(mo, self->trial, self->v[stages - 1], farthest))
        return INFINITY;
    *met = self->fixed > 0 ? CAP_JOLT : CAP_COUNT;
    if (self->fixed <= 0)
        return error;
    return motion_is_gentle(mo, self->a[0], self->a[stages - 1], NULL, h) ? 0.5 : (double)INFINITY;
}

static void take(embedded *self, motion *mo, double h, bool last, double t1) {
    int final = self->table->stages - 1;
    motion_accept(mo, self->trial, self->v[final], h, last, t1);
    double *v = self->v[0], *a = self->a[0];
    self->v[0] = self->v[final];
    self->a[0] = self->a[final];
    self->v[final] = v;
    self->a[final] = a;
}

/* The step after an accepted one of length h. One cut short at the end says nothing against the longer one; a fixed one
 * that was refused is tried at twice its length again. */
static double next_step(const embedded *self, double h, double factor, bool last) {
    double next = self->fixed > 0 ? fmin(self->fixed, 2 * h) : h * factor;
    return last && next < self->h ? self->h : next;
}

static int step(void *of, motion *mo, double t1, diag *d) {
    embedded *self = of;
    int status = self->started ? control_watch(&self->limit, mo, d) : start(self, mo, d);
    if (status)
        return status;
    if (self->stale)
        compute_first_stage(self, mo);
    for (;;) {
        bool last;
        double most = control_most(&self->limit, self->most), h = control_cut(mo, self->h, most, t1, &last);
        compute_stages(self, mo, h);
        cap_kind met;
        double error = judge(self, mo, h, &met), factor = control_factor(error, self->style->order);
        if (error < 1) {
            take(self, mo, h, last, t1);
            self->h = next_step(self, h, factor, last);
            control_count(&self->limit, mo, h);
            return SARCINA_OK;
        }
        motion_refuse(mo, met);
        self->h = h * factor;
        if (self->h < CONTROL_LEAST_STEP)
            return control_give_up(&self->limit, mo, motion_worst(mo, self->trial + 3 * self->n), d);
    }
}

#define EMBEDDED_FUNCTIONS .create = create, .step = step, .reset = reset, .renew = renew, .destroy = destroy

const integrator_style integrator_dopri5 = {
    .name = "dopri5",
    .summary = "Dormand-Prince 5(4), the paper's method",
    .source = "Dormand & Prince 1980",
    .order = 5,
    .caps = INTEGRATOR_ADAPTIVE,
    .tolerance = 0.1,
    .method = &dormand_prince,
    .vectors = 19,
    EMBEDDED_FUNCTIONS,
};

const integrator_style integrator_bs32 = {
    .name = "bs32",
    .summary = "Bogacki-Shampine 3(2)",
    .source = "Bogacki & Shampine 1989",
    .order = 3,
    .caps = INTEGRATOR_ADAPTIVE,
    .tolerance = 0.01,
    .method = &bogacki_shampine,
    .vectors = 19,
    EMBEDDED_FUNCTIONS,
};

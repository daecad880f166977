/* SPDX-License-Identifier: GPL-3.0-or-later */
/* GSL's explicit steppers under the control of this program: the same error norm, factor and limits as dopri5; rk4,
 * which has no estimate worth its price, takes the step of the stiffness. Source: GSL, ode-initval2. */
#include "relax/integrator.h"

#include "base/alloc.h"
#include "relax/control.h"

#include <gsl/gsl_odeiv2.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

/* GSL's types are pointers set when the program starts: a record holds where they are. */
typedef struct stepper {
    const integrator_style *style;
    gsl_odeiv2_step *gsl;
    double tolerance, most, fixed, h;
    size_t n;            /* particles x dimensions */
    bool started, stale; /* h holds; the slope does not */
    control_limit limit;
    double *y, *error, *slope, *next_slope, *scratch, *memory; /* (x, v) and the like (2 n each); scratch (4 n) */
} stepper;

static void *create(const integrator_style *style, const relax_settings *how, const motion *mo) {
    stepper *self = alloc_zeroed(1, sizeof *self);
    self->style = style;
    self->tolerance = how->tolerance > 0 ? how->tolerance : style->tolerance;
    self->most = how->most;
    self->fixed = how->step;
    self->n = mo->components;
    const gsl_odeiv2_step_type *const *type = style->method;
    self->gsl = gsl_odeiv2_step_alloc(*type, 2 * self->n);
    self->memory = alloc_zeroed(13 * self->n, sizeof *self->memory);
    self->y = self->memory;
    self->error = self->y + 2 * self->n;
    self->slope = self->error + 2 * self->n;
    self->next_slope = self->slope + 2 * self->n;
    self->scratch = self->next_slope + 2 * self->n;
    self->limit.mode = self->scratch + 4 * self->n;
    self->limit.obeyed = self->fixed > 0 || !(style->caps & INTEGRATOR_ADAPTIVE);
    return self;
}

static void reset(void *of) {
    stepper *self = of;
    gsl_odeiv2_step_reset(self->gsl);
    self->started = false;
}

/* The error of the steps to come finds a step that the new forces bear; rk4, which has none, looks at the stiffness. */
static void renew(void *of, double stiffness) {
    stepper *self = of;
    gsl_odeiv2_step_reset(self->gsl);
    self->stale = true;
    self->started = self->started && (stiffness == 0 || self->style->caps & INTEGRATOR_ADAPTIVE);
}

static void destroy(void *of) {
    stepper *self = of;
    gsl_odeiv2_step_free(self->gsl);
    free(self->memory);
    free(self);
}

/* dy/dt of y = (x, v) */
static int slope_of(double t, const double y[], double dydt[], void *params) {
    (void)t;
    motion *mo = params;
    size_t n = mo->components;
    memcpy(dydt, y + n, n * sizeof *y);
    motion_accelerate(mo, y, y + n, dydt + n);
    return GSL_SUCCESS;
}

/* The step of a method without control of its own: as told, or as the limit says; where nothing limits it, 1 ms. */
static double longest(const stepper *self) {
    if (self->fixed > 0)
        return self->fixed;
    return isfinite(self->limit.step) ? self->limit.step : 1e-3;
}

static int start(stepper *self, motion *mo, diag *d) {
    int status = self->limit.obeyed ? control_look(&self->limit, mo, d) : SARCINA_OK;
    slope_of(mo->time, self->y, self->slope, mo);
    if (!self->limit.obeyed)
        self->h = control_first_step(mo, self->slope + self->n, self->tolerance, self->style->order, self->scratch);
    else
        self->h = longest(self);
    self->started = status == SARCINA_OK;
    self->stale = false;
    return status;
}

static void load(const stepper *self, const motion *mo) {
    memcpy(self->y, mo->x, self->n * sizeof *self->y);
    memcpy(self->y + self->n, mo->v, self->n * sizeof *self->y);
}

/* Error of a trial in tolerances; where a limit is obeyed only whether it is sane. *met: the cap that refuses it. */
static double judge(const stepper *self, const motion *mo, int status, double h, cap_kind *met) {
    double farthest = self->limit.obeyed ? MOTION_FARTHEST : MOTION_FARTHEST_ESTIMATED;
    *met = CAP_FAR;
    if (status || !motion_is_sane(mo, self->y, self->y + self->n, farthest))
        return INFINITY;
    *met = self->limit.obeyed ? CAP_JOLT : CAP_COUNT;
    if (self->limit.obeyed)
        return motion_is_gentle(mo, self->slope + self->n, self->next_slope + self->n, NULL, h) ? 0.5
                                                                                                : (double)INFINITY;
    return motion_error(mo, self->error, self->error + self->n, self->tolerance);
}

static int step(void *of, motion *mo, double t1, diag *d) {
    stepper *self = of;
    const gsl_odeiv2_system system = {slope_of, NULL, 2 * self->n, mo};
    load(self, mo);
    int begun = self->started ? control_watch(&self->limit, mo, d) : start(self, mo, d);
    if (begun)
        return begun;
    if (self->stale)
        slope_of(mo->time, self->y, self->slope, mo);
    self->stale = false;
    for (;;) {
        bool last;
        double most = control_most(&self->limit, self->most), h = control_cut(mo, self->h, most, t1, &last);
        int status =
            gsl_odeiv2_step_apply(self->gsl, mo->time, h, self->y, self->error, self->slope, self->next_slope, &system);
        cap_kind met;
        double error = judge(self, mo, status, h, &met), factor = control_factor(error, self->style->order);
        if (error < 1) {
            motion_accept(mo, self->y, self->y + self->n, h, last, t1);
            memcpy(self->slope, self->next_slope, 2 * self->n * sizeof *self->slope);
            double next = self->limit.obeyed ? fmin(longest(self), 2 * h) : h * factor;
            self->h = last && next < self->h ? self->h : next;
            control_count(&self->limit, mo, h);
            return SARCINA_OK;
        }
        motion_refuse(mo, met);
        self->h = h * factor;
        load(self, mo);
        if (self->h < CONTROL_LEAST_STEP)
            return control_give_up(&self->limit, mo, motion_worst(mo, self->slope + self->n), d);
    }
}

#define STEPPER_FUNCTIONS .create = create, .step = step, .reset = reset, .renew = renew, .destroy = destroy

const integrator_style integrator_rk4 = {
    .name = "rk4",
    .summary = "classical Runge-Kutta, two half steps and a full one",
    .source = "GSL rk4",
    .order = 4,
    .method = &gsl_odeiv2_step_rk4,
    .vectors = 23,
    STEPPER_FUNCTIONS,
};

const integrator_style integrator_rkf45 = {
    .name = "rkf45",
    .summary = "Runge-Kutta-Fehlberg 4(5)",
    .source = "GSL rkf45",
    .order = 5,
    .caps = INTEGRATOR_ADAPTIVE,
    .tolerance = 0.1,
    .method = &gsl_odeiv2_step_rkf45,
    .vectors = 29,
    STEPPER_FUNCTIONS,
};

const integrator_style integrator_rk8pd = {
    .name = "rk8pd",
    .summary = "Prince-Dormand 8(9)",
    .source = "GSL rk8pd",
    .order = 8,
    .caps = INTEGRATOR_ADAPTIVE,
    .tolerance = 0.01,
    .method = &gsl_odeiv2_step_rk8pd,
    .vectors = 43,
    STEPPER_FUNCTIONS,
};

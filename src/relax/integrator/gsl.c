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
    size_t n;                                                  /* 3 x particles */
    bool started, stale;                                       /* h holds; the slope does not */
    double *y, *error, *slope, *next_slope, *scratch, *memory; /* (x, v) and the like (2 n each); scratch (4 n) */
} stepper;

static void *create(const integrator_style *style, const relax_settings *how, const motion *mo) {
    stepper *self = alloc_zeroed(1, sizeof *self);
    self->style = style;
    self->tolerance = how->tolerance > 0 ? how->tolerance : style->tolerance;
    self->most = how->most;
    self->fixed = how->step;
    self->n = 3 * mo->n;
    const gsl_odeiv2_step_type *const *type = style->method;
    self->gsl = gsl_odeiv2_step_alloc(*type, 2 * self->n);
    self->memory = alloc_zeroed(12 * self->n, sizeof *self->memory);
    self->y = self->memory;
    self->error = self->y + 2 * self->n;
    self->slope = self->error + 2 * self->n;
    self->next_slope = self->slope + 2 * self->n;
    self->scratch = self->next_slope + 2 * self->n;
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
    size_t n = 3 * mo->n;
    memcpy(dydt, y + n, n * sizeof *y);
    motion_accelerate(mo, y, y + n, dydt + n);
    return GSL_SUCCESS;
}

static double first_step(stepper *self, motion *mo) {
    if (self->fixed > 0)
        return self->fixed;
    if (self->style->caps & INTEGRATOR_ADAPTIVE)
        return control_first_step(mo, self->slope + self->n, self->tolerance, self->style->order, self->scratch);
    double stable = motion_stable_step(mechanics_stiffness(mo->m, mo->x));
    return isfinite(stable) ? stable : 1e-3;
}

static void load(const stepper *self, const motion *mo) {
    memcpy(self->y, mo->x, self->n * sizeof *self->y);
    memcpy(self->y + self->n, mo->v, self->n * sizeof *self->y);
}

static double judge(const stepper *self, const motion *mo, int status) {
    if (status || !motion_is_finite(mo, self->y, self->y + self->n))
        return INFINITY;
    if (self->fixed > 0 || !(self->style->caps & INTEGRATOR_ADAPTIVE))
        return 0.5;
    return motion_error(mo, self->error, self->error + self->n, self->tolerance);
}

static int step(void *of, motion *mo, double t1, diag *d) {
    stepper *self = of;
    const gsl_odeiv2_system system = {slope_of, NULL, 2 * self->n, mo};
    load(self, mo);
    if (!self->started) {
        slope_of(mo->time, self->y, self->slope, mo);
        self->h = first_step(self, mo);
        self->started = true;
    } else if (self->stale) {
        slope_of(mo->time, self->y, self->slope, mo);
    }
    self->stale = false;
    bool controlled = self->fixed <= 0 && self->style->caps & INTEGRATOR_ADAPTIVE;
    for (;;) {
        bool last;
        double h = control_cut(mo, self->h, self->most, t1, &last);
        int status =
            gsl_odeiv2_step_apply(self->gsl, mo->time, h, self->y, self->error, self->slope, self->next_slope, &system);
        double error = judge(self, mo, status), factor = control_factor(error, self->style->order);
        if (error < 1) {
            motion_accept(mo, self->y, self->y + self->n, h, last, t1);
            memcpy(self->slope, self->next_slope, 2 * self->n * sizeof *self->slope);
            if (controlled && !(last && h * factor < self->h))
                self->h = h * factor;
            return SARCINA_OK;
        }
        mo->rejected++;
        self->h = h * factor;
        load(self, mo);
        if (self->h < CONTROL_LEAST_STEP)
            return motion_fail_thrown(mo, motion_worst(mo, self->slope + self->n), CONTROL_LEAST_STEP, d);
    }
}

#define STEPPER_FUNCTIONS .create = create, .step = step, .reset = reset, .renew = renew, .destroy = destroy

const integrator_style integrator_rk4 = {
    .name = "rk4",
    .summary = "classical Runge-Kutta, two half steps and a full one",
    .source = "GSL rk4",
    .order = 4,
    .method = &gsl_odeiv2_step_rk4,
    .vectors = 22,
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
    .vectors = 28,
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
    .vectors = 42,
    STEPPER_FUNCTIONS,
};

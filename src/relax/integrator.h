/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The table of integrators. Each advances the state by one accepted step from the present time towards t1, never past
 * it; when it fails, time and state are to the bit as before the call. */
#ifndef SARCINA_RELAX_INTEGRATOR_H
#define SARCINA_RELAX_INTEGRATOR_H

#include "relax/motion.h"

enum {
    INTEGRATOR_ADAPTIVE = 1,      /* takes its step from an error estimate */
    INTEGRATOR_EXACT_DAMPING = 2, /* damping is not in the force but solved exactly */
    INTEGRATOR_MINIMISES = 4      /* goes to rest and follows no time: motion.time stays */
};

typedef struct integrator_style {
    const char *name;    /* in scripts */
    const char *summary; /* one line */
    const char *source;  /* where it comes from */
    int order;           /* the convergence test fits this slope */
    unsigned caps;
    int vectors;        /* arrays of (particles x dimensions) numbers that a method holds */
    double tolerance;   /* its own, where settings.tolerance is 0; adaptive only */
    const void *method; /* for create, where several records share their functions */
    /* A method for this motion; owned by the caller, freed by destroy. */
    void *(*create)(const struct integrator_style *style, const relax_settings *how, const motion *mo);
    /* One accepted step. */
    int (*step)(void *self, motion *mo, double t1, diag *d);
    /* Undamped forces (n x dimensions) at the present state where it has them, NULL where not; optional. */
    const double *(*force)(const void *self);
    /* Once the relaxation is over: gives the motion the velocities of its time, where the method's steps hold those of
     * another; optional. */
    void (*finish)(void *self, motion *mo);
    /* Forgets its history, the step included: between segments. */
    void (*reset)(void *self);
    /* Links have changed: the forces at the present state are not what they were. Keeps the step; stiffness (1/s2): a
     * bound on what the new ones add to the largest squared eigenfrequency. */
    void (*renew)(void *self, double stiffness);
    void (*destroy)(void *self);
} integrator_style;

/* The records, in the order of integrator_kind. */
extern const integrator_style *const integrator_styles[INTEGRATOR_COUNT];

/* A setting that the method would not look at is a slip: the error says why, *wrong is its keyword. */
int integrator_check(const relax_settings *how, const char **wrong, diag *d);

/* One line a method: integrator/NAME.c */
extern const integrator_style integrator_dopri5;
extern const integrator_style integrator_bs32;
extern const integrator_style integrator_verlet;
extern const integrator_style integrator_euler;
extern const integrator_style integrator_rk4;
extern const integrator_style integrator_rkf45;
extern const integrator_style integrator_rk8pd;
extern const integrator_style integrator_newton;

#endif

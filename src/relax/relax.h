/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Relaxation: Newton's equations with damping, m dv/dt = F, dx/dt = v, for a given time or until the forces are small.
 * The accuracy presets choose method and step, never physics. */
#ifndef SARCINA_RELAX_RELAX_H
#define SARCINA_RELAX_RELAX_H

#include "base/diag.h"
#include "mechanics/mechanics.h"

#include <signal.h>

typedef enum {
    INTEGRATOR_DOPRI5,
    INTEGRATOR_VERLET,
    INTEGRATOR_RK4,
    INTEGRATOR_RKF45,
    INTEGRATOR_RK8PD,
    INTEGRATOR_EULER,
    INTEGRATOR_BS32,
    INTEGRATOR_NEWTON,
    INTEGRATOR_COUNT
} integrator_kind;

/* Method and step rule. */
typedef struct relax_settings {
    integrator_kind integrator;
    double step;      /* fixed step, s; 0: from the present stiffness (verlet, rk4) or by error control */
    double tolerance; /* error a step, um and um/s (RMS over all components); 0: the integrator's own */
    double segment;   /* the integrator starts anew after this much time, s; 0: never (accuracy paper: 0.2 s) */
    double most;      /* no step longer than this, s (while masses are the particles' own); 0: no bound */
    double inertia;   /* verlet, euler: masses grow to this part of t k_d, t the time relaxed; 0: they stay */
} relax_settings;

/* Presets by name: draft, fast, balanced, paper, reference. Row of a preset; -1. */
typedef struct accuracy_preset {
    const char *name, *summary; /* of method and step rule */
    relax_settings settings;
    const char *validated; /* for what */
    size_t validated_to;   /* cells; 0: nothing */
} accuracy_preset;
extern const accuracy_preset accuracy_presets[];
extern const size_t accuracy_preset_count;

typedef struct relax_goal {
    double time;                            /* at most this long, s */
    double force;                           /* stop when the largest net force is below this; 0: only by time */
    const volatile sig_atomic_t *interrupt; /* looked at between accepted steps; NULL: never */
    uint64_t evaluations;                   /* stop once there have been so many; 0: no bound */
} relax_goal;

/* RELAX_STALLED: of a minimiser, the largest force falls no further. */
typedef enum { RELAX_TIME, RELAX_FORCE, RELAX_INTERRUPTED, RELAX_EVALUATIONS, RELAX_STALLED } relax_stop;

typedef struct relax_result {
    relax_stop stop;
    double time;     /* relaxed, s; of a minimiser 0 */
    double fmax;     /* at the end, 1e-21 N; computed only when goal.force > 0 */
    uint64_t cell;   /* RELAX_STALLED: whose force that is */
    force_kind term; /* ... and the term whose force is largest there */
    uint64_t steps, rejected, evaluations;
    uint64_t products;               /* of a minimiser's matrix with a vector */
    double least_step, largest_step; /* of a minimiser 0 */
    uint64_t caps[CAP_COUNT];        /* limits on motion that were met */
    double remodel_seconds;          /* wall time of forming and breaking links; without that of neighbour lists */
} relax_result;

/* SARCINA_ERROR: a minimiser, which follows no time, has been given one, or no force to reach. */
int relax_check(const relax_settings *how, double time, double force, diag *d);

/* Relaxes m's colony (bound by mechanics_prepare), writing its x and v. On SARCINA_NUMERICAL the diag names the cell,
 * the term and the cause, and the colony is as at the last accepted step; a rejected step leaves x, v and the time as
 * they were, to the bit. */
int relax_run(mechanics *m, const relax_settings *how, const relax_goal *goal, relax_result *result, diag *d);

#endif

/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The state that integrators move, and what they share: error norm, stable step, tests of a step, messages. */
#ifndef SARCINA_RELAX_MOTION_H
#define SARCINA_RELAX_MOTION_H

#include "relax/relax.h"

#include <stdbool.h>

/* x and v are the colony's own: only accepted steps are written there. */
typedef struct motion {
    mechanics *m;
    size_t n;              /* particles */
    double *x, *v;         /* (n x 3), um, um/s */
    double time;           /* s, from the beginning of the relaxation */
    const uint32_t *order; /* particle rows in the order of sums (n) */
    uint64_t steps, rejected, evaluations;
    double least_step, largest_step;
} motion;

/* Accelerations a (n x 3) at x, v (n x 3): one evaluation. */
void motion_accelerate(motion *mo, const double *x, const double *v, double *a);

/* Undamped forces f (n x 3) at x: one evaluation. */
void motion_force(motion *mo, const double *x, double *f);

/* The same without what acts within flexible cells: one evaluation. */
void motion_force_outside(motion *mo, const double *x, double *f);

/* Takes over a trial state as the present one, h later (at exactly t1 when `last`). */
void motion_accept(motion *mo, const double *x, const double *v, double h, bool last, double t1);

/* Root mean square of e / tolerance over all 6 n components of (positions, velocities), in the order of ids. */
double motion_error(const motion *mo, const double *ex, const double *ev, double tolerance);

/* Is every number finite? */
bool motion_is_finite(const motion *mo, const double *x, const double *v);

/* The particle of the first number that is not finite, or of the largest |value|. */
size_t motion_worst(const motion *mo, const double *values);

/* Longest explicit step for a mode of this squared frequency (1/s2): 0.7 of Verlet's limit 2 / omega. */
double motion_stable_step(double stiffness);

/* SARCINA_NUMERICAL: the springs on a particle need steps shorter than `least` (s); or, whatever the step, it is thrown
 * too far. Both name the cell, the term and the cause. */
int motion_fail_stiff(motion *mo, size_t particle, double least, diag *d);
int motion_fail_thrown(motion *mo, size_t particle, double least, diag *d);

#endif

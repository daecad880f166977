/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Control of the step by an error estimate: h <- h clamp(0.9 err^(-1/order), 0.2, 10), accepted when err < 1; the first
 * step from the size of the first two derivatives (Hairer, Norsett & Wanner, Solving ODEs I, II.4). */
#ifndef SARCINA_RELAX_CONTROL_H
#define SARCINA_RELAX_CONTROL_H

#include "relax/motion.h"

/* Below this (s) an error-controlled step counts as impossible. */
#define CONTROL_LEAST_STEP 1e-9

/* How long the steps of an explicit method may be: what springs and damping at the present state bear. Methods without
 * an error estimate, and those told their step, obey it; those with one find it themselves, and are stopped when it is
 * shorter than what is taken. */
typedef struct control_limit {
    bool obeyed;
    double step;  /* s; infinite where nothing limits it */
    int steps;    /* accepted since it was looked for; of methods that do not obey: short ones in a row */
    double *mode; /* (n x dimensions) of the stiffest motion, owned by the method; zeros to begin with */
} control_limit;

/* Looks for it now. SARCINA_NUMERICAL when it is below motion.least. */
int control_look(control_limit *limit, motion *mo, diag *d);

/* SARCINA_NUMERICAL: no step down to CONTROL_LEAST_STEP is accepted; `particle` moves farthest. */
int control_give_up(control_limit *limit, motion *mo, size_t particle, diag *d);

/* Counts an accepted step of length h. */
void control_count(control_limit *limit, const motion *mo, double h);

/* Before a step: looks again when it is time to. */
int control_watch(control_limit *limit, motion *mo, diag *d);

/* Factor for the next step after an error (in tolerances; not finite: 0.2). */
double control_factor(double error, int order);

/* First step of a method of this order. a (components): accelerations at the present state; trial (4 x components):
 * scratch. One evaluation. */
double control_first_step(motion *mo, const double *a, double tolerance, int order, double *trial);

/* The bound on a method's steps: its own (0: none) and, where it is obeyed, that of the limit; 0: none. */
double control_most(const control_limit *limit, double most);

/* The present step of a method: what it wants, cut to `most` (0: no bound) and to the time left. *last: it ends at t1.
 */
double control_cut(const motion *mo, double wanted, double most, double t1, bool *last);

#endif

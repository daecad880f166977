/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Control of the step by an error estimate: h <- h clamp(0.9 err^(-1/order), 0.2, 10), accepted when err < 1; the first
 * step from the size of the first two derivatives (Hairer, Norsett & Wanner, Solving ODEs I, II.4). */
#ifndef SARCINA_RELAX_CONTROL_H
#define SARCINA_RELAX_CONTROL_H

#include "relax/motion.h"

/* Below this (s) an error-controlled step counts as impossible. */
#define CONTROL_LEAST_STEP 1e-9

/* Factor for the next step after an error (in tolerances; not finite: 0.2). */
double control_factor(double error, int order);

/* First step of a method of this order. a (n x 3): accelerations at the present state; trial (n x 12): scratch. One
 * evaluation. */
double control_first_step(motion *mo, const double *a, double tolerance, int order, double *trial);

/* The present step of a method: what it wants, cut to `most` (0: no bound) and to the time left. *last: it ends at t1.
 */
double control_cut(const motion *mo, double wanted, double most, double t1, bool *last);

#endif

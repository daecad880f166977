/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The state that integrators move, and what they share: error norm, stable step, tests of a step, messages. */
#ifndef SARCINA_RELAX_MOTION_H
#define SARCINA_RELAX_MOTION_H

#include "relax/relax.h"

#include <stdbool.h>

/* x and v are the present state: the colony's own rows (mechanics_take_state), or between steps a method's that it has
 * handed over. Only accepted steps are written there. In the plane they, and whatever has their shape, have two numbers
 * a particle. */
typedef struct motion {
    mechanics *m;
    size_t n;              /* particles */
    int dimensions;        /* 3; 2 in the plane */
    size_t components;     /* n x dimensions: numbers in x */
    double *x, *v;         /* (n x dimensions), um, um/s */
    double *home[2];       /* where the colony's own are */
    double time;           /* s, from the beginning of the relaxation */
    const uint32_t *order; /* particle rows in the order of sums (n) */
    uint64_t steps, rejected, evaluations;
    uint64_t products; /* of a minimiser's matrix with a vector */
    double goal;       /* largest net force to reach, 1e-21 N; 0: none */
    bool stuck;        /* a minimiser gets no further down */
    double least_step, largest_step;
    double least; /* a scene that needs steps below this throughout is refused, s */
    uint64_t caps[CAP_COUNT];
} motion;

/* Accelerations a (n x dimensions) at x, v: one evaluation. */
void motion_accelerate(motion *mo, const double *x, const double *v, double *a);

/* Undamped forces f (n x dimensions) at x: one evaluation. */
void motion_force(motion *mo, const double *x, double *f);

/* The same without what acts within flexible cells: one evaluation. */
void motion_force_outside(motion *mo, const double *x, double *f);

/* Takes over a trial state as the present one, h later (at exactly t1 when `last`). */
void motion_accept(motion *mo, const double *x, const double *v, double h, bool last, double t1);

/* The same without a copy: the trial's own arrays are the present state from now on, until motion_settle; those that
 * were are free for the next trial. */
void motion_hand_over(motion *mo, double *x, double *v, double h, bool last, double t1);

/* Brings the present state home, for whoever looks at the colony's own rows. */
void motion_settle(motion *mo);

/* Counts a trial that is not taken: by the cap that refused it; CAP_COUNT: by its error, which is no cap. */
void motion_refuse(motion *mo, cap_kind why);

/* Root mean square of e / tolerance over all 6 n components of (positions, velocities), in the order of ids; those
 * along z are 0 in the plane, and count. */
double motion_error(const motion *mo, const double *ex, const double *ev, double tolerance);

/* How far a step may move a particle, in its radii: cells that pass each other untouched is what must not be. Methods
 * that estimate their error see a contact that they enter by more; beyond a diameter none sees it. */
#define MOTION_FARTHEST 0.5
#define MOTION_FARTHEST_ESTIMATED 2

/* Is every number of a trial state finite, with no particle moved farther than that many radii? */
bool motion_is_sane(const motion *mo, const double *x, const double *v, double farthest);

/* How far, in radii, the change of force in a step may move a particle in the next. */
#define MOTION_GENTLE 0.25

/* Whether the change of force in a step of length h, from f0 to f1 (n x dimensions), moves no particle by more than a
 * quarter of its radius in the next one: h^2/2 |f1 - f0| / m. Where it does, a spring has come to act that the step is
 * too long for, and what the state has gained by entering it is energy from nowhere. mass (n); NULL: f are
 * accelerations. */
bool motion_is_gentle(const motion *mo, const double *f0, const double *f1, const double *mass, double h);

/* The particle of the first number that is not finite, or of the largest |value|. */
size_t motion_worst(const motion *mo, const double *values);

/* Longest explicit step for a mode of this squared frequency (1/s2): 0.7 of Verlet's limit 2 / omega. */
double motion_stable_step(double stiffness);

/* The same for splittings with exact damping. They hand on energy that they do not get quite right: where damping takes
 * long to remove it (a hundred radians of the mode and more) they need finer steps, by the fourth root of that, down to
 * a quarter. Where damping is faster than the mode they bear longer ones: stable is h^2/2 K < m y coth y, y = k_d h /
 * 2m, so that h < k_d / k is enough whatever the mass. */
double motion_careful_step(const motion *mo, double stiffness);

/* Longest explicit step for contacts that may close at any time, whether or not they do now: a step that is too long
 * for one it enters gains energy there. The limit itself, without a margin; not below a fifth of motion.least: what
 * does not touch is no reason to refuse a scene. */
double motion_contact_step(const motion *mo);

/* SARCINA_NUMERICAL: the springs on a particle need steps (`needed`, s) shorter than are taken (motion.least); so does
 * its damping, which explicit methods follow; or, whatever the step down to `least` (s), it is thrown too far. All name
 * the cell, the term and the cause. */
int motion_fail_stiff(motion *mo, size_t particle, double needed, diag *d);
int motion_fail_damped(motion *mo, size_t particle, diag *d);
int motion_fail_thrown(motion *mo, size_t particle, double least, diag *d);

/* SARCINA_NUMERICAL: however short a minimiser's step, this particle is thrown too far. Names the cell and the term. */
int motion_fail_descent(motion *mo, size_t particle, diag *d);

#endif

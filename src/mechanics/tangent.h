/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The stiffness matrix of a state, for who solves with it: K = sum of k g g' over the springs that act
 * (force_style.stiffness), and where one between two points is stretched its resistance to being turned,
 * pull (1 - u u'). Every part is positive semi-definite, and so is K: that of the second derivatives of the energy
 * which is not (a compressed spring gives way to the side) is left out. Units: pg/s2.
 *
 * As a preconditioner: K's blocks of single cells, in which a particle's row holds itself and three before it: all of
 * a coccus or rod, and all that acts within a flexible cell. */
#ifndef SARCINA_MECHANICS_TANGENT_H
#define SARCINA_MECHANICS_TANGENT_H

#include "mechanics/mechanics.h"

typedef struct tangent tangent;

/* Owned by the caller; m has to outlive it. */
tangent *tangent_create(mechanics *m);
void tangent_free(tangent *t);

/* Takes K at x (nparticles x dimensions); false where x is not finite. */
bool tangent_take(tangent *t, const double *x);

/* out = (K + shift) y, both (nparticles x dimensions). The sums' order depends on ids only. */
void tangent_apply(const tangent *t, double shift, const double *y, double *out);

/* Factorises the blocks of K + shift, shift > 0. */
void tangent_factor(tangent *t, double shift);

/* out = blocks^-1 y, both (nparticles x dimensions). */
void tangent_solve(const tangent *t, const double *y, double *out);

#endif

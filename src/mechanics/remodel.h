/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Links form and break between accepted steps of a relaxation (Storck et al. 2014, "Tertiary structures"):
 *   a link breaks, all its springs at once, when one is longer than its rest length by more than its rule's break;
 *   two cells not linked to each other stick when their axes are nearer than r_A + r_B + form;
 *   a cell without an anchor is anchored when a particle is lower than r + form above the substratum.
 * Everything is judged on the state as it stands before any of it is done: what breaks now forms at the next time at
 * the earliest. Links form in the order of their cells' ids. */
#ifndef SARCINA_MECHANICS_REMODEL_H
#define SARCINA_MECHANICS_REMODEL_H

#include "mechanics/mechanics.h"

/* May links form or break in the bound colony? Where not, mechanics_remodel need never be called. */
bool mechanics_remodels(const mechanics *m);

/* Time between remodellings, s; 0: after every accepted step. */
double mechanics_remodel_every(const mechanics *m);

typedef struct remodel_change {
    size_t formed, broken;
    double stiffness; /* bound on what the links formed add to the largest squared eigenfrequency, 1/s2 */
} remodel_change;

/* Forms and breaks links at the colony's own x, and binds the springs anew: cheap, the neighbour list stays. False:
 * nothing has changed. Positions that are not finite change nothing. */
bool mechanics_remodel(mechanics *m, remodel_change *change);

/* Sticking only: what `link stick now` does. */
bool mechanics_remodel_stick(mechanics *m, remodel_change *change);

#endif

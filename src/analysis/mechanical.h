/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Forces and energy of the whole colony. */
#ifndef SARCINA_ANALYSIS_MECHANICAL_H
#define SARCINA_ANALYSIS_MECHANICAL_H

#include "analysis/view.h"

/* Fields in the order of MECHANICAL_ENERGY_FIELDS; their sum is the bare value. Defined for the whole colony only: an
 * error with members. 1e-27 J. */
#define MECHANICAL_ENERGY_FIELDS                                                                                       \
    "internal:energy,bend:energy,twist:energy,filial:energy,stick:energy,anchor:energy,spring:energy,collision:"       \
    "energy,"                                                                                                          \
    "substratum:energy,dlvo:energy,gravity:energy,kinetic:energy"
int mechanical_energy(const view *v, const bool *members, double *out, diag *d);

/* value.h measure: largest net force on a particle, damping left out, 1e-21 N. Of the whole colony: an error with
 * members. */
int mechanical_fmax(const view *v, const bool *members, double *out, diag *d);

#endif

/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The table of force terms. Each adds one physical effect and knows no other term, no integrator and no script; the
 * file of a term states its law, its source and every factor. Units: um, pg, s; force 1e-21 N. */
#ifndef SARCINA_MECHANICS_FORCE_H
#define SARCINA_MECHANICS_FORCE_H

#include "base/param.h"

#include <stdbool.h>
#include <stddef.h>

/* What the script has named: which terms act, and their parameters in the order of each style's param records. */
typedef struct force_settings {
    bool on;
    double p[PARAM_COUNT_MAX];
} force_settings;

/* Rows of the force table. */
typedef enum {
    FORCE_INTERNAL, /* springs inside rods; k by species (species.internal_k), on while any species has one */
    FORCE_BEND,     /* resistance of flexible cells against bending; k by species, on while a cell has one */
    FORCE_TWIST,    /* and against twisting */
    FORCE_SPRINGS,  /* the spring rows of links; on while there are any */
    FORCE_COLLISION,
    FORCE_SUBSTRATUM,
    FORCE_DLVO,
    FORCE_DAMPING,
    FORCE_GRAVITY,
    FORCE_COUNT
} force_kind;

typedef struct force_set {
    force_settings term[FORCE_COUNT];
} force_set;

typedef enum { CONTACT_REGULARISED, CONTACT_CLOSEST } contact_law;

/* Columns of force_set.term[...].p */
enum { COLLISION_K, COLLISION_REACH, COLLISION_CONTACT, COLLISION_EPSILON };
enum { SUBSTRATUM_Z, SUBSTRATUM_K };
enum { DLVO_CES, DLVO_CVDW, DLVO_KAPPA, DLVO_CLAMP };
enum { DAMPING_K };
enum { GRAVITY_G, GRAVITY_FLUID };

#endif

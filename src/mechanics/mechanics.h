/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The forces on a colony: binds the active terms of a force set, keeps the neighbour list, and evaluates.
 *
 * Sums depend neither on the order of rows nor on the number of threads: the owner of a row computes its whole sum, in
 * the order of the partners' ids. What is not active is neither computed nor allocated. */
#ifndef SARCINA_MECHANICS_MECHANICS_H
#define SARCINA_MECHANICS_MECHANICS_H

#include "base/diag.h"
#include "mechanics/force.h"
#include "model/colony.h"
#include "model/species.h"

typedef enum { NEIGHBOR_CELLS, NEIGHBOR_PAIRS } neighbor_method;

typedef struct neighbor_settings {
    double skin; /* um; negative: chosen by the program */
    neighbor_method method;
} neighbor_settings;

/* What the mechanics read; it owns none of it. */
typedef struct mechanics_input {
    colony *colony;
    const species_table *species;
    const force_set *forces;
    neighbor_settings neighbor;
    uint64_t seed;
    int threads;
} mechanics_input;

typedef struct mechanics mechanics;

mechanics *mechanics_create(void);
void mechanics_free(mechanics *m);

/* Binds to the colony as it stands: checks that the terms are consistent (dlvo needs a substratum, a rod its internal
 * spring ...), builds masses, indices and the neighbour list. Call again after anything but x and v has changed;
 * cheap when nothing has (colony.version and the settings are compared). On error nothing is bound. */
int mechanics_prepare(mechanics *m, const mechanics_input *in, diag *d);

/* Forces f (nparticles x 3) at x, v (nparticles x 3): every active term; damping too. Rebuilds the neighbour list when
 * x has moved out of its skin. */
void mechanics_force(mechanics *m, const double *x, const double *v, double *f);

/* The same without damping, for integrators that damp exactly, and for fmax. */
void mechanics_force_undamped(mechanics *m, const double *x, double *f);

double mechanics_drag(const mechanics *m);        /* linear drag of a particle; 0 without damping */
const double *mechanics_mass(const mechanics *m); /* mass of each particle (nparticles) */
size_t mechanics_particles(const mechanics *m);

/* Largest eigenfrequency squared (1/s2) of the bare springs that act at x: the bound on explicit steps. */
double mechanics_stiffness(mechanics *m, const double *x);

/* Energy of one term at x (1e-27 J); 0 for a term that is not active or has none. */
double mechanics_energy(mechanics *m, force_kind term, const double *x);
double mechanics_kinetic(mechanics *m, const double *v);

/* Largest net force on a particle at the colony's own x, damping left out. */
double mechanics_fmax(mechanics *m);

/* Per cell at the colony's own x: deepest overlap (r_A + r_B - distance, 0 when apart; without the 1 % reach), number
 * of contacts (cells within reach), and net force (ncells x 3) without damping. Arrays by cell row; any may be NULL. */
void mechanics_contacts(mechanics *m, double *overlap, uint32_t *contacts, double *force);

typedef struct mechanics_stats {
    uint64_t evaluations, builds;        /* since creation */
    double force_seconds, build_seconds; /* wall time */
    size_t pairs;                        /* entries of the present list */
    double skin;
    size_t bytes;       /* memory held */
    const char *kernel; /* "avx512", "avx2", "base" */
} mechanics_stats;
mechanics_stats mechanics_statistics(const mechanics *m);

#endif

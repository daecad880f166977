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
#include "model/link_rules.h"
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
    const link_rules *links; /* by which links form and break; NULL: they stay as they are */
    double time;             /* growth time, s: that of links which form */
    bool flat;               /* two dimensions: every z is 0, nothing acts along it, and no cell is flexible */
    bool lenient;            /* bind to look, not to move: terms that lack what they need are no error */
} mechanics_input;

typedef struct mechanics mechanics;

mechanics *mechanics_create(void);
void mechanics_free(mechanics *m);

/* Binds to the colony as it stands: checks that the terms are consistent (dlvo needs a substratum, a rod its internal
 * spring ...), builds masses, indices and the neighbour list. Call again after anything but x and v has changed;
 * cheap when nothing has (colony.version and the settings are compared). On error nothing is bound. */
int mechanics_prepare(mechanics *m, const mechanics_input *in, diag *d);

/* The checks of mechanics_prepare alone; changes nothing. */
int mechanics_check(const mechanics_input *in, diag *d);

/* Puts the rows of a large colony in the order of space, which makes evaluations faster and changes no result. To be
 * called before mechanics_prepare: rows and colony.version change. */
void mechanics_arrange(colony *c);

/* Below, a state is x, v (nparticles x dimensions each), um and um/s; forces are f of that shape. In the plane there
 * are two dimensions and no z. */
int mechanics_dimensions(const mechanics *m);

/* The colony's own x and v as a state, for who moves them. In the plane they stand packed in the place of the colony's
 * rows until they are returned: nothing but these functions may look at the colony's x and v meanwhile. */
void mechanics_take_state(mechanics *m, double **x, double **v);
void mechanics_return_state(mechanics *m);

/* Forces f at x, v: every active term; damping too. Rebuilds the neighbour list when x has moved out of its skin. */
void mechanics_force(mechanics *m, const double *x, const double *v, double *f);

/* The same without damping, for integrators that damp exactly, and for fmax. */
void mechanics_force_undamped(mechanics *m, const double *x, double *f);

/* The same without what acts within flexible cells (their own springs, bending, twisting), for integrators that take
 * those implicitly: see mechanics_flight. Without flexible cells: the same as mechanics_force_undamped. */
void mechanics_force_outside(mechanics *m, const double *x, double *f);

/* Flexible cells that a step has held back, and whose step is not solved to its tolerance. */
typedef struct mechanics_hits {
    size_t held, unsolved;
} mechanics_hits;

/* Moves the particles of all flexible cells for h under what acts within their cell and damping, by implicit Euler: x
 * and v (nparticles x 3) become those at the end; others' rows are left alone. No bending is too stiff for any h. */
mechanics_hits mechanics_flight(mechanics *m, double h, double *x, double *v);

/* Are there flexible cells; is a particle one of theirs? */
bool mechanics_has_chains(const mechanics *m);
bool mechanics_is_chained(const mechanics *m, size_t particle);

/* The forces of one term alone, 0 when it is not active; v may be NULL for terms that do not read it. */
void mechanics_force_of(mechanics *m, force_kind term, const double *x, const double *v, double *f);

double mechanics_drag(const mechanics *m);        /* linear drag of a particle; 0 without damping */
const double *mechanics_mass(const mechanics *m); /* mass of each particle (nparticles) */
size_t mechanics_particles(const mechanics *m);

/* Particle rows in the order of their cells' ids (nparticles): the order of sums over all of them. NULL: rows stand in
 * that order. */
const uint32_t *mechanics_order(const mechanics *m);

/* Radius of each particle, um (nparticles). */
const double *mechanics_radius(const mechanics *m);

/* Largest eigenfrequency squared (1/s2) of the bare springs that act at x: the bound on explicit steps. */
double mechanics_stiffness(mechanics *m, const double *x);

/* The same by power iteration from mode (nparticles x dimensions), the last eigenvector found, which it improves: cheap
 * where the system has changed little. A mode of zeros is started anew. */
double mechanics_stiffness_from(mechanics *m, const double *x, double *mode);

/* The same without what acts within flexible cells. */
double mechanics_stiffness_outside(mechanics *m, const double *x, double *mode);

/* The same of the stiffest contact that the lightest particle may come into, whether or not it is in one. */
double mechanics_contact_stiffness(const mechanics *m);

/* Who is to blame for a step that cannot be taken at x: the particle's cell, the term whose force on it is largest, and
 * the stiffest spring that acts on it, with its term. FORCE_COUNT: no term, no spring. */
typedef struct mechanics_culprit {
    uint64_t cell;
    force_kind strongest, stiffest;
    double k, mass; /* of that spring, pg/s2, and of the particle, pg */
} mechanics_culprit;
mechanics_culprit mechanics_blame(mechanics *m, const double *x, size_t particle);

/* Energy of one term at x, NULL: at the colony's own (1e-27 J); 0 for a term that is not active or has none. Kinetic:
 * of the colony's own v. */
double mechanics_energy(mechanics *m, force_kind term, const double *x);
double mechanics_kinetic(mechanics *m);

/* Particles that are nearer to the substratum than the clamp of dlvo, where its force is held; 0 without it. */
size_t mechanics_clamped(const mechanics *m);

/* Largest net force on a particle at the colony's own x, damping left out. */
double mechanics_fmax(mechanics *m);

/* Cells whose surfaces are nearer than this times the sum of their radii count as touching; at least 1. */
double mechanics_touch(const mechanics *m);

/* Per cell at the colony's own x: deepest overlap (r_A + r_B - distance, 0 when apart; without the 1 % reach), number
 * of contacts (cells within reach), and net force (ncells x 3) without damping. Arrays by cell row; any may be NULL. */
void mechanics_contacts(mechanics *m, double *overlap, uint32_t *contacts, double *force);

typedef struct mechanics_stats {
    uint64_t evaluations, builds;        /* since creation */
    uint64_t cell_evaluations;           /* evaluations, each times the cells it was of */
    double force_seconds, build_seconds; /* wall time */
    /* of every 64th evaluation: seconds of all threads in each term, and in what they read (capsules) */
    double term_seconds[FORCE_COUNT], upkeep_seconds;
    size_t pairs; /* entries of the present list */
    double skin;
    size_t bytes;       /* memory held */
    const char *kernel; /* "avx512", "avx2", "base" */
    bool flat;          /* and in the plane */
    bool spheres;       /* contacts are those of spheres: no cell has more than one particle */
} mechanics_stats;
mechanics_stats mechanics_statistics(const mechanics *m);

/* Memory by what it is for, bytes; parts that nothing here needs are 0. */
enum { MECHANICS_PARTS = 6 };
typedef struct mechanics_part {
    const char *name;
    size_t bytes;
} mechanics_part;
void mechanics_memory(const mechanics *m, mechanics_part parts[MECHANICS_PARTS]);

/* Does a term act on the bound colony: is it named, or on by what the colony holds? */
bool mechanics_is_active(const mechanics *m, force_kind term);

/* The loops for this processor's width of vectors: mechanics/kernel.h. */
const struct contact_kernel *mechanics_loops(const mechanics *m);

/* Chooses the contact kernel by name, for tests and measurements; false when this processor lacks it. */
bool mechanics_kernel(mechanics *m, const char *name);

#endif

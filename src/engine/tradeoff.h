/* SPDX-License-Identifier: GPL-3.0-or-later */
/* What accuracy costs, measured on a scene as it stands: the same beginning by several methods, with the motion's error
 * against a converged reference after one relaxation, and what cells do over many cycles, seed by seed. The scene is
 * afterwards what it was, to the bit, whatever happened. Units: um, s. */
#ifndef SARCINA_ENGINE_TRADEOFF_H
#define SARCINA_ENGINE_TRADEOFF_H

#include "engine/scene.h"

/* A method under test; a preset of accuracy, or an integrator with a step of its own. */
typedef struct tradeoff_method {
    const char *name;
    relax_settings how;
} tradeoff_method;

typedef struct tradeoff_cost {
    double seconds; /* of all processors */
    uint64_t evaluations, steps;
} tradeoff_cost;

/* How far two ends are apart: over all particles, um. */
typedef struct tradeoff_distance {
    double most, rms;
} tradeoff_distance;

/* The converged end: Dormand-Prince at ever tighter tolerances, until two that follow each other agree or a tighter
 * one would take too many evaluations. */
typedef struct tradeoff_reference {
    size_t cells;                 /* that were relaxed */
    double tolerance, coarser;    /* of the end taken, and of the one it is compared with, um and um/s */
    tradeoff_distance error;      /* between those two: the reference's own error is less */
    double displacement;          /* of each particle at the beginning, um, at most ... */
    tradeoff_distance divergence; /* ... and what has become of it at the end */
    uint64_t evaluations, first;  /* of all of this; of the coarsest */
    bool cut;                     /* the next tighter one takes too many evaluations */
} tradeoff_reference;

typedef enum {
    TRADEOFF_MEASURED,
    TRADEOFF_RESOLVED, /* no farther from the reference than twice the reference's own error */
    TRADEOFF_CHAOS,    /* a displacement too small to see changes the end about as much: no measure of accuracy */
    TRADEOFF_FAILED    /* the method could not go on: reason */
} tradeoff_state;

typedef struct tradeoff_row {
    tradeoff_state state;
    tradeoff_cost cost;
    tradeoff_distance error;
    bool front; /* no other measured row has fewer evaluations and a smaller rms error */
    char reason[200];
} tradeoff_row;

/* The cycle that is measured. Where it begins with growth, that is done once, for all methods. */
typedef struct tradeoff_plan {
    double grow, relax; /* s; grow 0: none */
} tradeoff_plan;

/* One relaxation by each of n methods, behind the plan's growth; rows (n). A method that cannot go on is a row that
 * says so; a reference that cannot be had (SARCINA_NUMERICAL), or an interruption, is an error. */
int tradeoff_relaxation(scene *s, const tradeoff_plan *plan, const tradeoff_method *methods, size_t n,
                        tradeoff_row *rows, tradeoff_reference *reference, diag *d);

/* Row with the least rms error; -1: none could be measured. */
int tradeoff_most_exact(const tradeoff_row *rows, size_t n);

#endif

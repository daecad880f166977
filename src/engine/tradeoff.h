/* SPDX-License-Identifier: GPL-3.0-or-later */
/* What accuracy costs, measured on a scene as it stands: the same beginning by several methods, with the motion's error
 * against a converged reference after one relaxation, and what cells do over many cycles, seed by seed. The scene is
 * afterwards what it was, to the bit, whatever happened. Units: um, s. */
#ifndef SARCINA_ENGINE_TRADEOFF_H
#define SARCINA_ENGINE_TRADEOFF_H

#include "base/inference.h"
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

/* The converged end: Dormand-Prince at ever tighter tolerances, until two that follow each other agree to a twentieth
 * of the least error measured, come no nearer to each other, or the next takes too many evaluations. */
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

/* ---- many cycles, seed by seed ----------------------------------------------------------------------------------- */

typedef struct tradeoff_study {
    tradeoff_plan plan; /* of a cycle */
    uint64_t cycles;
    size_t seeds; /* the scene's own, and those that follow it */
    size_t nobserved;
    void *self;
    /* Fills values (nobserved) of the scene as it stands at the end of a run by this method from this seed. */
    int (*observe)(void *self, size_t method, size_t seed, double *values, diag *d);
} tradeoff_study;

/* What the runs ended with; made by tradeoff_cycles, freed by tradeoff_runs_free. */
typedef struct tradeoff_runs {
    size_t methods, seeds, nobserved;
    double *values;      /* (methods x seeds x nobserved); NaN: undefined, or the method failed */
    tradeoff_cost *cost; /* of each method, over all seeds (methods) */
    bool *failed;        /* (methods) */
} tradeoff_runs;

int tradeoff_cycles(scene *s, const tradeoff_study *study, const tradeoff_method *methods, size_t n,
                    tradeoff_runs *runs, diag *d);
void tradeoff_runs_free(tradeoff_runs *r);

typedef enum {
    TRADEOFF_EQUIVALENT, /* the two one-sided tests say so at 5 %, whatever the interval */
    TRADEOFF_BIASED,     /* the interval excludes 0 */
    TRADEOFF_OPEN,       /* neither: more seeds would tell */
    TRADEOFF_UNDEFINED   /* a value is not there, or the method failed */
} tradeoff_verdict;

/* One observed quantity of one method, against the reference method, paired by seed. */
typedef struct tradeoff_comparison {
    inference_sample own, reference;
    inference_difference difference;
    double width;  /* half of the interval of the difference; 95 % for all quantities of a method together */
    double margin; /* of equivalence: that part of |mean| of the reference */
    double p;      /* of the two one-sided tests */
    tradeoff_verdict verdict;
    double seeds; /* about how many would tell; NaN: one seed says nothing of that */
} tradeoff_comparison;

/* Every method against that of row `reference`; out (methods x nobserved). margin: a part of the reference's mean. */
void tradeoff_compare(const tradeoff_runs *r, size_t reference, double margin, tradeoff_comparison *out);

/* The method with the fewest evaluations all of whose quantities are equivalent (or undefined, as the reference's are),
 * out of what tradeoff_compare found; the reference is one of them. */
size_t tradeoff_cheapest(const tradeoff_runs *r, size_t reference, const tradeoff_comparison *all);

/* Row with the least rms error; -1: none could be measured. */
int tradeoff_most_exact(const tradeoff_row *rows, size_t n);

#endif

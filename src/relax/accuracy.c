/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The presets of accuracy. They choose method and step, never physics: relaxation time and growth step are parameters
 * of the model and no preset touches them.
 *
 * Verlet's steps are at most 2 ms, 0.7 of the limit of stability, and longer as inertia fades (integrator/verlet.c):
 * that is where it saves, and where its error is. Against steps of 0.5 ms, E. coli from 2,000 rods on, radius of
 * gyration a growth step (of 1.2 %): steps of 2 ms +.008 +- .009 %, inertia .05 +.022 +- .008, .1 +.047 +- .008, .2
 * +.093 +- .007, as its size; paper +.014 +- .010. What that comes to from one cell to 3,000
 * rods: scripts/tradeoff ecoli_grown. */
#include "relax/relax.h"

#include "base/table.h"

const accuracy_preset accuracy_presets[] = {
    {"draft",
     "velocity Verlet as in balanced, inertia 0.3: for trying out",
     {.integrator = INTEGRATOR_VERLET, .most = 2e-3, .inertia = 0.3},
     "E. coli, ten growth steps, against reference: to 300 rods (10 seeds) radius of gyration 0.1 +- 0.4 %, mean "
     "layer -0.2 +- 0.3 %, equivalent within 2 %; to 3,000 (5 seeds) 1.2 +- 0.7 %, equivalent, and -1.5 +- 1.4 %, too "
     "wide; anchored, to 1,000 (5 seeds) -0.1 +- 0.3 % and 1.0 +- 1.1 %, equivalent",
     1000},
    {"fast",
     "velocity Verlet as in balanced, inertia 0.15",
     {.integrator = INTEGRATOR_VERLET, .most = 2e-3, .inertia = 0.15},
     "E. coli, ten growth steps, against reference: to 300 rods (10 seeds) radius of gyration 0.0 +- 0.4 %, mean "
     "layer -0.1 +- 0.4 %; to 3,000 (5 seeds) 1.2 +- 0.8 % and -1.5 +- 0.9 %; anchored, to 1,000 (5 seeds) -0.1 +- 0.6 "
     "% and 0.9 +- 2.2 %: all equivalent within 2 %",
     1000},
    {"balanced",
     "velocity Verlet, steps of at most 2 ms, longer as inertia fades (0.1)",
     {.integrator = INTEGRATOR_VERLET, .most = 2e-3, .inertia = 0.1},
     "E. coli, ten growth steps, against paper (48 seeds): to 300 rods radius of gyration 0.4 +- 0.2 %, order of "
     "neighbours (nematic) 0.4 +- 0.7 %, mean layer -0.5 +- 0.3 %; to 3,000 0.4 +- 0.2 %, 0.0 +- 0.9 %, -0.1 +- 0.4 "
     "%; anchored, to 1,000 0.0 +- 0.1 %, -0.3 +- 1.2 %, 0.3 +- 0.4 %, links -0.4 +- 0.9 %; from one cell to 3,000 "
     "against steps of 1 ms (20 seeds) radius 0.0 +- 1.5 %, layer 0.0 +- 2.7 %: all equivalent within 2 %; to 10,000 "
     "against paper (16 seeds) radius 0.3 +- 0.2 %, layer 0.1 +- 0.2 %, equivalent, order 1.1 +- 1.8 %, which needs "
     "more seeds",
     10000},
    {"paper",
     "Dormand-Prince 5(4) as published: tolerance 0.1 um and 0.1 um/s, begun anew every 0.2 s",
     {.integrator = INTEGRATOR_DOPRI5, .tolerance = 0.1, .segment = 0.2},
     "the original authors' program, state by state and in 20 colonies of 400 rods; its tolerance shows: "
     "against reference, E. coli stacks 7 +- 3 % earlier, and the radius of gyration of 300 rods is 1.3 +- 0.5 "
     "% less (20 seeds); at 3,000, against steps of 1 ms (20 seeds), 0.4 +- 1.3 % less, equivalent",
     400},
    {"reference",
     "Dormand-Prince 5(4), tolerance 0.001 um and 0.001 um/s",
     {.integrator = INTEGRATOR_DOPRI5, .tolerance = 1e-3},
     "E. coli of 330 rods: positions after 1 s within 1.1 nm (root mean square) of those by Verlet steps of 0.5 ms; "
     "beyond 1,000 rods trajectories are chaotic, and no method's are truer than another's",
     1000},
};
const size_t accuracy_preset_count = TABLE_COUNT(accuracy_presets);

/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The presets of accuracy. They choose method and step, never physics: relaxation time and growth step are parameters
 * of the model and no preset touches them.
 *
 * Verlet's steps are at most 2 ms, 0.7 of the limit of stability, and longer as inertia fades (integrator/verlet.c):
 * that is where it saves, and where its error is. Against steps of 0.5 ms, E. coli from 2,000 rods on, radius of
 * gyration a growth step (of 1.2 %): steps of 2 ms +.008 +- .009 %, inertia .05 +.022 +- .008, .1 +.047 +- .008, .2
 * +.093 +- .007, as its size; paper +.014 +- .010. */
#include "relax/relax.h"

#include "base/table.h"

const accuracy_preset accuracy_presets[] = {
    {"draft",
     "velocity Verlet as in balanced, inertia 0.3: for trying out",
     {.integrator = INTEGRATOR_VERLET, .most = 2e-3, .inertia = 0.3},
     "E. coli to 300 rods from one cell, against reference (20 seeds): radius of gyration 0.0 +- 0.6 %, first stacking "
     "-1 +- 3 %; at 3,000 rods 10 growth steps make the radius 1.0 +- 0.4 % too large, from one cell it is some 3 %",
     300},
    {"fast",
     "velocity Verlet as in balanced, inertia 0.15",
     {.integrator = INTEGRATOR_VERLET, .most = 2e-3, .inertia = 0.15},
     "E. coli to 300 rods from one cell, against reference (20 seeds): radius of gyration -0.2 +- 0.5 %, first "
     "stacking "
     "-2 +- 3 %; at 3,000 rods 10 growth steps make the radius 0.4 +- 0.3 % too large, from one cell it is 2 to 3 %",
     300},
    {"balanced",
     "velocity Verlet, steps of at most 2 ms, longer as inertia fades (0.07)",
     {.integrator = INTEGRATOR_VERLET, .most = 2e-3, .inertia = 0.07},
     "E. coli to 300 rods from one cell, against reference (20 seeds): radius of gyration 0.1 +- 0.6 %, first stacking "
     "0 +- 2 %; 10 growth steps at 3,000 rods, against paper (5 seeds): radius 0.1 +- 0.2 %, thickness -0.2 +- 0.5 %; "
     "3,000 from one cell (8 seeds): radius 1.8 +- 3.1 % above that by steps of 1 ms, 2.5 +- 2.4 % above paper's; "
     "flocs of 370 cells, against steps of 1 ms (6 seeds): sticking links 1 +- 4 %, radius -1 +- 6 %",
     3000},
    {"paper",
     "Dormand-Prince 5(4) as published: tolerance 0.1 um and 0.1 um/s, begun anew every 0.2 s",
     {.integrator = INTEGRATOR_DOPRI5, .tolerance = 0.1, .segment = 0.2},
     "the original authors' program, state by state and in 20 colonies of 400 rods; its tolerance shows: against "
     "reference, E. coli stacks 7 +- 3 % earlier, and the radius of gyration of 300 rods is 1.3 +- 0.5 % less (20 "
     "seeds)",
     400},
    {"reference",
     "Dormand-Prince 5(4), tolerance 0.001 um and 0.001 um/s",
     {.integrator = INTEGRATOR_DOPRI5, .tolerance = 1e-3},
     "E. coli of 330 rods: positions after 1 s within 1.1 nm (root mean square) of those by Verlet steps of 0.5 ms; "
     "beyond 1,000 rods trajectories are chaotic, and no method's are truer than another's",
     1000},
};
const size_t accuracy_preset_count = TABLE_COUNT(accuracy_presets);

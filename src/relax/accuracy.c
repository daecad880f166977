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
     "not validated: colonies of 3,000 rods are some 2 to 3 % too wide, as far as they are told apart at all below 300",
     0},
    {"fast",
     "velocity Verlet as in balanced, inertia 0.15",
     {.integrator = INTEGRATOR_VERLET, .most = 2e-3, .inertia = 0.15},
     "E. coli to 300 rods (20 seeds from one cell); at 3,000 rods 1 to 2 % too wide",
     300},
    {"balanced",
     "velocity Verlet, steps of at most 2 ms, longer as inertia fades (0.07)",
     {.integrator = INTEGRATOR_VERLET, .most = 2e-3, .inertia = 0.07},
     "E. coli to 3,000 rods: radius of gyration within 2 % of paper and of steps of 1 ms after 10 growth steps",
     3000},
    {"paper",
     "Dormand-Prince 5(4) as published: tolerance 0.1 um and 0.1 um/s, begun anew every 0.2 s",
     {.integrator = INTEGRATOR_DOPRI5, .tolerance = 0.1, .segment = 0.2},
     "the original authors' program, state by state and in 20 colonies of 400 rods",
     400},
    {"reference",
     "Dormand-Prince 5(4), tolerance 0.001 um and 0.001 um/s",
     {.integrator = INTEGRATOR_DOPRI5, .tolerance = 1e-3},
     "convergence: halving its steps changes less than it does; beyond 1,000 rods trajectories are chaotic",
     1000},
};
const size_t accuracy_preset_count = TABLE_COUNT(accuracy_presets);

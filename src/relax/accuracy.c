/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The presets of accuracy. They choose method and step, never physics: relaxation time and growth step are parameters
 * of the model and no preset touches them.
 *
 * Measured on unlinked E. coli (1 s, position error rms in um at 20 / 321 / 3,192 rods; evaluations): paper .012 / .020
 * / .096 (1,300-2,300), velocity Verlet 1 ms .002 / .005 / .078 (1,000), 2 ms .013 / .070 / .21 (500). To 3,000 rods
 * all of these have the paper's statistics within intervals; no method with fewer than about 500 evaluations did, so
 * draft stays at 2 ms. */
#include "relax/relax.h"

#include "base/table.h"

const accuracy_preset accuracy_presets[] = {
    {"draft", "velocity Verlet, steps of at most 2 ms", {.integrator = INTEGRATOR_VERLET, .most = 2e-3}},
    {"fast", "velocity Verlet, steps of at most 1.5 ms", {.integrator = INTEGRATOR_VERLET, .most = 1.5e-3}},
    {"balanced", "velocity Verlet, steps of at most 1 ms", {.integrator = INTEGRATOR_VERLET, .most = 1e-3}},
    {"paper",
     "Dormand-Prince 5(4) as published: tolerance 0.1 um and 0.1 um/s, begun anew every 0.2 s",
     {.integrator = INTEGRATOR_DOPRI5, .tolerance = 0.1, .segment = 0.2}},
    {"reference",
     "Dormand-Prince 5(4), tolerance 0.001 um and 0.001 um/s",
     {.integrator = INTEGRATOR_DOPRI5, .tolerance = 1e-3}},
};
const size_t accuracy_preset_count = TABLE_COUNT(accuracy_presets);

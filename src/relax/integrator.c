/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "relax/integrator.h"

const integrator_style *const integrator_styles[INTEGRATOR_COUNT] = {
    [INTEGRATOR_DOPRI5] = &integrator_dopri5, [INTEGRATOR_VERLET] = &integrator_verlet,
    [INTEGRATOR_RK4] = &integrator_rk4,       [INTEGRATOR_RKF45] = &integrator_rkf45,
    [INTEGRATOR_RK8PD] = &integrator_rk8pd,   [INTEGRATOR_EULER] = &integrator_euler,
    [INTEGRATOR_BS32] = &integrator_bs32,     [INTEGRATOR_NEWTON] = &integrator_newton,
};

int integrator_check(const relax_settings *how, const char **wrong, diag *d) {
    const integrator_style *style = integrator_styles[how->integrator];
    if (style->caps & INTEGRATOR_MINIMISES && (how->step > 0 || how->tolerance > 0 || how->inertia > 0)) {
        *wrong = how->step > 0 ? "step" : how->tolerance > 0 ? "tol" : "inertia";
        return diag_error(d, "integrator %s has no %s: it finds its own step", style->name, *wrong);
    }
    if (how->tolerance > 0 && !(style->caps & INTEGRATOR_ADAPTIVE)) {
        *wrong = "tol";
        return diag_error(d, "%s does not control its error: it has no tol", style->name);
    }
    if (how->inertia > 0 && !(style->caps & INTEGRATOR_EXACT_DAMPING)) {
        *wrong = "inertia";
        return diag_error(d, "inertia is for verlet and euler, which solve the damping exactly, not for %s",
                          style->name);
    }
    if (how->inertia > 0 && how->step > 0) {
        *wrong = "inertia";
        return diag_error(d, "inertia makes longer steps from the stiffness of the scene, and step sets them: one of "
                             "both");
    }
    return SARCINA_OK;
}

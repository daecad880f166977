/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "model/shape.h"

#include <math.h>
#include <sleef.h>

double shape_coccus_diameter(double mass, double density) {
    return Sleef_cinz_cbrtd1_u10purec(6 * mass / (M_PI * density));
}

double shape_coccus_mass(double diameter, double density) {
    return M_PI * density * diameter * diameter * diameter / 6;
}

double shape_rod_rest(double mass, double diameter, double density) {
    return 4 * mass / (density * M_PI * diameter * diameter) - 2 * diameter / 3;
}

double shape_rod_mass(double rest, double diameter, double density) {
    return density * M_PI * diameter * diameter * (rest + 2 * diameter / 3) / 4;
}

double shape_rod_aspect_diameter(double mass, double aspect, double density) {
    return Sleef_cinz_cbrtd1_u10purec(4 * mass / (density * M_PI * (aspect - 1.0 / 3)));
}

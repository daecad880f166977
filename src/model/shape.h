/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Mass sets shape, at constant density (model: Storck et al. 2014, "Primary structures"):
 *   coccus                D = (6 m / (pi rho))^(1/3)
 *   rod, fixed diameter   L_rest = 4 m / (rho pi D^2) - 2 D / 3
 *   rod, fixed aspect a   L_rest = (a - 1) D, D = (4 m / (rho pi (a - 1/3)))^(1/3)
 * L_rest: between the particles; the total length is L_rest + D. Units: um, pg, pg/um3. */
#ifndef SARCINA_MODEL_SHAPE_H
#define SARCINA_MODEL_SHAPE_H

double shape_coccus_diameter(double mass, double density);
double shape_coccus_mass(double diameter, double density);
double shape_rod_rest(double mass, double diameter, double density);
double shape_rod_mass(double rest, double diameter, double density);
double shape_rod_aspect_diameter(double mass, double aspect, double density);

#endif

/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Scenes of two dimensions: a strict monolayer in the plane z = 0. Centres, axes and velocities have no z, nothing may
 * give them one, and so they keep it to the bit; cells are still bodies, with the mass and volume of such. Each
 * function is an error where something would lead out of the plane, and does nothing in three dimensions. */
#ifndef SARCINA_ENGINE_FLAT_H
#define SARCINA_ENGINE_FLAT_H

#include "engine/scene.h"

/* May the scene as it stands be of two dimensions? Whatever its dimension is now. */
int flat_check_scene(const scene *s, diag *d);

int flat_check_term(const scene *s, force_kind term, diag *d);
int flat_check_link(const scene *s, link_kind kind, diag *d);
int flat_check_species(const scene *s, const species *sp, diag *d);
int flat_check_region(const scene *s, const region *where, diag *d);
int flat_check_orient(const scene *s, orient_kind orient, const double axis[3], diag *d);

/* A place or velocity; what: "a cell at z". */
int flat_check_place(const scene *s, const double x[3], diag *d);

/* A row of a file: its centre, axis and particles. */
int flat_check_row(const scene *s, const cell_row *row, diag *d);

#endif

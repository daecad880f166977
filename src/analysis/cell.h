/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Values of one cell (row of the cell table); engine units. See value.c for their definitions. */
#ifndef SARCINA_ANALYSIS_CELL_H
#define SARCINA_ANALYSIS_CELL_H

#include "analysis/view.h"

/* Every cell value that is a number: CELL_VALUE(name, dimension, definition). */
#define CELL_VALUES                                                                                                    \
    CELL_VALUE(id, "number", "identity, never reused, from 1")                                                         \
    CELL_VALUE(parent, "number", "id of the mother; 0 for a created cell")                                             \
    CELL_VALUE(founder, "number", "id of the created cell it descends from")                                           \
    CELL_VALUE(generation, "number", "divisions since the founder")                                                    \
    CELL_VALUE(age, "time", "time since it was born or created")                                                       \
    CELL_VALUE(mass, "mass", "mass of the cell")                                                                       \
    CELL_VALUE(stage, "number", "mass over the mass at which it divides; 0 when it never divides")                     \
    CELL_VALUE(rate, "rate", "growth rate drawn last")                                                                 \
    CELL_VALUE(x, "length", "x of the centre, its centre of mass")                                                     \
    CELL_VALUE(y, "length", "y of the centre")                                                                         \
    CELL_VALUE(z, "length", "z of the centre")                                                                         \
    CELL_VALUE(ux, "number", "x of the axis, a unit vector from end to end; 0 for a coccus")                           \
    CELL_VALUE(uy, "number", "y of the axis")                                                                          \
    CELL_VALUE(uz, "number", "z of the axis")                                                                          \
    CELL_VALUE(zmin, "length", "z of its lowest particle")                                                             \
    CELL_VALUE(zmax, "length", "z of its highest particle")                                                            \
    CELL_VALUE(length, "length", "distance along its particles plus the diameter (tip to tip, with caps)")             \
    CELL_VALUE(straightness, "number",                                                                                 \
               "distance of its end particles over the length along its particles; 1 for a rod, a coccus")             \
    CELL_VALUE(diameter, "length", "diameter")                                                                         \
    CELL_VALUE(volume, "volume", "mass over density")                                                                  \
    CELL_VALUE(vx, "velocity", "x of the velocity of the centre")                                                      \
    CELL_VALUE(vy, "velocity", "y of the velocity of the centre")                                                      \
    CELL_VALUE(vz, "velocity", "z of the velocity of the centre")                                                      \
    CELL_VALUE(speed, "velocity", "magnitude of the velocity of the centre")                                           \
    CELL_VALUE(fx, "force", "x of the net force, damping left out")                                                    \
    CELL_VALUE(fy, "force", "y of the net force")                                                                      \
    CELL_VALUE(fz, "force", "z of the net force")                                                                      \
    CELL_VALUE(contacts, "number", "cells within reach of the contact force")                                          \
    CELL_VALUE(overlap, "length", "deepest overlap with another cell; 0: none")                                        \
    CELL_VALUE(filial, "number", "filial links it has")                                                                \
    CELL_VALUE(stuck, "number", "sticking links it has")                                                               \
    CELL_VALUE(anchored, "number", "anchoring links it has")                                                           \
    CELL_VALUE(stretch, "length", "longest excess of a spring of the cell or its links over its rest length")          \
    CELL_VALUE(strain, "number", "largest excess of such a spring relative to its rest length")                        \
    CELL_VALUE(cluster, "number", "lowest id among the cells that links join it to")                                   \
    CELL_VALUE(quati, "number", "i of the rotation that takes z to the axis")                                          \
    CELL_VALUE(quatj, "number", "j of the rotation")                                                                   \
    CELL_VALUE(quatk, "number", "k of the rotation: 0")                                                                \
    CELL_VALUE(quatw, "number", "real part of the rotation")                                                           \
    CELL_VALUE(shapex, "length", "diameter, as OVITO reads spherocylinders (it halves)")                               \
    CELL_VALUE(shapey, "length", "diameter")                                                                           \
    CELL_VALUE(shapez, "length", "twice the length between the caps, as OVITO reads spherocylinders (it halves)")

#define CELL_VALUE(name, dimension, definition) double cell_##name(const view *v, uint32_t row);
CELL_VALUES
#undef CELL_VALUE

/* The shortest rotation (i, j, k, w) from z to an axis (unit vector, or 0 0 0: none), or to its opposite where that is
 * nearer: a capsule has no head, and so nothing is divided by zero. */
void cell_quaternion(const double u[3], double q[4]);

/* Name of its species; belongs to the species table. */
const char *cell_species(const view *v, uint32_t row);

#endif

/* SPDX-License-Identifier: GPL-3.0-or-later */
/* What the cells of a species share: shape, size, density, and the laws by which they grow, divide and link. */
#ifndef SARCINA_MODEL_SPECIES_H
#define SARCINA_MODEL_SPECIES_H

#include "base/param.h"
#include "base/spread.h"
#include "model/chain.h"
#include "model/colony.h"

typedef enum { SHAPE_COCCUS, SHAPE_ROD, SHAPE_FLEXIBLE } shape_kind;

/* A style chosen from a table, with its parameters in the order of the style's param records (engine units;
 * a choice is its row, a flag 0 or 1). */
typedef struct style_choice {
    int style; /* row in the style's table; -1: none */
    spread values[PARAM_COUNT_MAX];
} style_choice;

typedef struct species {
    char name[64];
    shape_kind shape;
    double density;  /* pg/um3 */
    spread diameter; /* rods of fixed diameter and flexible cells, um; law fixed and 0: aspect is kept instead */
    spread aspect;   /* rods of fixed length over diameter; 0: not kept */
    char color[16];  /* "#rrggbb", or "" : by order */
    style_choice growth, division;
    double internal_k; /* each spring inside a rod or flexible cell, pg/s2; 0: the script has not named it */
    /* flexible cells */
    uint32_t particles;             /* of each cell, 3 or more */
    chain_coil coil;                /* rest shape */
    double bend_k, twist_k;         /* 1e-27 J; 0: the script has not named it */
    double bend_angle, twist_angle; /* rest angles, rad; NaN: those of the rest shape */
} species;

typedef struct species_table {
    size_t count, capacity;
    species *list;
} species_table;

/* Row of the species called name; -1: there is none. */
int species_find(const species_table *t, const char *name);

/* Adds a species with nothing set but its name; returns its row. */
int species_add(species_table *t, const char *name);

/* Diameter and rest length of a cell from its mass and what it keeps (its columns diameter or aspect). */
void species_shape_cell(const species *s, colony *c, uint32_t row);

/* Rest length of each spring inside a cell of the species whose rest length is `rest`: of a coil's segment, the chord.
 */
double species_segment(const species *s, double rest);

/* Rest angles of such a flexible cell: turning angle, cosine and sine of the torsion. */
void species_rest_angles(const species *s, double rest, double *theta, double *cos_phi, double *sin_phi);

/* What an error calls a cell of the shape: "a coccus", "a rod", "flexible". */
const char *species_shape_name(shape_kind shape);

/* Rest length a rod of this mass would have, with diameter d (fixed diameter) or aspect a (a > 0). */
double species_rest(const species *s, double mass, double diameter, double aspect);

/* Constant of the springs inside a cell: its own, or that of the species; 0: the script has not named any. pg/s2. */
double species_stiffness(const species *s, const colony *c, uint32_t row);

/* Particles a cell of this species has. */
size_t species_particles(const species *s);

#endif

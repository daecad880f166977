/* SPDX-License-Identifier: GPL-3.0-or-later */
/* What one `create_cells` asks for: of the command, which carries it out, and of the forecast, which keeps it. */
#ifndef SARCINA_COMMAND_CREATION_H
#define SARCINA_COMMAND_CREATION_H

#include "engine/scene.h"

typedef enum { CREATION_SINGLE, CREATION_RANDOM, CREATION_GRID } creation_kind;

typedef struct creation {
    creation_kind kind;
    placement placement;
    double at[3];           /* of one, or of the first of a grid, um */
    double step[3];         /* of a grid, um */
    long long n, points[3]; /* at random places; of a grid along x, y and z */
    double spacing;         /* at random places, um; 0: as they come */
    region where;           /* a copy */
} creation;

/* How many places it names; a filament stands at each, or a cell. */
double creation_count(const creation *c);

/* All of them or none. *created: how many cells. */
int creation_make(scene *s, const creation *c, size_t *created, diag *d);

#endif

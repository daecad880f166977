/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The index of a series of VTK files (.pvd): which file shows which growth time, for ParaView to open as one. It is
 * whole after every step, for it is written beside and renamed.
 *
 *     <VTKFile type="Collection"><Collection><DataSet timestep="SECONDS" part="0" file="NAME"/> ... */
#ifndef SARCINA_OUTPUT_COLLECTION_H
#define SARCINA_OUTPUT_COLLECTION_H

#include "base/diag.h"

#include <stdint.h>

typedef struct collection collection;

/* Of the files of this pattern, `*` the step: the index stands beside them, named as what comes before the *, without
 * `.`, `_` or `-` at its end: colony.*.vtp has colony.pvd. A `*` alone has index.pvd. Touches no file. */
collection *collection_create(const char *pattern);
void collection_free(collection *c); /* NULL is allowed */

/* One more file of the series. The first call begins the index anew, or, after collection_rewind, goes on. */
int collection_add(collection *c, double time, const char *file, diag *d);

/* The scene has gone back to this step: entries of later ones leave the index, when it is written next. */
void collection_rewind(collection *c, uint64_t step);

#endif

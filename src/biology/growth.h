/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Growth laws: the table, and the step that applies them. Growth changes mass only; mass sets shape (model/shape.h). */
#ifndef SARCINA_BIOLOGY_GROWTH_H
#define SARCINA_BIOLOGY_GROWTH_H

#include "base/diag.h"
#include "base/param.h"
#include "base/rng.h"
#include "model/colony.h"
#include "model/species.h"

typedef struct growth_style {
    const char *name, *summary, *formula, *source, *example;
    const param *params; /* in the order of style_choice.values */
    size_t nparams;
    double (*mass_after)(double mass, double rate, double dt);
} growth_style;

extern const growth_style growth_styles[];
extern const size_t growth_style_count;

/* Parameters that every law has, first in its list. */
enum { GROWTH_RATE, GROWTH_DRAW };
enum { DRAW_STEP, DRAW_BIRTH };

/* Every cell of a species with a law grows for dt seconds, as step number `step` of the random streams. A law that
 * would leave a mass that is not positive and finite is an error that names the cell; nothing has changed then. */
int growth_step(colony *c, const species_table *t, rng *r, uint64_t step, double dt, diag *d);

#endif

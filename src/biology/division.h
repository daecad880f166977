/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Division rules: the table, and the step that divides the cells that are due. */
#ifndef SARCINA_BIOLOGY_DIVISION_H
#define SARCINA_BIOLOGY_DIVISION_H

#include "base/diag.h"
#include "base/param.h"
#include "base/rng.h"
#include "model/colony.h"
#include "model/link_rules.h"
#include "model/species.h"

/* What a rule is told of the scene. */
typedef struct division_context {
    colony *colony;
    const species_table *species;
    const link_rules *links; /* NULL: no links are made or handed on */
    rng *rng;
    double time;     /* growth time at which the daughters are born, s */
    bool flat;       /* two dimensions: all stays in the plane of x and y */
    bool substratum; /* is there a plane, and at which height (um)? */
    double substratum_z;
} division_context;

/* Are random directions beside the division's own (jitter, frame, side of a snap) drawn in the plane of x and y? */
static inline bool division_is_horizontal(const division_context *x) {
    return x->substratum || x->flat;
}

typedef struct division_style {
    const char *name, *summary, *source, *example;
    const char *head;    /* its name as a command has it, with the arguments in place */
    unsigned shapes;     /* whose rule it is: bit SHAPE_... */
    const param *params; /* in the order of style_choice.values; the first two are sizes at division, one of which
                          * counts and the other is NaN */
    size_t nparams;
    /* Places mother (row) and daughter (appended; its row is returned) of half the mother's mass each; the caller sets
     * masses and identity columns before, shapes are right when it is called. */
    void (*place)(const division_context *x, uint32_t mother, uint32_t daughter);
    /* Before any cell of the step divides: turns what the mother keeps of her orientation to where her n filial
     * neighbours (rows) lie now. Optional. */
    void (*turn)(const division_context *x, uint32_t mother, const uint32_t *neighbours, size_t n);
} division_style;

extern const division_style *const division_styles[];
extern const size_t division_style_count;

enum { DIVISION_COCCI = 1 << SHAPE_COCCUS, DIVISION_RODS = 1 << SHAPE_ROD, DIVISION_FLEXIBLE = 1 << SHAPE_FLEXIBLE };

/* Columns of style_choice.values: four that every rule has, then its own. */
enum { DIVISION_MASS, DIVISION_SIZE, DIVISION_JITTER, DIVISION_AXIS, DIVISION_OWN };
enum { DIVISION_BRANCH = DIVISION_OWN }; /* of midpoint */
enum { DIVISION_TRIES = DIVISION_OWN };  /* of random */
enum { DIVISION_PLANES = DIVISION_OWN }; /* of planes */
enum {
    DIVISION_PAIRS = DIVISION_OWN + 1,
    DIVISION_SNAP
}; /* the former of midpoint and planes, the latter of midpoint */

/* Do cells of the species share walls with others than mother and daughter: cocci that divide along two or three
 * planes?
 */
bool division_walls(const species *s);

/* How the species' divisions lead out of the plane of x and y ("along three axes"); NULL: they do not. */
const char *division_leaves_plane(const species *s);

/* Do cells of the species part from their older filial neighbours when they divide? */
bool division_pairs(const species *s);
enum { AXIS_AUTO, AXIS_X, AXIS_Y, AXIS_Z };

/* Mass at which a cell divides, pg: drawn once a life where the rule has a spread; infinite without a rule. */
double division_limit(const species *s, rng *r, uint64_t id, double diameter, double aspect);

/* The species' mean mass at division, for its mean diameter; NaN without a rule. */
double division_mean_mass(const species *s);

/* Probability that the daughter of a cell linked filially at both ends begins a branch. */
double division_branch(const species *s);

/* Is the rule possible for the shape: would the daughters of a cell of mean size have a body? */
int division_check(const species *s, diag *d);

/* Draws a diameter or aspect (> 0) for cell id of the species into the columns; a coccus keeps none. */
void division_draw_size(const species *s, colony *c, uint32_t row, rng *r);

/* Divides, in the order of the mothers' ids, every cell whose mass exceeds its limit, once. Returns how many. */
size_t division_step(const division_context *x);

#endif

/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Links between cells and to the substratum: a set of springs that is made and broken as one. How many there are
 * between which particles, how stiff and how long at rest: Storck et al. 2014, "Filial, sticking and anchoring links".
 * Units: um, pg, s. */
#ifndef SARCINA_MODEL_LINK_H
#define SARCINA_MODEL_LINK_H

#include "model/link_rules.h"

/* What a filial link is: in a row, or one of the two that hold the first cell of a branch (cell_a). */
typedef enum { LINK_STRAIGHT, LINK_BRANCHED } link_joint;

/* Which end of a cell faces the other: its first or last particle. Of a coccus both are the same. */
typedef enum { LINK_FIRST_END, LINK_LAST_END } link_end;

/* A filial link between the ends of two cells, by the rule for filial links; returns its row. */
uint32_t link_add_filial(colony *c, const link_rule *rule, link_joint joint, uint32_t row_a, link_end end_a,
                         uint32_t row_b, link_end end_b, double time);

/* A sticking link between two cells as they lie; returns its row. */
uint32_t link_add_stick(colony *c, const link_rule *rule, uint32_t row_a, uint32_t row_b, double time);

/* Anchors a cell as it lies above a substratum at height floor; returns the link's row. */
uint32_t link_add_anchor(colony *c, const link_rule *rule, uint32_t row, double floor, double time);

/* Attaches a sticking link to two cells (rows) as they lie now, as if formed here. */
void link_attach_stick(colony *c, uint32_t link, uint32_t row_a, uint32_t row_b);

/* Lets spring i of an anchoring link hold particle i of a cell (row), from the point straight below it. */
void link_attach_anchor(colony *c, uint32_t link, uint32_t i, uint32_t row, double floor);

/* The end of a cell (row; the link's a or b) that a filial link holds. */
link_end link_find_end(const colony *c, uint32_t link, uint32_t row);

/* Spring constants of all links from the rules as they stand, and rest lengths of filial ones from their cells' sizes:
 * after growth, and when a rule or a size has changed. A link whose species have no rule stays as it is. */
void link_renew(colony *c, const link_rules *rules);

/* Drops the links of a kind whose species (or pair of species) have no rule; returns how many. */
size_t link_drop_unruled(colony *c, const link_rules *rules, link_kind kind);

/* The rule a link follows; NULL. */
const link_rule *link_find_rule(colony *c, const link_rules *rules, uint32_t link);

#endif

/* SPDX-License-Identifier: GPL-3.0-or-later */
/* What becomes of a mother's links when she divides, and the link between her and her daughter (Storck et al. 2014,
 * "Secondary structures"; growth and division).
 *
 * Filial: what holds the end that is now the daughter's goes to the daughter, so that she is inserted into the
 * filament; of a coccus, what is nearer to the daughter. Then mother and daughter are linked, end to end. Where the
 * rule says `pairs`, the mother's older links break instead, and what she was part of falls into pairs. With the
 * probability of the division rule the daughter of a cell linked at both ends begins a branch instead: the links stay,
 * and she is joined to her mother and to the neighbour on her side.
 * A coccus that divides along two or three planes cuts the walls it shares with its neighbours: where a neighbour has
 * divided alike, her half of that wall joins the daughter to the neighbour's own, so that tetrads and packets hold
 * along every edge.
 * Sticking: a link goes to the nearer of mother and daughter, where it is as if formed then (its age is kept).
 * Anchoring: an anchor point stays with the nearer of mother and daughter. The particle that has not moved keeps its
 * spring; the others of a cell so held are anchored below where they are born.
 * With `handover mother` the mother keeps sticking or anchoring links as they are: her inner particle has jumped, and
 * they are stretched by that, as in the original authors' program. */
#ifndef SARCINA_BIOLOGY_HANDOVER_H
#define SARCINA_BIOLOGY_HANDOVER_H

#include "biology/division.h"

typedef struct handover handover;

/* For the divisions of one step; NULL when no cell is linked and none will be, which every call takes. */
handover *handover_begin(const division_context *x);

/* Rows of up to HANDOVER_NEIGHBOURS cells that a cell is filially linked to, in the order of the links; returns how
 * many. */
enum { HANDOVER_NEIGHBOURS = 8 };
size_t handover_neighbours(const handover *h, uint32_t row, uint32_t neighbours[HANDOVER_NEIGHBOURS]);

/* After mother and daughter (rows) have been placed. */
void handover_divide(handover *h, uint32_t mother, uint32_t daughter);

void handover_end(handover *h);

#endif

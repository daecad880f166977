/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Who was the mother of whom, for cells that are no longer there: the living have it in their column `parent`. So a
 * scene without deletions keeps nothing, and descent can be told across the dead. */
#ifndef SARCINA_MODEL_LINEAGE_H
#define SARCINA_MODEL_LINEAGE_H

#include "model/colony.h"

typedef struct lineage lineage;

/* No one dead yet. It counts references, so that snapshots share it: lineage_free gives up one, and takes NULL. */
lineage *lineage_create(void);
lineage *lineage_keep(lineage *l);
void lineage_free(lineage *l);

/* Adds the cells whose flag is set (by cell row), before they are deleted. *l is replaced when it is shared. */
void lineage_add(lineage **l, colony *c, const bool *doomed);

/* Flags (by cell row) the cell with this id, and every cell that descends from it. */
void lineage_mark(const lineage *l, colony *c, uint64_t id, bool *flags);

/* The table as pairs (id, mother's id), in the order of ids, for restart files. */
size_t lineage_count(const lineage *l);
const uint64_t *lineage_pairs(const lineage *l);
lineage *lineage_of_pairs(const uint64_t *pairs, size_t n);

#endif

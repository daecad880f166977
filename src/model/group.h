/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Groups that cells are put into and daughters inherit: a bit each of the column `groups`. Which cells are in is in
 * the colony; the table has the names. (Groups by a test that is made anew at every look are the command layer's.) */
#ifndef SARCINA_MODEL_GROUP_H
#define SARCINA_MODEL_GROUP_H

#include "model/colony.h"

enum { GROUP_MAX = 64 };

typedef struct group_table {
    char name[GROUP_MAX][64]; /* "": the bit is free */
} group_table;

/* Bit of the group called so; -1: there is none. */
int group_find(const group_table *t, const char *name);

/* Gives a new group the lowest free bit; -1: all are taken. No cell is in it. */
int group_add(group_table *t, const char *name);

/* Frees a bit; no cell is in it any more. */
void group_remove(group_table *t, int bit, colony *c);

/* Makes the cells whose flag is set (by cell row), and no others, the group. */
void group_assign(int bit, colony *c, const bool *flags);

bool group_has(const colony *c, uint32_t row, int bit);

#endif

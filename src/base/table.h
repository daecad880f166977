/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Counted tables of records whose first member is `const char *name`: one look-up for all of them. */
#ifndef SARCINA_BASE_TABLE_H
#define SARCINA_BASE_TABLE_H

#include <stddef.h>

/* Row of the record called name among n records of stride bytes; -1 when there is none. */
ptrdiff_t table_find(const void *records, size_t n, size_t stride, const char *name);

/* The name nearest to what was typed (edit distance, swaps counted once, case slips almost free) among n records;
 * NULL when none is near enough to suggest. */
const char *table_nearest(const void *records, size_t n, size_t stride, const char *typed);

/* The same distance for callers whose names are not in one table: smaller is nearer; 0: equal. */
double table_distance(const char *typed, const char *name);

/* Whether a distance is small enough, for what was typed, to say "did you mean". */
int table_is_near(const char *typed, double distance);

#define TABLE_COUNT(a) (sizeof(a) / sizeof(a)[0])

#endif

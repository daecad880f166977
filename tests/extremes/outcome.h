/* SPDX-License-Identifier: GPL-3.0-or-later */
/* What came of each case with each preset when they were last recorded: outcomes.tsv, a row each, from which the
 * manual's page is written and with which a run of the full tier is compared. Only what is the same on every machine is
 * in it. */
#ifndef SARCINA_TESTS_EXTREMES_OUTCOME_H
#define SARCINA_TESTS_EXTREMES_OUTCOME_H

#include "extremes/judge.h"

/* The row of a case: id, preset, what came of it, steps, refused steps, evaluations, shortest step, the error's words;
 * the caller frees. */
char *outcome_row(const extreme *e, size_t preset, const verdict *v);

/* The recorded rows, a text each, for outcome_find; free with outcome_free. NULL: no such file. */
typedef struct outcome_table outcome_table;
outcome_table *outcome_read(const char *path);
void outcome_free(outcome_table *t);

/* The row recorded of a case; NULL. */
const char *outcome_find(const outcome_table *t, const extreme *e, size_t preset);

/* The manual's page of all cases up to the full tier; those that are not recorded are told on stderr. Returns how many.
 */
size_t outcome_write_page(const outcome_table *t, const extreme_table *cases);

#endif

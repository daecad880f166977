/* SPDX-License-Identifier: GPL-3.0-or-later */
/* -test: scripts with expects and reference tables.
 *
 * Each script (*.test.in) runs in a fresh folder that is removed afterwards. A comment at its head,
 *
 *     # ref: table.csv rel 1e-6 abs 0 column C abs 0.01
 *
 * compares the table it writes with table.csv.ref beside the script. Counted are expects, tables, and scripts that
 * stop with an error or hold neither. */
#ifndef SARCINA_APP_TEST_RUN_H
#define SARCINA_APP_TEST_RUN_H

#include "app/options.h"
#include "app/program.h"

/* Prints "N passed, N failed"; SARCINA_EXPECT when any failed, SARCINA_ERROR when there was nothing to run. */
int test_run_all(program *p, const options *o);

#endif

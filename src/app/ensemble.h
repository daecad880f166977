/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Ensembles: one script run with many seeds (-replicates) and values of variables (-sweep), each run in a folder of
 * its own below NAME.runs, by as many processes at a time as there are cores, or by the ranks of mpirun.
 *
 *   NAME.runs/d=0.5um/seed=3/   screen.txt errors.txt log.sarcina results.csv scalars.csv, what the script writes,
 *                               and `done` once the run has ended well
 *   NAME.ensemble.csv           every thermo column and analysis: mean, interval ... over the replicates, per step
 *   NAME.scalars.csv            one row a replicate; NAME.summary.csv: their means and intervals
 *
 * Whether a run is done is read from its folder, so running again does what is missing. Tables are merged from the
 * folders in the order of the plan, so they depend on no number of workers. */
#ifndef SARCINA_APP_ENSEMBLE_H
#define SARCINA_APP_ENSEMBLE_H

#include "app/options.h"
#include "app/plan.h"
#include "app/program.h"

/* Checks the script, runs what is missing and merges; the exit code: 0, 1 when a replicate failed, 130 interrupted. */
int ensemble_main(program *host, const options *o);

#endif

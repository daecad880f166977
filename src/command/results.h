/* SPDX-License-Identifier: GPL-3.0-or-later */
/* What a run leaves for the ensemble it belongs to (-results), in its folder, in SI units:
 *
 *   results.csv   step,time,quantity,unit,value: at each thermo row, every column and every analysis by its ID; bins
 *                 as ID.count[3]
 *   scalars.csv   quantity,unit,value: at the end, what first_time analyses saw (`never`: nothing) and the value of
 *                 every `equal` variable that is one number
 *
 * Quantities are named in the tables rather than being their columns, because a script may change its columns. */
#ifndef SARCINA_COMMAND_RESULTS_H
#define SARCINA_COMMAND_RESULTS_H

#include "command/outputs.h"

/* Adds the present step to results.csv, unless it is there: the thermo table has just written its row. Going on from a
 * restart file, the rows after its step are dropped. */
int results_row(outputs *o, diag *d);

/* Writes scalars.csv of the scene as it stands at the end of a script. */
int results_scalars(interp *in, diag *d);

#endif

/* SPDX-License-Identifier: GPL-3.0-or-later */
/* What a run writes while it goes on: the thermo table, dumps and analyses, each with its interval. */
#ifndef SARCINA_COMMAND_OUTPUTS_H
#define SARCINA_COMMAND_OUTPUTS_H

#include "engine/archive.h"
#include "script/command.h"

typedef struct outputs outputs;

outputs *outputs_create(interp *in);
void outputs_free(outputs *o);

/* Before the first cycle of a run: opens what is to be written, so that a file that cannot be is found out now. */
int outputs_open(outputs *o, diag *d);

/* Then prints the thermo header and the row of the present step, and writes what is due at it. */
int outputs_begin(outputs *o, diag *d);

/* After each cycle; last: the run ends here, whose row is always printed. Judges first_time analyses, prints thermo
 * rows, writes dumps and analyses that are due. A step is written once to each file, the log repeats it at a new run.
 * May be called again at the same step with last (until has come true): nothing is written or printed twice. */
int outputs_step(outputs *o, bool last, diag *d);

/* After a run: files are flushed. */
void outputs_end(outputs *o);

/* Takes out every dump, analysis and the thermo settings. */
void outputs_clear(outputs *o);

/* Where the outputs stand (last step written to each file, what first_time has seen): into a restart file and back.
 * Loading, tables and text files lose the rows after the restart's step and go on. */
void outputs_save(const outputs *o, archive *a);
int outputs_load(outputs *o, const archive *a, diag *d);

/* Is something with interval `every` due after the cycle that led from time `before` to `now`, to this step? */
bool outputs_due(args_cycles_value every, uint64_t step, double before, double now);

#endif

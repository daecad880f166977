/* SPDX-License-Identifier: GPL-3.0-or-later */
/* How far a run is, and how long it will still take.
 *
 * A colony grows exponentially, so its cycles get longer and the mean so far says little. A cycle is taken to cost what
 * a pg of cells costs lately, times the mass there will be: with c the seconds a pg and g the factor by which the mass
 * grows a cycle, n cycles more from mass M take c M (g + g^2 + ... + g^n). Both are means over the last ten cycles or
 * so (weights 0.9^age). Mass, not the number of cells: it grows smoothly, also before the first division. */
#ifndef SARCINA_OUTPUT_PROGRESS_H
#define SARCINA_OUTPUT_PROGRESS_H

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

typedef struct progress {
    uint64_t total, done;     /* cycles */
    double began, now, shown; /* s of wall time; shown: when a line was made last */
    double mass;              /* pg */
    double seconds, spent;    /* sums over cycles, with weights: of wall time, and of mass */
    double growth, count;     /* the same of ln(mass after / mass before), and of 1 */
} progress;

/* A run of `total` cycles begins with this mass; now: wall time from any beginning. */
progress progress_begin(uint64_t total, double now, double mass);

/* One more cycle is done. */
void progress_cycle(progress *p, double now, double mass);

/* Seconds still to go; NaN while nothing is known. */
double progress_left(const progress *p);

/* Whether a line is worth showing: half a second after the beginning, and then four times a second. */
bool progress_is_due(const progress *p);

/* "cycle 40 of 70, 187 cells, 12.5 cycles/s, 0:00:07 left"; at_most: the run may end before. first: cycles of the scene
 * before this run. */
void progress_line(progress *p, uint64_t first, size_t cells, bool at_most, char *text, size_t room);

#endif

/* SPDX-License-Identifier: GPL-3.0-or-later */
/* What a run says of itself beside its table. On the screen: a line with the time it took. In the log: the sections of
 * LAMMPS's, which programs look for, filled with what this program knows.
 *
 *     Per MPI rank memory allocation (min/avg/max) = ...      the line before the table's heading
 *     Loop time of T on P procs for N steps with M atoms      the line behind the table
 *
 * A step is a cycle, an atom a cell. Runs of one loop show one table on the screen, with the time behind the loop; in
 * the log each has its own, so that the columns stay readable, and the loop has the other sections. */
#ifndef SARCINA_COMMAND_RUN_REPORT_H
#define SARCINA_COMMAND_RUN_REPORT_H

#include "script/interp.h"

/* Where the counters of a scene stood. */
typedef struct run_report {
    bool open; /* a loop's runs are being counted */
    bool logged;
    int depth; /* runs under way: commands of `every` may loop */
    scene_timing timing;
    scene_tally tally;
    uint64_t step, formed, broken, caps[CAP_COUNT];
    double wall, processor; /* s; clocks of the machine */
} run_report;

/* Before the table. */
void run_report_begin(interp *in, run_report *r);

/* Behind it; seconds, cycles: of this run alone. */
void run_report_end(interp *in, run_report *r, double seconds, uint64_t cycles);

/* The outermost loop has ended. */
void run_report_end_loop(interp *in, run_report *r);

/* Warns of so many minimisations whose force fell no further; 0: of none. */
void run_report_stalled(interp *in, uint64_t n);

/* After a `relax` that is no part of a run: what it took, into the log. */
void run_report_relaxation(interp *in, const relax_result *result);

#endif

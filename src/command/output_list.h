/* SPDX-License-Identifier: GPL-3.0-or-later */
/* What `outputs` holds: the thermo table, dumps and analyses. For the files of src/command that declare or write them;
 * the others see outputs.h only. */
#ifndef SARCINA_COMMAND_OUTPUT_LIST_H
#define SARCINA_COMMAND_OUTPUT_LIST_H

#include "command/outputs.h"

#include "analysis/value.h"
#include "output/dump.h"
#include "output/image.h"
#include "output/stream.h"
#include "output/thermo.h"

typedef struct output_dump {
    char *id;
    char *group; /* its name: rows of groups move */
    args_cycles_value every;
    dump *file;
    output_column *columns;
    size_t ncolumns;
    image_options image; /* of a picture */
} output_dump;

typedef struct output_bins output_bins; /* analyze_bins.h */

typedef struct output_analysis {
    char *id;
    char *group;
    const value_style *style; /* NULL: first_time, or bins */
    double radius;            /* of styles that look around, um; 0: their own */
    output_column *of;        /* the number of each cell that the style looks at; NULL: its own */
    output_bins *bins;        /* NULL: none */
    /* first_time */
    expr *test;
    output_column *kept;
    size_t nkept;
    bool happened;
    double step, time; /* when; s */
    double *values;    /* of the kept columns then, SI (nkept) */
    /* written along the way */
    args_cycles_value every;
    stream *file; /* NULL: none */
} output_analysis;

struct outputs {
    interp *in;
    thermo *table;
    stream *results;                /* results.csv of a run of an ensemble; NULL: not begun */
    args_cycles_value thermo_every; /* 0 cycles: first and last row only */
    output_dump *dumps;
    size_t ndumps, dump_capacity;
    output_analysis *analyses;
    size_t nanalyses, analysis_capacity;
    bool headed;               /* the header of the present columns is on the screen */
    bool has_row, has_log_row; /* the row of step `row_step` is below the header on the screen, in the log */
    uint64_t row_step;
    double before; /* growth time at the step before this one, s */
    /* files that the restart we go on from was writing: they go on too */
    char **resumed;
    size_t nresumed, resumed_capacity;
    uint64_t resumed_step;
};

outputs *output_list_of(interp *in);

/* Flags of a group by name; *flags is NULL for all cells, else the caller's to free. Fails when it is gone. */
int output_list_members(interp *in, const char *group, bool **flags, diag *d);

/* Whether the text of an argument is known: not so in some checks of scripts. */
bool output_list_knows(const args *a, const char *name);

/* Is this file one that a restart goes on with? Then the step up to which it is kept. */
bool output_list_resumes(const outputs *o, const char *path, uint64_t *step);

/* Takes a dump or analysis out. */
void output_list_drop_dump(outputs *o, size_t i);
void output_list_drop_analysis(outputs *o, size_t i);

void output_list_release_columns(output_column *columns, size_t n);

/* thermo.c: the columns of `thermo_style one`; one of a value over all cells, the caller's; the heading, into the log
 * and where asked on the screen; the row of the present step, to either. */
void output_list_default_thermo(outputs *o);
output_column output_list_plain_column(interp *in, const char *name, const char *field); /* field NULL: the bare name */
void output_list_print_header(outputs *o, bool screen);
int output_list_print_row(outputs *o, bool screen, bool log, diag *d);

/* dump.c: opens, and writes the present step unless it has been written. */
int output_list_open_dump(output_dump *p, diag *d);
int output_list_write_dump(outputs *o, output_dump *p, diag *d);

/* analyze.c: takes an analysis in, with the ID, GROUP and `every` of the command; what it points to goes over. */
void output_list_add_analysis(outputs *o, const output_analysis *p, const args *a);

/* Opens, judges a first_time at the end of a cycle, and writes a row of the present step to the file. */
int output_list_open_analysis(output_analysis *p, diag *d);
int output_list_judge(outputs *o, output_analysis *p, diag *d);
int output_list_write_analysis(outputs *o, output_analysis *p, diag *d);

#endif

/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The command line: LAMMPS's switches and ours; --name is accepted for each. */
#ifndef SARCINA_APP_OPTIONS_H
#define SARCINA_APP_OPTIONS_H

#include "base/diag.h"

#include <stdbool.h>
#include <stddef.h>

typedef struct option_pair {
    const char *name, *text;
} option_pair;

typedef struct options {
    int argc; /* the words themselves */
    char *const *argv;
    const char *file;   /* NULL: none */
    const char **names; /* of -var; texts beside them */
    const char **texts;
    size_t nvars;
    const char **commands; /* of -e */
    size_t ncommands;
    const char **tests; /* behind -test */
    size_t ntests;
    const char *log;        /* a file; "none"; NULL: log.sarcina (logfile.h) */
    const char *screen;     /* NULL: standard output; "none"; a file */
    const char *echo;       /* NULL: as the language has it */
    const char *replicates; /* NULL: no ensemble of seeds */
    option_pair *sweeps;    /* a variable, and its values parted by commas */
    size_t nsweeps;
    int workers;  /* runs of an ensemble at a time; 0: as many as cores */
    int threads;  /* 0: not given */
    bool results; /* leave results.csv and scalars.csv: this is a run of an ensemble */
    bool check, test, interactive, noinit, skiprun, safe, version, help, json;
} options;

/* Fills o from the command line; its lists are freed with options_free. SARCINA_USAGE with an error when the command
 * line is at fault. */
int options_read(options *o, int argc, char **argv, diag *d);
void options_free(options *o);

/* An option as help, manual and completion show it. */
typedef struct option_text {
    const char *name;
    const char *takes;   /* "NAME TEXT", "": nothing; NULL: a second name, summary tells of which */
    const char *summary; /* one line, no full stop */
} option_text;

/* The i-th option in *out; NULL when there are fewer. */
const option_text *options_list(size_t i, option_text *out);

/* The text of -help; the caller frees. */
char *options_help(void);

#endif

/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The log. One that was asked for (-log FILE, `log FILE`) begins at once and replaces the file, or goes on behind it.
 *
 * Otherwise, as LAMMPS has log.lammps, there is log.sarcina in the working folder: once cells begin to move, so that
 * asking for help or checking a script leaves no file. What came before that is held and then written. An earlier
 * log.sarcina is kept: it becomes log.sarcina.1, or the next number that is free, so that the runs of a sweep in one
 * folder lose nothing. Where it cannot be written the program says so and goes on. */
#ifndef SARCINA_APP_LOGFILE_H
#define SARCINA_APP_LOGFILE_H

#include "base/diag.h"

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>
#include <stdio.h>

#define LOGFILE_NAME "log.sarcina"

typedef struct logfile {
    FILE *file;   /* NULL: none open */
    bool waiting; /* log.sarcina is to begin when cells move */
    char *held;   /* what it will begin with */
    size_t nheld, room;
    char *command; /* the program's command line, quoted as a shell wants it */
    double began;  /* s */
} logfile;

/* No file yet; waits for start where `automatic`. The words are the command line's. */
void logfile_create(logfile *l, bool automatic, int argc, char *const *argv);

/* Begins a file, with the version, the date and the command line; the one before is closed. path NULL: no log. */
int logfile_open(logfile *l, const char *path, bool append, diag *d);

/* Cells begin to move: log.sarcina begins, where it is due. Says whether there is a log. */
bool logfile_start(logfile *l);

void logfile_put(logfile *l, const char *text);

/* Writes the wall time and the number of warnings, and closes. */
void logfile_end(logfile *l, uint64_t warnings);

#endif

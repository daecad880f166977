/* SPDX-License-Identifier: GPL-3.0-or-later */
/* What the program lends the interpreter: screen, log, shell, environment, Ctrl-C. The only place that prints. */
#ifndef SARCINA_APP_PROGRAM_H
#define SARCINA_APP_PROGRAM_H

#include "app/logfile.h"
#include "app/options.h"
#include "script/interp.h"

#include <stdio.h>

typedef struct program {
    interp_host host;
    units *units;
    command_table *commands;
    FILE *screen; /* NULL: nowhere */
    logfile log;
    int shown; /* lines of progress that stand on the terminal */
    char date[16];
    char *library;
} program;

/* Sets up everything from the command line. On an error nothing is left to free. */
int program_create(program *p, const options *o, diag *d);

/* Closes log and screen, and frees; SARCINA_ERROR, said on standard error, where the screen's text was lost. */
int program_free(program *p);

/* Closes what was printed to: false, said on standard error, where some of it was lost (a full disk), for then the
 * program has not done what it was asked to. */
bool program_close_screen(FILE *screen);

/* The end of what there was to do: a word on warnings, and the end of the log. */
void program_end(program *p, interp *in);

/* An interpreter with the variables and settings of the command line. */
interp *program_interp(program *p, const options *o, diag *d);

/* Ctrl-C sets the interrupt flag; a second one before it was looked at ends the program. At a prompt the second only
 * says that the command has not come to an end yet, and the third ends the program. One that
 * another process sends within a tenth of a second counts as the same. Elsewhere a SIGINT that whoever started the
 * program has set to be ignored, as shells do for what they start in the background, stays so. */
void program_catch_interrupts(bool prompt);
void program_be_patient(void);

/* Whether Ctrl-C ends the wait of a read: for as long as a pipe or file is waited for that nobody may write to. */
void program_end_reads(bool yes);

bool program_is_interrupted(void);
void program_clear_interrupt(void);

/* From here on SIGTERM and SIGHUP (unless it is ignored: nohup) are caught, and tell this program to end what it has
 * started; so does a SIGINT that comes from another process: what the terminal sends, those get themselves. Which
 * signal it was; 0: none. A second one ends the program at once. */
void program_catch_ending(void);
int program_ending(void);

/* "sarcina: error: ..." with help, on standard error. */
void program_complain(const diag *d);

#endif

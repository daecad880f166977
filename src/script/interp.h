/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The interpreter: its services for commands, and how a program makes one and feeds it with files, texts and lines. */
#ifndef SARCINA_SCRIPT_INTERP_H
#define SARCINA_SCRIPT_INTERP_H

#include "base/units.h"
#include "engine/scene.h"
#include "engine/column.h"
#include "script/args.h"

#include <signal.h>

typedef struct command_table command_table; /* script/command.h */

/* ---- the interpreter's services --------------------------------------------------------------------------------- */

scene *interp_scene(interp *in);
void *interp_client(interp *in);
bool interp_checking(const interp *in); /* -check: change only names and settings, touch no file */

typedef enum { UNITS_SI, UNITS_BIO } unit_system;
void interp_set_units(interp *in, unit_system u);

bool interp_in_loop(const interp *in); /* a body of for, while or repeat is running */

/* The units of bare numbers of dimension d, in SI: 1 under si. */
double interp_unit(const interp *in, dim d);

/* The table of units, to read texts of files with. */
units *interp_units(const interp *in);

/* Each prints one line; the line end is added. */
void interp_print(interp *in, const char *format, ...) __attribute__((format(printf, 2, 3))); /* screen and log */
void interp_screen(interp *in, const char *format, ...) __attribute__((format(printf, 2, 3)));
void interp_log(interp *in, const char *format, ...) __attribute__((format(printf, 2, 3)));

/* Cells are about to move: a log that nobody asked for begins here. Says whether there is a log. */
bool interp_start_log(interp *in);

/* One line that the next one replaces; NULL takes it away. Where there is no terminal to show it on
 * (interp_has_progress says so) nothing happens. */
bool interp_has_progress(const interp *in);

/* Where the screen's text goes: a terminal, or what stands for one in a file or pipe. */
typedef struct interp_terminal {
    int columns, rows;
    int colors; /* 0: none; 256; 1 << 24 */
    bool unicode;
} interp_terminal;
interp_terminal interp_terminal_of(const interp *in);

void interp_progress(interp *in, const char *line);
void interp_warn(interp *in, const char *format, ...) __attribute__((format(printf, 2, 3))); /* limited, counted */

typedef enum { WARN_ON, WARN_OFF, WARN_ERROR } warn_mode;
void interp_set_warn(interp *in, warn_mode mode);

/* random() and its kin of scripts begin again: `seed`. */
void interp_restart_random(interp *in);

/* Runs a command or block given as text. */
int interp_execute(interp *in, const char *text, diag *d);

/* In a check: from here on names are unknown (a restart file defines them), so none is reported as missing. */
void interp_open_world(interp *in);
bool interp_has_open_world(const interp *in);

/* The folder of the running script, "" for the prompt: ${here}. */
const char *interp_here(const interp *in);

/* The journal: the texts, $ replaced, of the COMMAND_JOURNAL commands that succeeded. */
size_t interp_journal_count(const interp *in);
const char *interp_journal(const interp *in, size_t i);
void interp_journal_add(interp *in, const char *text);
void interp_journal_clear(interp *in); /* `clear` */
int interp_journal_replay(interp *in, const char *const *texts, size_t n, diag *d);

/* The variables as text, one a line: for restart files. Loading keeps what the command line set (-var wins).
 * The caller frees the text. */
char *interp_variables_save(const interp *in);
char *interp_variables_list(const interp *in); /* to be read: NAME = TEXT, one a line; the caller frees */
int interp_variables_load(interp *in, const char *text, diag *d);

/* The name of the i-th `equal` variable; NULL behind the last. */
const char *interp_formula(const interp *in, size_t i);

/* Is this a run of an ensemble, which leaves its tables (command/results.h)? */
bool interp_results(const interp *in);

/* ---- texts run later -------------------------------------------------------------------------------------------- */

command_text *interp_keep_text(command_text *t); /* counts references */
void interp_free_text(command_text *t);
int interp_run_text(interp *in, command_text *t, diag *d);

/* ---- expressions ------------------------------------------------------------------------------------------------ */

expr *expr_keep(expr *e); /* counts references; NULL is allowed */
void expr_free(expr *e);
const char *expr_text(const expr *e); /* as written, after replacement of $ */

/* Adds to a diag what the two sides of a comparison are. */
void expr_explain(interp *in, const expr *e, diag *d);

/* Evaluate on the scene as it stands. Undefined (NaN) values are no error for a number, false as a truth. */
int interp_number(interp *in, expr *e, quantity *out, diag *d);
int interp_truth(interp *in, expr *e, bool *out, diag *d);
int interp_cells(interp *in, expr *e, double *si, dim *dimension, diag *d); /* si: one a cell row */
int interp_flags(interp *in, expr *e, bool *flags, diag *d);                /* flags: one a cell row */

/* Whether the expression gives the same at every look: random() does not. */
int interp_check_repeatable(interp *in, const expr *e, diag *d);

/* A column for the writers of tables and dumps from a `value` or `cell` expression: its heading is the expression's
 * text. The column holds the expression and must not outlive the interpreter. */
int interp_column(interp *in, expr *e, bool per_cell, output_column *out, diag *d);

typedef enum { ECHO_NONE, ECHO_SCREEN, ECHO_LOG, ECHO_BOTH } echo_mode;

/* ---- for the control commands ------------------------------------------------------------------------------------ */

/* Runs a file where the running script stands: looked for beside it, then in the working folder, then in the
 * library. */
int interp_include(interp *in, const char *path, diag *d);

/* Counts an expect. A failure under -test is shown and counted, and the script goes on; else it is an error. */
int interp_expect(interp *in, bool holds, diag *failure);

/* Returns the mode before. */
echo_mode interp_set_echo(interp *in, echo_mode mode);
int interp_open_log(interp *in, const char *path, bool append, diag *d); /* path NULL: none */
int interp_shell(interp *in, const char *command, diag *d);
const char *interp_environment(interp *in, const char *name); /* NULL: not set */
const char *interp_date(const interp *in);                    /* "2026-11-21", or "" */
int interp_edit(interp *in, char **text, diag *d);            /* by the user; *text is replaced */
size_t interp_undo_bytes(const interp *in);
/* In a check: how often the command that is checked would run, as far as loops say; 0 in a branch that is not taken. */
double interp_check_passes(const interp *in);
bool interp_skips_runs(const interp *in); /* -skiprun: nothing grows, nothing moves */
void interp_quit(interp *in, int code);
size_t interp_forecast_runs(const interp *in); /* how many runs of the script a forecast is to be of */

/* ---- for the program --------------------------------------------------------------------------------------------- */

/* What the interpreter cannot do itself. Every callback but `commands` and `units` may be NULL. */
typedef struct interp_host {
    const command_table *commands;
    units *units;
    void *self;
    void (*screen)(void *self, const char *text); /* text with its line ends */
    void (*log)(void *self, const char *text);
    bool (*start_log)(void *self);                                       /* see interp_start_log */
    void (*progress)(void *self, const char *line);                      /* see interp_progress; NULL: no terminal */
    void (*error)(void *self, const char *text);                         /* errors, laid out */
    void (*warning)(void *self, const char *text);                       /* and warnings; NULL: as errors */
    int (*open_log)(void *self, const char *path, bool append, diag *d); /* path NULL: no log */
    int (*shell)(void *self, const char *command, diag *d);
    const char *(*environment)(void *self, const char *name);
    interp_terminal (*terminal)(void *self);       /* NULL: 80 x 24, without colours, in ASCII */
    const char *(*date)(void *self);               /* of today, as 2026-11-21 */
    int (*edit)(void *self, char **text, diag *d); /* in the user's editor; *text is replaced */
    const volatile sig_atomic_t *interrupt;
    const char *library; /* folder include searches last; NULL */
    bool safe;           /* refuse what is COMMAND_UNSAFE */
    size_t undo_bytes;   /* of states that a prompt keeps for undo, at most; 0: 256 MB */
    bool skip_runs;      /* grow and relax nothing */
    bool test;           /* a failed expect is counted and the script goes on */
    size_t forecast;     /* a check without errors says what so many runs of the script will take; 0: it does not */
    bool results;        /* leave the tables that ensembles are merged from */
} interp_host;

/* host must outlive the interpreter. */
interp *interp_create(const interp_host *host);
void interp_free(interp *in);

/* -var NAME TEXT. */
int interp_set_variable(interp *in, const char *name, const char *text, diag *d);

/* Checks a script whole, on a scene of its own: every error goes to host->error. Returns how many there were.
 * *unread: the error of a -var that nothing reads counts too. */
size_t interp_check_file(interp *in, const char *path);

/* The same for several that run one after the other: the later know what the earlier have declared. whole: nothing
 * follows them, so that a -var which none of them reads is an error. */
typedef struct interp_script {
    const char *name; /* as errors show it; NULL: text is the path of a file */
    const char *text;
} interp_script;
size_t interp_check(interp *in, const interp_script *list, size_t n, bool whole);
size_t interp_check_text(interp *in, const char *name, const char *text);

/* A number that says which texts the last interp_check_* read: the script's and those it includes. */
uint64_t interp_fingerprint(const interp *in);

/* Runs a script whose check has passed. A failure has been told to host->error; its status returns. */
int interp_run_file(interp *in, const char *path);
int interp_run_source(interp *in, const char *name, const char *text);

/* The value of an expression on the scene as it stands, in SI: one number, or one a cell row. A failure has been told
 * to host->error, with `name` for its place; its status returns. */
int interp_run_expression(interp *in, const char *name, const char *text, bool per_cell, double *si);

/* Runs one line or block of a prompt; the status returns and a failure has been told. What is no command but an
 * expression has its value printed. */
int interp_run_line(interp *in, const char *text);

/* The text is what interp_run_line takes as an expression. */
bool interp_is_expression(interp *in, const char *text);

/* What `undo` takes back beside scene and journal: units, echo, warnings, threads; and the variables, those of the
 * command line too, where interp_variables_load would keep what is not in the text. The caller frees the text. */
char *interp_settings_save(const interp *in);
void interp_settings_load(interp *in, const char *text);
int interp_variables_restore(interp *in, const char *text, diag *d);

/* quit was met; with which code. */
bool interp_has_quit(const interp *in, int *code);

/* Expects so far, for -test. */
void interp_expects(const interp *in, uint64_t *passed, uint64_t *failed);
uint64_t interp_warnings(const interp *in);
void interp_tell_warnings(interp *in); /* at the end: how many more there were of each kind than were shown */

/* An error as it is shown; the caller frees. Uses what the interpreter kept of the last error. */
char *interp_explain(interp *in, const diag *d);

#endif

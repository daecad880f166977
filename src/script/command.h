/* SPDX-License-Identifier: GPL-3.0-or-later */
/* What a file of src/command needs: the record of a command form, its checked arguments, the interpreter's services.
 *
 * A command is one or more const `command_form` records in one file of src/command. The reader picks the form by its
 * literal words, reads and checks every argument (kind, dimension, range, names), and only then calls `run`, which
 * asks for the arguments by name. Usage lines, help, completion and suggestions come from the same records.
 *
 * Notation of heads and parameters (language-reference.md 2.5): words of a head stand for themselves; NAME:KIND[RANGE]
 * is an argument in its place; `@off` says that the word off may stand here and ends the command. A parameter is
 * name[=DEFAULT]:KIND[RANGE]. Suffixes of a kind: `~` a distribution may stand here; `%` percent is of the natural
 * whole; `!` required, `!1` one of group 1 required; `...` one or more; `?` may be left out (in place only).
 * Kinds:
 *   length rate stiffness ...   a number of that dimension (base/dim.h)
 *   number int flag nothing     a pure number; a whole number; yes|no; a bare keyword
 *   {a|b|c}                     one of these words
 *   word text file fileoff rest one word; quoted text; a file name; the same or off; everything to the end of the line
 *   +class  class  class*       defines a name; refers to one; or `*` for all (classes: name_class below)
 *   expr cellexpr               longest expression; of one value; of a value per cell
 *   value cell                  an expression of one word; of one value; of a value per cell
 *   formula                     the rest of the line as an expression, read when used
 *   command everycmd            text run later; CYCLES then one or more of them (may be repeated)
 *   cycles relaxation orient    N or a time; T or `to F [within T]`; x|y|z|xy|random or three numbers
 *   bound length3 size view     length or INF; 0,0,0 or three lengths; W H; a name or two angles
 *   range2 any quantity         two numbers, one number of any dimension
 *   color cellcolor             a colour; a one-word formula per cell or a colour
 *   columnformat values words   COLUMN %FORMAT; any number of words
 */
#ifndef SARCINA_SCRIPT_COMMAND_H
#define SARCINA_SCRIPT_COMMAND_H

#include "analysis/view.h"
#include "base/diag.h"
#include "base/dim.h"
#include "base/param.h"
#include "base/spread.h"
#include "engine/column.h"
#include "engine/scene.h"

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

typedef struct interp interp;
typedef struct args args;
typedef struct expr expr;

/* ---- the record of a form -------------------------------------------------------------------------------------- */

enum {
    COMMAND_SHADOW = 1,   /* -check runs it too, on a scene of its own: it must touch no file and compute nothing then
                             (interp_checking), but declare names and find every error it can */
    COMMAND_JOURNAL = 2,  /* its text belongs to what a restart file replays */
    COMMAND_DECLARES = 3, /* both: everything that defines or amends something by name */
    COMMAND_UNSAFE = 4    /* refused under -safe */
};

typedef struct command_form {
    const char *head;    /* "region ID:+region block XLO:bound ...", "force dlvo @off" */
    const param *params; /* keywords, and the records (summary) of arguments in place */
    size_t nparams;
    const char *summary; /* one line, no full stop */
    const char *details; /* what help shows below the usage; NULL */
    const char *example; /* a line that runs as a test; NULL */
    unsigned flags;
    int (*run)(interp *in, const args *a, diag *d);
    bool (*exists)(interp *in, const args *a); /* the head names something that stands: keywords amend it, so none is
                                                  required. NULL: never */
    int style; /* row in a style table, for forms derived from one; args_style gives it to run */
} command_form;

/* ---- the list of all commands, made once by src/command/commands.c ---------------------------------------------- */

typedef struct command_table command_table;

/* Adds n forms. A record whose notation is wrong aborts: it is a mistake in the program. */
void command_add(command_table *t, const command_form *forms, size_t n);

/* Adds a form derived from a row of a style table: everything of `common` but head (copied), parameters, summary and
 * style. */
void command_add_style(command_table *t, const command_form *common, const char *head, const char *summary,
                       const param *params, size_t nparams, int style);

/* Names of one kind: species, regions, groups, analyses, dumps ... Looked up by the kinds of arguments, by
 * expressions, by "did you mean" and by the check for clashes. Rows are those of the owner's table. */
typedef struct name_class {
    const char *name; /* as in the notation: "species" */
    const char *noun; /* with its article: "a species" */
    bool free;        /* its names never stand in expressions and clash with nothing (dump IDs) */
    bool redefine;    /* `+class` of a name that stands already is no error: the command amends or replaces */
    size_t (*count)(interp *in);
    const char *(*get)(interp *in, size_t i);
    /* NULL, or the names are truth values per cell: fills flags (one a cell row). */
    int (*members)(interp *in, size_t i, const view *v, bool *flags, diag *d);
    /* NULL, or the names are values: dimension and number (SI; NaN: undefined) of name[.field]; si NULL: only the
     * dimension is asked. field NULL: the bare name. index: NAN, or the number in name.field[index]. */
    int (*value)(interp *in, size_t i, const char *field, double index, dim *d, double *si, diag *diagnostic);
} name_class;

void command_add_class(command_table *t, const name_class *c);

/* What the command layer keeps beside each scene (also beside that of a check). Called by interp_create and
 * interp_free. */
void command_set_client(command_table *t, void *(*create)(interp *in), void (*free_client)(void *client));

/* ---- checked arguments ------------------------------------------------------------------------------------------ */
/* By the parameter's name as in its record. Numbers are in the engine's units (um, pg, s) after the check of dimension
 * and range. What was not given has its record's default; NaN, 0 or NULL without one. */

bool args_given(const args *a, const char *name); /* stood in the command: an amending command changes only these */
bool args_off(const args *a);                     /* `off` stood at @off */
int args_style(const args *a);                    /* command_form.style */
const char *args_head(const args *a);             /* the command's name, for messages */

double args_number(const args *a, const char *name);
bool args_percent(const args *a,
                  const char *name); /* % kinds: args_number and args_spread are fractions of the whole */
spread args_spread(const args *a, const char *name);
long long args_int(const args *a, const char *name);
bool args_flag(const args *a, const char *name);
int args_choice(const args *a, const char *name);       /* 0, 1, ... in the record's order */
const char *args_text(const args *a, const char *name); /* word, text, file, name, colour; NULL: off or not given */
bool args_all(const args *a, const char *name);         /* class*: the word was * (args_row is -1 then) */
int args_row(const args *a, const char *name);          /* row of a name in its class */

size_t args_count(const args *a, const char *name); /* how many values a `...` argument got */
const char *args_text_at(const args *a, const char *name, size_t i);
expr *args_expr(const args *a, const char *name); /* belongs to a; expr_keep to hold it longer. NULL: not given */
expr *args_expr_at(const args *a, const char *name, size_t i);
const char *args_command(const args *a, const char *name); /* text for interp_execute; `everycmd`: args_every */

void args_vector(const args *a, const char *name, double *out, size_t n); /* length3, size, range2 (SI), view angles */
orient_kind args_orient(const args *a, const char *name, double axis[3]);

typedef struct args_cycles_value {
    bool is_time;
    uint64_t cycles; /* when not is_time */
    double time;     /* s */
} args_cycles_value;
args_cycles_value args_cycles(const args *a, const char *name);

/* A relaxation: for time (force 0), or until the net force is below force, within time (infinite: no bound). */
void args_relaxation(const args *a, const char *name, double *time, double *force);

/* The i-th `every CYCLES "command" ...`; *commands (*n of them) belong to a, see command_text_keep. */
typedef struct command_text command_text;
size_t args_every_count(const args *a, const char *name);
args_cycles_value args_every(const args *a, const char *name, size_t i, command_text *const **commands, size_t *n);

/* A number of any dimension, in SI; plain: it came without a unit and takes the dimension of what it meets. */
typedef struct quantity {
    double si;
    dim d;
    bool plain;
} quantity;
quantity args_quantity(const args *a, const char *name);

/* COLUMN and %FORMAT of a columnformat. */
void args_column_format(const args *a, const char *name, const char **column, const char **format);

/* Place of an argument, for an error about its value: diag_place(d, args_span(a, "mass")). */
span args_span(const args *a, const char *name);
span args_span_at(const args *a, const char *name, size_t i);

/* ---- texts run later -------------------------------------------------------------------------------------------- */

command_text *command_text_keep(command_text *t); /* counts references */
void command_text_free(command_text *t);
int interp_run_text(interp *in, command_text *t, diag *d);

/* ---- expressions ------------------------------------------------------------------------------------------------ */

expr *expr_keep(expr *e); /* counts references; NULL is allowed */
void expr_free(expr *e);
const char *expr_text(const expr *e); /* as written, after replacement of $ */

/* Evaluate on the scene as it stands. Undefined (NaN) values are no error for a number, false as a truth. */
int interp_number(interp *in, expr *e, quantity *out, diag *d);
int interp_truth(interp *in, expr *e, bool *out, diag *d);
int interp_cells(interp *in, expr *e, double *si, dim *dimension, diag *d); /* si: one a cell row */
int interp_flags(interp *in, expr *e, bool *flags, diag *d);                /* flags: one a cell row */

/* A column for the writers of tables and dumps from a `value` or `cell` expression: its heading is the expression's
 * text. The column holds the expression and must not outlive the interpreter. */
int interp_column(interp *in, expr *e, bool per_cell, output_column *out, diag *d);

/* ---- the interpreter's services --------------------------------------------------------------------------------- */

scene *interp_scene(interp *in);
void *interp_client(interp *in);
bool interp_checking(const interp *in);  /* -check: change only names and settings, touch no file */
bool interp_replaying(const interp *in); /* interp_journal_replay is running */

typedef enum { UNITS_SI, UNITS_BIO } unit_system;
void interp_set_units(interp *in, unit_system u);
unit_system interp_units(const interp *in);

/* The units of bare numbers of dimension d, in SI: 1 under si. */
double interp_unit(const interp *in, dim d);

void interp_print(interp *in, const char *format, ...) __attribute__((format(printf, 2, 3))); /* screen and log */
void interp_screen(interp *in, const char *format, ...) __attribute__((format(printf, 2, 3)));
void interp_log(interp *in, const char *format, ...) __attribute__((format(printf, 2, 3)));
void interp_warn(interp *in, const char *format, ...) __attribute__((format(printf, 2, 3))); /* limited, counted */

typedef enum { WARN_ON, WARN_OFF, WARN_ERROR } warn_mode;
void interp_set_warn(interp *in, warn_mode mode);

/* Warnings under `warn error` become an error of the command that gave them, when it returns. */

/* Runs a command or block given as text. */
int interp_execute(interp *in, const char *text, diag *d);

/* In a check: from here on names are unknown (a restart file defines them), so none is reported as missing. */
void interp_open_world(interp *in);

/* The folder of the running script, "" for the prompt: ${here}. */
const char *interp_here(const interp *in);

/* The journal: the texts, $ replaced, of the COMMAND_JOURNAL commands that succeeded. */
size_t interp_journal_count(const interp *in);
const char *interp_journal(const interp *in, size_t i);
void interp_journal_clear(interp *in); /* `clear` */
int interp_journal_replay(interp *in, const char *const *texts, size_t n, diag *d);

/* The variables as text, one a line: for restart files. Loading keeps what the command line set (-var wins).
 * The caller frees the text. */
char *interp_variables_save(const interp *in);
int interp_variables_load(interp *in, const char *text, diag *d);

#endif

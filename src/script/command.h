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
#include "base/units.h"
#include "script/args.h"
#include "script/interp.h"

#include <stdbool.h>
#include <stddef.h>

/* ---- the record of a form -------------------------------------------------------------------------------------- */

enum {
    COMMAND_SHADOW = 1,   /* -check runs it too, on a scene of its own: it must touch no file and compute nothing then
                             (interp_checking), but declare names and find every error it can */
    COMMAND_JOURNAL = 2,  /* its text belongs to what a restart file replays */
    COMMAND_DECLARES = 3, /* both: everything that defines or amends something by name */
    COMMAND_UNSAFE = 4,   /* refused under -safe */
    COMMAND_MEANT_TO_FAIL = 8, /* -check leaves out the commands it takes as text */
    COMMAND_PROMPT = 16,       /* for the prompt: refused in files, pipes and -e */
    COMMAND_ALONE = 48         /* and there on a line of its own: in no block, no command text */
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

/* u must outlive the table. */
command_table *command_table_create(units *u);
void command_table_free(command_table *t);

/* Adds n forms. A record whose notation is wrong aborts: it is a mistake in the program. */
void command_add(command_table *t, const command_form *forms, size_t n);

/* Adds a form derived from a row of a style table: everything of `common` but head (copied), parameters, summary and
 * style. */
void command_add_style(command_table *t, const command_form *common, const char *head, const char *summary,
                       const param *params, size_t nparams, int style);

/* Adds to the form added last what a row of a style table says beside its summary: the law, and where it comes from
 * (NULL: nothing). */
void command_cite(command_table *t, const char *formula, const char *source);

/* Adds to the form added last what one of its choices ({a|b|c}) means. */
void command_add_choice(command_table *t, const char *choice, const char *summary);

/* What is said of a command whatever its form: one record a command. */
typedef struct command_page {
    const char *name;
    const char *topic;   /* "Model": the heading it stands under where all commands are listed */
    const char *summary; /* one line, no full stop */
    const char *details; /* paragraphs parted by an empty line; NULL */
    const char *see;     /* "dump_modify write_dump": related commands; NULL */
} command_page;

/* What the examples of forms run after, each in a scene of its own: a script, and files that stand in the folder. */
typedef struct command_file {
    const char *name, *text;
} command_file;

void command_add_pages(command_table *t, const command_page *pages, size_t n);
void command_set_prelude(command_table *t, const char *script, const command_file *files, size_t nfiles);

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

/* Called before and after each line or block of a prompt. */
void command_set_line(command_table *t, void (*begins)(interp *in),
                      void (*ended)(interp *in, const char *text, int status));

/* What the command layer keeps beside each scene (also beside that of a check). Called by interp_create and
 * interp_free; loop_end when the outermost running loop has ended, not in a check. */
void command_set_client(command_table *t, void *(*create)(interp *in), void (*free_client)(void *client),
                        void (*loop_end)(interp *in));

/* Called behind a check without errors whose host wants a forecast. */
void command_set_checked(command_table *t, void (*checked)(interp *in));

#endif

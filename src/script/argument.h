/* SPDX-License-Identifier: GPL-3.0-or-later */
/* One argument as read: the reader of each kind, and what args.h looks values up in. */
#ifndef SARCINA_SCRIPT_ARGUMENT_H
#define SARCINA_SCRIPT_ARGUMENT_H

#include "script/expr.h"
#include "script/reader.h"
#include "script/signature.h"

/* One `every CYCLES "command" ...`. */
typedef struct argument_every {
    args_cycles_value cycles;
    command_text **commands;
    size_t n;
} argument_every;

/* What was read for a slot, in the engine's units; which members count depends on the kind. */
typedef struct argument {
    bool given;
    span at;
    double number; /* also int, flag, choice, row */
    spread range;
    bool percent, all;
    replacement note; /* what a check does not know of the text */
    char *text;
    double vector[3];
    orient_kind orient;
    args_cycles_value cycles;
    double time, force; /* relaxation */
    quantity quantity;
    char **texts;
    span *spans;
    expr **exprs; /* one, or one of each `...` */
    size_t n, capacity;
    argument_every *every;
    size_t nevery;
    command_text *command;
} argument;

struct args {
    interp *in;
    const signature *form;
    argument *values; /* head, then keywords */
    bool off;
    bool nameless; /* a check does not know a name it refers to: it is read, but not run */
    bool unknown;  /* a check does not know some words: what follows was not looked at */
    bool guessed;  /* a check does not know some value: a plausible one stands for it */
    char *defines; /* the name a +class argument read; NULL */
    const name_class *defines_in;
    bool redefines; /* in a check, in a branch that may not be taken: that name is there already */
};

/* Reads the argument for slot s at the reader's place. */
int argument_read(args *a, const slot *s, argument *out, reader *r, diag *d);
void argument_free(argument *v);

/* Lays the default of a slot into an argument that was not given. */
void argument_set_default(args *a, const slot *s, argument *out);

/* Numbers: the kinds built of them, in argument_number.c. All leave the place of an error to the caller's word. */
int argument_read_number(args *a, const slot *s, const word *w, double *engine, bool *percent, diag *d);
int argument_read_spread(args *a, const slot *s, argument *out, reader *r, diag *d);
int argument_read_int(args *a, const slot *s, const word *w, double *out, diag *d);
int argument_read_cycles(args *a, const slot *s, const word *w, args_cycles_value *out, diag *d);
int argument_read_quantity(args *a, const slot *s, const word *w, quantity *out, diag *d);
int argument_read_relaxation(args *a, const slot *s, argument *out, reader *r, diag *d);

/* Kinds of several words, in argument_words.c: n numbers; a direction; a name or two angles; a column and a format;
 * words up to the next keyword. */
int argument_read_numbers(args *a, const slot *s, size_t n, argument *out, reader *r, diag *d);
int argument_read_orient(args *a, const slot *s, argument *out, reader *r, diag *d);
int argument_read_view(args *a, const slot *s, argument *out, reader *r, diag *d);
int argument_read_column_format(args *a, const slot *s, argument *out, reader *r, diag *d);
int argument_read_words(args *a, const slot *s, argument *out, reader *r, diag *d);

/* The next word, which must be there. */
int argument_next_word(args *a, const slot *s, reader *r, word *w, diag *d);

/* The form that the words at r->at choose among those of the command; NULL with an error, or with *unknown when a
 * check cannot tell. Then the whole line is read and checked. */
const signature *args_read_form(interp *in, reader *r, bool *unknown, diag *d);
int args_read(interp *in, const signature *form, reader *r, args *out, diag *d);
void args_free(args *a);

/* Warns about numbers that are hardly meant, with the unit that may be. */
void argument_warn(args *a, const slot *s, const word *w, double si);

#endif

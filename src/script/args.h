/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The checked arguments of a command, by the parameter's name as in its record.
 *
 * Numbers are in the engine's units (um, pg, s) after the check of dimension and range. What was not given has its
 * record's default; NaN, 0 or NULL without one. */
#ifndef SARCINA_SCRIPT_ARGS_H
#define SARCINA_SCRIPT_ARGS_H

#include "base/diag.h"
#include "base/dim.h"
#include "base/spread.h"
#include "engine/scene.h"

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

typedef struct interp interp;
typedef struct args args;
typedef struct expr expr;
typedef struct command_text command_text;

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
/* In a check: the text is not known, or holds what is not; *note says what is known of it. */
struct replacement; /* script/reader.h */
bool args_unknown(const args *a, const char *name, struct replacement *note);

bool args_all(const args *a, const char *name); /* class*: the word was * (args_row is -1 then) */
int args_row(const args *a, const char *name);  /* row of a name in its class */

size_t args_count(const args *a, const char *name); /* how many values a `...` argument got */
const char *args_text_at(const args *a, const char *name, size_t i);
expr *args_expr(const args *a, const char *name); /* belongs to a; expr_keep to hold it longer. NULL: not given */
expr *args_expr_at(const args *a, const char *name, size_t i);
command_text *args_command(const args *a, const char *name); /* for interp_run_text; `everycmd`: args_every */

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

/* The i-th `every CYCLES "command" ...`; *commands (*n of them) belong to a, see interp_keep_text. */
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

#endif

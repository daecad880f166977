/* SPDX-License-Identifier: GPL-3.0-or-later */
/* One argument of a command or style, as data: its name, kind, unit, range, default and what it means.
 *
 * The specification is one short text, in the notation of the language reference:
 *
 *     k=1e-10N/m:stiffness(0,)     keyword k, a stiffness above 0, default 1e-10 N/m
 *     rate:rate~!(-0.01/s,0.01/s)  required keyword; ~: a distribution may stand here
 *     XLO:bound                    upper case: an argument in its place
 *     contact=regularised:{regularised|closest}
 *
 * The parser, usage lines, help and suggestions are all derived from these records; see script/signature.h for the
 * parsed form. Values reach the engine in its own units (um, pg, s). */
#ifndef SARCINA_BASE_PARAM_H
#define SARCINA_BASE_PARAM_H

typedef struct param {
    const char *spec;    /* "NAME[=DEFAULT]:KIND[RANGE]" */
    const char *summary; /* one line, no full stop */
} param;

#define PARAM_COUNT_MAX 12 /* parameters of one style at most */

#endif

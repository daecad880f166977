/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Units of numbers, known to UDUNITS-2, behind a strict grammar of ours:
 *
 *     unit   = "%" | [ "/" ] factor { ( "." | "/" | "·" ) factor }
 *     factor = LETTERS [ [ "^" ] [ "-" ] DIGITS ]
 *
 * Superscripts read as digits, µ as u, deg as degree. UDUNITS alone would take "1.5.2m", "5um@3" or "h0". */
#ifndef SARCINA_BASE_UNITS_H
#define SARCINA_BASE_UNITS_H

#include "base/diag.h"
#include "base/dim.h"

#include <stdbool.h>
#include <stddef.h>

typedef struct units units; /* UDUNITS's tables and a cache of the units met */

/* NULL with an error when UDUNITS's database cannot be read. UDUNITS's own messages are silenced. */
units *units_create(diag *d);
void units_free(units *u);

/* One unit: a number of it times scale is SI. Powers of ten are kept as such, so that 0.75um is 7.5e-7 to the bit;
 * so are whole parts, so that 1.23/h is 1.23/3600. */
typedef struct unit {
    enum { UNIT_POWER, UNIT_MULTIPLY, UNIT_DIVIDE, UNIT_PERCENT } how;
    int power;     /* UNIT_POWER: of ten */
    double factor; /* UNIT_MULTIPLY, UNIT_DIVIDE */
    dim d;
} unit;

/* The unit written in the first n bytes of text, all of them. */
int units_find(units *u, const char *text, size_t n, unit *out, diag *d);

/* The number in the first n bytes (number_length's) in that unit, in SI; percent: a hundredth. */
double units_convert(const unit *of, const char *number, size_t n);

/* A whole argument: number with an optional unit. */
typedef struct units_value {
    double si;
    bool has_unit, percent;
    dim d;
} units_value;

/* Reads all n bytes as a number with an optional unit. Errors: not a number, not a unit, not finite. */
int units_read(units *u, const char *text, size_t n, units_value *out, diag *d);

/* Whether UDUNITS knows the word as a unit, of whatever dimension: h, C, dt. */
bool units_is_name(units *u, const char *name);

/* What may have been meant by a unit that has the wrong dimension ("m is metre; minutes are min"), or is unknown;
 * NULL: no idea. expected: the dimension due; NULL: not known. */
const char *units_hint(const char *text, size_t n, const dim *expected);

/* Names of the usual units of dimension d ("um", "nm" ...), for completion; returns how many were written. */
size_t units_usual(dim d, const char *names[], size_t room);

#endif

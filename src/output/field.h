/* SPDX-License-Identifier: GPL-3.0-or-later */
/* One field of a text table. */
#ifndef SARCINA_OUTPUT_FIELD_H
#define SARCINA_OUTPUT_FIELD_H

#include <stdio.h>

enum { FIELD_ROOM = 32 };

/* x with 15 digits, or 17 where 15 do not read back as x; "nan" whatever its sign. Returns text. */
const char *field_number(double x, char text[FIELD_ROOM]);

/* Text as a field of a CSV: quoted where it holds a comma, a quote or a line's end (RFC 4180). */
void field_put_csv(FILE *out, const char *text);

/* Text as it stands in an attribute of XML; the caller frees. */
char *field_xml(const char *text);

#endif

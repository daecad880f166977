/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Number formats of scripts: "%" [flags] [width] [ "." digits ] ( d i f e g ), exactly one, checked before printf. */
#ifndef SARCINA_SCRIPT_FORMAT_H
#define SARCINA_SCRIPT_FORMAT_H

#include "base/diag.h"
#include "base/dim.h"

#include <stdbool.h>

bool format_is_valid(const char *format);

/* x by a valid format; %d rounds and refuses what is no whole number. NULL on an error; the caller frees. */
char *format_number(const char *format, double x, diag *d);

/* x in SI with its unit, as scripts read it back: 3e-06m, 0.5. The caller frees. */
char *format_quantity(double si, dim d);

#endif

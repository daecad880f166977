/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Units for people's eyes: pictures and diagrams show um and hours, where files have SI. */
#ifndef SARCINA_OUTPUT_READABLE_H
#define SARCINA_OUTPUT_READABLE_H

#include "base/dim.h"

/* What to divide numbers in SI by, and the unit's name ("" for pure numbers). */
double readable_unit(dim d, char name[48]);

#endif

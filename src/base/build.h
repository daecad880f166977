/* SPDX-License-Identifier: GPL-3.0-or-later */
/* What this build of the program was configured to leave out (-DSARCINA_WITHOUT=..., src/without.cmake). */
#ifndef SARCINA_BASE_BUILD_H
#define SARCINA_BASE_BUILD_H

#include "base/diag.h"

#include <stdbool.h>

/* Was the part (a force term, a kind of link, flexible, remodel) left out? */
bool build_lacks(const char *part);

/* An error where it was. */
int build_check(const char *part, diag *d);

#endif

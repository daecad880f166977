/* SPDX-License-Identifier: GPL-3.0-or-later */
/* What the terminal can show, from its size and the environment: COLUMNS, LINES, NO_COLOR, COLORTERM, TERM, the locale.
 */
#ifndef SARCINA_APP_TERMINAL_H
#define SARCINA_APP_TERMINAL_H

#include "script/interp.h"

#include <stdio.h>

/* Of the stream that is printed to; NULL: of nothing. A file or pipe is 80 x 24 unless COLUMNS and LINES say otherwise,
 * and without colours. */
interp_terminal terminal_of(FILE *screen);

#endif

/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The decimal numbers of scripts: [sign] digits [. digits] [e [sign] digits], no blank, hex, inf or nan. */
#ifndef SARCINA_BASE_NUMBER_H
#define SARCINA_BASE_NUMBER_H

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

/* Characters of the number that text (n bytes) begins with; 0: it begins with none. An `e` without digits behind it
 * is no part of the number: 5em is 5 and `em`. */
size_t number_length(const char *text, size_t n, bool sign_allowed);

/* The number in the first n bytes (as measured by number_length) times 10^shift, rounded once: the exponent of the
 * text is shifted before it is converted. Infinite or 0 where binary64 ends. */
double number_read(const char *text, size_t n, int shift);

/* x as the shortest of %.15g and %.17g that reads back as x. */
const char *number_write(double x, char buffer[32]);

/* What n things are called in a sentence, as in "1 cell", "0 cells", "2 entries". */
static inline const char *number_noun(uint64_t n, const char *one, const char *many) {
    return n == 1 ? one : many;
}

#endif

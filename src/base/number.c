/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "base/number.h"

#include "base/alloc.h"

#include <ctype.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

static size_t digits(const char *text, size_t n, size_t i) {
    size_t start = i;
    while (i < n && isdigit((unsigned char)text[i]))
        i++;
    return i - start;
}

static size_t sign(const char *text, size_t n, size_t i) {
    return i < n && (text[i] == '+' || text[i] == '-');
}

/* Characters of the mantissa from i: DIGITS [. [DIGITS]] or . DIGITS; 0: none. */
static size_t mantissa(const char *text, size_t n, size_t i) {
    size_t whole = digits(text, n, i), end = i + whole;
    if (end < n && text[end] == '.') {
        size_t fraction = digits(text, n, end + 1);
        if (whole || fraction)
            end += 1 + fraction;
    }
    return end - i;
}

size_t number_length(const char *text, size_t n, bool sign_allowed) {
    size_t i = sign_allowed ? sign(text, n, 0) : 0;
    size_t m = mantissa(text, n, i);
    if (m == 0)
        return 0;
    i += m;
    if (i < n && (text[i] == 'e' || text[i] == 'E')) {
        size_t s = sign(text, n, i + 1), e = digits(text, n, i + 1 + s);
        if (e)
            i += 1 + s + e;
    }
    return i;
}

double number_read(const char *text, size_t n, int shift) {
    size_t s = sign(text, n, 0), m = s + mantissa(text, n, s);
    long exponent = 0;
    if (m < n) {
        char *tail = alloc_copy_n(text + m + 1, n - m - 1);
        exponent = strtol(tail, NULL, 10); /* saturates, far beyond what counts */
        free(tail);
    }
    if (exponent > 100000)
        exponent = 100000;
    if (exponent < -100000)
        exponent = -100000;
    char *shifted = alloc_format("%.*se%ld", (int)m, text, exponent + shift);
    double x = strtod(shifted, NULL);
    free(shifted);
    return x;
}

const char *number_write(double x, char buffer[32]) {
    snprintf(buffer, 32, "%.15g", x);
    if (strtod(buffer, NULL) != x)
        snprintf(buffer, 32, "%.17g", x);
    return buffer;
}

/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "script/format.h"

#include "base/alloc.h"
#include "base/number.h"

#include <ctype.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

/* Index behind digits; at most three of them, so that no width is absurd. */
static size_t digits(const char *format, size_t i) {
    size_t n = 0;
    while (isdigit((unsigned char)format[i + n]) && n < 3)
        n++;
    return i + n;
}

bool format_is_valid(const char *format) {
    if (format[0] != '%')
        return false;
    size_t i = 1 + strspn(format + 1, "-+ 0#");
    i = digits(format, i);
    if (format[i] == '.')
        i = digits(format, i + 1);
    return format[i] && strchr("difegFEG", format[i]) && format[i + 1] == '\0';
}

/* A whole number: %d of it through printf's long long. */
static char *format_whole(const char *format, double x, diag *d) {
    double whole = nearbyint(x);
    if (!(fabs(x - whole) <= 1e-9 * fmax(1, fabs(x))) || fabs(whole) > 9e15) {
        diag_error(d, "%s takes a whole number, not %.15g", format, x);
        diag_help(d, "%%.0f rounds");
        return NULL;
    }
    size_t n = strlen(format);
    char *longer = alloc_format("%.*sll%c", (int)n - 1, format, format[n - 1]);
#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Wformat-nonliteral"
    char *text = alloc_format(longer, (long long)whole);
#pragma GCC diagnostic pop
    free(longer);
    return text;
}

char *format_number(const char *format, double x, diag *d) {
    char last = format[strlen(format) - 1];
    if ((last == 'd' || last == 'i') && !isnan(x))
        return format_whole(format, x, d);
    if (isnan(x))
        return alloc_copy("nan");
#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Wformat-nonliteral"
    return alloc_format(format, x);
#pragma GCC diagnostic pop
}

char *format_quantity(double si, dim d) {
    char number[32], suffix[48];
    if (isnan(si))
        return alloc_copy("nan");
    return alloc_format("%s%s", number_write(si, number), dim_suffix(d, suffix));
}

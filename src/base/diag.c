/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "base/diag.h"

#include <stdarg.h>
#include <stdio.h>
#include <string.h>

#ifdef SARCINA_TRACE_MESSAGES
void diag_trace(const char *format); /* tests/tools/trace.c */
#else
#define diag_trace(format) ((void)0)
#endif

static void fill(diag *d, sarcina_status status, const char *format, va_list list) {
    diag_trace(format);
    if (!d)
        return;
    d->status = status;
    d->help[0] = '\0';
    vsnprintf(d->message, sizeof d->message, format, list);
}

int diag_error(diag *d, const char *format, ...) {
    va_list list;
    va_start(list, format);
    fill(d, SARCINA_ERROR, format, list);
    va_end(list);
    return SARCINA_ERROR;
}

int diag_fail(diag *d, sarcina_status status, const char *format, ...) {
    va_list list;
    va_start(list, format);
    fill(d, status, format, list);
    va_end(list);
    return (int)status;
}

int diag_help(diag *d, const char *format, ...) {
    if (!d)
        return SARCINA_ERROR;
    size_t used = strlen(d->help);
    if (used && used + 1 < sizeof d->help)
        d->help[used++] = '\n';
    va_list list;
    va_start(list, format);
    vsnprintf(d->help + used, sizeof d->help - used, format, list);
    va_end(list);
    return (int)d->status;
}

void diag_place(diag *d, span at) {
    if (d && !d->at.source)
        d->at = at;
}

void diag_clear(diag *d) {
    if (d)
        memset(d, 0, sizeof *d);
}

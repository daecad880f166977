/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "output/field.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

const char *field_number(double x, char text[FIELD_ROOM]) {
    if (isnan(x)) {
        snprintf(text, FIELD_ROOM, "nan");
        return text;
    }
    snprintf(text, FIELD_ROOM, "%.15g", x);
    if (strtod(text, NULL) != x)
        snprintf(text, FIELD_ROOM, "%.17g", x);
    return text;
}

void field_put_csv(FILE *out, const char *text) {
    if (!strpbrk(text, ",\"\r\n")) {
        fputs(text, out);
        return;
    }
    fputc('"', out);
    for (; *text; text++) {
        if (*text == '"')
            fputc('"', out);
        fputc(*text, out);
    }
    fputc('"', out);
}

char *field_xml(const char *text) {
    char *out = NULL;
    size_t size;
    FILE *f = open_memstream(&out, &size);
    for (; *text; text++)
        switch (*text) {
        case '&':
            fputs("&amp;", f);
            break;
        case '<':
            fputs("&lt;", f);
            break;
        case '"':
            fputs("&quot;", f);
            break;
        default:
            fputc(*text, f);
        }
    fclose(f);
    return out;
}

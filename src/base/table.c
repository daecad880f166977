/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Names are compared by the optimal string alignment distance (Damerau-Levenshtein without repeated edits). */
#include "base/table.h"

#include <ctype.h>
#include <string.h>

enum { TABLE_NAME_MAX = 64 };

static const char *record_name(const void *records, size_t stride, size_t i) {
    const char *const *name = (const void *)((const char *)records + i * stride);
    return *name;
}

ptrdiff_t table_find(const void *records, size_t n, size_t stride, const char *name) {
    for (size_t i = 0; i < n; i++)
        if (strcmp(record_name(records, stride, i), name) == 0)
            return (ptrdiff_t)i;
    return -1;
}

static double substitution(char a, char b) {
    if (a == b)
        return 0;
    return tolower((unsigned char)a) == tolower((unsigned char)b) ? 0.1 : 1;
}

static double smallest(double a, double b, double c) {
    double m = a < b ? a : b;
    return m < c ? m : c;
}

double table_distance(const char *typed, const char *name) {
    size_t n = strlen(typed), m = strlen(name);
    if (n >= TABLE_NAME_MAX || m >= TABLE_NAME_MAX)
        return TABLE_NAME_MAX;
    double row[3][TABLE_NAME_MAX + 1];
    for (size_t j = 0; j <= m; j++)
        row[0][j] = (double)j;
    for (size_t i = 1; i <= n; i++) {
        double *here = row[i % 3], *above = row[(i - 1) % 3], *swap = row[(i + 1) % 3];
        here[0] = (double)i;
        for (size_t j = 1; j <= m; j++) {
            here[j] = smallest(above[j] + 1, here[j - 1] + 1, above[j - 1] + substitution(typed[i - 1], name[j - 1]));
            int swapped = i > 1 && j > 1 && typed[i - 1] == name[j - 2] && typed[i - 2] == name[j - 1];
            if (swapped && swap[j - 2] + 1 < here[j])
                here[j] = swap[j - 2] + 1;
        }
    }
    return row[n % 3][m];
}

int table_is_near(const char *typed, double distance) {
    size_t n = strlen(typed);
    double limit = n <= 2 ? 0.9 : n <= 4 ? 1 : n <= 8 ? 2 : 3;
    return distance <= limit;
}

const char *table_nearest(const void *records, size_t n, size_t stride, const char *typed) {
    const char *nearest = NULL;
    double least = TABLE_NAME_MAX;
    for (size_t i = 0; i < n; i++) {
        const char *name = record_name(records, stride, i);
        double d = table_distance(typed, name);
        if (d < least) {
            least = d;
            nearest = name;
        }
    }
    return nearest && table_is_near(typed, least) ? nearest : NULL;
}

/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "engine/spots.h"

#include "base/alloc.h"

#include <math.h>
#include <stdint.h>
#include <stdlib.h>

struct spots {
    double spacing;
    double (*points)[3];
    uint32_t *next; /* of the points in the same slot, one more; 0: the last */
    uint32_t *first;
    size_t n, slots; /* a power of two */
};

spots *spots_create(size_t n, double spacing) {
    spots *s = alloc_zeroed(1, sizeof *s);
    s->spacing = spacing;
    s->slots = 16;
    while (s->slots < 2 * n)
        s->slots *= 2;
    s->points = alloc_zeroed(n, sizeof *s->points);
    s->next = alloc_zeroed(n, sizeof *s->next);
    s->first = alloc_zeroed(s->slots, sizeof *s->first);
    return s;
}

void spots_free(spots *s) {
    if (!s)
        return;
    free(s->points);
    free(s->next);
    free(s->first);
    free(s);
}

static size_t slot_of(const spots *s, const double cube[3]) {
    uint64_t h = 0;
    for (int k = 0; k < 3; k++)
        h = (h ^ (uint64_t)(int64_t)cube[k]) * 0x9e3779b97f4a7c15u;
    return (size_t)(h >> 20) & (s->slots - 1);
}

static bool slot_is_free(const spots *s, size_t slot, const double x[3]) {
    for (uint32_t i = s->first[slot]; i; i = s->next[i - 1]) {
        const double *p = s->points[i - 1];
        double d[3] = {p[0] - x[0], p[1] - x[1], p[2] - x[2]};
        if (d[0] * d[0] + d[1] * d[1] + d[2] * d[2] < s->spacing * s->spacing)
            return false;
    }
    return true;
}

bool spots_are_free(const spots *s, const double x[3]) {
    for (int around = 0; around < 27; around++) {
        const int shift[3] = {around % 3 - 1, around / 3 % 3 - 1, around / 9 - 1};
        double cube[3];
        for (int k = 0; k < 3; k++)
            cube[k] = floor(x[k] / s->spacing) + shift[k];
        if (!slot_is_free(s, slot_of(s, cube), x))
            return false;
    }
    return true;
}

void spots_add(spots *s, const double x[3]) {
    double cube[3];
    for (int k = 0; k < 3; k++) {
        s->points[s->n][k] = x[k];
        cube[k] = floor(x[k] / s->spacing);
    }
    size_t slot = slot_of(s, cube);
    s->next[s->n] = s->first[slot];
    s->first[slot] = (uint32_t)++s->n;
}

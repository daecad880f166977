/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "output/progress.h"

#include "base/number.h"

#include <inttypes.h>
#include <math.h>
#include <stdio.h>

static const double memory = 0.9; /* weight of a cycle against that of the next */

progress progress_begin(uint64_t total, double now, double mass) {
    return (progress){.total = total, .began = now, .now = now, .shown = -INFINITY, .mass = mass};
}

void progress_cycle(progress *p, double now, double mass) {
    p->seconds = memory * p->seconds + (now - p->now);
    p->spent = memory * p->spent + mass;
    if (mass > 0 && p->mass > 0) { /* cells may have been deleted or created meanwhile: that counts too */
        p->growth = memory * p->growth + log(mass / p->mass);
        p->count = memory * p->count + 1;
    }
    p->now = now;
    p->mass = mass;
    p->done++;
}

double progress_left(const progress *p) {
    if (p->done == 0 || !(p->spent > 0))
        return NAN;
    double n = (double)(p->total - p->done), rate = p->count > 0 ? p->growth / p->count : 0;
    /* g + ... + g^n, and its limit for no growth */
    double cycles = fabs(rate) < 1e-9 ? n : exp(rate) * expm1(n * rate) / expm1(rate);
    return p->seconds / p->spent * p->mass * cycles;
}

bool progress_is_due(const progress *p) {
    return p->now - p->began >= 0.5 && p->now - p->shown >= 0.25;
}

static void put_time(double seconds, char *text, size_t room) {
    if (!(seconds < 1e7)) {
        snprintf(text, room, isnan(seconds) ? "?" : "more than 100 days");
        return;
    }
    unsigned s = (unsigned)lround(seconds);
    snprintf(text, room, "%u:%02u:%02u", s / 3600, s / 60 % 60, s % 60);
}

void progress_line(progress *p, uint64_t first, size_t cells, bool at_most, char *text, size_t room) {
    char left[40];
    double weight = (1 - pow(memory, (double)p->done)) / (1 - memory), cycle = p->seconds / weight;
    put_time(progress_left(p), left, sizeof left);
    snprintf(text, room, "cycle %" PRIu64 " of %" PRIu64 ", %zu %s, %.3g %s, %s%s left", first + p->done,
             first + p->total, cells, number_noun(cells, "cell", "cells"), cycle < 1 ? 1 / cycle : cycle,
             cycle < 1 ? "cycles/s" : "s a cycle", at_most ? "at most " : "", left);
    p->shown = p->now;
}

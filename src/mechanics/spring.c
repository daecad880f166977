/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "mechanics/spring.h"

#include "base/alloc.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

double spring_direction(const double *a, const double *b, const force_frame *at, uint64_t key_a, uint64_t key_b,
                        double u[3]) {
    double d[3] = {b[0] - a[0], b[1] - a[1], at->flat ? 0 : b[2] - a[2]};
    double length = sqrt(d[0] * d[0] + d[1] * d[1] + d[2] * d[2]);
    if (length == 0) {
        force_direction(at, key_a, key_b, u);
        return 0;
    }
    for (int i = 0; i < 3; i++)
        u[i] = d[i] / length;
    return length;
}

/* How many springs end at each particle, as offsets: start[p + 1] is the first of p, for now. */
static void count_ends(spring_index *index, const colony *c) {
    memset(index->start, 0, (c->particle.count + 2) * sizeof *index->start);
    for (size_t s = 0; s < c->spring.count; s++) {
        index->start[c->spring.a[s] + 2]++;
        if (c->spring.b[s] != SPRING_ANCHOR)
            index->start[c->spring.b[s] + 2]++;
    }
    for (size_t p = 0; p < c->particle.count; p++)
        index->start[p + 2] += index->start[p + 1];
}

void spring_index_build(spring_index *index, const colony *c, const uint32_t *owner, const body *bodies) {
    index->springs = &c->spring;
    index->start = alloc_grow(index->start, &index->start_capacity, c->particle.count + 2, sizeof *index->start);
    index->ends = alloc_grow(index->ends, &index->ends_capacity, 2 * c->spring.count, sizeof *index->ends);
    count_ends(index, c);
    /* filling moves each start to where the next one begins, so that start[p] is the first of p in the end */
    for (uint32_t s = 0; s < c->spring.count; s++) {
        uint32_t a = c->spring.a[s], b = c->spring.b[s];
        uint64_t key_b = b == SPRING_ANCHOR ? 0 : body_particle_key(&bodies[owner[b]], b);
        const double k = c->spring.k[s], rest = c->spring.rest[s];
        index->ends[index->start[a + 1]++] = (spring_end){s, b, key_b, k, rest};
        if (b != SPRING_ANCHOR)
            index->ends[index->start[b + 1]++] = (spring_end){s, a, body_particle_key(&bodies[owner[a]], a), k, rest};
    }
}

void spring_index_free(spring_index *index) {
    free(index->start);
    free(index->ends);
    memset(index, 0, sizeof *index);
}

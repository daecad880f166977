/* SPDX-License-Identifier: GPL-3.0-or-later */
/* bench-force [EVALUATIONS]: time of a force evaluation per rod for crowded monolayers of 300, 3,000 and 30,000 rods,
 * for each contact kernel, as a ratio to the reference of the same run: the same contacts and terms by plain scalar
 * code. Also what building the neighbour list costs. One thread. bench-force grow N: processor seconds from one cell to
 * N, at the default accuracy. */
#include "colony.h"

#include "mechanics/contact.h"
#include "mechanics/neighbor.h"
#include "mechanics/state.h"

#include <stdio.h>

/* Copies of a grown colony side by side until there are n cells. */
static packing make_colony(const scene *sc, size_t n) {
    const colony *from = sc->colony;
    packing p = packing_create(1);
    packing_on(&p, FORCE_COLLISION, FORCE_DAMPING);
    double side = 40 + 2.2 * sqrt((double)from->cell.count);
    size_t wide = (size_t)ceil(sqrt((double)n / (double)from->cell.count));
    for (size_t i = 0; i < n; i++) {
        size_t copy = i / from->cell.count, row = i % from->cell.count, line = copy / wide;
        double ends[6];
        memcpy(ends, from->particle.x + 3 * (size_t)from->cell.first[row], sizeof ends);
        for (size_t e = 0; e < 2; e++) {
            ends[3 * e] += side * (double)(copy % wide);
            ends[3 * e + 1] += side * (double)line;
        }
        packing_rod(&p, ends, ends + 3, from->cell.rest[row], from->cell.diameter[row]);
    }
    return p;
}

/* Contacts one by one, early out where boxes do not meet: what a program without batches would do. */
static void add_contact(const force_frame *at, contact_law_values law, size_t owner, uint32_t partner, double *f) {
    bool owner_is_a = at->bodies[owner].id < at->bodies[partner].id;
    const capsule *list = at->capsules, *a = &list[owner_is_a ? owner : partner],
                  *b = &list[owner_is_a ? partner : owner];
    contact_pair pair = {.radii = a->radius + b->radius, .rests = a->rest * b->rest};
    for (int k = 0; k < 3; k++) {
        pair.r[k] = a->x[k] - b->x[k];
        pair.d1[k] = a->d[k];
        pair.d2[k] = b->d[k];
    }
    contact_result c = contact_compute(law, pair);
    double place = owner_is_a ? c.s : c.t, sign = owner_is_a ? 1 : -1, *out = f + 3 * (size_t)at->bodies[owner].first;
    if (c.scale == 0)
        return;
    for (int k = 0; k < 3; k++) {
        out[k] += sign * (1 - place) * c.scale * c.delta[k];
        out[k + 3] += sign * place * c.scale * c.delta[k];
    }
}

static void scalar_forces(mechanics *m, const double *x, const double *v, double *f) {
    const contact_law_values law = {1e5, 1.01, 0.01};
    state_refresh(m, x);
    const force_frame at = state_frame(m, x, v);
    memset(f, 0, 3 * m->nparticles * sizeof *f);
    for (size_t slot = 0; slot < m->nbodies; slot++) {
        neighbor_row row = neighbor_get(at.neighbor, at.bodies, slot);
        for (size_t i = 0; i < row.nlower; i++)
            add_contact(&at, law, slot, row.lower[i], f);
        for (size_t i = 0; i < row.nupper; i++)
            add_contact(&at, law, slot, row.upper[i], f);
    }
    for (int i = 0; i < FORCE_COUNT; i++)
        if (i != FORCE_COLLISION && m->forces.term[i].on)
            force_styles[i]->add(m->forces.term[i].p, &at, 0, m->nbodies, f);
}

/* Best of five, seconds an evaluation; kernel NULL: the scalar reference. */
static double measure(const packing *p, const char *kernel, int evaluations) {
    mechanics *m = packing_mechanics(p, NEIGHBOR_CELLS, 1);
    double *f = calloc(3 * p->c->particle.count, sizeof *f), best = INFINITY;
    const double *x = p->c->particle.x, *v = p->c->particle.v;
    bool able = !kernel || mechanics_kernel(m, kernel);
    for (int round = 0; able && round < 5; round++) {
        mechanics_force(m, x, v, f);
        double begin = colony_now();
        for (int i = 0; i < evaluations; i++)
            kernel ? mechanics_force(m, x, v, f) : scalar_forces(m, x, v, f);
        best = fmin(best, (colony_now() - begin) / evaluations);
    }
    free(f);
    mechanics_free(m);
    return able ? best : (double)NAN;
}

static double measure_build(const packing *p) {
    double best = INFINITY;
    for (int round = 0; round < 3; round++) {
        mechanics *m = packing_mechanics(p, NEIGHBOR_CELLS, 1);
        mechanics_force_undamped(m, p->c->particle.x, m->scratch);
        best = fmin(best, mechanics_statistics(m).build_seconds);
        mechanics_free(m);
    }
    return best;
}

static void print_line(const packing *p, int total) {
    static const char *const kernels[] = {"base", "avx2", "avx512"};
    mechanics *m = packing_mechanics(p, NEIGHBOR_CELLS, 1);
    mechanics_force_undamped(m, p->c->particle.x, m->scratch);
    double n = (double)p->c->cell.count, entries = (double)mechanics_statistics(m).pairs / n;
    mechanics_free(m);
    int evaluations = total / (int)n + 1;
    double scalar = measure(p, NULL, evaluations);
    printf("%8.0f %9.1f %9.1f ns", n, entries, scalar / n * 1e9);
    for (int k = 0; k < 3; k++) {
        double t = measure(p, kernels[k], evaluations);
        printf("  %6.1f ns x%.2f", t / n * 1e9, t / scalar);
    }
    printf(" %9.0f ns\n", measure_build(p) / n * 1e9);
}

/* Seconds of the processor from one cell to each size, and (by the wall clock) where they went. */
static void time_growth(size_t most) {
    scene *sc = colony_start();
    double begin = colony_now();
    printf("%8s %8s %12s %8s %8s %12s\n", "cells", "s", "evaluations", "force s", "list s", "lists built");
    for (size_t n = most % 10 ? most : 10; n <= most; n *= 10) {
        colony_grow_to(sc, n);
        mechanics_stats stats = mechanics_statistics(sc->mechanics);
        printf("%8zu %8.2f %12llu %8.2f %8.2f %12llu\n", sc->colony->cell.count, colony_now() - begin,
               (unsigned long long)stats.evaluations, stats.force_seconds, stats.build_seconds,
               (unsigned long long)stats.builds);
    }
    scene_free(sc);
}

int main(int argc, char **argv) {
    if (argc > 2 && strcmp(argv[1], "grow") == 0) {
        time_growth((size_t)atol(argv[2]));
        return 0;
    }
    int total = argc > 1 ? atoi(argv[1]) : 1000000; /* rod evaluations a round */
    scene *sc = colony_start();
    printf("%8s %9s %12s  %15s  %15s  %15s %12s\n", "rods", "entries", "scalar", "base", "avx2", "avx512", "list");
    static const size_t sizes[] = {300, 3000, 30000};
    for (int i = 0; i < 3; i++) {
        colony_grow_to(sc, sizes[i] < 3000 ? sizes[i] : 3000);
        packing p = make_colony(sc, sizes[i]);
        print_line(&p, total);
        packing_free(&p);
    }
    scene_free(sc);
    return 0;
}

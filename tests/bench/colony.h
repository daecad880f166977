/* SPDX-License-Identifier: GPL-3.0-or-later */
/* A colony to measure, and the clock to measure it by. */
#ifndef SARCINA_TESTS_COLONY_H
#define SARCINA_TESTS_COLONY_H

#include "packing.h"

#include "biology/division.h"
#include "biology/growth.h"
#include "engine/scene.h"

#include <time.h>

/* Seconds of the processor this program has had: others may be using the machine. */
static inline double colony_now(void) {
    struct timespec t;
    clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &t);
    return (double)t.tv_sec + 1e-9 * (double)t.tv_nsec;
}

/* E. coli of Storck et al. 2014 on a plane, in cycles of 240 s of growth and 1 s of relaxation. */
static inline scene *colony_start(void) {
    scene *sc = scene_create();
    packing defaults = packing_create(1);
    sc->forces = defaults.forces;
    packing_free(&defaults);
    for (int i = FORCE_COLLISION; i <= FORCE_DAMPING; i++)
        sc->forces.term[i].on = true;
    species_add(&sc->species, "ecoli");
    species *s = &sc->species.list[0];
    s->shape = SHAPE_ROD;
    s->density = 1.01;
    s->internal_k = 5e4;
    s->diameter = (spread){SPREAD_NORMAL, 0.75, 0.0375};
    s->growth.style = 0;
    s->growth.values[GROWTH_RATE] = (spread){SPREAD_NORMAL, 1.23 / 3600, 0.277 / 3600};
    s->growth.values[GROWTH_DRAW] = spread_fixed(DRAW_STEP);
    s->division.style = 0;
    s->division.values[DIVISION_MASS] = spread_fixed(2.45);
    s->division.values[DIVISION_SIZE] = spread_fixed(NAN);
    s->division.values[DIVISION_JITTER] = spread_fixed(0.01);
    s->division.values[DIVISION_AXIS] = spread_fixed(AXIS_AUTO);
    const placement place = {.species = 0, .orient = ORIENT_XY, .mass = spread_fixed(2.12), .gap = 0, .maxtry = 1};
    size_t created;
    scene_create_single(sc, &place, (double[]){0, 0, 0}, &created, NULL);
    return sc;
}

static inline void colony_grow_to(scene *sc, size_t n) {
    while (sc->colony->cell.count < n && scene_cycle(sc, 240, 1, 0, NULL) == SARCINA_OK)
        ;
}

#endif

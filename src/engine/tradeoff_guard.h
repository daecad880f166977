/* SPDX-License-Identifier: GPL-3.0-or-later */
/* What the measurements of a trade-off share: the scene's state put by and back, the clock, a displacement. */
#ifndef SARCINA_ENGINE_TRADEOFF_GUARD_H
#define SARCINA_ENGINE_TRADEOFF_GUARD_H

#include "engine/snapshot.h"

/* All of a scene that relaxing, growing and seeding change. */
typedef struct tradeoff_guard {
    scene *s;
    snapshot *state;
    relax_settings relax;
    uint64_t seed;
    scene_timing timing;
    scene_tally tally;
} tradeoff_guard;

/* Puts it by; tradeoff_guard_end puts it back, to the bit, and frees. */
tradeoff_guard tradeoff_guard_begin(scene *s);
void tradeoff_guard_end(tradeoff_guard *g);

/* Time of all processors, s. */
double tradeoff_guard_seconds(void);

/* um */
double tradeoff_guard_diameter(const colony *c);

/* Moves every particle by this part of its cell's diameter in a direction from the scene's seed, the cell's id and the
 * particle's place in it. */
void tradeoff_guard_displace(scene *s, double part);

/* SARCINA_INTERRUPTED. */
int tradeoff_guard_interrupted(diag *d);

#endif

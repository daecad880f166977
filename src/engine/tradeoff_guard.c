/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "engine/tradeoff_guard.h"

#include <gsl/gsl_randist.h>
#include <math.h>
#include <time.h>

tradeoff_guard tradeoff_guard_begin(scene *s) {
    return (tradeoff_guard){.s = s,
                            .state = snapshot_take(s),
                            .relax = s->relax,
                            .seed = rng_get_seed(s->rng),
                            .timing = s->timing,
                            .tally = s->tally};
}

void tradeoff_guard_end(tradeoff_guard *g) {
    scene *s = g->s;
    snapshot_restore(s, g->state);
    snapshot_free(g->state);
    s->relax = g->relax;
    rng_seed(s->rng, g->seed);
    s->timing = g->timing;
    s->tally = g->tally;
}

double tradeoff_guard_seconds(void) {
    struct timespec t;
    clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &t);
    return (double)t.tv_sec + 1e-9 * (double)t.tv_nsec;
}

double tradeoff_guard_diameter(const colony *c) {
    double largest = 0;
    for (size_t i = 0; i < c->cell.count; i++)
        largest = fmax(largest, c->cell.diameter[i]);
    return largest;
}

void tradeoff_guard_displace(scene *s, double part) {
    colony *c = s->colony;
    for (size_t i = 0; i < c->cell.count; i++)
        for (uint32_t k = 0; k < c->cell.nparticles[i]; k++) {
            double u[3], *x = &c->particle.x[3 * (c->cell.first[i] + k)];
            gsl_ran_dir_3d(rng_stream(s->rng, RNG_DISPLACE, c->cell.id[i], k), &u[0], &u[1], &u[2]);
            for (int axis = 0; axis < 3; axis++)
                x[axis] += part * c->cell.diameter[i] * u[axis];
        }
    c->version++;
}

int tradeoff_guard_interrupted(diag *d) {
    return diag_fail(d, SARCINA_INTERRUPTED, "interrupted; the scene is as it was before");
}

/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Random numbers as a function of (seed, purpose, cell id, step): no order of events, no number of threads and no
 * restart can change a draw. The generator is Random123's Philox4x64-10 (Salmon et al. 2011); GSL's distributions
 * draw from it. */
#ifndef SARCINA_BASE_RNG_H
#define SARCINA_BASE_RNG_H

#include <gsl/gsl_rng.h>
#include <stdint.h>

/* What a stream is for. Numbers are part of the results: append, never reorder. */
typedef enum {
    RNG_RATE = 1,      /* growth rate of a cell in a step */
    RNG_DIAMETER = 2,  /* diameter of a newborn */
    RNG_JITTER = 3,    /* displacement at division */
    RNG_DIRECTION = 4, /* direction in which a coccus divides */
    RNG_CREATE = 5,    /* place, axis and mass of created cells; id is that of the new cell */
    RNG_DELETE = 6,    /* which cells delete_cells takes */
    RNG_SIZE = 7,      /* size at division of a cell */
    RNG_CONTACT = 8,   /* direction for contacts and springs of length zero; id mixes the two cells */
    RNG_SCRIPT = 9,    /* random(), normal(), poisson() of scripts */
    RNG_FRAME = 10,    /* frame of a coccus that divides along planes, at its first division */
    RNG_BRANCH = 11,   /* whether a daughter begins a branch */
    RNG_ATTACH = 12,   /* how many cells attach in a step, and each one's mass, axis and place */
    RNG_SNAP = 13,     /* side to which a daughter snaps at division */
    RNG_DISPLACE = 14  /* direction in which tradeoff displaces a particle; step: its place in the cell */
} rng_purpose;

typedef struct rng rng;

rng *rng_create(uint64_t seed);
void rng_free(rng *r);
void rng_seed(rng *r, uint64_t seed);
uint64_t rng_get_seed(const rng *r);

/* The stream of (seed, purpose, id, step), at its beginning. It belongs to r and holds until the next call. */
gsl_rng *rng_stream(rng *r, rng_purpose purpose, uint64_t id, uint64_t step);

/* A Poisson distributed number. By products of uniform numbers, mean by mean of at most 16 (Knuth 1997, 3.4.1 F): exact
 * and, unlike the libraries', the same bits on every processor. */
uint64_t rng_poisson(gsl_rng *stream, double mean);

/* A unit vector from (seed, RNG_CONTACT, a, b), the same for (a, b) and (b, a) but for its sign. Needs no rng, so that
 * force kernels may call it from any thread. */
void rng_direction(uint64_t seed, uint64_t a, uint64_t b, double u[3]);

/* The same in the plane: u[2] is 0. */
void rng_direction_flat(uint64_t seed, uint64_t a, uint64_t b, double u[3]);

#endif

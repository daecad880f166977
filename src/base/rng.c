/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "base/rng.h"

#include "base/alloc.h"

#include <Random123/philox.h>
#include <gsl/gsl_randist.h>
#include <math.h>
#include <sleef.h>
#include <stdlib.h>

/* GSL asks its generator for 32 bits at a time; a Philox block gives eight. */
typedef struct block_state {
    philox4x64_ctr_t counter;
    philox4x64_key_t key;
    philox4x64_ctr_t block;
    unsigned used; /* 32-bit halves of the block already given */
} block_state;

struct rng {
    gsl_rng gsl;
    block_state state;
    uint64_t seed;
};

static unsigned long block_get(void *p) {
    block_state *s = p;
    if (s->used == 8) {
        s->counter.v[3]++;
        s->block = philox4x64(s->counter, s->key);
        s->used = 0;
    }
    uint64_t word = s->block.v[s->used / 2];
    unsigned long half = s->used % 2 ? (unsigned long)(word >> 32) : (unsigned long)(word & 0xffffffffu);
    s->used++;
    return half;
}

static double block_get_double(void *p) {
    return (double)block_get(p) / 4294967296.0;
}

static void block_set(void *p, unsigned long seed) {
    block_state *s = p;
    s->key.v[0] = seed;
    s->used = 8;
}

static const gsl_rng_type philox_type = {"philox4x64", 0xffffffffUL,    0, sizeof(block_state), block_set,
                                         block_get,    block_get_double};

rng *rng_create(uint64_t seed) {
    rng *r = alloc_zeroed(1, sizeof *r);
    r->gsl.type = &philox_type;
    r->gsl.state = &r->state;
    r->seed = seed;
    return r;
}

void rng_free(rng *r) {
    free(r);
}

void rng_seed(rng *r, uint64_t seed) {
    r->seed = seed;
}

uint64_t rng_get_seed(const rng *r) {
    return r->seed;
}

gsl_rng *rng_stream(rng *r, rng_purpose purpose, uint64_t id, uint64_t step) {
    r->state.key = (philox4x64_key_t){{r->seed, (uint64_t)purpose}};
    r->state.counter = (philox4x64_ctr_t){{id, step, 0, 0}};
    r->state.used = 8;
    return &r->gsl;
}

void rng_direction(uint64_t seed, uint64_t a, uint64_t b, double u[3]) {
    uint64_t low = a < b ? a : b, high = a < b ? b : a;
    double sign = a < b ? 1 : -1;
    philox4x64_key_t key = {{seed, RNG_CONTACT}};
    philox4x64_ctr_t counter = {{low, high, 0, 0}};
    for (;;) {
        /* Marsaglia (1972): uniform on the sphere from a point in the disc */
        counter.v[3]++;
        philox4x64_ctr_t r = philox4x64(counter, key);
        double p = 2 * ((double)(r.v[0] >> 11) * 0x1p-53) - 1, q = 2 * ((double)(r.v[1] >> 11) * 0x1p-53) - 1;
        double s = p * p + q * q;
        if (s >= 1)
            continue;
        double root = 2 * sqrt(1 - s);
        u[0] = sign * p * root;
        u[1] = sign * q * root;
        u[2] = sign * (1 - 2 * s);
        return;
    }
}

void rng_direction_flat(uint64_t seed, uint64_t a, uint64_t b, double u[3]) {
    double length;
    do { /* the shadow of a direction in space; the poles, which have hardly one, draw anew */
        rng_direction(seed, a, b, u);
        length = sqrt(u[0] * u[0] + u[1] * u[1]);
        seed++;
    } while (length < 0.01);
    u[0] /= length;
    u[1] /= length;
    u[2] = 0;
}

uint64_t rng_poisson(gsl_rng *stream, double mean) {
    uint64_t n = 0;
    while (mean > 0) {
        double part = fmin(mean, 16), least = Sleef_cinz_expd1_u10purec(-part), product = gsl_rng_uniform_pos(stream);
        for (; product > least; n++)
            product *= gsl_rng_uniform_pos(stream);
        mean -= part;
    }
    return n;
}

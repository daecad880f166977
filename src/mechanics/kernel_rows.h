/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Rows of contacts, PACK_WIDTH owners beside each other: each lane walks its own owner's row and sums it in registers.
 * Included by kernel_batch.h. The file of a vector width defines `pack`, a vector of PACK_WIDTH numbers, and what
 * contact_law.h asks for by the names pack_...; pack_load and pack_store of PACK_WIDTH numbers; pack_any of a mask (is
 * it true in a lane?); and pack_records(from, n, to): the first n numbers (6 or 8) at each of PACK_WIDTH addresses,
 * to[k] with the k-th of all.
 *
 * What a contact is waits for four quotients and a root, one for the other, for some 200 cycles in all: two short loops
 * over a row instead of one long one let the processor work at many contacts at once. */
#include "mechanics/kernel.h"

#define CONTACT_REAL pack
#define CONTACT_MASK pack_mask
#define CONTACT_(name) pack_##name
#include "mechanics/contact_law.h"
#undef CONTACT_REAL
#undef CONTACT_MASK
#undef CONTACT_

#define KERNEL_INLINE static inline __attribute__((always_inline))

/* The capsules of PACK_WIDTH bodies. */
typedef struct rows_bodies {
    pack x[3], d[3], radius, rest;
} rows_bodies;

/* Those that begin at these places. */
KERNEL_INLINE void load_bodies(int dimensions, const void *capsules, const uint32_t *places, rows_bodies *to) {
    const double *from[PACK_WIDTH];
    pack numbers[8];
    for (int l = 0; l < PACK_WIDTH; l++)
        from[l] = (const double *)capsules + places[l];
    pack_records(from, 2 * dimensions + 2, numbers);
    for (int k = 0; k < dimensions; k++) {
        to->x[k] = numbers[k];
        to->d[k] = numbers[CAPSULE_AXIS + k];
    }
    to->radius = numbers[dimensions];
    to->rest = numbers[capsule_rest(dimensions)];
}

/* What the second loop needs of the contacts that the first has found. */
enum { ROWS_BLOCK = 16 };
typedef struct rows_found {
    pack delta[3], place, g, reach; /* delta from the partner to the owner; place on the owner */
} rows_found;

typedef struct rows_sums {
    pack total[3], last[3]; /* without axes no `last` */
    pack least;             /* squared distance */
} rows_sums;

/* Contact of each owner with one partner: the body of lower id is A. */
KERNEL_INLINE void find_segments(int dimensions, contact_law_values law, const rows_bodies *own,
                                 const rows_bodies *other, pack_mask own_is_b, rows_found *out) {
    const pack side = pack_pick(own_is_b, pack_set(-1), pack_set(1));
    pack_pair p;
    pack_result c;
    for (int k = 0; k < dimensions; k++) {
        p.r[k] = side * (own->x[k] - other->x[k]);
        p.d1[k] = pack_pick(own_is_b, other->d[k], own->d[k]);
        p.d2[k] = pack_pick(own_is_b, own->d[k], other->d[k]);
    }
    p.radii = own->radius + other->radius;
    p.rests = own->rest * other->rest;
    pack_nearest(dimensions, law, &p, &c);
    for (int k = 0; k < dimensions; k++)
        out->delta[k] = side * c.delta[k];
    out->place = pack_pick(own_is_b, c.t, c.s);
    out->g = c.g;
    out->reach = c.reach;
}

/* Without axes most of the law is constant. */
KERNEL_INLINE void find_spheres(int dimensions, contact_law_values law, const rows_bodies *own,
                                const rows_bodies *other, rows_found *out) {
    const pack reach = law.reach * (own->radius + other->radius);
    for (int k = 0; k < dimensions; k++)
        out->delta[k] = own->x[k] - other->x[k];
    out->place = pack_set(0);
    out->g = pack_set(-0.0); /* to add it is nothing, and known to be */
    out->reach = reach * reach;
}

KERNEL_INLINE void sum_found(int dimensions, bool axes, contact_law_values law, const rows_found *found,
                             rows_sums *sums) {
    pack_result c = {.g = found->g, .reach = found->reach};
    for (int k = 0; k < dimensions; k++)
        c.delta[k] = found->delta[k];
    pack_push(dimensions, law, &c);
    for (int k = 0; k < dimensions; k++) {
        const pack force = c.scale * c.delta[k];
        sums->total[k] += force;
        if (axes)
            sums->last[k] += found->place * force;
    }
    sums->least = pack_min(c.square, sums->least);
}

/* Contacts of the owners with their partners begin ... begin + n - 1. Those of spheres wait for one quotient and a root
 * only: one loop. */
KERNEL_INLINE void sum_block(int dimensions, bool axes, contact_law_values law, const kernel_rows *rows, size_t from,
                             size_t begin, size_t n, const rows_bodies *own, rows_sums *sums) {
    const uint32_t *partners = rows->partners + KERNEL_LANES * begin + from;
    const pack lower = pack_load(rows->lower + from);
    rows_found found[ROWS_BLOCK];
    for (size_t i = 0; i < n; i++) {
        rows_bodies other;
        const pack place = pack_set((double)(int64_t)(rows->begin + begin + i));
        load_bodies(dimensions, rows->capsules, partners + KERNEL_LANES * i, &other);
        if (axes) {
            find_segments(dimensions, law, own, &other, pack_less(place, lower), &found[i]);
            continue;
        }
        find_spheres(dimensions, law, own, &other, &found[0]);
        sum_found(dimensions, axes, law, &found[0], sums);
    }
    for (size_t i = 0; axes && i < n; i++)
        sum_found(dimensions, axes, law, &found[i], sums);
}

/* Owners from ... from + PACK_WIDTH - 1. */
KERNEL_INLINE bool sum_rows(int dimensions, bool axes, const contact_law_values *law, const kernel_rows *rows,
                            size_t from, kernel_sums *out) {
    const contact_law_values l = *law;
    rows_bodies own;
    rows_sums sums;
    for (int k = 0; k < dimensions; k++) {
        sums.total[k] = rows->begin ? pack_load(out->total[k] + from) : pack_set(0);
        if (axes)
            sums.last[k] = rows->begin ? pack_load(out->last[k] + from) : pack_set(0);
    }
    sums.least = pack_set(1);
    uint32_t places[PACK_WIDTH];
    for (size_t i = 0; i < PACK_WIDTH; i++)
        places[i] = capsule_place(rows->owners[from + i], dimensions == 2);
    load_bodies(dimensions, rows->capsules, places, &own);
    for (size_t begin = 0; begin < rows->length; begin += ROWS_BLOCK) {
        const size_t n = rows->length - begin < ROWS_BLOCK ? rows->length - begin : ROWS_BLOCK;
        sum_block(dimensions, axes, l, rows, from, begin, n, &own, &sums);
    }
    for (int k = 0; k < dimensions; k++) {
        pack_store(out->total[k] + from, sums.total[k]);
        if (axes)
            pack_store(out->last[k] + from, sums.last[k]);
    }
    return pack_any(pack_less(sums.least, pack_set(CONTACT_COINCIDENT * CONTACT_COINCIDENT)));
}

KERNEL_INLINE bool rows_in(int dimensions, bool axes, const contact_law_values *law, const kernel_rows *rows,
                           kernel_sums *sums) {
    bool coincident = false;
    for (size_t from = 0; from < KERNEL_LANES; from += PACK_WIDTH)
        coincident |= sum_rows(dimensions, axes, law, rows, from, sums);
    return coincident;
}

static bool rows_segments(const contact_law_values *law, const kernel_rows *rows, kernel_sums *sums) {
    return rows_in(3, true, law, rows, sums);
}

static bool rows_segments_flat(const contact_law_values *law, const kernel_rows *rows, kernel_sums *sums) {
    return rows_in(2, true, law, rows, sums);
}

static bool rows_spheres(const contact_law_values *law, const kernel_rows *rows, kernel_sums *sums) {
    return rows_in(3, false, law, rows, sums);
}

static bool rows_spheres_flat(const contact_law_values *law, const kernel_rows *rows, kernel_sums *sums) {
    return rows_in(2, false, law, rows, sums);
}

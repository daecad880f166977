/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "mechanics/force.h"

#include "base/alloc.h"
#include "base/rng.h"
#include "mechanics/force/forces.h"

#include <string.h>

const force_style *const force_styles[FORCE_COUNT] = {
    [FORCE_INTERNAL] = &force_internal, [FORCE_BEND] = &force_bend,           [FORCE_TWIST] = &force_twist,
    [FORCE_SPRINGS] = &force_springs,   [FORCE_COLLISION] = &force_collision, [FORCE_SUBSTRATUM] = &force_substratum,
    [FORCE_DLVO] = &force_dlvo,         [FORCE_DAMPING] = &force_damping,     [FORCE_GRAVITY] = &force_gravity,
};

void force_direction(const force_frame *at, uint64_t key_a, uint64_t key_b, double u[3]) {
    (at->flat ? rng_direction_flat : rng_direction)(at->seed, key_a, key_b, u);
}

stiff_spring *force_spring_add(stiff_list *list, size_t of, double k) {
    list->list = alloc_grow(list->list, &list->capacity, list->count + 1, sizeof *list->list);
    stiff_spring *next = &list->list[list->count++];
    next->k = k;
    next->pull = 0;
    next->count = 0;
    next->of = (uint32_t)of;
    return next;
}

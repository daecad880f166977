/* SPDX-License-Identifier: GPL-3.0-or-later */
/* What the mechanics hold and did: memory by part, evaluations, time by term. */
#include "mechanics/state.h"

void mechanics_memory(const mechanics *m, mechanics_part parts[MECHANICS_PARTS]) {
    const neighbor *list = &m->neighbor;
    const mechanics_part all[MECHANICS_PARTS] = {
        {"bodies",
         sizeof *m + m->image.capacity + m->next_image.capacity +
             m->body_capacity * (2 * sizeof *m->bodies + sizeof *m->by_id) +
             m->particle_capacity * (2 * sizeof(uint32_t) + (2 + (size_t)state_dimensions(m)) * sizeof(double))},
        {"chains", m->chain_capacity * sizeof *m->chains + m->share_capacity * sizeof *m->shares},
        {"capsules",
         m->capsule_capacity * (capsule_size(m->flat) + 2 * (size_t)state_dimensions(m) * sizeof *m->built_at)},
        {"neighbours",
         (list->entries_capacity + list->lanes_capacity) * sizeof(uint32_t) +
             list->n_capacity * (sizeof *list->start + 2 * sizeof(uint32_t)) +
             neighbor_groups(list->n_capacity) *
                 (sizeof *list->group_start + KERNEL_LANES * (sizeof *list->members + sizeof *list->lower)) +
             list->grid.places_capacity * sizeof *list->grid.places +
             list->grid.boxes_capacity * sizeof *list->grid.boxes + list->grid.rows_capacity * sizeof *list->grid.rows},
        {"spring index",
         m->springs.ends_capacity * sizeof *m->springs.ends + m->springs.start_capacity * sizeof *m->springs.start},
        {"stiffness", m->stiff.capacity * sizeof *m->stiff.list + m->start_capacity * sizeof *m->start},
    };
    for (int i = 0; i < MECHANICS_PARTS; i++)
        parts[i] = all[i];
}

mechanics_stats mechanics_statistics(const mechanics *m) {
    mechanics_stats stats = m->stats;
    mechanics_part parts[MECHANICS_PARTS];
    mechanics_memory(m, parts);
    for (int i = 0; i < MECHANICS_PARTS; i++)
        stats.bytes += parts[i].bytes;
    stats.pairs = m->listed ? neighbor_entries(&m->neighbor) : 0;
    stats.skin = m->skin;
    stats.kernel = m->kernel->name;
    stats.spheres = m->cocci;
    stats.flat = m->flat;
    return stats;
}

bool mechanics_is_active(const mechanics *m, force_kind term) {
    return m->bound && m->forces.term[term].on;
}

/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "engine/snapshot.h"

#include "base/alloc.h"

#include <inttypes.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

struct snapshot {
    colony *colony;
    lineage *dead;
    uint64_t step, growth_steps, deletions, arrived, crowded;
    double time, relaxed, time_rest, relaxed_rest;
};

snapshot *snapshot_take(const scene *s) {
    snapshot *p = alloc_zeroed(1, sizeof *p);
    p->colony = colony_create();
    colony_copy(p->colony, s->colony);
    p->dead = lineage_keep(s->dead);
    p->arrived = s->attachments.arrived;
    p->crowded = s->attachments.crowded;
    p->step = s->step;
    p->growth_steps = s->growth_steps;
    p->deletions = s->deletions;
    p->time = s->time;
    p->relaxed = s->relaxed;
    p->time_rest = s->time_rest;
    p->relaxed_rest = s->relaxed_rest;
    return p;
}

void snapshot_free(snapshot *p) {
    if (!p)
        return;
    colony_free(p->colony);
    lineage_free(p->dead);
    free(p);
}

void snapshot_restore(scene *s, const snapshot *p) {
    colony_copy(s->colony, p->colony);
    lineage_free(s->dead);
    s->dead = lineage_keep(p->dead);
    s->attachments.arrived = p->arrived;
    s->attachments.crowded = p->crowded;
    s->step = p->step;
    s->growth_steps = p->growth_steps;
    s->deletions = p->deletions;
    s->time = p->time;
    s->relaxed = p->relaxed;
    s->time_rest = p->time_rest;
    s->relaxed_rest = p->relaxed_rest;
}

static int save_column(void *self, const char *table, const char *column, void *data, size_t row_bytes, size_t rows) {
    char name[64];
    snprintf(name, sizeof name, "%s.%s", table, column);
    archive_put(self, name, data, rows * row_bytes);
    return 0;
}

/* Doubles as hexadecimal: text that reads back to the bit. */
#define CLOCK_FORMAT                                                                                                   \
    "step %" PRIu64 " growth_steps %" PRIu64 " deletions %" PRIu64 " time %a relaxed %a seed %" PRIu64                 \
    " next_cell %" PRIu64 " next_link %" PRIu64 " formed %" PRIu64 " broken %" PRIu64                                  \
    " particles %zu cells %zu links %zu springs %zu"
#define CLOCK_SCAN                                                                                                     \
    "step %" SCNu64 " growth_steps %" SCNu64 " deletions %" SCNu64 " time %la relaxed %la seed %" SCNu64               \
    " next_cell %" SCNu64 " next_link %" SCNu64 " formed %" SCNu64 " broken %" SCNu64                                  \
    " particles %zu cells %zu links %zu springs %zu"
enum { CLOCK_ITEMS = 14 };

/* "far 3 jolt 0 ...": by name, so that files of before a cap was known are read. */
static void save_caps(const colony *c, archive *a) {
    char text[64 * CAP_COUNT] = "";
    size_t used = 0;
    for (int i = 0; i < CAP_COUNT; i++)
        used += (size_t)snprintf(text + used, sizeof text - used, "%s %" PRIu64 "\n", cap_records[i].name, c->caps[i]);
    archive_put(a, "caps", text, used);
}

static void load_caps(colony *c, const archive *a) {
    const char *text = archive_get(a, "caps", NULL);
    char name[32];
    uint64_t hits;
    for (int n = 0; text && sscanf(text, "%31s %" SCNu64 "%n", name, &hits, &n) == 2; text += n)
        for (int i = 0; i < CAP_COUNT; i++)
            if (strcmp(name, cap_records[i].name) == 0)
                c->caps[i] = hits;
}

void snapshot_save(scene *s, archive *a) {
    colony *c = s->colony;
    char *clock = alloc_format(CLOCK_FORMAT, s->step, s->growth_steps, s->deletions, s->time, s->relaxed,
                               rng_get_seed(s->rng), c->next_cell_id, c->next_link_id, c->links_formed, c->links_broken,
                               c->particle.count, c->cell.count, c->link.count, c->spring.count);
    archive_put(a, "clock", clock, strlen(clock));
    free(clock);
    char rests[64];
    archive_put(a, "rests", rests, (size_t)snprintf(rests, sizeof rests, "%a %a", s->time_rest, s->relaxed_rest));
    save_caps(c, a);
    colony_walk(c, save_column, a);
    archive_put(a, "lineage", lineage_pairs(s->dead), 16 * lineage_count(s->dead));
}

static int load_column(void *self, const char *table, const char *column, void *data, size_t row_bytes, size_t rows) {
    char name[64];
    snprintf(name, sizeof name, "%s.%s", table, column);
    size_t n = 0;
    const char *bytes = archive_get(self, name, &n);
    if (!bytes || n != rows * row_bytes)
        return 1;
    if (n)
        memcpy(data, bytes, n);
    return 0;
}

/* Are the rows that columns point to there? Damage that a checksum cannot see: a file written by hand. */
static bool is_consistent(const colony *c, size_t nspecies) {
    size_t particles = 0, springs = 0;
    for (size_t i = 0; i < c->cell.count; i++) {
        if (c->cell.first[i] != particles || c->cell.species[i] < 0 || (size_t)c->cell.species[i] >= nspecies)
            return false;
        particles += c->cell.nparticles[i];
    }
    for (size_t i = 0; i < c->link.count; i++) {
        if (c->link.first[i] != springs)
            return false;
        springs += c->link.nsprings[i];
    }
    for (size_t i = 0; i < c->spring.count; i++)
        if (c->spring.a[i] >= particles || (c->spring.b[i] >= particles && c->spring.b[i] != SPRING_ANCHOR))
            return false;
    return particles == c->particle.count && springs == c->spring.count;
}

int snapshot_load(scene *s, const archive *a, diag *d) {
    uint64_t step, growth_steps, deletions, seed, next_cell, next_link, formed, broken;
    double time, relaxed;
    size_t particles, cells, links, springs;
    const char *clock = archive_get(a, "clock", NULL);
    if (!clock || sscanf(clock, CLOCK_SCAN, &step, &growth_steps, &deletions, &time, &relaxed, &seed, &next_cell,
                         &next_link, &formed, &broken, &particles, &cells, &links, &springs) != CLOCK_ITEMS)
        return diag_error(d, "the restart file has no state");
    size_t bytes = 0;
    const char *pairs = archive_get(a, "lineage", &bytes);
    colony *c = colony_create();
    colony_resize(c, particles, cells, links, springs);
    if (bytes % 16 || colony_walk(c, load_column, (void *)a) || !is_consistent(c, s->species.count)) {
        colony_free(c);
        return diag_error(d, "the restart file's columns do not fit together");
    }
    c->next_cell_id = next_cell;
    c->next_link_id = next_link;
    c->links_formed = formed;
    c->links_broken = broken;
    load_caps(c, a);
    colony_copy(s->colony, c);
    lineage_free(s->dead);
    s->dead = lineage_of_pairs((const void *)pairs, bytes / 16);
    colony_free(c);
    s->step = step;
    s->growth_steps = growth_steps;
    s->deletions = deletions;
    s->time = time;
    s->relaxed = relaxed;
    s->time_rest = s->relaxed_rest = 0;
    const char *rests = archive_get(a, "rests", NULL); /* files of earlier versions have none */
    if (rests)
        sscanf(rests, "%la %la", &s->time_rest, &s->relaxed_rest);
    rng_seed(s->rng, seed);
    return SARCINA_OK;
}

/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "engine/scene.h"

#include "analysis/view_cache.h"
#include "base/alloc.h"
#include "biology/division.h"
#include "engine/flat.h"
#include "mechanics/remodel.h"
#include "model/link.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

/* What a new or cleared scene is set to: nothing acts, seed 1, the default accuracy. */
static void set_defaults(scene *s) {
    s->neighbor = (neighbor_settings){.skin = -1, .method = NEIGHBOR_CELLS};
    for (size_t i = 0; i < accuracy_preset_count; i++)
        if (strcmp(accuracy_presets[i].name, "balanced") == 0)
            s->accuracy = (int)i;
    s->relax = accuracy_presets[s->accuracy].settings;
    memset(&s->forces, 0, sizeof s->forces);
    s->dimension = 3;
    link_rules_clear(&s->links);
    memset(&s->timing, 0, sizeof s->timing);
    s->tally = (scene_tally){.least_step = INFINITY};
    s->step = s->growth_steps = s->deletions = 0;
    s->time = s->relaxed = s->time_rest = s->relaxed_rest = 0;
    rng_seed(s->rng, 1);
}

scene *scene_create(void) {
    scene *s = alloc_zeroed(1, sizeof *s);
    s->colony = colony_create();
    s->rng = rng_create(1);
    s->mechanics = mechanics_create();
    s->cache = view_cache_create();
    s->dead = lineage_create();
    s->threads = 1;
    set_defaults(s);
    return s;
}

void scene_free(scene *s) {
    if (!s)
        return;
    colony_free(s->colony);
    rng_free(s->rng);
    mechanics_free(s->mechanics);
    view_cache_free(s->cache);
    free(s->species.list);
    free(s->regions.list);
    link_rules_free(&s->links);
    free(s->attachments.list);
    lineage_free(s->dead);
    free(s);
}

void scene_clear(scene *s) {
    colony_clear(s->colony);
    s->species.count = 0;
    s->regions.count = 0;
    memset(&s->groups, 0, sizeof s->groups);
    s->attachments.count = s->attachments.serials = s->attachments.arrived = s->attachments.crowded = 0;
    lineage_free(s->dead);
    s->dead = lineage_create();
    set_defaults(s);
}

int scene_prepare(scene *s, diag *d) {
    const mechanics_input in = {.colony = s->colony,
                                .species = &s->species,
                                .forces = &s->forces,
                                .links = &s->links,
                                .time = s->time,
                                .flat = s->dimension == 2,
                                .neighbor = s->neighbor,
                                .seed = rng_get_seed(s->rng),
                                .threads = s->threads};
    return mechanics_prepare(s->mechanics, &in, d);
}

/* Field by field: padding between them need not agree. */
static bool is_same(const force_set *a, const force_set *b) {
    for (int i = 0; i < FORCE_COUNT; i++) {
        if (a->term[i].on != b->term[i].on)
            return false;
        for (int k = 0; k < PARAM_COUNT_MAX; k++)
            if (a->term[i].p[k] != b->term[i].p[k])
                return false;
    }
    return true;
}

/* What measures share is kept while the state they measured stands. */
static void refresh_cache(scene *s) {
    bool same = s->cached.version == s->colony->version && s->cached.relaxed == s->relaxed &&
                is_same(&s->cached.forces, &s->forces);
    if (same)
        return;
    view_cache_reset(s->cache);
    s->cached.version = s->colony->version;
    s->cached.relaxed = s->relaxed;
    s->cached.forces = s->forces;
}

view scene_view(scene *s) {
    bool bound = scene_prepare(s, NULL) == SARCINA_OK;
    refresh_cache(s);
    return (view){.colony = s->colony,
                  .species = &s->species,
                  .dead = s->dead,
                  .mechanics = bound ? s->mechanics : NULL,
                  .seed = rng_get_seed(s->rng),
                  .step = s->step,
                  .time = s->time,
                  .relaxed = s->relaxed,
                  .wall = s->timing.total,
                  .links_formed = s->colony->links_formed,
                  .links_broken = s->colony->links_broken,
                  .cache = s->cache};
}

void scene_delete(scene *s, const bool *doomed) {
    size_t n = s->colony->cell.count, kept = 0;
    uint32_t *rows = alloc_zeroed(n, sizeof *rows);
    for (uint32_t i = 0; i < n; i++)
        if (!doomed[i])
            rows[kept++] = i;
    if (kept < n) {
        lineage_add(&s->dead, s->colony, doomed);
        colony_arrange(s->colony, rows, kept);
    }
    free(rows);
}

static void refresh_species(scene *s, int row) {
    colony *c = s->colony;
    const species *sp = &s->species.list[row];
    for (uint32_t i = 0; i < c->cell.count; i++) {
        if (c->cell.species[i] != row)
            continue;
        species_shape_cell(sp, c, i);
        c->cell.limit[i] = division_limit(sp, s->rng, c->cell.id[i], c->cell.diameter[i], c->cell.aspect[i]);
    }
    c->version++; /* masses and sizes are not what caches of the mechanics hold */
    scene_refresh_links(s);
}

int scene_change_species(scene *s, int row, const species *changed, diag *d) {
    int status = division_check(changed, d);
    if (!status)
        status = flat_check_species(s, changed, d);
    if (status)
        return status;
    s->species.list[row] = *changed;
    refresh_species(s, row);
    return SARCINA_OK;
}

void scene_refresh_links(scene *s) {
    link_renew(s->colony, &s->links);
}

int scene_stick(scene *s, size_t *formed, diag *d) {
    remodel_change change;
    int status = scene_prepare(s, d);
    if (status)
        return status;
    mechanics_remodel_stick(s->mechanics, &change);
    *formed = change.formed;
    return SARCINA_OK;
}

/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "analysis/view_cache.h"

#include "analysis/component.h"
#include "base/alloc.h"
#include "base/vec3.h"

#include <math.h>
#include <stdlib.h>

struct view_cache {
    bool has_contacts, has_links;
    size_t capacity; /* cells there is room for */
    double *overlap, *force, *stretch, *strain;
    uint32_t *contacts, *filial, *stuck, *anchored, *root;
};

view_cache *view_cache_create(void) {
    return alloc_zeroed(1, sizeof(view_cache));
}

void view_cache_free(view_cache *cache) {
    if (!cache)
        return;
    free(cache->overlap);
    free(cache->force);
    free(cache->stretch);
    free(cache->strain);
    free(cache->contacts);
    free(cache->filial);
    free(cache->stuck);
    free(cache->anchored);
    free(cache->root);
    free(cache);
}

void view_cache_reset(view_cache *cache) {
    cache->has_contacts = cache->has_links = false;
}

static void reserve(view_cache *cache, size_t cells) {
    if (cells <= cache->capacity && cache->overlap)
        return;
    size_t n = cells + cells / 2;
    cache->capacity = n;
    cache->overlap = alloc_resize(cache->overlap, n, sizeof(double));
    cache->force = alloc_resize(cache->force, 3 * n, sizeof(double));
    cache->stretch = alloc_resize(cache->stretch, n, sizeof(double));
    cache->strain = alloc_resize(cache->strain, n, sizeof(double));
    cache->contacts = alloc_resize(cache->contacts, n, sizeof(uint32_t));
    cache->filial = alloc_resize(cache->filial, n, sizeof(uint32_t));
    cache->stuck = alloc_resize(cache->stuck, n, sizeof(uint32_t));
    cache->anchored = alloc_resize(cache->anchored, n, sizeof(uint32_t));
    cache->root = alloc_resize(cache->root, n, sizeof(uint32_t));
    view_cache_reset(cache);
}

/* A scene that cannot be prepared, or whose positions are not finite: nothing is known of its forces. */
static void fill_unknown(view_cache *cache, size_t n) {
    for (size_t i = 0; i < n; i++) {
        cache->overlap[i] = cache->force[3 * i] = cache->force[3 * i + 1] = cache->force[3 * i + 2] = NAN;
        cache->contacts[i] = 0;
    }
}

view_contacts view_cache_contacts(const view *v) {
    view_cache *cache = v->cache;
    reserve(cache, v->colony->cell.count);
    if (!cache->has_contacts)
        fill_unknown(cache, v->colony->cell.count);
    if (!cache->has_contacts && v->mechanics)
        mechanics_contacts(v->mechanics, cache->overlap, cache->contacts, cache->force);
    cache->has_contacts = true;
    return (view_contacts){cache->overlap, cache->contacts, cache->force};
}

/* Larger of a and b, b when a is not yet a number. */
static double larger(double a, double b) {
    return a >= b ? a : b;
}

static void note_spring(view_cache *cache, uint32_t row, double length, double rest) {
    cache->stretch[row] = larger(cache->stretch[row], length - rest);
    if (rest > 0)
        cache->strain[row] = larger(cache->strain[row], (length - rest) / rest);
}

/* A cell's own springs: the distances of its particles against the rest length that its mass gives. */
static void note_internal(view_cache *cache, const colony *c, const species_table *t, uint32_t row) {
    cache->stretch[row] = cache->strain[row] = NAN;
    if (c->cell.nparticles[row] < 2)
        return;
    const double *a = c->particle.x + 3 * (size_t)c->cell.first[row];
    double rest = species_segment(&t->list[c->cell.species[row]], c->cell.rest[row]);
    for (uint32_t p = 0; p + 1 < c->cell.nparticles[row]; p++, a += 3)
        note_spring(cache, row, vec3_norm(vec3_sub(vec3_load(a + 3), vec3_load(a))), rest);
}

static void note_link(view_cache *cache, const colony *c, uint32_t link, uint32_t row) {
    if (row == COLONY_NO_ROW)
        return;
    cache->filial[row] += c->link.kind[link] == LINK_FILIAL;
    cache->stuck[row] += c->link.kind[link] == LINK_STICK;
    cache->anchored[row] += c->link.kind[link] == LINK_ANCHOR;
    for (uint32_t i = 0; i < c->link.nsprings[link]; i++) {
        uint32_t s = c->link.first[link] + i;
        note_spring(cache, row, colony_spring_length(c, s), c->spring.rest[s]);
    }
}

static void compute_links(view_cache *cache, colony *c, const species_table *t) {
    for (uint32_t row = 0; row < c->cell.count; row++) {
        cache->filial[row] = cache->stuck[row] = cache->anchored[row] = 0;
        note_internal(cache, c, t, row);
    }
    for (uint32_t link = 0; link < c->link.count; link++) {
        note_link(cache, c, link, colony_row(c, c->link.cell_a[link]));
        note_link(cache, c, link, colony_row(c, c->link.cell_b[link]));
    }
    for (uint32_t row = 0; row < c->cell.count; row++) { /* no spring: nothing is stretched */
        cache->stretch[row] = isnan(cache->stretch[row]) ? 0 : cache->stretch[row];
        cache->strain[row] = isnan(cache->strain[row]) ? 0 : cache->strain[row];
    }
    component_roots(c, COMPONENT_ANY_LINK, NULL, cache->root);
}

view_links view_cache_links(const view *v) {
    view_cache *cache = v->cache;
    reserve(cache, v->colony->cell.count);
    if (!cache->has_links)
        compute_links(cache, v->colony, v->species);
    cache->has_links = true;
    return (view_links){cache->filial, cache->stuck, cache->anchored, cache->stretch, cache->strain, cache->root};
}

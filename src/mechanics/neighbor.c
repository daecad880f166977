/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "mechanics/neighbor.h"

#include "base/alloc.h"
#include "mechanics/grid.h"

#include <omp.h>
#include <stdlib.h>
#include <string.h>

/* Distances in lists are trusted to this, um: near-parallel axes are only known to about so much. */
static const double slack = 1e-6;

void neighbor_free(neighbor *list) {
    free(list->entries);
    free(list->start);
    free(list->middle);
    free(list->by_id);
    memset(list, 0, sizeof *list);
}

void neighbor_sort(const capsule *capsules, size_t n, uint32_t *order) {
    grid_sort(capsules, n, order);
}

size_t neighbor_entries(const neighbor *list) {
    if (list->method == NEIGHBOR_PAIRS)
        return list->n ? list->n * (list->n - 1) : 0;
    return list->start ? list->start[list->n] : 0;
}

/* What one thread gathers: the rows of a stretch of slots, one after another. */
typedef struct gatherer {
    const grid *g;
    const body *bodies;
    const capsule *capsules;
    const contact_kernel *kernel;
    contact_law_values law; /* the published one: distances between axes */
    double skin;
    uint32_t *found; /* slots whose boxes meet */
    uint64_t *keys;  /* rank << 32 | slot of those near enough */
    uint32_t *entries;
    size_t found_capacity, keys_capacity, entries_capacity, count;
} gatherer;

static void load_candidates(gatherer *w, size_t slot, const uint32_t *found, size_t n, kernel_batch *b) {
    const capsule *own = &w->capsules[slot];
    for (size_t i = 0; i < n; i++) {
        const capsule *other = &w->capsules[found[i]];
        for (int k = 0; k < 3; k++) {
            b->r[k][i] = own->x[k] - other->x[k];
            b->d1[k][i] = own->d[k];
            b->d2[k][i] = other->d[k];
        }
        b->radii[i] = own->radius + other->radius;
        b->rests[i] = 0;
    }
}

/* Of the found slots, the keys of those whose segments are near enough. */
static size_t filter(gatherer *w, size_t slot, size_t nfound) {
    kernel_batch b;
    size_t kept = 0;
    w->keys = alloc_grow(w->keys, &w->keys_capacity, nfound, sizeof *w->keys);
    for (size_t at = 0; at < nfound; at += KERNEL_BATCH) {
        size_t n = nfound - at < KERNEL_BATCH ? nfound - at : KERNEL_BATCH;
        load_candidates(w, slot, w->found + at, n, &b);
        w->kernel->contact(&w->law, n, &b);
        for (size_t i = 0; i < n; i++) {
            double limit = w->law.reach * b.radii[i] + w->skin;
            if (b.square[i] > limit * limit)
                continue;
            uint32_t other = w->found[at + i];
            w->keys[kept++] = (uint64_t)w->bodies[other].rank << 32 | other;
        }
    }
    return kept;
}

static int compare_keys(const void *a, const void *b) {
    uint64_t p = *(const uint64_t *)a, q = *(const uint64_t *)b;
    return (p > q) - (p < q);
}

/* Rows are short: insertion beats the library's sort up to some tens of keys. */
static void sort_keys(uint64_t *keys, size_t n) {
    if (n > 64) {
        qsort(keys, n, sizeof *keys, compare_keys);
        return;
    }
    for (size_t i = 1; i < n; i++) {
        uint64_t key = keys[i];
        size_t j = i;
        for (; j > 0 && keys[j - 1] > key; j--)
            keys[j] = keys[j - 1];
        keys[j] = key;
    }
}

/* Appends the row of a slot; returns how many of its partners have a lower id. */
static uint32_t gather_row(gatherer *w, size_t slot) {
    size_t n = filter(w, slot, grid_search(w->g, slot, &w->found, &w->found_capacity));
    sort_keys(w->keys, n);
    w->entries = alloc_grow(w->entries, &w->entries_capacity, w->count + n, sizeof *w->entries);
    uint32_t lower = 0;
    for (size_t i = 0; i < n; i++) {
        w->entries[w->count++] = (uint32_t)w->keys[i];
        lower += w->keys[i] >> 32 < w->bodies[slot].rank;
    }
    return lower;
}

static void gather(gatherer *w, neighbor *list, size_t begin, size_t end) {
    for (size_t slot = begin; slot < end; slot++) {
        size_t before = w->count;
        list->middle[slot] = gather_row(w, slot);
        list->start[slot + 1] = w->count - before;
    }
}

static void free_gatherer(gatherer *w) {
    free(w->found);
    free(w->keys);
    free(w->entries);
}

/* Joins the threads' stretches; start holds the rows' lengths so far. */
static void join(neighbor *list, const gatherer *parts, int nparts) {
    list->start[0] = 0;
    for (size_t i = 0; i < list->n; i++)
        list->start[i + 1] += list->start[i];
    size_t total = list->start[list->n], at = 0;
    list->entries = alloc_grow(list->entries, &list->entries_capacity, total, sizeof *list->entries);
    for (int p = 0; p < nparts; p++) {
        if (parts[p].count)
            memcpy(list->entries + at, parts[p].entries, parts[p].count * sizeof *list->entries);
        at += parts[p].count;
    }
}

static void reserve(neighbor *list, size_t n) {
    if (n + 1 > list->n_capacity) {
        list->n_capacity = n + 1 + n / 2;
        list->start = alloc_resize(list->start, list->n_capacity, sizeof *list->start);
        list->middle = alloc_resize(list->middle, list->n_capacity, sizeof *list->middle);
        list->by_id = alloc_resize(list->by_id, list->n_capacity, sizeof *list->by_id);
    }
    list->n = n;
}

void neighbor_build(neighbor *list, const body *bodies, const capsule *capsules, size_t n, double reach, int threads,
                    const contact_kernel *kernel) {
    reserve(list, n);
    for (size_t i = 0; i < n; i++)
        list->by_id[bodies[i].rank] = (uint32_t)i;
    if (list->method == NEIGHBOR_PAIRS)
        return;
    grid g;
    grid_build(&g, capsules, n, reach, list->skin + slack);
    gatherer start = {.g = &g,
                      .bodies = bodies,
                      .capsules = capsules,
                      .kernel = kernel,
                      .law = {1, reach, 0},
                      .skin = list->skin + slack};
    gatherer *parts = alloc_zeroed((size_t)threads, sizeof *parts);
#pragma omp parallel for num_threads(threads) schedule(static, 1)
    for (int p = 0; p < threads; p++) {
        parts[p] = start;
        gather(&parts[p], list, n * (size_t)p / (size_t)threads, n * ((size_t)p + 1) / (size_t)threads);
    }
    join(list, parts, threads);
    for (int p = 0; p < threads; p++)
        free_gatherer(&parts[p]);
    free(parts);
    grid_free(&g);
}

/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "mechanics/neighbor.h"

#include "base/alloc.h"

#include <omp.h>
#include <stdlib.h>
#include <string.h>

/* Distances in lists are trusted to this, um: near-parallel axes are only known to about so much. */
static const double slack = 1e-6;

void neighbor_free(neighbor *list) {
    free(list->partners);
    free(list->start);
    free(list->middle);
    free(list->by_id);
    free(list->members);
    free(list->lower);
    free(list->lanes);
    free(list->group_start);
    grid_free(&list->grid);
    memset(list, 0, sizeof *list);
}

void neighbor_sort(neighbor *list, const void *capsules, size_t n, uint32_t *order) {
    list->n = n;
    grid_sort(&list->grid, capsules, list->flat, n);
    for (size_t i = 0; i < n; i++)
        order[i] = list->grid.places[i].index;
}

size_t neighbor_entries(const neighbor *list) {
    if (list->listed)
        return list->start[list->n];
    return list->n ? list->n * (list->n - 1) : 0;
}

/* The all-pairs method writes its rows when they are asked for. A body's own place in its row is left to nobody. */
static size_t write_pairs(const neighbor *list, const uint32_t *members, size_t begin, uint32_t *buffer,
                          kernel_rows *rows) {
    size_t length = list->n - begin < NEIGHBOR_BLOCK ? list->n - begin : NEIGHBOR_BLOCK;
    for (size_t j = 0; j < length; j++)
        for (size_t l = 0; l < KERNEL_LANES; l++) {
            uint32_t partner = list->by_id[begin + j];
            buffer[KERNEL_LANES * j + l] = capsule_place(partner == members[l] ? list->n + 1 : partner, list->flat);
        }
    rows->partners = buffer;
    rows->length = length;
    return begin + length < list->n ? begin + length : 0;
}

size_t neighbor_rows(const neighbor *list, size_t group, size_t begin, uint32_t *buffer, kernel_rows *rows) {
    rows->owners = list->members + KERNEL_LANES * group;
    rows->lower = list->lower + KERNEL_LANES * group;
    rows->begin = begin;
    if (!list->listed)
        return write_pairs(list, rows->owners, begin, buffer, rows);
    rows->partners = list->lanes + KERNEL_LANES * list->group_start[group];
    rows->length = list->group_start[group + 1] - list->group_start[group];
    return 0;
}

/* What one thread gathers: for a stretch of slots, the partners above each that are near enough. */
typedef struct gatherer {
    const neighbor *list;
    grid_search search; /* slots whose boxes meet */
    const body *bodies;
    const void *capsules;
    const contact_kernel *kernel;
    double reach, beyond;        /* pairs within reach (r_A + r_B) + beyond, um, and their leeways */
    uint32_t *owners, *partners; /* pairs, by owner */
    size_t owners_capacity, partners_capacity, count;
    size_t nbatch; /* candidates that wait in the batch */
    uint32_t batch_owner[KERNEL_BATCH], batch_partner[KERNEL_BATCH];
    kernel_batch batch;
} gatherer;

/* Keeps those of the batch whose segments are near enough. */
static void filter(gatherer *w) {
    w->kernel->apart[w->list->spheres][w->list->flat](w->nbatch, &w->batch);
    w->owners = alloc_grow(w->owners, &w->owners_capacity, w->count + w->nbatch, sizeof *w->owners);
    w->partners = alloc_grow(w->partners, &w->partners_capacity, w->count + w->nbatch, sizeof *w->partners);
    for (size_t i = 0; i < w->nbatch; i++) {
        const body *own = &w->bodies[w->batch_owner[i]], *other = &w->bodies[w->batch_partner[i]];
        double leeway = (double)own->leeway + (double)other->leeway;
        double limit = w->reach * (own->radius + other->radius) + w->beyond + leeway;
        w->owners[w->count] = w->batch_owner[i];
        w->partners[w->count] = w->batch_partner[i];
        w->count += w->batch.square[i] <= limit * limit;
    }
    w->nbatch = 0;
}

/* The candidate that comes next in the batch. */
DIMENSIONS_INLINE void load_candidate(gatherer *w, uint32_t slot, uint32_t partner, int dimensions) {
    if (w->nbatch == KERNEL_BATCH)
        filter(w);
    kernel_batch_axes(&w->batch, w->nbatch, w->capsules, slot, partner, dimensions);
    size_t i = w->nbatch++;
    w->batch_owner[i] = slot;
    w->batch_partner[i] = partner;
}

DIMENSIONS_INLINE void gather_in(gatherer *w, size_t begin, size_t end, int dimensions) {
    for (size_t slot = begin; slot < end; slot++) {
        size_t nfound = grid_find(&w->search, (uint32_t)slot);
        for (size_t i = 0; i < nfound; i++)
            if (!SARCINA_FLEXIBLE || !w->list->chained ||
                !body_is_joined(&w->bodies[slot], &w->bodies[w->search.found[i]], w->reach))
                load_candidate(w, (uint32_t)slot, w->search.found[i], dimensions);
    }
    filter(w);
}

static void gather(gatherer *w, size_t begin, size_t end) {
    if (w->list->flat)
        gather_in(w, begin, end, 2);
    else
        gather_in(w, begin, end, 3);
}

/* The same for all pairs, near or far: the oracle where some are joined. */
static void gather_all(gatherer *w, size_t n) {
    for (size_t slot = 0; slot < n; slot++) {
        w->owners = alloc_grow(w->owners, &w->owners_capacity, w->count + n, sizeof *w->owners);
        w->partners = alloc_grow(w->partners, &w->partners_capacity, w->count + n, sizeof *w->partners);
        for (size_t other = slot + 1; other < n; other++)
            if (!body_is_joined(&w->bodies[slot], &w->bodies[other], w->reach)) {
                w->owners[w->count] = (uint32_t)slot;
                w->partners[w->count++] = (uint32_t)other;
            }
    }
}

static void free_gatherer(gatherer *w) {
    grid_search_free(&w->search);
    free(w->owners);
    free(w->partners);
}

/* Where each body's row begins; start[n + 1] is the number of entries for now, and start[i + 1] the beginning of row i.
 */
static void count_entries(neighbor *list, const gatherer *parts, int nparts) {
    size_t n = list->n, *start = list->start;
    memset(start, 0, (n + 2) * sizeof *start);
    for (int p = 0; p < nparts; p++)
        for (size_t i = 0; i < parts[p].count; i++) {
            start[parts[p].owners[i] + 2]++;
            start[parts[p].partners[i] + 2]++;
        }
    for (size_t i = 0; i < n; i++)
        start[i + 2] += start[i + 1];
}

static void reserve_entries(uint32_t **entries, size_t *capacity, size_t wanted) {
    if (wanted <= *capacity)
        return;
    *capacity = wanted + wanted / 2;
    *entries = alloc_resize(*entries, *capacity, sizeof **entries);
}

/* Puts rows into the order of the partners' ids, without comparing any: bodies enter themselves into the rows of their
 * partners, one after another in that order. What a row holds when its own body's turn comes is of lower ids. */
static void order_rows(neighbor *list, const uint32_t *loose) {
    const size_t *start = list->start;
    uint32_t *filled = list->members; /* as free as the room of the loose rows */
    memset(filled, 0, list->n * sizeof *filled);
    for (size_t rank = 0; rank < list->n; rank++) {
        const uint32_t slot = list->by_id[rank];
        list->middle[slot] = filled[slot];
        for (size_t i = start[slot]; i < start[slot + 1]; i++) {
            const uint32_t partner = loose[i];
            list->partners[start[partner] + filled[partner]++] = slot;
        }
    }
}

/* Enters every pair into the rows of both its bodies. */
static void enter_pairs(neighbor *list, const gatherer *parts, int nparts) {
    count_entries(list, parts, nparts);
    size_t *start = list->start, entries = start[list->n + 1];
    reserve_entries(&list->partners, &list->entries_capacity, entries);
    reserve_entries(&list->lanes, &list->lanes_capacity, entries);
    uint32_t *loose = list->lanes; /* free until the rows are written beside each other */
    /* filling moves each start to where the next row begins */
    for (int p = 0; p < nparts; p++)
        for (size_t i = 0; i < parts[p].count; i++) {
            uint32_t a = parts[p].owners[i], b = parts[p].partners[i];
            loose[start[a + 1]++] = b;
            loose[start[b + 1]++] = a;
        }
    order_rows(list, loose);
}

/* Rows of more entries than this lie beside each other in any order. */
enum { LENGTH_MOST = 255 };

static size_t row_length(const neighbor *list, size_t slot) {
    return list->start[slot + 1] - list->start[slot];
}

/* The members of a window's groups: its bodies, those with the longest rows first. */
static void group_window(neighbor *list, size_t begin, size_t end) {
    uint32_t place[LENGTH_MOST + 2] = {0};
    size_t lengths[NEIGHBOR_WINDOW];
    for (size_t slot = begin; slot < end; slot++) {
        size_t length = row_length(list, slot);
        lengths[slot - begin] = LENGTH_MOST - (length < LENGTH_MOST ? length : LENGTH_MOST);
        place[lengths[slot - begin] + 1]++;
    }
    for (size_t i = 0; i < LENGTH_MOST; i++)
        place[i + 1] += place[i];
    for (size_t slot = begin; slot < end; slot++)
        list->members[begin + place[lengths[slot - begin]]++] = (uint32_t)slot;
}

/* How many of a body's partners have lower ids: of all bodies, where rows are of all pairs. */
static void note_lower(neighbor *list, const body *bodies) {
    for (size_t i = 0; i < KERNEL_LANES * neighbor_groups(list->n); i++) {
        const uint32_t slot = list->members[i];
        list->lower[i] = slot >= list->n ? 0 : list->listed ? list->middle[slot] : bodies[slot].rank;
    }
}

/* Which bodies share a group, and where its rows begin. */
static void group_rows(neighbor *list, const body *bodies) {
    size_t n = list->n, groups = neighbor_groups(n);
    for (size_t i = 0; i < KERNEL_LANES * groups; i++)
        list->members[i] = (uint32_t)(i < n ? i : n);
    list->group_start[0] = 0;
    for (size_t begin = 0; list->listed && begin < n; begin += NEIGHBOR_WINDOW)
        group_window(list, begin, begin + NEIGHBOR_WINDOW < n ? begin + NEIGHBOR_WINDOW : n);
    for (size_t g = 0; list->listed && g < groups; g++) {
        size_t longest = 0;
        for (size_t l = 0; l < KERNEL_LANES; l++) {
            uint32_t slot = list->members[KERNEL_LANES * g + l];
            size_t length = slot < n ? row_length(list, slot) : 0;
            longest = length > longest ? length : longest;
        }
        list->group_start[g + 1] = list->group_start[g] + longest;
    }
    reserve_entries(&list->lanes, &list->lanes_capacity, KERNEL_LANES * list->group_start[list->listed ? groups : 0]);
    note_lower(list, bodies);
}

/* Writes the rows of groups begin ... end - 1 beside each other. */
static void write_lanes(neighbor *list, size_t begin, size_t end) {
    for (size_t g = begin; g < end; g++) {
        uint32_t *lanes = list->lanes + KERNEL_LANES * list->group_start[g];
        size_t longest = list->group_start[g + 1] - list->group_start[g];
        for (size_t l = 0; l < KERNEL_LANES; l++) {
            uint32_t slot = list->members[KERNEL_LANES * g + l];
            size_t length = slot < list->n ? row_length(list, slot) : 0;
            for (size_t j = 0; j < longest; j++)
                lanes[KERNEL_LANES * j + l] =
                    capsule_place(j < length ? list->partners[list->start[slot] + j] : list->n + 1, list->flat);
        }
    }
}

static void reserve(neighbor *list) {
    if (list->n + 2 <= list->n_capacity)
        return;
    list->n_capacity = list->n + 2 + list->n / 2;
    list->start = alloc_resize(list->start, list->n_capacity, sizeof *list->start);
    list->middle = alloc_resize(list->middle, list->n_capacity, sizeof *list->middle);
    list->by_id = alloc_resize(list->by_id, list->n_capacity, sizeof *list->by_id);
    size_t groups = neighbor_groups(list->n_capacity);
    list->members = alloc_resize(list->members, KERNEL_LANES * groups, sizeof *list->members);
    list->lower = alloc_resize(list->lower, KERNEL_LANES * groups, sizeof *list->lower);
    list->group_start = alloc_resize(list->group_start, groups + 1, sizeof *list->group_start);
}

void neighbor_build(neighbor *list, const body *bodies, const void *capsules, double reach, int threads,
                    const contact_kernel *kernel) {
    reserve(list);
    for (size_t i = 0; i < list->n; i++)
        list->by_id[bodies[i].rank] = (uint32_t)i;
    list->listed = list->method == NEIGHBOR_CELLS || list->chained;
    if (!list->listed) {
        group_rows(list, bodies);
        return;
    }
    bool all = list->method == NEIGHBOR_PAIRS;
    const double beyond = list->margin + slack;
    threads = all ? 1 : threads;
    if (!all)
        grid_build(&list->grid, bodies, capsules, reach, beyond);
    gatherer *parts = alloc_aligned((size_t)threads, sizeof *parts, _Alignof(gatherer));
    memset(parts, 0, (size_t)threads * sizeof *parts);
#pragma omp parallel for num_threads(threads) schedule(static, 1)
    for (int p = 0; p < threads; p++) {
        gatherer *w = &parts[p];
        w->list = list;
        w->search.g = &list->grid;
        w->bodies = bodies;
        w->capsules = capsules;
        w->kernel = kernel;
        w->reach = reach;
        w->beyond = beyond;
        if (all)
            gather_all(w, list->n);
        else
            gather(w, list->n * (size_t)p / (size_t)threads, list->n * ((size_t)p + 1) / (size_t)threads);
    }
    enter_pairs(list, parts, threads);
    group_rows(list, bodies);
    size_t groups = neighbor_groups(list->n);
#pragma omp parallel for num_threads(threads) schedule(static, 1)
    for (int p = 0; p < threads; p++)
        write_lanes(list, groups * (size_t)p / (size_t)threads, groups * ((size_t)p + 1) / (size_t)threads);
    for (int p = 0; p < threads; p++)
        free_gatherer(&parts[p]);
    free(parts);
}

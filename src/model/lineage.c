/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "model/lineage.h"

#include "base/alloc.h"
#include "base/search.h"

#include <stdlib.h>
#include <string.h>

typedef struct pair {
    uint64_t id, parent;
} pair;

struct lineage {
    int references;
    pair *list; /* by id */
    size_t n;
};

lineage *lineage_create(void) {
    lineage *l = alloc_zeroed(1, sizeof *l);
    l->references = 1;
    return l;
}

lineage *lineage_keep(lineage *l) {
    l->references++;
    return l;
}

void lineage_free(lineage *l) {
    if (!l || --l->references > 0)
        return;
    free(l->list);
    free(l);
}

size_t lineage_count(const lineage *l) {
    return l->n;
}

const uint64_t *lineage_pairs(const lineage *l) {
    return (const void *)l->list;
}

lineage *lineage_of_pairs(const uint64_t *pairs, size_t n) {
    lineage *l = lineage_create();
    l->list = alloc_zeroed(n, sizeof *l->list);
    l->n = n;
    if (n)
        memcpy(l->list, pairs, n * sizeof *l->list);
    return l;
}

/* Both lists are in the order of ids; so is what becomes of them. */
void lineage_add(lineage **l, colony *c, const bool *doomed) {
    const lineage *old = *l;
    lineage *all = lineage_create();
    const uint32_t *order = colony_by_id(c);
    size_t dead = 0, at = 0;
    for (size_t i = 0; i < c->cell.count; i++)
        dead += doomed[i];
    all->list = alloc_zeroed(old->n + dead, sizeof *all->list);
    for (size_t i = 0; i < c->cell.count; i++) {
        uint32_t row = order[i];
        if (!doomed[row])
            continue;
        while (at < old->n && old->list[at].id < c->cell.id[row])
            all->list[all->n++] = old->list[at++];
        all->list[all->n++] = (pair){c->cell.id[row], c->cell.parent[row]};
    }
    while (at < old->n)
        all->list[all->n++] = old->list[at++];
    lineage_free(*l);
    *l = all;
}

/* A mother's id is below her daughters', so one pass over the living and the dead in the order of ids tells all. */
void lineage_mark(const lineage *l, colony *c, uint64_t id, bool *flags) {
    const uint32_t *order = colony_by_id(c);
    size_t total = l->n + c->cell.count, n = 0, dead = 0;
    uint64_t *ids = alloc_zeroed(total, sizeof *ids);
    bool *marked = alloc_zeroed(total, sizeof *marked);
    for (size_t i = 0; i <= c->cell.count; i++) {
        uint64_t next = i < c->cell.count ? c->cell.id[order[i]] : UINT64_MAX;
        for (; dead < l->n && l->list[dead].id < next; dead++) {
            size_t mother = search_id(ids, n, l->list[dead].parent);
            marked[n] = l->list[dead].id == id || (mother < n && marked[mother]);
            ids[n++] = l->list[dead].id;
        }
        if (i == c->cell.count)
            break;
        size_t mother = search_id(ids, n, c->cell.parent[order[i]]);
        marked[n] = next == id || (mother < n && marked[mother]);
        flags[order[i]] = marked[n];
        ids[n++] = next;
    }
    free(ids);
    free(marked);
}

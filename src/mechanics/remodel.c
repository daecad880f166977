/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "mechanics/remodel.h"

#include "base/alloc.h"
#include "mechanics/state.h"
#include "model/link.h"

#include <math.h>
#include <omp.h>
#include <stdlib.h>
#include <string.h>

/* Two cells that stick from now on, by id and row; that of lower id first. */
typedef struct stick_pair {
    uint64_t low, high;
    uint32_t low_row, high_row;
} stick_pair;

/* What one thread finds: candidates gather in the batch until it is full. */
typedef struct seeker {
    const mechanics *m;
    uint32_t *linked; /* (ncells) slot + 1 of the body whose cell this one is known to be linked to */
    stick_pair *found;
    size_t count, capacity;
    size_t nbatch;
    stick_pair candidates[KERNEL_BATCH];
    double limit[KERNEL_BATCH]; /* um */
    kernel_batch batch;
} seeker;

bool mechanics_remodels(const mechanics *m) {
    return m->rules && (m->sticks || m->anchors || m->breaks);
}

double mechanics_remodel_every(const mechanics *m) {
    return m->rules ? m->rules->every : 0;
}

/* Row of the cell that a particle belongs to. */
static uint32_t cell_of(const mechanics *m, uint32_t particle) {
    return m->bodies[m->owner[particle]].row;
}

static int species_of(const mechanics *m, uint32_t row) {
    return m->colony->cell.species[row];
}

/* Longest stretch of a link; infinite where none breaks it. */
static double break_length(const mechanics *m, size_t link) {
    const colony *c = m->colony;
    link_kind kind = (link_kind)c->link.kind[link];
    if (kind == LINK_SPRING)
        return INFINITY;
    uint32_t a = c->spring.a[c->link.first[link]], b = c->spring.b[c->link.first[link]];
    int species_a = species_of(m, cell_of(m, a));
    int species_b = b == SPRING_ANCHOR ? species_a : species_of(m, cell_of(m, b));
    const link_rule *rule = link_rules_find(m->rules, kind, species_a, species_b);
    return rule ? link_rules_break(kind, rule) : (double)INFINITY;
}

/* Marks the links that break; returns how many. */
static size_t find_broken(const mechanics *m, bool *broken) {
    const colony *c = m->colony;
    size_t count = 0;
#pragma omp parallel for num_threads(state_threads(m)) schedule(static) reduction(+ : count)
    for (size_t link = 0; link < c->link.count; link++) {
        double most = break_length(m, link);
        uint32_t first = c->link.first[link];
        broken[link] = false;
        for (uint32_t s = first; s < first + c->link.nsprings[link]; s++)
            broken[link] = broken[link] || colony_spring_length(c, s) > c->spring.rest[s] + most;
        count += broken[link];
    }
    return count;
}

/* Is a particle of the cell near enough to the substratum? */
static bool is_low(const mechanics *m, uint32_t row, double form) {
    const colony *c = m->colony;
    double limit = m->forces.term[FORCE_SUBSTRATUM].p[SUBSTRATUM_Z] + 0.5 * c->cell.diameter[row] + form;
    for (uint32_t i = c->cell.first[row]; i < c->cell.first[row] + c->cell.nparticles[row]; i++)
        if (c->particle.x[3 * (size_t)i + 2] < limit)
            return true;
    return false;
}

/* Cells to be anchored, in the order of ids: their rows into `rows` (ncells); returns how many. */
static size_t find_anchors(const mechanics *m, uint32_t *rows) {
    const colony *c = m->colony;
    const uint32_t *by_id = colony_by_id(m->colony);
    bool *anchored = alloc_zeroed(m->ncells, sizeof *anchored);
    for (size_t link = 0; link < c->link.count; link++)
        if (c->link.kind[link] == LINK_ANCHOR)
            anchored[cell_of(m, c->spring.a[c->link.first[link]])] = true;
    size_t count = 0;
    for (size_t i = 0; i < m->ncells; i++) {
        uint32_t row = by_id[i];
        const link_rule *rule =
            anchored[row] ? NULL : link_rules_find(m->rules, LINK_ANCHOR, species_of(m, row), species_of(m, row));
        if (rule && is_low(m, row, rule->p[ANCHOR_FORM]))
            rows[count++] = row;
    }
    free(anchored);
    return count;
}

/* Keeps those of the batch whose axes are near enough. */
static void sift(seeker *s) {
    s->m->kernel->apart[s->m->cocci][s->m->flat](s->nbatch, &s->batch);
    s->found = alloc_grow(s->found, &s->capacity, s->count + s->nbatch, sizeof *s->found);
    for (size_t i = 0; i < s->nbatch; i++) {
        s->found[s->count] = s->candidates[i];
        s->count += s->batch.square[i] < s->limit[i] * s->limit[i];
    }
    s->nbatch = 0;
}

/* The body of lower rank is A, so that the distance is the same to the bit whichever owns the row. */
static void consider(seeker *s, uint32_t slot, uint32_t partner, double form) {
    if (s->nbatch == KERNEL_BATCH)
        sift(s);
    const body *p = &s->m->bodies[slot], *q = &s->m->bodies[partner];
    size_t i = s->nbatch++;
    if (s->m->flat)
        kernel_batch_axes(&s->batch, i, s->m->capsules, slot, partner, 2);
    else
        kernel_batch_axes(&s->batch, i, s->m->capsules, slot, partner, 3);
    s->candidates[i] = (stick_pair){p->id, q->id, p->row, q->row};
    s->limit[i] = p->radius + q->radius + form;
}

/* Notes which cells the body's own is linked to. */
static void note_partners(seeker *s, uint32_t slot) {
    const mechanics *m = s->m;
    const cell_columns *cells = &m->colony->cell;
    uint32_t row = m->bodies[slot].row, first = cells->first[row];
    if (!m->forces.term[FORCE_SPRINGS].on)
        return;
    for (uint32_t e = m->springs.start[first]; e < m->springs.start[first + cells->nparticles[row]]; e++)
        if (m->springs.ends[e].other != SPRING_ANCHOR)
            s->linked[cell_of(m, m->springs.ends[e].other)] = slot + 1;
}

/* Pairs of bodies begin ... end - 1 with those above them; of cells that are not linked. */
static void seek(seeker *s, size_t begin, size_t end) {
    const mechanics *m = s->m;
    for (uint32_t slot = (uint32_t)begin; slot < end; slot++) {
        neighbor_row row = neighbor_get(&m->neighbor, m->bodies, slot);
        uint32_t own = m->bodies[slot].row;
        note_partners(s, slot);
        for (size_t i = 0; i < row.nupper; i++) {
            uint32_t other = m->bodies[row.upper[i]].row;
            if (other == own || s->linked[other] == slot + 1)
                continue;
            const link_rule *rule = link_rules_find(m->rules, LINK_STICK, species_of(m, own), species_of(m, other));
            if (rule)
                consider(s, slot, row.upper[i], rule->p[STICK_FORM]);
        }
    }
    sift(s);
}

static int compare_pairs(const void *a, const void *b) {
    const stick_pair *p = a, *q = b;
    if (p->low != q->low)
        return p->low < q->low ? -1 : 1;
    return (p->high > q->high) - (p->high < q->high);
}

/* Sorts pairs by ids, each once: chains may be near by several segments. Returns how many are left. */
static size_t sort_pairs(stick_pair *pairs, size_t count) {
    size_t kept = 0;
    qsort(pairs, count, sizeof *pairs, compare_pairs);
    for (size_t i = 0; i < count; i++)
        if (i == 0 || compare_pairs(&pairs[i], &pairs[kept - 1]) != 0)
            pairs[kept++] = pairs[i];
    return kept;
}

/* Pairs that stick, in the order of ids; the caller frees. *count: how many. */
static stick_pair *find_sticks(const mechanics *m, size_t *count) {
    int threads = state_threads(m);
    seeker *parts = alloc_aligned((size_t)threads, sizeof *parts, _Alignof(seeker));
    memset(parts, 0, (size_t)threads * sizeof *parts);
#pragma omp parallel for num_threads(threads) schedule(static, 1)
    for (int p = 0; p < threads; p++) {
        parts[p].m = m;
        parts[p].linked = alloc_zeroed(m->ncells, sizeof *parts[p].linked);
        seek(&parts[p], m->nbodies * (size_t)p / (size_t)threads, m->nbodies * ((size_t)p + 1) / (size_t)threads);
    }
    stick_pair *all = NULL;
    size_t capacity = 0, found = 0;
    for (int p = 0; p < threads; p++) {
        all = alloc_grow(all, &capacity, found + parts[p].count + 1, sizeof *all);
        if (parts[p].count)
            memcpy(all + found, parts[p].found, parts[p].count * sizeof *all);
        found += parts[p].count;
        free(parts[p].found);
        free(parts[p].linked);
    }
    free(parts);
    *count = sort_pairs(all, found);
    return all;
}

/* Mass of a cell's lightest particle. */
static double least_mass(const mechanics *m, uint32_t row) {
    return m->mass[m->colony->cell.first[row]];
}

static void form_anchors(mechanics *m, const uint32_t *rows, size_t count, remodel_change *change) {
    double floor = m->forces.term[FORCE_SUBSTRATUM].p[SUBSTRATUM_Z];
    for (size_t i = 0; i < count; i++) {
        const link_rule *rule = link_rules_find(m->rules, LINK_ANCHOR, species_of(m, rows[i]), species_of(m, rows[i]));
        link_add_anchor(m->colony, rule, rows[i], floor, m->time);
        change->stiffness = fmax(change->stiffness, rule->p[ANCHOR_K] / least_mass(m, rows[i]));
    }
    change->formed += count;
}

static void form_sticks(mechanics *m, const stick_pair *pairs, size_t count, remodel_change *change) {
    for (size_t i = 0; i < count; i++) {
        uint32_t a = pairs[i].low_row, b = pairs[i].high_row;
        const link_rule *rule = link_rules_find(m->rules, LINK_STICK, species_of(m, a), species_of(m, b));
        link_add_stick(m->colony, rule, a, b, m->time);
        double added = rule->p[STICK_K] * (1 / least_mass(m, a) + 1 / least_mass(m, b));
        change->stiffness = fmax(change->stiffness, added);
    }
    change->formed += count;
}

/* The springs' index follows; bodies and the neighbour list are as they were. */
static void bind_springs(mechanics *m) {
    m->forces.term[FORCE_SPRINGS].on = m->colony->spring.count > 0;
    if (m->forces.term[FORCE_SPRINGS].on)
        spring_index_build(&m->springs, m->colony, m->owner, m->bodies);
    m->breaks = m->colony->link.count > 0;
}

/* Makes the list hold at the colony's own x; false when that is not finite. */
static bool refresh(mechanics *m) {
    bool packed = state_pack(m), fresh = state_refresh_pairs(m, m->colony->particle.x);
    if (packed)
        state_unpack(m);
    return fresh;
}

bool mechanics_remodel_stick(mechanics *m, remodel_change *change) {
    *change = (remodel_change){0};
    if (!m->rules || !m->sticks || !refresh(m))
        return false;
    size_t count;
    stick_pair *pairs = find_sticks(m, &count);
    form_sticks(m, pairs, count, change);
    free(pairs);
    if (count)
        bind_springs(m);
    return count > 0;
}

static bool remodel(mechanics *m, remodel_change *change) {
    bool *broken = alloc_zeroed(m->colony->link.count, sizeof *broken);
    uint32_t *anchors = alloc_zeroed(m->ncells, sizeof *anchors);
    size_t nanchors = 0, nsticks = 0;
    stick_pair *sticks = NULL;
    change->broken = find_broken(m, broken);
    if (m->anchors)
        nanchors = find_anchors(m, anchors);
    if (m->sticks)
        sticks = find_sticks(m, &nsticks);

    if (change->broken)
        colony_drop_links(m->colony, broken);
    m->colony->links_broken += change->broken;
    form_anchors(m, anchors, nanchors, change);
    form_sticks(m, sticks, nsticks, change);
    if (change->broken || change->formed)
        bind_springs(m);
    free(broken);
    free(anchors);
    free(sticks);
    return change->broken || change->formed;
}

bool mechanics_remodel(mechanics *m, remodel_change *change) {
    *change = (remodel_change){0};
    if (m->sticks && !refresh(m))
        return false;
    bool packed = m->packed;
    state_unpack(m); /* links are the colony's */
    bool changed = remodel(m, change);
    if (packed)
        state_pack(m);
    return changed;
}

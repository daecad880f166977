/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "biology/handover.h"

#include "base/alloc.h"
#include "base/vec3.h"
#include "model/axis.h"
#include "model/link.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#define NO_ENTRY UINT32_MAX

/* Links by cell: a list a cell, in the order of link rows, which is that of their ids. */
typedef struct link_entry {
    uint32_t link, next;
} link_entry;

struct handover {
    const division_context *x;
    uint32_t *head, *tail; /* by cell row (ncells: twice those when the step began, newborns included) */
    size_t ncells;
    link_entry *entries;
    size_t count, capacity;
    bool *broken; /* by link row, as far as links have broken: to be dropped in the end */
    size_t nbroken, broken_end, broken_capacity;
};

static void note(handover *h, uint32_t row, uint32_t link) {
    h->entries = alloc_grow(h->entries, &h->capacity, h->count + 1, sizeof *h->entries);
    h->entries[h->count] = (link_entry){link, NO_ENTRY};
    if (h->head[row] == NO_ENTRY)
        h->head[row] = (uint32_t)h->count;
    else
        h->entries[h->tail[row]].next = (uint32_t)h->count;
    h->tail[row] = (uint32_t)h->count++;
}

handover *handover_begin(const division_context *x) {
    colony *c = x->colony;
    if (!x->links || (c->link.count == 0 && !link_rules_any(x->links, LINK_FILIAL)))
        return NULL;
    handover *h = alloc_zeroed(1, sizeof *h);
    h->x = x;
    h->ncells = 2 * c->cell.count;
    h->head = alloc_zeroed(h->ncells, sizeof *h->head);
    h->tail = alloc_zeroed(h->ncells, sizeof *h->tail);
    memset(h->head, 0xff, h->ncells * sizeof *h->head);
    for (uint32_t link = 0; link < c->link.count; link++) {
        note(h, colony_row(c, c->link.cell_a[link]), link);
        if (c->link.cell_b[link])
            note(h, colony_row(c, c->link.cell_b[link]), link);
    }
    return h;
}

/* Breaks a link: nothing is held by it from now on, and it goes when the step is over. */
static void part(handover *h, uint32_t link) {
    h->broken = alloc_grow(h->broken, &h->broken_capacity, (size_t)link + 1, sizeof *h->broken);
    while (h->broken_end <= link)
        h->broken[h->broken_end++] = false;
    h->broken[link] = true;
    h->nbroken++;
}

static bool is_broken(const handover *h, uint32_t link) {
    return link < h->broken_end && h->broken[link];
}

static void drop_broken(handover *h) {
    colony *c = h->x->colony;
    if (!h->nbroken)
        return;
    bool *drop = alloc_zeroed(c->link.count, sizeof *drop);
    memcpy(drop, h->broken, h->broken_end * sizeof *drop);
    colony_drop_links(c, drop);
    c->links_broken += h->nbroken;
    free(drop);
}

void handover_end(handover *h) {
    if (!h)
        return;
    drop_broken(h);
    free(h->broken);
    free(h->head);
    free(h->tail);
    free(h->entries);
    free(h);
}

/* The cell at the other end of a link. */
static uint32_t other_row(colony *c, uint32_t link, uint32_t row) {
    uint64_t a = c->link.cell_a[link];
    return colony_row(c, a == c->cell.id[row] ? c->link.cell_b[link] : a);
}

static bool is_held(const colony *c, uint32_t link, uint32_t row) {
    return c->link.cell_a[link] == c->cell.id[row] || c->link.cell_b[link] == c->cell.id[row];
}

/* Lets particle i of the daughter take the place of particle i of the mother in every spring of a link. */
static void give(colony *c, uint32_t link, uint32_t mother, uint32_t daughter) {
    bool is_a = c->link.cell_a[link] == c->cell.id[mother];
    uint32_t *particles = (is_a ? c->spring.a : c->spring.b) + c->link.first[link];
    (is_a ? c->link.cell_a : c->link.cell_b)[link] = c->cell.id[daughter];
    for (uint32_t i = 0; i < c->link.nsprings[link]; i++)
        particles[i] = particles[i] - c->cell.first[mother] + c->cell.first[daughter];
}

static bool is_nearer(const colony *c, uint32_t daughter, uint32_t mother, uint32_t other) {
    return axis_cell_distance(c, daughter, other) < axis_cell_distance(c, mother, other);
}

/* Of a rod the end says whose a filial link is, of a coccus the distance. */
static void hand_filial(handover *h, uint32_t link, uint32_t mother, uint32_t daughter) {
    colony *c = h->x->colony;
    bool goes = c->cell.nparticles[mother] > 1 ? link_find_end(c, link, mother) == LINK_LAST_END
                                               : is_nearer(c, daughter, mother, other_row(c, link, mother));
    if (!goes)
        return;
    give(c, link, mother, daughter);
    note(h, daughter, link);
}

static void hand_stick(const handover *h, uint32_t link, uint32_t mother, uint32_t daughter) {
    colony *c = h->x->colony;
    uint32_t other = other_row(c, link, mother);
    const link_rule *rule = link_find_rule(c, h->x->links, link);
    if (rule && rule->p[STICK_HANDOVER] == HANDOVER_MOTHER)
        return;
    link_attach_stick(c, link, is_nearer(c, daughter, mother, other) ? daughter : mother, other);
}

/* Anchors anew the particles of a cell but the one that has not moved. */
static void anchor_others(const handover *h, uint32_t link, uint32_t row, uint32_t unmoved) {
    for (uint32_t i = 0; i < h->x->colony->cell.nparticles[row]; i++)
        if (i != unmoved)
            link_attach_anchor(h->x->colony, link, i, row, h->x->substratum_z);
}

/* Which of the two each anchor point is nearer to: bit 0 the mother, bit 1 the daughter. */
static unsigned anchored_cells(const colony *c, uint32_t link, uint32_t mother, uint32_t daughter) {
    unsigned held = 0;
    for (uint32_t i = 0; i < c->link.nsprings[link]; i++) {
        const double *point = c->spring.anchor + 3 * (size_t)(c->link.first[link] + i);
        double to_mother = axis_cell_point_distance(c, mother, point);
        held |= axis_cell_point_distance(c, daughter, point) < to_mother ? 2 : 1;
    }
    return held;
}

static void hand_anchor(handover *h, uint32_t link, uint32_t mother, uint32_t daughter) {
    colony *c = h->x->colony;
    const link_rule *rule = link_find_rule(c, h->x->links, link);
    if (rule && rule->p[ANCHOR_HANDOVER] == HANDOVER_MOTHER)
        return;
    unsigned held = anchored_cells(c, link, mother, daughter);
    uint32_t n = c->cell.nparticles[mother], last = n - 1, kept = n > 1 ? 0 : n;
    if (held == 3 && rule) {
        uint32_t hers = link_add_anchor(c, rule, daughter, h->x->substratum_z, c->link.birth[link]);
        uint32_t from = c->link.first[link] + last, to = c->link.first[hers] + last;
        c->spring.rest[to] = c->spring.rest[from];
        memcpy(c->spring.anchor + 3 * (size_t)to, c->spring.anchor + 3 * (size_t)from, 3 * sizeof(double));
        note(h, daughter, hers);
        anchor_others(h, link, mother, kept);
    } else if (held == 2) {
        give(c, link, mother, daughter);
        anchor_others(h, link, daughter, n > 1 ? last : n);
    } else {
        anchor_others(h, link, mother, kept);
    }
}

/* The straight link at the mother's last end, where the daughter has been born, when she has one at her first end too;
 * NO_ENTRY. */
static uint32_t find_branching(const handover *h, uint32_t mother) {
    const colony *c = h->x->colony;
    uint32_t found = NO_ENTRY;
    bool at_first = false;
    for (uint32_t e = h->head[mother]; e != NO_ENTRY; e = h->entries[e].next) {
        uint32_t link = h->entries[e].link;
        if (c->link.kind[link] != LINK_FILIAL || !is_held(c, link, mother))
            continue;
        bool first = link_find_end(c, link, mother) == LINK_FIRST_END;
        at_first = at_first || first;
        if (!first && c->link.style[link] == LINK_STRAIGHT && found == NO_ENTRY)
            found = link;
    }
    return at_first ? found : NO_ENTRY;
}

/* The link beside which the daughter begins a branch; NO_ENTRY: she is inserted. */
static uint32_t draw_branch(const handover *h, uint32_t mother, uint32_t daughter) {
    const colony *c = h->x->colony;
    double probability = division_branch(&h->x->species->list[c->cell.species[mother]]);
    if (!(probability > 0) || c->cell.nparticles[mother] == 1)
        return NO_ENTRY;
    uint32_t link = find_branching(h, mother);
    if (link == NO_ENTRY)
        return NO_ENTRY;
    gsl_rng *stream = rng_stream(h->x->rng, RNG_BRANCH, c->cell.id[daughter], 0);
    return gsl_rng_uniform(stream) < probability ? link : NO_ENTRY;
}

static void join(handover *h, const link_rule *rule, link_joint joint, uint32_t row_a, link_end end_a, uint32_t row_b,
                 link_end end_b) {
    uint32_t link = link_add_filial(h->x->colony, rule, joint, row_a, end_a, row_b, end_b, h->x->time);
    note(h, row_a, link);
    note(h, row_b, link);
}

static void begin_branch(handover *h, const link_rule *rule, uint32_t beside, uint32_t mother, uint32_t daughter) {
    colony *c = h->x->colony;
    uint32_t neighbour = other_row(c, beside, mother);
    link_end facing = link_find_end(c, beside, neighbour);
    join(h, rule, LINK_BRANCHED, daughter, LINK_FIRST_END, mother, LINK_LAST_END);
    join(h, rule, LINK_BRANCHED, daughter, LINK_FIRST_END, neighbour, facing);
}

static double distance_between(const colony *c, uint32_t row, uint32_t other) {
    double a[3], b[3];
    colony_centre(c, row, a);
    colony_centre(c, other, b);
    return vec3_norm(vec3_sub(vec3_load(a), vec3_load(b)));
}

/* Joins one of the halves to a cell; where the two stick, that link gives way. What it holds was the mother's. */
static void share_wall(handover *h, const link_rule *rule, uint32_t mother, uint32_t half, uint32_t other) {
    const colony *c = h->x->colony;
    for (uint32_t e = h->head[mother]; e != NO_ENTRY; e = h->entries[e].next) {
        uint32_t link = h->entries[e].link;
        if (c->link.kind[link] == LINK_STICK && is_held(c, link, half) && is_held(c, link, other))
            part(h, link);
    }
    join(h, rule, LINK_STRAIGHT, half, LINK_FIRST_END, other, LINK_LAST_END);
}

static bool has_row(const uint32_t *rows, size_t n, uint32_t row) {
    for (size_t i = 0; i < n; i++)
        if (rows[i] == row)
            return true;
    return false;
}

/* The neighbour's neighbour that is nearest to a half whose sister has kept the neighbour, and nearer than that one;
 * NO_ENTRY. */
static uint32_t find_wall(const handover *h, uint32_t half, uint32_t neighbour) {
    const colony *c = h->x->colony;
    uint32_t own[HANDOVER_NEIGHBOURS], beyond[HANDOVER_NEIGHBOURS], nearest = NO_ENTRY;
    size_t nown = handover_neighbours(h, half, own), n = handover_neighbours(h, neighbour, beyond);
    double least = distance_between(c, half, neighbour);
    for (size_t i = 0; i < n; i++) {
        double distance = distance_between(c, half, beyond[i]);
        bool free = beyond[i] != half && c->cell.nparticles[beyond[i]] == 1 && !has_row(own, nown, beyond[i]);
        if (free && distance < least) {
            nearest = beyond[i];
            least = distance;
        }
    }
    return nearest;
}

/* For each of the mother's neighbours as they were: the half that has not kept it looks for a wall of its own. */
static void share_walls(handover *h, const link_rule *rule, uint32_t mother, uint32_t daughter,
                        const uint32_t *neighbours, size_t n) {
    for (size_t i = 0; i < n; i++) {
        uint32_t half = is_nearer(h->x->colony, daughter, mother, neighbours[i]) ? mother : daughter;
        uint32_t other = find_wall(h, half, neighbours[i]);
        if (other != NO_ENTRY)
            share_wall(h, rule, mother, half, other);
    }
}

size_t handover_neighbours(const handover *h, uint32_t row, uint32_t neighbours[HANDOVER_NEIGHBOURS]) {
    size_t n = 0;
    for (uint32_t e = h ? h->head[row] : NO_ENTRY; e != NO_ENTRY; e = h->entries[e].next) {
        uint32_t link = h->entries[e].link;
        const colony *c = h->x->colony;
        if (n < HANDOVER_NEIGHBOURS && c->link.kind[link] == LINK_FILIAL && is_held(c, link, row) &&
            !is_broken(h, link))
            neighbours[n++] = other_row(h->x->colony, link, row);
    }
    return n;
}

void handover_divide(handover *h, uint32_t mother, uint32_t daughter) {
    if (!h)
        return;
    colony *c = h->x->colony;
    int row = c->cell.species[mother];
    const link_rule *rule = link_rules_find(h->x->links, LINK_FILIAL, row, row);
    uint32_t beside = rule ? draw_branch(h, mother, daughter) : NO_ENTRY, neighbours[HANDOVER_NEIGHBOURS];
    bool walls = rule && division_walls(&h->x->species->list[row]) && !division_pairs(&h->x->species->list[row]);
    size_t nneighbours = walls ? handover_neighbours(h, mother, neighbours) : 0;
    for (uint32_t e = h->head[mother]; e != NO_ENTRY; e = h->entries[e].next) {
        uint32_t link = h->entries[e].link;
        if (!is_held(c, link, mother) || is_broken(h, link))
            continue;
        if (c->link.kind[link] == LINK_FILIAL && division_pairs(&h->x->species->list[row]))
            part(h, link);
        else if (c->link.kind[link] == LINK_FILIAL && beside == NO_ENTRY)
            hand_filial(h, link, mother, daughter);
        else if (c->link.kind[link] == LINK_STICK)
            hand_stick(h, link, mother, daughter);
        else if (c->link.kind[link] == LINK_ANCHOR)
            hand_anchor(h, link, mother, daughter);
    }
    if (beside != NO_ENTRY)
        begin_branch(h, rule, beside, mother, daughter);
    else if (rule)
        join(h, rule, LINK_STRAIGHT, daughter, LINK_FIRST_END, mother, LINK_LAST_END);
    if (nneighbours)
        share_walls(h, rule, mother, daughter, neighbours, nneighbours);
}

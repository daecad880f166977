/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Filial, straight:  L_short = l_short D,  L_long = l_long D + L_A + L_B, k/2 each; D mean of the two diameters
 *   branched:        L_short = l D,  L_long = l sqrt((L_A + L_short/2)^2 + (L_B + sqrt(3/4) L_short)^2), k/4 each,
 *                    l = (l_short + l_long)/2, A the first cell of the branch
 *   coccus-coccus:   L = ratio (r_A + r_B), k
 * Sticking:          L = max(length when formed, r_A + r_B), k/N each
 * Anchoring:         L = max(height when formed, 1.01 r), k/N each
 *
 * The long spring of a filial link ends one particle behind the short one: at the far end of a rod, at the next
 * particle of a chain, L_A then being the rest length of that segment; at the particle itself of a coccus (L_A = 0). */
#include "model/link.h"

#include "base/alloc.h"
#include "model/axis.h"

#include <math.h>
#include <stdlib.h>

static const double least_height = 1.01; /* of an anchor's rest length, in radii */

static uint32_t end_particle(const colony *c, uint32_t row, link_end end) {
    uint32_t first = c->cell.first[row];
    return end == LINK_FIRST_END ? first : first + c->cell.nparticles[row] - 1;
}

/* The particle behind an end. */
static uint32_t inner_particle(const colony *c, uint32_t row, link_end end) {
    uint32_t particle = end_particle(c, row, end);
    if (c->cell.nparticles[row] == 1)
        return particle;
    return end == LINK_FIRST_END ? particle + 1 : particle - 1;
}

static double segment_rest(const colony *c, uint32_t row) {
    uint32_t n = c->cell.nparticles[row];
    return n > 1 ? c->cell.rest[row] / (n - 1) : 0;
}

static void set_filial_rests(colony *c, uint32_t link, const link_rule *rule, uint32_t row_a, uint32_t row_b) {
    double *rest = c->spring.rest + c->link.first[link];
    double mean = 0.5 * (c->cell.diameter[row_a] + c->cell.diameter[row_b]);
    if (c->link.nsprings[link] == 1) {
        rest[0] = rule->p[FILIAL_RATIO] * mean;
        return;
    }
    double a = segment_rest(c, row_a), b = segment_rest(c, row_b);
    if (c->link.style[link] == LINK_STRAIGHT) {
        rest[0] = rule->p[FILIAL_SHORT] * mean;
        rest[1] = rule->p[FILIAL_LONG] * mean + a + b;
        return;
    }
    double l = 0.5 * (rule->p[FILIAL_SHORT] + rule->p[FILIAL_LONG]);
    double along = a + 0.5 * l * mean, across = b + sqrt(0.75) * l * mean;
    rest[0] = l * mean;
    rest[1] = l * sqrt(along * along + across * across);
}

static void share_stiffness(colony *c, uint32_t link, double k) {
    uint32_t n = c->link.nsprings[link];
    /* the two links of a branch have four springs together */
    double each = k / (c->link.style[link] == LINK_BRANCHED ? 2 * n : n);
    for (uint32_t i = 0; i < n; i++)
        c->spring.k[c->link.first[link] + i] = each;
}

static uint32_t add(colony *c, link_kind kind, uint64_t id_a, uint64_t id_b, uint32_t springs, link_joint joint,
                    double k, double time) {
    uint32_t link = colony_add_link(c, kind, id_a, id_b, springs);
    c->link.style[link] = joint;
    c->link.birth[link] = time;
    share_stiffness(c, link, k);
    c->links_formed++;
    return link;
}

uint32_t link_add_filial(colony *c, const link_rule *rule, link_joint joint, uint32_t row_a, link_end end_a,
                         uint32_t row_b, link_end end_b, double time) {
    bool cocci = c->cell.nparticles[row_a] == 1 && c->cell.nparticles[row_b] == 1;
    uint32_t link =
        add(c, LINK_FILIAL, c->cell.id[row_a], c->cell.id[row_b], cocci ? 1 : 2, joint, rule->p[FILIAL_K], time);
    uint32_t spring = c->link.first[link];
    c->spring.a[spring] = end_particle(c, row_a, end_a);
    c->spring.b[spring] = end_particle(c, row_b, end_b);
    if (!cocci) {
        c->spring.a[spring + 1] = inner_particle(c, row_a, end_a);
        c->spring.b[spring + 1] = inner_particle(c, row_b, end_b);
    }
    set_filial_rests(c, link, rule, row_a, row_b);
    return link;
}

/* The particles of a cell that a sticking link holds: those of its nearest segment. */
static uint32_t sticking_particles(const colony *c, uint32_t row) {
    return c->cell.nparticles[row] == 1 ? 1 : 2;
}

void link_attach_stick(colony *c, uint32_t link, uint32_t row_a, uint32_t row_b) {
    uint32_t segment_a = 0, segment_b = 0, spring = c->link.first[link];
    if (c->cell.nparticles[row_a] > 2 || c->cell.nparticles[row_b] > 2)
        axis_cell_nearest(c, row_a, row_b, &segment_a, &segment_b);
    double touching = 0.5 * (c->cell.diameter[row_a] + c->cell.diameter[row_b]);
    c->link.cell_a[link] = c->cell.id[row_a];
    c->link.cell_b[link] = c->cell.id[row_b];
    for (uint32_t i = 0; i < sticking_particles(c, row_a); i++)
        for (uint32_t j = 0; j < sticking_particles(c, row_b); j++, spring++) {
            c->spring.a[spring] = c->cell.first[row_a] + segment_a + i;
            c->spring.b[spring] = c->cell.first[row_b] + segment_b + j;
            c->spring.rest[spring] = fmax(colony_spring_length(c, spring), touching);
        }
}

uint32_t link_add_stick(colony *c, const link_rule *rule, uint32_t row_a, uint32_t row_b, double time) {
    uint32_t springs = sticking_particles(c, row_a) * sticking_particles(c, row_b);
    uint32_t link =
        add(c, LINK_STICK, c->cell.id[row_a], c->cell.id[row_b], springs, LINK_STRAIGHT, rule->p[STICK_K], time);
    link_attach_stick(c, link, row_a, row_b);
    return link;
}

void link_attach_anchor(colony *c, uint32_t link, uint32_t i, uint32_t row, double floor) {
    uint32_t spring = c->link.first[link] + i, particle = c->cell.first[row] + i;
    const double *x = c->particle.x + 3 * (size_t)particle;
    double *anchor = c->spring.anchor + 3 * (size_t)spring;
    c->spring.a[spring] = particle;
    c->spring.b[spring] = SPRING_ANCHOR;
    anchor[0] = x[0];
    anchor[1] = x[1];
    anchor[2] = floor;
    c->spring.rest[spring] = fmax(x[2] - floor, least_height * 0.5 * c->cell.diameter[row]);
}

uint32_t link_add_anchor(colony *c, const link_rule *rule, uint32_t row, double floor, double time) {
    uint32_t n = c->cell.nparticles[row];
    uint32_t link = add(c, LINK_ANCHOR, c->cell.id[row], 0, n, LINK_STRAIGHT, rule->p[ANCHOR_K], time);
    for (uint32_t i = 0; i < n; i++) {
        link_attach_anchor(c, link, i, row, floor);
        c->spring.glides[c->link.first[link] + i] = rule->p[ANCHOR_GLIDE] != 0;
    }
    return link;
}

link_end link_find_end(const colony *c, uint32_t link, uint32_t row) {
    uint32_t spring = c->link.first[link];
    uint32_t particle = c->link.cell_a[link] == c->cell.id[row] ? c->spring.a[spring] : c->spring.b[spring];
    return particle == end_particle(c, row, LINK_FIRST_END) ? LINK_FIRST_END : LINK_LAST_END;
}

static const link_rule *rule_between(const colony *c, const link_rules *rules, uint32_t link, uint32_t row_a,
                                     uint32_t row_b) {
    link_kind kind = (link_kind)c->link.kind[link];
    if (kind == LINK_SPRING || row_a == COLONY_NO_ROW || row_b == COLONY_NO_ROW)
        return NULL;
    return link_rules_find(rules, kind, c->cell.species[row_a], c->cell.species[row_b]);
}

static void find_rows(colony *c, uint32_t link, uint32_t *row_a, uint32_t *row_b) {
    *row_a = colony_row(c, c->link.cell_a[link]);
    *row_b = c->link.cell_b[link] ? colony_row(c, c->link.cell_b[link]) : *row_a;
}

const link_rule *link_find_rule(colony *c, const link_rules *rules, uint32_t link) {
    uint32_t row_a, row_b;
    find_rows(c, link, &row_a, &row_b);
    return rule_between(c, rules, link, row_a, row_b);
}

void link_renew(colony *c, const link_rules *rules) {
    for (uint32_t link = 0; link < c->link.count; link++) {
        uint32_t row_a, row_b;
        find_rows(c, link, &row_a, &row_b);
        const link_rule *rule = rule_between(c, rules, link, row_a, row_b);
        if (!rule)
            continue;
        share_stiffness(c, link, rule->p[0]); /* every kind's first parameter is k */
        if (c->link.kind[link] == LINK_FILIAL)
            set_filial_rests(c, link, rule, row_a, row_b);
        for (uint32_t i = 0; c->link.kind[link] == LINK_ANCHOR && i < c->link.nsprings[link]; i++)
            c->spring.glides[c->link.first[link] + i] = rule->p[ANCHOR_GLIDE] != 0;
    }
    c->version++;
}

size_t link_drop_unruled(colony *c, const link_rules *rules, link_kind kind) {
    bool *drop = alloc_zeroed(c->link.count, sizeof *drop);
    size_t dropped = 0;
    for (uint32_t link = 0; link < c->link.count; link++)
        if (c->link.kind[link] == (int32_t)kind && !link_find_rule(c, rules, link)) {
            drop[link] = true;
            dropped++;
        }
    if (dropped)
        colony_drop_links(c, drop);
    free(drop);
    return dropped;
}

/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The graph of links stays whole under 100,000 random divisions, deletions, sortings, breakings and remodellings; and
 * the checker that says so finds every kind of fault. */
#include "check.h"

#include "base/alloc.h"
#include "engine/scene.h"
#include "mechanics/remodel.h"
#include "model/link.h"
#include "model/link_check.h"
#include "model/shape.h"

#include "biology/division.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

enum { ROD, COCCUS, PACKET, SPECIES, MOST_CELLS = 30 };

typedef struct world {
    scene *s;
    uint64_t random;
} world;

static double draw(world *w, double lo, double hi) {
    uint64_t z = w->random += 0x9e3779b97f4a7c15u;
    z = (z ^ z >> 30) * 0xbf58476d1ce4e5b9u;
    z = (z ^ z >> 27) * 0x94d049bb133111ebu;
    z ^= z >> 31;
    return lo + (hi - lo) * ((double)(z >> 11) * 0x1p-53);
}

static void add_species(scene *s, const char *name, shape_kind shape, int rule, double mass, double own) {
    int row = species_add(&s->species, name);
    species *sp = &s->species.list[row];
    sp->shape = shape;
    sp->density = 1.01;
    sp->internal_k = shape == SHAPE_ROD ? 5e4 : 0;
    sp->diameter = spread_fixed(shape == SHAPE_ROD ? 0.7 : 0);
    sp->growth.style = 0;
    sp->growth.values[0] = (spread){SPREAD_NORMAL, 1e-3, 3e-4};
    sp->growth.values[1] = spread_fixed(0);
    sp->division.style = rule;
    sp->division.values[DIVISION_MASS] = (spread){SPREAD_NORMAL, mass, 0.1 * mass};
    sp->division.values[DIVISION_SIZE] = spread_fixed(NAN);
    sp->division.values[DIVISION_JITTER] = spread_fixed(0.01);
    sp->division.values[DIVISION_AXIS] = spread_fixed(AXIS_AUTO);
    sp->division.values[DIVISION_OWN] = spread_fixed(own);
}

static void set_rule(scene *s, link_kind kind, int a, int b, const double *p) {
    link_rule rule = {.on = true};
    memcpy(rule.p, p, sizeof rule.p);
    link_rules_set(&s->links, kind, a, b, &rule);
}

/* Every kind of link, both ways to hand them on, branches; two species of cocci and one of rods above a plane. */
static world make(void) {
    world w = {scene_create(), 5};
    scene *s = w.s;
    add_species(s, "rod", SHAPE_ROD, 0, shape_rod_mass(2, 0.7, 1.01), 0.5);
    add_species(s, "coccus", SHAPE_COCCUS, 1, 0.6, 100);
    add_species(s, "packet", SHAPE_COCCUS, 2, 0.6, 3);
    for (int a = 0; a < SPECIES; a++) {
        set_rule(s, LINK_FILIAL, a, a, (double[]){2e4, 1, 0.5, 1.7, 1.1});
        set_rule(s, LINK_ANCHOR, a, a, (double[]){1e4, 0.5, 0.5, a == COCCUS, a != ROD});
        for (int b = 0; b <= a; b++)
            set_rule(s, LINK_STICK, a, b, (double[]){1e4, 0.3, 0.5, b == PACKET, 0});
    }
    s->forces.term[FORCE_SUBSTRATUM] = (force_settings){true, {0, 1e5}};
    s->forces.term[FORCE_COLLISION] = (force_settings){true, {1e5, 1.01, 0, 0.01}};
    s->forces.term[FORCE_DAMPING] = (force_settings){true, {100}};
    return w;
}

static void found(world *w) {
    const placement place = {.species = (int)draw(w, 0, SPECIES),
                             .orient = ORIENT_RANDOM,
                             .mass = spread_fixed(0.5),
                             .gap = draw(w, 0, 1),
                             .overlap = true,
                             .maxtry = 1,
                             .filament = (int)draw(w, 1, 5)};
    size_t created;
    double at[3] = {draw(w, -3, 3), draw(w, -3, 3), 0};
    assert_int_equal(scene_create_single(w->s, &place, at, &created, NULL), SARCINA_OK);
}

/* Some cells go; more of them where there are many. */
static void delete_some(world *w) {
    size_t n = w->s->colony->cell.count;
    double part = n > MOST_CELLS ? 0.6 : 0.05;
    bool *doomed = alloc_zeroed(n, sizeof *doomed);
    for (size_t i = 0; i < n; i++)
        doomed[i] = draw(w, 0, 1) < part;
    scene_delete(w->s, doomed);
    free(doomed);
}

static void shuffle(world *w) {
    uint32_t n = (uint32_t)w->s->colony->cell.count, *rows = alloc_zeroed(n, sizeof *rows);
    for (uint32_t i = 0; i < n; i++)
        rows[i] = i;
    for (uint32_t i = n; i > 1; i--) {
        uint32_t j = (uint32_t)draw(w, 0, i), swap = rows[i - 1];
        rows[i - 1] = rows[j];
        rows[j] = swap;
    }
    colony_arrange(w->s->colony, rows, n);
    free(rows);
}

static void tear(world *w) {
    colony *c = w->s->colony;
    bool *drop = alloc_zeroed(c->link.count, sizeof *drop);
    for (size_t i = 0; i < c->link.count; i++)
        drop[i] = draw(w, 0, 1) < 0.1;
    colony_drop_links(c, drop);
    free(drop);
}

static void move_and_remodel(world *w) {
    colony *c = w->s->colony;
    remodel_change change;
    for (size_t i = 0; i < 3 * c->particle.count; i++)
        c->particle.x[i] += draw(w, -0.3, 0.3);
    assert_int_equal(scene_prepare(w->s, NULL), SARCINA_OK);
    mechanics_remodel(w->s->mechanics, &change);
}

static void grow(world *w) {
    assert_int_equal(scene_grow(w->s, draw(w, 100, 500), NULL), SARCINA_OK);
}

static void test_random_events(void **state) {
    (void)state;
    static void (*const events[])(world *) = {grow, delete_some, shuffle, tear, move_and_remodel};
    enum { KINDS = sizeof events / sizeof *events };
    world w = make();
    colony *c = w.s->colony;
    uint64_t seen[LINK_STYLES] = {0}, branched = 0;
    for (int i = 0; i < 100000; i++) {
        while (c->cell.count < 6)
            found(&w);
        events[c->cell.count > MOST_CELLS ? 1 : (int)draw(&w, 0, KINDS)](&w);
        link_fault fault = link_check(c);
        if (fault.what)
            fail_msg("event %d, link %llu: %s", i, (unsigned long long)fault.link, fault.what);
        for (size_t l = 0; l < c->link.count; l++) {
            seen[c->link.kind[l]]++;
            branched += c->link.style[l] == LINK_BRANCHED;
        }
    }
    printf("seen: %llu filial (%llu branched), %llu sticking, %llu anchoring; %llu cells born, %llu links broken\n",
           (unsigned long long)seen[LINK_FILIAL], (unsigned long long)branched, (unsigned long long)seen[LINK_STICK],
           (unsigned long long)seen[LINK_ANCHOR], (unsigned long long)c->next_cell_id - 1,
           (unsigned long long)c->links_broken);
    /* nothing of this was idle */
    for (int kind = 0; kind < LINK_STYLES; kind++)
        assert_true(seen[kind] > 100000);
    assert_true(branched > 1000 && c->next_cell_id > 50000 && c->links_broken > 10000);
    scene_free(w.s);
}

/* Four rods: two linked filially, two stuck, one anchored. */
static colony *make_whole(void) {
    const link_rule rule = {true, {1e4, 1, 1, 1, 1}};
    colony *c = colony_create();
    for (int i = 0; i < 4; i++) {
        uint32_t row = colony_add_cell(c, 2, (double[]){0, i, 1, 2, i, 1});
        c->cell.diameter[row] = 0.7;
        c->cell.rest[row] = 2;
    }
    link_add_filial(c, &rule, LINK_STRAIGHT, 0, LINK_FIRST_END, 1, LINK_LAST_END, 0);
    link_add_stick(c, &rule, 1, 2, 0);
    link_add_anchor(c, &rule, 3, 0, 0);
    return c;
}

static void break_id(colony *c) {
    c->link.id[1] = c->link.id[0];
}
static void break_next(colony *c) {
    c->next_link_id = c->link.id[2];
}
static void break_cell(colony *c) {
    c->link.cell_b[1] = 99;
}
static void break_self(colony *c) {
    c->link.cell_b[1] = c->link.cell_a[1];
}
static void break_substratum(colony *c) {
    c->link.cell_b[1] = 0;
}
static void break_first(colony *c) {
    c->link.first[1]++;
}
static void break_count(colony *c) {
    c->link.nsprings[1]--;
}
static void break_particle_a(colony *c) {
    c->spring.a[c->link.first[1]] = 0;
}
static void break_particle_b(colony *c) {
    c->spring.b[c->link.first[1]] = 0;
}
static void break_anchor(colony *c) {
    c->spring.b[c->link.first[2]] = 0;
}
static void break_k(colony *c) {
    c->spring.k[2] = 0;
}
static void break_rest(colony *c) {
    c->spring.rest[2] = NAN;
}
static void break_rows(colony *c) {
    colony_resize(c, c->particle.count, c->cell.count, c->link.count, c->spring.count + 1);
}
/* a pair linked filially that sticks, too */
static void break_pair(colony *c) {
    const link_rule rule = {true, {1e4, 1, 1, 1, 1}};
    link_add_stick(c, &rule, 1, 0, 0);
}
static void break_anchors(colony *c) {
    const link_rule rule = {true, {1e4, 1, 1, 1, 1}};
    link_add_anchor(c, &rule, 3, 0, 0);
}

static void test_faults(void **state) {
    (void)state;
    static void (*const faults[])(colony *) = {
        break_id,    break_next,  break_cell,       break_self,       break_substratum,
        break_first, break_count, break_particle_a, break_particle_b, break_anchor,
        break_k,     break_rest,  break_rows,       break_pair,       break_anchors,
    };
    colony *whole = make_whole();
    assert_null(link_check(whole).what);
    colony_free(whole);
    for (size_t i = 0; i < sizeof faults / sizeof *faults; i++) {
        colony *c = make_whole();
        faults[i](c);
        if (!link_check(c).what)
            fail_msg("fault %zu is not found", i);
        colony_free(c);
    }
}

int main(void) {
    const struct CMUnitTest tests[] = {cmocka_unit_test(test_random_events), cmocka_unit_test(test_faults)};
    return cmocka_run_group_tests_name("link_check", tests, NULL, NULL);
}

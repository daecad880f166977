/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Scenes for tests of the mechanics: rods and cocci at given or random places, with the forces of Storck et al. 2014 at
 * their Table 1 values. Units: um, pg, s. */
#ifndef SARCINA_TESTS_PACKING_H
#define SARCINA_TESTS_PACKING_H

#include "mechanics/force_style.h"
#include "mechanics/mechanics.h"
#include "model/shape.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

enum { PACKING_COCCUS, PACKING_ROD, PACKING_FLEXIBLE };

typedef struct packing {
    colony *c;
    species_table species;
    force_set forces; /* every term has its values; the test turns on what it wants */
    link_rules links; /* none: links stay as they are */
    uint64_t random;  /* state of the generator */
} packing;

/* Uniform in [lo, hi): SplitMix64, enough for places. */
static inline double packing_draw(packing *p, double lo, double hi) {
    uint64_t z = p->random += 0x9e3779b97f4a7c15u;
    z = (z ^ z >> 30) * 0xbf58476d1ce4e5b9u;
    z = (z ^ z >> 27) * 0x94d049bb133111ebu;
    z ^= z >> 31;
    return lo + (hi - lo) * ((double)(z >> 11) * 0x1p-53);
}

static inline packing packing_create(uint64_t seed) {
    packing p = {.c = colony_create(), .random = seed};
    link_rules_clear(&p.links);
    species_add(&p.species, "coccus");
    species_add(&p.species, "rod");
    species_add(&p.species, "flexible");
    for (size_t i = 0; i < p.species.count; i++)
        p.species.list[i].density = 1.01;
    p.species.list[PACKING_ROD].shape = SHAPE_ROD;
    p.species.list[PACKING_ROD].internal_k = 5e4;
    species *flexible = &p.species.list[PACKING_FLEXIBLE];
    flexible->shape = SHAPE_FLEXIBLE;
    flexible->particles = 7;
    flexible->internal_k = 5e4;
    flexible->bend_k = 2e4;
    flexible->twist_k = 1e4;
    flexible->coil = (chain_coil){0.4, 2, false};
    force_settings *t = p.forces.term;
    memcpy(t[FORCE_COLLISION].p, (double[]){1e5, 1.01, CONTACT_REGULARISED, 0.01}, 4 * sizeof(double));
    memcpy(t[FORCE_SUBSTRATUM].p, (double[]){0, 1e5}, 2 * sizeof(double));
    memcpy(t[FORCE_DLVO].p, (double[]){1e5, 100, 50, 6}, 4 * sizeof(double));
    memcpy(t[FORCE_DAMPING].p, (double[]){100}, sizeof(double));
    memcpy(t[FORCE_GRAVITY].p, (double[]){9.81e6, 0.998}, 2 * sizeof(double));
    return p;
}

static inline void packing_free(packing *p) {
    colony_free(p->c);
    free(p->species.list);
    link_rules_free(&p->links);
}

static inline void packing_on(packing *p, force_kind first, force_kind last) {
    for (int i = (int)first; i <= (int)last; i++)
        p->forces.term[i].on = true;
}

/* A rule for links of a species, or of a pair of them. */
static inline void packing_rule(packing *p, link_kind kind, int a, int b, const double values[LINK_PARAMS_MAX]) {
    link_rule rule = {.on = true};
    memcpy(rule.p, values, sizeof rule.p);
    link_rules_set(&p->links, kind, a, b, &rule);
}

/* A coccus at x; returns its cell row. */
static inline uint32_t packing_coccus(packing *p, const double x[3], double diameter) {
    uint32_t row = colony_add_cell(p->c, 1, x);
    p->c->cell.species[row] = PACKING_COCCUS;
    p->c->cell.diameter[row] = diameter;
    p->c->cell.mass[row] = shape_coccus_mass(diameter, 1.01);
    return row;
}

/* A rod of this rest length between two points, whose distance may differ from it. */
static inline uint32_t packing_rod(packing *p, const double a[3], const double b[3], double rest, double diameter) {
    double x[6];
    memcpy(x, a, 3 * sizeof *x);
    memcpy(x + 3, b, 3 * sizeof *x);
    uint32_t row = colony_add_cell(p->c, 2, x);
    p->c->cell.species[row] = PACKING_ROD;
    p->c->cell.diameter[row] = diameter;
    p->c->cell.rest[row] = rest;
    p->c->cell.mass[row] = shape_rod_mass(rest, diameter, 1.01);
    return row;
}

/* A flexible cell at x (n x 3) with segments of this rest length. */
static inline uint32_t packing_chain(packing *p, const double *x, size_t n, double segment, double diameter) {
    double rest = segment * (double)(n - 1);
    uint32_t row = colony_add_cell(p->c, n, x);
    p->c->cell.species[row] = PACKING_FLEXIBLE;
    p->c->cell.diameter[row] = diameter;
    p->c->cell.rest[row] = rest;
    p->c->cell.mass[row] = shape_rod_mass(rest, diameter, 1.01);
    return row;
}

static inline void packing_direction(packing *p, double u[3]) {
    double square;
    do {
        for (int k = 0; k < 3; k++)
            u[k] = packing_draw(p, -1, 1);
        square = u[0] * u[0] + u[1] * u[1] + u[2] * u[2];
    } while (square > 1 || square < 1e-4);
    for (int k = 0; k < 3; k++)
        u[k] /= sqrt(square);
}

typedef struct packing_recipe {
    size_t n;
    double box[3];             /* sides; centred in x and y, from 0 up in z, um */
    double rods;               /* fraction of rods, the rest cocci */
    double shortest, longest;  /* rest lengths of rods */
    double thinnest, thickest; /* diameters */
    double flatness;           /* axes' z is multiplied by this; 0: all flat */
} packing_recipe;

/* n random cells; velocities are random too. */
static inline void packing_fill(packing *p, const packing_recipe *r) {
    for (size_t i = 0; i < r->n; i++) {
        double d = packing_draw(p, r->thinnest, r->thickest), u[3], a[3], b[3];
        double centre[3] = {packing_draw(p, -0.5, 0.5) * r->box[0], packing_draw(p, -0.5, 0.5) * r->box[1],
                            0.45 * d + packing_draw(p, 0, 1) * r->box[2]};
        bool rod = packing_draw(p, 0, 1) < r->rods;
        double rest = packing_draw(p, r->shortest, r->longest), length = rest * packing_draw(p, 0.97, 1.02);
        packing_direction(p, u);
        u[2] *= r->flatness;
        double norm = sqrt(u[0] * u[0] + u[1] * u[1] + u[2] * u[2]);
        for (int k = 0; k < 3; k++) {
            a[k] = centre[k] - 0.5 * length * u[k] / norm;
            b[k] = centre[k] + 0.5 * length * u[k] / norm;
        }
        if (rod)
            packing_rod(p, a, b, rest, d);
        else
            packing_coccus(p, centre, d);
    }
    for (size_t i = 0; i < 3 * p->c->particle.count; i++)
        p->c->particle.v[i] = packing_draw(p, -5, 5);
}

/* A coil of the flexible species about a centre, every coordinate off its place by up to `noise`. */
static inline uint32_t packing_coil(packing *p, const double centre[3], double segment, double diameter, double noise) {
    enum { MOST = 64 };
    const species *s = &p->species.list[PACKING_FLEXIBLE];
    double x[3 * MOST];
    for (size_t i = 0; i < s->particles; i++)
        vec3_store(x + 3 * i, chain_coil_place(&s->coil, ((double)i - 0.5 * (s->particles - 1)) * segment));
    for (size_t i = 0; i < 3 * (size_t)s->particles; i++)
        x[i] += centre[i % 3] + packing_draw(p, -noise, noise);
    return packing_chain(p, x, s->particles, segment, diameter);
}

/* A spring between two particles of different cells, or from one to an anchor (b SPRING_ANCHOR). */
static inline uint32_t packing_spring(packing *p, uint32_t cell_a, uint32_t i, uint32_t cell_b, uint32_t j, double k,
                                      double rest) {
    colony *c = p->c;
    bool anchor = cell_b == SPRING_ANCHOR;
    uint32_t link =
        colony_add_link(c, anchor ? LINK_ANCHOR : LINK_FILIAL, c->cell.id[cell_a], anchor ? 0 : c->cell.id[cell_b], 1);
    uint32_t spring = c->link.first[link];
    c->spring.a[spring] = c->cell.first[cell_a] + i;
    c->spring.b[spring] = anchor ? SPRING_ANCHOR : c->cell.first[cell_b] + j;
    c->spring.k[spring] = k;
    c->spring.rest[spring] = rest;
    return spring;
}

static inline mechanics_input packing_input(const packing *p, neighbor_method method, int threads) {
    return (mechanics_input){.colony = p->c,
                             .species = &p->species,
                             .forces = &p->forces,
                             .links = &p->links,
                             .neighbor = {.skin = -1, .method = method},
                             .seed = 7,
                             .threads = threads};
}

static inline int packing_bind(const packing *p, mechanics *m, neighbor_method method, int threads, diag *d) {
    const mechanics_input in = packing_input(p, method, threads);
    return mechanics_prepare(m, &in, d);
}

/* Mechanics bound to the scene; a scene that cannot be bound ends the program. */
static inline mechanics *packing_mechanics(const packing *p, neighbor_method method, int threads) {
    mechanics *m = mechanics_create();
    if (packing_bind(p, m, method, threads, NULL) != SARCINA_OK)
        abort();
    return m;
}

#endif

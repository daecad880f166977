/* SPDX-License-Identifier: GPL-3.0-or-later */
/* bench-terms SCENE SECONDS [+TERM|-TERM]...: relaxes a scene by velocity Verlet with steps of 1 ms. SCENE: cocci or
 * rods, 120 of them (cocci:N, rods:N: N) that touch, on which collision, damping and, for rods, their springs act;
 * +TERM adds one to that, -TERM takes one out: a force term, filial, stick or anchor (links and their rules), chains
 * (12 flexible cells). +balanced, +paper: by that preset. +level: every z is 0; +flat, the last word: in two
 * dimensions. SECONDS 0: 20 force evaluations at the state as it is. It prints what there was to do, the memory of
 * mechanics and integrator, and nothing of time: tests/bench/term_cost counts its instructions. */
#include "packing.h"

#include "mechanics/remodel.h"
#include "model/link.h"
#include "relax/integrator.h"

#include <stdio.h>

enum { CELLS = 120, CHAINS = 12, EVALUATIONS = 20 };

/* Cells in a row of a layer that is about as long as wide. */
static int row_of(int cells) {
    return (int)sqrt((double)cells);
}

/* Side by side and end to end, each turned a little, in a layer on the plane. */
static void add_cells(packing *p, bool rods, int cells) {
    const int row = row_of(cells);
    for (int i = 0; i < cells; i++) {
        const int column = i % row, line = i / row;
        double x = (rods ? 2.85 : 0.79) * column, y = 0.79 * line, turn = packing_draw(p, -0.02, 0.02);
        if (rods)
            packing_rod(p, (double[]){x, y - turn, 0.4}, (double[]){x + 2, y + turn, 0.41}, 2, 0.8);
        else
            packing_coccus(p, (double[]){x, y + turn, 0.4}, 0.8);
    }
}

static void add_chains(packing *p) {
    for (int i = 0; i < CHAINS; i++)
        packing_coil(p, (double[]){3 * i, -4, 1}, 0.6, 0.5, 0.01);
}

/* Links of a kind between neighbours in a row, and their rule. */
static void add_links(packing *p, link_kind kind, bool rods) {
    const link_rule rules[LINK_STYLES] = {[LINK_FILIAL] = {true, {2e4, 2, 0.5, 1.7, 1.1}},
                                          [LINK_STICK] = {true, {1e4, 0.1, 1}},
                                          [LINK_ANCHOR] = {true, {1e4, 0.1, 1}}};
    int of = rods ? PACKING_ROD : PACKING_COCCUS;
    const uint32_t cells = (uint32_t)p->c->cell.count, row = (uint32_t)row_of((int)cells);
    link_rules_set(&p->links, kind, of, of, &rules[kind]);
    for (uint32_t i = 0; i + 1 < cells; i++) {
        if (kind == LINK_ANCHOR)
            link_add_anchor(p->c, &rules[kind], i, 0, 0);
        else if (kind == LINK_FILIAL && (i + 1) % row)
            link_add_filial(p->c, &rules[kind], LINK_STRAIGHT, i + 1, LINK_FIRST_END, i, LINK_LAST_END, 0);
        else if (kind == LINK_STICK && i + row < cells)
            link_add_stick(p->c, &rules[kind], i, i + row, 0);
    }
}

static const accuracy_preset *find_preset(const char *name) {
    for (size_t i = 0; i < accuracy_preset_count; i++)
        if (strcmp(accuracy_presets[i].name, name) == 0)
            return &accuracy_presets[i];
    return NULL;
}

/* One word of the command line; false: there is no such thing. */
static bool change(packing *p, const char *word, bool rods) {
    const char *name = word + 1;
    for (int kind = 0; kind < LINK_STYLES; kind++)
        if (strcmp(word, (const char *[]){"+filial", "+stick", "+anchor"}[kind]) == 0) {
            add_links(p, (link_kind)kind, rods);
            return true;
        }
    if (strcmp(word, "+flat") == 0 || find_preset(word + 1))
        return true;
    if (strcmp(word, "+level") == 0) {
        for (size_t i = 0; i < p->c->particle.count; i++)
            p->c->particle.x[3 * i + 2] = 0;
        return true;
    }
    if (strcmp(word, "+chains") == 0) {
        add_chains(p);
        return true;
    }
    for (int i = 0; i < FORCE_COUNT; i++)
        if (strcmp(force_styles[i]->name, name) == 0 && (*word == '+' || *word == '-')) {
            p->forces.term[i].on = *word == '+';
            return true;
        }
    return false;
}

/* The first evaluation, which builds the list, goes by another name. */
static void evaluate(const packing *p, mechanics *m) {
    double *f = calloc(3 * p->c->particle.count, sizeof *f), *x, *v;
    mechanics_take_state(m, &x, &v);
    mechanics_force_undamped(m, x, f);
    for (int i = 0; i < EVALUATIONS; i++)
        mechanics_force(m, x, v, f);
    mechanics_return_state(m);
    free(f);
}

static int bind(const packing *p, bool flat, mechanics *m, diag *d) {
    const mechanics_input in = {.colony = p->c,
                                .species = &p->species,
                                .forces = &p->forces,
                                .links = &p->links,
                                .neighbor = {.skin = -1, .method = NEIGHBOR_CELLS},
                                .seed = 7,
                                .flat = flat,
                                .threads = 1};
    return mechanics_prepare(m, &in, d);
}

int main(int argc, char **argv) {
    bool rods = argc > 1 && strncmp(argv[1], "rods", 4) == 0;
    if (argc < 3 || (!rods && strncmp(argv[1], "cocci", 5) != 0)) {
        fprintf(stderr, "usage: bench-terms cocci|rods[:CELLS] SECONDS [+TERM|-TERM]...\n");
        return 2;
    }
    packing p = packing_create(1);
    packing_on(&p, FORCE_COLLISION, FORCE_COLLISION);
    packing_on(&p, FORCE_DAMPING, FORCE_DAMPING);
    const char *count = strchr(argv[1], ':');
    add_cells(&p, rods, count ? atoi(count + 1) : CELLS);
    relax_settings how = {.integrator = INTEGRATOR_VERLET, .most = 1e-3};
    for (int i = 3; i < argc; i++) {
        const accuracy_preset *preset = find_preset(argv[i] + 1);
        how = preset ? preset->settings : how;
        if (!change(&p, argv[i], rods)) {
            fprintf(stderr, "bench-terms: no term '%s'\n", argv[i]);
            return 2;
        }
    }
    mechanics *m = mechanics_create();
    diag d = {0};
    bool flat = strcmp(argv[argc - 1], "+flat") == 0;
    if (bind(&p, flat, m, &d) != SARCINA_OK) {
        fprintf(stderr, "bench-terms: %s\n", d.message);
        return 1;
    }
    relax_result result = {.evaluations = EVALUATIONS};
    if (atof(argv[2]) == 0)
        evaluate(&p, m);
    if (atof(argv[2]) > 0 && relax_run(m, &how, &(relax_goal){.time = atof(argv[2])}, &result, &d) != SARCINA_OK) {
        fprintf(stderr, "bench-terms: %s\n", d.message);
        return 1;
    }
    mechanics_stats s = mechanics_statistics(m);
    size_t state = (size_t)mechanics_dimensions(m) * mechanics_particles(m) * sizeof(double);
    size_t integrator = (size_t)integrator_styles[how.integrator]->vectors * state;
    printf("%zu cells %zu links %zu pairs %llu evaluations %s %zu bytes\n", p.c->cell.count, p.c->link.count, s.pairs,
           (unsigned long long)result.evaluations, s.kernel, s.bytes + integrator);
    mechanics_free(m);
    packing_free(&p);
    return 0;
}

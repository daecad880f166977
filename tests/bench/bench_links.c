/* SPDX-License-Identifier: GPL-3.0-or-later */
/* bench-links KIND LINKS EVALUATIONS LOOKS: 2,000 rods in rows, LINKS of them linked to the next (filial, stick) or to
 * the plane (anchor), or none of them (none; rules: with rules that nothing here follows); so many force evaluations
 * and looks at what forms or breaks. It prints nothing of time: tests/bench/link_cost counts its instructions. */
#include "packing.h"

#include "mechanics/remodel.h"
#include "model/link.h"

#include <stdio.h>

enum { RODS = 2000, ROW = 50 };

static packing make_rows(void) {
    packing p = packing_create(1);
    for (int i = 0; i < RODS; i++) {
        double x = 3 * (i % ROW), y = 1.5 * (double)(i / ROW);
        packing_rod(&p, (double[]){x, y, 0.5}, (double[]){x + 2, y, 0.5}, 2, 0.8);
    }
    packing_on(&p, FORCE_COLLISION, FORCE_SUBSTRATUM);
    packing_on(&p, FORCE_DAMPING, FORCE_DAMPING);
    return p;
}

static void add_links(packing *p, const char *kind, uint32_t n) {
    const link_rule filial = {true, {2e4, 2, 0.5, 1.7, 1.1}}, stick = {true, {1e4, 0.1, 1}};
    const link_rule anchor = {true, {1e4, 0, 1}};
    bool is_filial = strcmp(kind, "filial") == 0, is_anchor = strcmp(kind, "anchor") == 0;
    int stuck = strcmp(kind, "rules") == 0 ? PACKING_COCCUS : PACKING_ROD;
    if (strcmp(kind, "none") == 0)
        return;
    if (is_filial || stuck == PACKING_COCCUS)
        link_rules_set(&p->links, LINK_FILIAL, PACKING_ROD, PACKING_ROD, &filial);
    if (!is_filial && !is_anchor)
        link_rules_set(&p->links, LINK_STICK, stuck, PACKING_ROD, &stick);
    if (is_anchor)
        link_rules_set(&p->links, LINK_ANCHOR, PACKING_ROD, PACKING_ROD, &anchor);
    for (uint32_t i = 0; i < n && i + 1 < RODS; i++) {
        if (is_filial)
            link_add_filial(p->c, &filial, LINK_STRAIGHT, i + 1, LINK_FIRST_END, i, LINK_LAST_END, 0);
        else if (is_anchor)
            link_add_anchor(p->c, &anchor, i, 0, 0);
        else
            link_add_stick(p->c, &stick, i, i + 1, 0);
    }
}

int main(int argc, char **argv) {
    if (argc != 5) {
        fprintf(stderr, "usage: bench-links none|rules|filial|stick|anchor LINKS EVALUATIONS LOOKS\n");
        return 2;
    }
    packing p = make_rows();
    add_links(&p, argv[1], (uint32_t)atoi(argv[2]));
    mechanics *m = packing_mechanics(&p, NEIGHBOR_CELLS, 1);
    double *f = calloc(3 * p.c->particle.count, sizeof *f);
    for (int i = 0; i < atoi(argv[3]); i++)
        mechanics_force(m, p.c->particle.x, p.c->particle.v, f);
    remodel_change change;
    for (int i = 0; i < atoi(argv[4]) && mechanics_remodels(m); i++)
        mechanics_remodel(m, &change);
    printf("%zu links\n", p.c->link.count);
    free(f);
    mechanics_free(m);
    packing_free(&p);
    return 0;
}

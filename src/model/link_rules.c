/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "model/link_rules.h"

#include "base/alloc.h"
#include "base/table.h"

#include <stdlib.h>
#include <string.h>

static const param filial_params[] = {
    {"k:stiffness!(0,)", "spring constant of a whole link, shared by its springs"},
    {"break:length!(0,)", "a spring longer than its rest length by more than this breaks the link"},
    {"short=0.5:number(0,)", "rest length of the spring between facing ends, in mean diameters"},
    {"long=1.7:number(0,)", "of that between far ends, beyond the rest lengths of the two cells, in mean diameters"},
    {"ratio=1.1:number(0,)", "between cocci: distance of the centres at rest over the sum of the radii"},
};

#define HANDOVER_PARAM                                                                                                 \
    {                                                                                                                  \
        "handover=nearer:{nearer|mother}",                                                                             \
            "who has the link after a division: the nearer of mother and daughter, or the mother as she then lies"     \
    }

static const param stick_params[] = {
    {"k=1e-11N/m:stiffness(0,)", "spring constant of a whole link, shared by its springs"},
    {"form=0.5um:length[0,)", "cells whose surfaces are nearer than this stick"},
    {"break=1um:length(0,)", "a spring longer than its rest length by more than this breaks the link"},
    HANDOVER_PARAM,
};

static const param anchor_params[] = {
    {"k=1e-11N/m:stiffness(0,)", "spring constant of a whole link, shared by its springs"},
    {"form=0.5um:length[0,)", "a cell whose surface is nearer than this to the substratum is anchored"},
    {"break=1um:length(0,)", "a spring longer than its rest length by more than this breaks the link"},
    {"glide=no:flag", "the anchor point follows below the particle: force along z only"},
    HANDOVER_PARAM,
};

static const char source[] = "Storck et al. 2014, secondary and tertiary structures";

const link_style link_rules_styles[LINK_STYLES] = {
    [LINK_FILIAL] = {.name = "filial",
                     .summary = "The link between mother and daughter",
                     .details =
                         "Made at division only. Rods: a spring between the facing ends, L = short D, and one between "
                         "the far ends, L = long D + L_A + L_B, with k/2 each; D is the mean of the two diameters, L_A "
                         "and L_B are the rods' own rest lengths. Where a division branches, the daughter A is joined "
                         "to her mother and to the mother's neighbour, each time by two springs with k/4: l D and "
                         "l sqrt((L_A + l D/2)^2 + (L_B + sqrt(3/4) l D)^2), l = (short + long)/2. Cocci: one spring, "
                         "L = ratio (r_A + r_B). Rest lengths follow growth. Named again, it changes the links that "
                         "are there, too; off removes them.",
                     .source = source,
                     .example = "link filial ecoli k 2e-11N/m break 2um short 0.5 long 1.7 ratio 1.1\n"
                                "create_cells ecoli single 0 -4um 0 orient x gap 0 filament 3\n"
                                "link filial ecoli off",
                     .params = filial_params,
                     .nparams = TABLE_COUNT(filial_params)},
    [LINK_STICK] = {.name = "stick",
                    .summary = "Sticking links between the cells of two species (or of one: name it twice)",
                    .details =
                        "Form while a colony relaxes, between cells not linked filially whose axes are nearer than "
                        "r_A + r_B + form: every particle of one with every particle of the other (1, 2 or 4 springs), "
                        "k over their number each, at rest at the larger of their length then and r_A + r_B. See "
                        "'link remodel' for when. Named again, k changes for the links that are there, too; off "
                        "removes them.",
                    .source = source,
                    .example = "link stick ecoli cf k 1e-11N/m form 0.5um break 1um handover nearer\n"
                               "link stick * * break 5um\n"
                               "link stick ecoli cf off",
                    .params = stick_params,
                    .nparams = TABLE_COUNT(stick_params),
                    .pairs = true},
    [LINK_ANCHOR] = {.name = "anchor",
                     .summary = "Anchoring links from the cells of a species to the substratum",
                     .details =
                         "Form while a colony relaxes, for a cell without one when a particle is lower than r + form: "
                         "from each of its particles to the point straight below on the substratum, k over their "
                         "number each, at rest at the larger of the height then and 1.01 r. See 'link remodel' for "
                         "when. Named again, k and glide change for the links that are there, too; off removes them.",
                     .source = source,
                     .example = "link anchor ecoli k 1e-11N/m form 0.5um break 1um glide no handover nearer\n"
                                "relax 10ms\n"
                                "link anchor ecoli off",
                     .params = anchor_params,
                     .nparams = TABLE_COUNT(anchor_params)},
};

static size_t rules_of(link_kind kind, size_t nspecies) {
    return link_rules_styles[kind].pairs ? nspecies * nspecies : nspecies;
}

void link_rules_free(link_rules *r) {
    for (int kind = 0; kind < LINK_STYLES; kind++)
        free(r->list[kind]);
    memset(r, 0, sizeof *r);
}

void link_rules_clear(link_rules *r) {
    link_rules_free(r);
    r->every = LINK_RULES_EVERY;
}

static size_t place_of(link_kind kind, size_t nspecies, int a, int b) {
    return link_rules_styles[kind].pairs ? (size_t)a * nspecies + (size_t)b : (size_t)a;
}

void link_rules_grow(link_rules *r, size_t n) {
    if (n <= r->nspecies)
        return;
    for (int kind = 0; kind < LINK_STYLES; kind++) {
        link_rule *list = alloc_zeroed(rules_of((link_kind)kind, n), sizeof *list);
        size_t others = link_rules_styles[kind].pairs ? r->nspecies : 1;
        for (size_t a = 0; a < r->nspecies; a++)
            for (size_t b = 0; b < others; b++)
                list[place_of((link_kind)kind, n, (int)a, (int)b)] =
                    r->list[kind][place_of((link_kind)kind, r->nspecies, (int)a, (int)b)];
        free(r->list[kind]);
        r->list[kind] = list;
    }
    r->nspecies = n;
}

/* Kinds that a build may leave out (src/without.cmake): none of their rules is ever found. */
#ifndef SARCINA_WITHOUT_FILIAL
#define SARCINA_WITHOUT_FILIAL 0
#endif
#ifndef SARCINA_WITHOUT_STICK
#define SARCINA_WITHOUT_STICK 0
#endif
#ifndef SARCINA_WITHOUT_ANCHOR
#define SARCINA_WITHOUT_ANCHOR 0
#endif

static bool is_left_out(link_kind kind) {
    return (SARCINA_WITHOUT_FILIAL && kind == LINK_FILIAL) || (SARCINA_WITHOUT_STICK && kind == LINK_STICK) ||
           (SARCINA_WITHOUT_ANCHOR && kind == LINK_ANCHOR);
}

const link_rule *link_rules_find(const link_rules *r, link_kind kind, int a, int b) {
    if (is_left_out(kind) || a < 0 || (size_t)a >= r->nspecies || b < 0 || (size_t)b >= r->nspecies)
        return NULL;
    const link_rule *rule = &r->list[kind][place_of(kind, r->nspecies, a, b)];
    return rule->on ? rule : NULL;
}

void link_rules_set(link_rules *r, link_kind kind, int a, int b, const link_rule *rule) {
    link_rules_grow(r, (size_t)(a > b ? a : b) + 1);
    r->list[kind][place_of(kind, r->nspecies, a, b)] = *rule;
    r->list[kind][place_of(kind, r->nspecies, b, a)] = *rule;
}

bool link_rules_any(const link_rules *r, link_kind kind) {
    for (size_t i = 0; i < rules_of(kind, r->nspecies); i++)
        if (r->list[kind][i].on)
            return true;
    return false;
}

double link_rules_break(link_kind kind, const link_rule *rule) {
    return rule->p[kind == LINK_FILIAL ? FILIAL_BREAK : kind == LINK_STICK ? STICK_BREAK : ANCHOR_BREAK];
}

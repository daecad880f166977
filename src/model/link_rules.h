/* SPDX-License-Identifier: GPL-3.0-or-later */
/* By which rules the cells of each species, or pair of species, are linked: which links there are, how stiff they are,
 * when they form and break. Scripts declare them; the links themselves are rows of the colony. */
#ifndef SARCINA_MODEL_LINK_RULES_H
#define SARCINA_MODEL_LINK_RULES_H

#include "base/param.h"
#include "model/colony.h"

#include <stdbool.h>
#include <stddef.h>

/* The kinds of links that have rules: filial, stick, anchor. */
enum { LINK_STYLES = LINK_ANCHOR + 1, LINK_PARAMS_MAX = 5 };

/* Columns of link_rule.p, in the order of each kind's param records; um, pg/s2. */
enum { FILIAL_K, FILIAL_BREAK, FILIAL_SHORT, FILIAL_LONG, FILIAL_RATIO };
enum { STICK_K, STICK_FORM, STICK_BREAK, STICK_HANDOVER };
enum { ANCHOR_K, ANCHOR_FORM, ANCHOR_BREAK, ANCHOR_GLIDE, ANCHOR_HANDOVER };
enum { HANDOVER_NEARER, HANDOVER_MOTHER };

typedef struct link_rule {
    bool on;
    double p[LINK_PARAMS_MAX];
} link_rule;

/* The record of a kind of link: what commands, help and manual know of it. */
typedef struct link_style {
    const char *name; /* in scripts */
    const char *summary, *details, *source, *example;
    const param *params; /* in the order of link_rule.p */
    size_t nparams;
    bool pairs; /* a rule is for a pair of species, not for one */
} link_style;

extern const link_style link_rules_styles[LINK_STYLES]; /* by link_kind */

/* How often links form and break while a colony relaxes, s, where no script says; 0: after every accepted step. */
#define LINK_RULES_EVERY 5e-3

typedef struct link_rules {
    size_t nspecies;
    link_rule *list[LINK_STYLES]; /* filial, anchor: (nspecies); stick: (nspecies x nspecies), symmetric */
    double every;                 /* s */
} link_rules;

void link_rules_free(link_rules *r);

/* No rules, and the default rhythm. */
void link_rules_clear(link_rules *r);

/* Makes room for the rules of n species. */
void link_rules_grow(link_rules *r, size_t n);

/* The rule of a kind for a species (stick: a pair of them, in any order); NULL where there is none. */
const link_rule *link_rules_find(const link_rules *r, link_kind kind, int a, int b);

/* Sets it; rule->on false takes it out. */
void link_rules_set(link_rules *r, link_kind kind, int a, int b, const link_rule *rule);

/* Is there any rule of this kind? */
bool link_rules_any(const link_rules *r, link_kind kind);

/* How far a spring of a link of this kind may be stretched, um. */
double link_rules_break(link_kind kind, const link_rule *rule);

#endif

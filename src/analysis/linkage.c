/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "analysis/linkage.h"

#include <math.h>
#include <stdlib.h>

/* Sums of all links, then by link_kind. */
typedef struct sums {
    double n[2 + LINK_SPRING], sum[2 + LINK_SPRING], least, largest;
} sums;

static void add(sums *s, int kind, double x) {
    s->n[0] += 1;
    s->sum[0] += x;
    s->n[1 + kind] += 1;
    s->sum[1 + kind] += x;
    s->least = fmin(s->least, x);
    s->largest = fmax(s->largest, x);
}

static double mean(const sums *s, int i) {
    return s->n[i] > 0 ? s->sum[i] / s->n[i] : (double)NAN;
}

static bool is_inside(colony *c, const bool *members, uint32_t link) {
    uint32_t a = colony_row(c, c->link.cell_a[link]);
    uint32_t b = c->link.cell_b[link] ? colony_row(c, c->link.cell_b[link]) : a;
    return !members || (members[a] && members[b]);
}

/* Links in the order of their ids. */
static sums sum_links(const view *v, const bool *members, void (*take)(sums *, const view *, uint32_t link)) {
    sums s = {.least = INFINITY, .largest = -INFINITY};
    uint32_t *order = colony_links_by_id(v->colony);
    for (size_t i = 0; i < v->colony->link.count; i++)
        if (is_inside(v->colony, members, order[i]))
            take(&s, v, order[i]);
    free(order);
    return s;
}

static void take_strain(sums *s, const view *v, uint32_t link) {
    const colony *c = v->colony;
    for (uint32_t i = c->link.first[link]; i < c->link.first[link] + c->link.nsprings[link]; i++)
        if (c->spring.rest[i] > 0)
            add(s, c->link.kind[link], colony_spring_length(c, i) / c->spring.rest[i] - 1);
}

static void take_age(sums *s, const view *v, uint32_t link) {
    add(s, v->colony->link.kind[link], v->time - v->colony->link.birth[link]);
}

int linkage_strain(const view *v, const bool *members, double *out, diag *d) {
    (void)d;
    sums s = sum_links(v, members, take_strain);
    out[0] = mean(&s, 0);
    out[1] = s.n[0] > 0 ? s.least : (double)NAN;
    out[2] = s.n[0] > 0 ? s.largest : (double)NAN;
    out[3] = mean(&s, 1 + LINK_FILIAL);
    out[4] = mean(&s, 1 + LINK_STICK);
    out[5] = mean(&s, 1 + LINK_ANCHOR);
    return SARCINA_OK;
}

int linkage_age(const view *v, const bool *members, double *out, diag *d) {
    (void)d;
    sums s = sum_links(v, members, take_age);
    out[0] = mean(&s, 0);
    out[1] = s.n[0] > 0 ? s.largest : (double)NAN;
    out[2] = mean(&s, 1 + LINK_FILIAL);
    out[3] = mean(&s, 1 + LINK_STICK);
    out[4] = mean(&s, 1 + LINK_ANCHOR);
    return SARCINA_OK;
}

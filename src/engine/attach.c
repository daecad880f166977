/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Cells that arrive from the bulk: in a growth step of length dt their number is Poisson distributed with mean
 * rate dt, drawn from the stream of the attachment and the growth step; each then draws its mass, axis and place. */
#include "engine/attach.h"

#include "base/alloc.h"
#include "biology/division.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

enum { ARRIVALS_MAX = 1000000 }; /* in one step: more is a slip of the rate */

attachment *scene_attach(scene *s, int species_row, const region *where) {
    attachment_table *t = &s->attachments;
    for (size_t i = 0; i < t->count; i++)
        if (t->list[i].placement.species == species_row && strcmp(t->list[i].where.name, where->name) == 0)
            return &t->list[i];
    t->list = alloc_grow(t->list, &t->capacity, t->count + 1, sizeof *t->list);
    attachment *a = &t->list[t->count++];
    *a = (attachment){.placement = {.species = species_row}, .where = *where, .serial = ++t->serials};
    return a;
}

void scene_attach_off(scene *s, int species_row) {
    attachment_table *t = &s->attachments;
    size_t kept = 0;
    for (size_t i = 0; i < t->count; i++)
        if (t->list[i].placement.species != species_row)
            t->list[kept++] = t->list[i];
    t->count = kept;
}

/* The placement with its mass in pg: a part is one of the division mass as it is now. */
static int resolve(const scene *s, const attachment *a, placement *p, diag *d) {
    *p = a->placement;
    const species *sp = &s->species.list[p->species];
    double whole = a->mass_is_part ? division_mean_mass(sp) : 1;
    if (isnan(whole)) {
        diag_error(d, "species %s attaches with a part of its division mass, but has none", sp->name);
        return diag_help(d, "write 'division %s ...' before, or attach with a mass in kg", sp->name);
    }
    p->mass.a *= whole;
    if (p->mass.law != SPREAD_LOGNORMAL)
        p->mass.b *= whole;
    return SARCINA_OK;
}

static int check_one(const scene *s, const attachment *a, double dt, diag *d) {
    placement p;
    if (resolve(s, a, &p, d) != SARCINA_OK)
        return SARCINA_ERROR;
    double mean = a->rate * dt;
    if (mean <= ARRIVALS_MAX)
        return SARCINA_OK;
    diag_error(d, "%.3g cells of %s would attach in one step of %g s", mean, s->species.list[p.species].name, dt);
    return diag_help(d, "a rate takes its unit: 6/h is six an hour");
}

int attach_check(const scene *s, double dt, diag *d) {
    for (size_t i = 0; i < s->attachments.count; i++)
        if (check_one(s, &s->attachments.list[i], dt, d) != SARCINA_OK)
            return SARCINA_ERROR;
    return SARCINA_OK;
}

void attach_step(scene *s, uint64_t step, double dt) {
    attachment_table *t = &s->attachments;
    for (size_t i = 0; i < t->count; i++) {
        attachment *a = &t->list[i];
        placement p;
        resolve(s, a, &p, NULL);
        uint64_t id = a->serial << 32;
        uint64_t n = rng_poisson(rng_stream(s->rng, RNG_ATTACH, id, step), a->rate * dt);
        for (uint64_t k = 0; k < n; k++) {
            bool placed = scene_create_arrival(s, &p, &a->where, id + 1 + 2 * k, step);
            t->arrived += placed;
            t->crowded += !placed;
        }
    }
}

/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Conservative terms as the mechanics give them; the springs of links are told apart by the kind of their link, each
 * E = k/2 (L - L0)^2. */
#include "analysis/mechanical.h"

#include <math.h>
#include <stdlib.h>

enum { INTERNAL, BEND, TWIST, FILIAL, STICK, ANCHOR, SPRING, COLLISION, SUBSTRATUM, DLVO, GRAVITY, KINETIC, FIELDS };

static double spring_energy(const colony *c, uint32_t s) {
    double stretch = colony_spring_length(c, s) - c->spring.rest[s];
    return 0.5 * c->spring.k[s] * stretch * stretch;
}

/* Links in the order of their ids. */
static void add_links(const colony *c, double *field) {
    static const int field_of[] = {
        [LINK_FILIAL] = FILIAL, [LINK_STICK] = STICK, [LINK_ANCHOR] = ANCHOR, [LINK_SPRING] = SPRING};
    uint32_t *order = colony_links_by_id(c);
    for (size_t i = 0; i < c->link.count; i++) {
        uint32_t l = order[i];
        for (uint32_t s = 0; s < c->link.nsprings[l]; s++)
            field[field_of[c->link.kind[l]]] += spring_energy(c, c->link.first[l] + s);
    }
    free(order);
}

int mechanical_energy(const view *v, const bool *members, double *out, diag *d) {
    if (members)
        return diag_error(d, "energy belongs to the whole colony, not to a group");
    const colony *c = v->colony;
    double *field = out + 1;
    for (int i = 0; i < FIELDS; i++)
        field[i] = v->mechanics ? 0 : (double)NAN;
    out[0] = NAN;
    if (!v->mechanics)
        return SARCINA_OK;
    field[INTERNAL] = mechanics_energy(v->mechanics, FORCE_INTERNAL, NULL);
    field[BEND] = mechanics_energy(v->mechanics, FORCE_BEND, NULL);
    field[TWIST] = mechanics_energy(v->mechanics, FORCE_TWIST, NULL);
    field[COLLISION] = mechanics_energy(v->mechanics, FORCE_COLLISION, NULL);
    field[SUBSTRATUM] = mechanics_energy(v->mechanics, FORCE_SUBSTRATUM, NULL);
    field[DLVO] = mechanics_energy(v->mechanics, FORCE_DLVO, NULL);
    field[GRAVITY] = mechanics_energy(v->mechanics, FORCE_GRAVITY, NULL);
    field[KINETIC] = mechanics_kinetic(v->mechanics);
    add_links(c, field);
    out[0] = 0;
    for (int i = 0; i < FIELDS; i++)
        out[0] += field[i];
    return SARCINA_OK;
}

int mechanical_fmax(const view *v, const bool *members, double *out, diag *d) {
    if (members)
        return diag_error(d, "fmax belongs to the whole colony, not to a group");
    out[0] = v->mechanics ? mechanics_fmax(v->mechanics) : (double)NAN;
    return SARCINA_OK;
}

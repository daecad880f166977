/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "model/species.h"

#include "base/alloc.h"
#include "model/shape.h"

#include <math.h>
#include <sleef.h>
#include <string.h>

int species_find(const species_table *t, const char *name) {
    for (size_t i = 0; i < t->count; i++)
        if (strcmp(t->list[i].name, name) == 0)
            return (int)i;
    return -1;
}

int species_add(species_table *t, const char *name) {
    t->list = alloc_grow(t->list, &t->capacity, t->count + 1, sizeof *t->list);
    species *s = &t->list[t->count];
    memset(s, 0, sizeof *s);
    strncpy(s->name, name, sizeof s->name - 1);
    s->growth.style = s->division.style = -1;
    s->bend_angle = s->twist_angle = NAN;
    return (int)t->count++;
}

size_t species_particles(const species *s) {
    return s->shape == SHAPE_COCCUS ? 1 : s->shape == SHAPE_ROD ? 2 : s->particles;
}

const char *species_shape_name(shape_kind shape) {
    static const char *const names[] = {
        [SHAPE_COCCUS] = "a coccus", [SHAPE_ROD] = "a rod", [SHAPE_FLEXIBLE] = "flexible"};
    return names[shape];
}

double species_segment(const species *s, double rest) {
    return s->shape == SHAPE_FLEXIBLE ? chain_coil_chord(&s->coil, rest / (s->particles - 1)) : rest;
}

void species_rest_angles(const species *s, double rest, double *theta, double *cos_phi, double *sin_phi) {
    chain_coil_angles(&s->coil, rest / (s->particles - 1), theta, cos_phi, sin_phi);
    if (!isnan(s->bend_angle))
        *theta = s->bend_angle;
    if (!isnan(s->twist_angle)) {
        *cos_phi = Sleef_cinz_cosd1_u10purec(s->twist_angle);
        *sin_phi = Sleef_cinz_sind1_u10purec(s->twist_angle);
    }
}

double species_stiffness(const species *s, const colony *c, uint32_t row) {
    return s->internal_k > 0 && c->cell.stiffness[row] > 0 ? c->cell.stiffness[row] : s->internal_k;
}

double species_rest(const species *s, double mass, double diameter, double aspect) {
    if (s->shape == SHAPE_COCCUS)
        return 0;
    if (aspect > 0)
        return (aspect - 1) * shape_rod_aspect_diameter(mass, aspect, s->density);
    return shape_rod_rest(mass, diameter, s->density);
}

void species_shape_cell(const species *s, colony *c, uint32_t row) {
    double mass = c->cell.mass[row];
    if (s->shape == SHAPE_COCCUS)
        c->cell.diameter[row] = shape_coccus_diameter(mass, s->density);
    else if (c->cell.aspect[row] > 0)
        c->cell.diameter[row] = shape_rod_aspect_diameter(mass, c->cell.aspect[row], s->density);
    double rest = species_rest(s, mass, c->cell.diameter[row], c->cell.aspect[row]);
    c->cell.rest[row] = rest > 0 ? rest : 0; /* a rod that shrinks ends as a ball of two particles */
}

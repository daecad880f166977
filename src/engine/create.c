/* SPDX-License-Identifier: GPL-3.0-or-later */
/* New cells: drawn or given, put where there is room, all or none. */
#include "engine/flat.h"
#include "engine/scene.h"
#include "engine/spots.h"

#include "base/alloc.h"
#include "base/number.h"
#include "base/quaternion.h"
#include "base/vec3.h"
#include "biology/division.h"
#include "model/axis.h"
#include "model/link.h"

#include <gsl/gsl_randist.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

/* What is there before: to go back to when not all can be placed. */
typedef struct mark {
    size_t cells;
    uint64_t next_id, next_link, formed;
} mark;

static mark set_mark(const scene *s) {
    const colony *c = s->colony;
    return (mark){c->cell.count, c->next_cell_id, c->next_link_id, c->links_formed};
}

static void return_to(scene *s, mark m) {
    uint32_t *rows = alloc_zeroed(m.cells, sizeof *rows);
    for (uint32_t i = 0; i < m.cells; i++)
        rows[i] = i;
    colony_arrange(s->colony, rows, m.cells);
    s->colony->next_cell_id = m.next_id;
    s->colony->next_link_id = m.next_link;
    s->colony->links_formed = m.formed;
    free(rows);
}

static vec3 draw_axis(const scene *s, const placement *p, gsl_rng *stream) {
    vec3 u = {0, 0, 0};
    switch (s->dimension == 2 && p->orient == ORIENT_RANDOM ? ORIENT_XY : p->orient) {
    case ORIENT_X:
        return vec3_of(1, 0, 0);
    case ORIENT_Y:
        return vec3_of(0, 1, 0);
    case ORIENT_Z:
        return vec3_of(0, 0, 1);
    case ORIENT_XY:
        gsl_ran_dir_2d(stream, &u.x, &u.y);
        return u;
    case ORIENT_RANDOM:
        gsl_ran_dir_3d(stream, &u.x, &u.y, &u.z);
        return u;
    case ORIENT_VECTOR:
        break;
    }
    u = vec3_load(p->axis);
    return vec3_scale(1 / vec3_norm(u), u);
}

/* Mass of a new cell: drawn until it is positive. */
static double draw_mass(const placement *p, gsl_rng *stream) {
    double mass = 0;
    for (int i = 0; i < 1000 && !(mass > 0); i++)
        mass = spread_draw(&p->mass, stream);
    return mass > 0 ? mass : spread_mean(&p->mass);
}

/* Appends a cell with its size and shape, all particles at the origin; returns its row. */
static uint32_t add_cell(scene *s, int species_row, double mass, double diameter) {
    const species *sp = &s->species.list[species_row];
    colony *c = s->colony;
    double *origin = alloc_zeroed(3 * species_particles(sp), sizeof *origin);
    uint32_t row = colony_add_cell(c, species_particles(sp), origin);
    free(origin);
    c->cell.species[row] = species_row;
    c->cell.founder[row] = c->cell.id[row];
    c->cell.birth[row] = s->time;
    c->cell.mass[row] = mass;
    division_draw_size(sp, c, row, s->rng);
    if (diameter > 0 && sp->shape != SHAPE_COCCUS)
        c->cell.diameter[row] = diameter;
    species_shape_cell(sp, c, row);
    c->cell.limit[row] = division_limit(sp, s->rng, c->cell.id[row], c->cell.diameter[row], c->cell.aspect[row]);
    return row;
}

static const chain_coil *coil_of(const scene *s, uint32_t row) {
    return &s->species.list[s->colony->cell.species[row]].coil;
}

/* Puts the cell's particles on a line, or the coil of its species, along the axis and about its centre. */
static void put_cell(scene *s, uint32_t row, vec3 centre, vec3 axis) {
    colony *c = s->colony;
    const chain_coil *coil = coil_of(s, row);
    quaternion turn = quaternion_from_x(axis);
    uint32_t n = c->cell.nparticles[row];
    double *x = c->particle.x + 3 * (size_t)c->cell.first[row];
    for (uint32_t i = 0; i < n; i++) {
        double at = n > 1 ? c->cell.rest[row] * ((double)i / (n - 1) - 0.5) : 0;
        vec3 place = coil->radius > 0 ? vec3_add(centre, quaternion_rotate(turn, chain_coil_place(coil, at)))
                                      : vec3_axpy(centre, at, axis);
        vec3_store(x + 3 * (size_t)i, place);
    }
}

/* How long the cell is along its axis, between its end particles. */
static double extent_of(const scene *s, uint32_t row) {
    double rest = s->colony->cell.rest[row];
    const chain_coil *coil = coil_of(s, row);
    return coil->radius > 0 ? rest * coil->pitch / chain_coil_turn(coil) : rest;
}

/* What is created as one: a cell, or a filament of them; rows first ... first + n - 1. */
typedef struct new_group {
    uint32_t first, n;
} new_group;

/* Appends the cells of a group; the first has this mass and diameter (NaN: drawn), the others draw theirs. */
static new_group add_group(scene *s, const placement *p, int species_row, double mass, double diameter) {
    new_group g = {add_cell(s, species_row, mass, diameter), p->filament > 1 ? (uint32_t)p->filament : 1};
    for (uint32_t i = 1; i < g.n; i++) {
        gsl_rng *stream = rng_stream(s->rng, RNG_CREATE, s->colony->next_cell_id, 0);
        add_cell(s, species_row, draw_mass(p, stream), NAN);
    }
    return g;
}

static const link_rule *filial_rule(const scene *s, int species_row) {
    return link_rules_find(&s->links, LINK_FILIAL, species_row, species_row);
}

/* Between the facing ends of a cell and the next in a filament: where the springs of their filial link cancel. */
static double joint_length(const scene *s, uint32_t row) {
    const colony *c = s->colony;
    const link_rule *rule = filial_rule(s, c->cell.species[row]);
    double mean = 0.5 * (c->cell.diameter[row] + c->cell.diameter[row + 1]);
    if (c->cell.nparticles[row] == 1)
        return rule->p[FILIAL_RATIO] * mean;
    return 0.5 * (rule->p[FILIAL_SHORT] + rule->p[FILIAL_LONG]) * mean;
}

/* Shifts the group so that its lowest surface is `gap` above the substratum. */
static void lift_group(const scene *s, new_group g, bool flat, double gap) {
    const colony *c = s->colony;
    double shift = -INFINITY, level = s->forces.term[FORCE_SUBSTRATUM].p[SUBSTRATUM_Z] + gap;
    uint32_t begin = c->cell.first[g.first], end = begin;
    for (uint32_t row = g.first; row < g.first + g.n; row++)
        for (uint32_t i = 0; i < c->cell.nparticles[row]; i++)
            shift = fmax(shift, level + 0.5 * c->cell.diameter[row] - c->particle.x[3 * (size_t)end++ + 2]);
    for (uint32_t i = begin; i < end; i++)
        c->particle.x[3 * (size_t)i + 2] += shift;
    /* what is flat lies exactly flat: the shift must not leave a rounding error for the daughters to inherit */
    for (uint32_t i = begin + 1; i < end && flat; i++)
        c->particle.x[3 * (size_t)i + 2] = c->particle.x[3 * (size_t)begin + 2];
}

/* Puts the group's cells in a row around a centre; then `gap` above the substratum, where that is asked for. */
static void put_group(scene *s, new_group g, const double centre[3], vec3 axis, double gap) {
    double length = 0, at = 0;
    for (uint32_t row = g.first; row < g.first + g.n; row++)
        length += extent_of(s, row) + (row + 1 < g.first + g.n ? joint_length(s, row) : 0);
    for (uint32_t row = g.first; row < g.first + g.n; row++) {
        vec3 place = vec3_load(centre);
        if (g.n > 1)
            place = vec3_axpy(place, at + 0.5 * extent_of(s, row) - 0.5 * length, axis);
        put_cell(s, row, place, axis);
        at += extent_of(s, row) + (row + 1 < g.first + g.n ? joint_length(s, row) : 0);
    }
    if (!isnan(gap))
        lift_group(s, g, axis.z == 0 && !(coil_of(s, g.first)->radius > 0), gap);
}

static void link_group(scene *s, new_group g) {
    for (uint32_t row = g.first; row + 1 < g.first + g.n; row++)
        link_add_filial(s->colony, filial_rule(s, s->colony->cell.species[row]), LINK_STRAIGHT, row + 1, LINK_FIRST_END,
                        row, LINK_LAST_END, s->time);
}

/* Smallest box around a cell's particles, grown by `margin`. */
static void bounding_box(const colony *c, uint32_t row, double margin, double low[3], double high[3]) {
    const double *x = c->particle.x + 3 * (size_t)c->cell.first[row];
    for (int k = 0; k < 3; k++) {
        low[k] = high[k] = x[k];
        for (uint32_t i = 1; i < c->cell.nparticles[row]; i++) {
            low[k] = fmin(low[k], x[3 * (size_t)i + (size_t)k]);
            high[k] = fmax(high[k], x[3 * (size_t)i + (size_t)k]);
        }
        low[k] -= margin;
        high[k] += margin;
    }
}

/* Does the cell overlap any of the first n? By their real radii, not the reach of the collision. */
static bool has_room(const colony *c, uint32_t row, size_t n) {
    double radius = 0.5 * c->cell.diameter[row], low[3], high[3], l[3], h[3];
    bounding_box(c, row, radius, low, high);
    for (uint32_t i = 0; i < n; i++) {
        bounding_box(c, i, 0.5 * c->cell.diameter[i], l, h);
        bool apart =
            l[0] > high[0] || h[0] < low[0] || l[1] > high[1] || h[1] < low[1] || l[2] > high[2] || h[2] < low[2];
        if (!apart && axis_cell_distance(c, row, i) < radius + 0.5 * c->cell.diameter[i])
            return false;
    }
    return true;
}

/* The same of every cell of a group. */
static bool group_has_room(const colony *c, new_group g, size_t n) {
    for (uint32_t row = g.first; row < g.first + g.n; row++)
        if (!has_room(c, row, n))
            return false;
    return true;
}

/* Cells in a row need what holds them together. */
static int check_filament(const scene *s, const placement *p, int species_row, diag *d) {
    if (p->filament <= 1 || filial_rule(s, species_row))
        return SARCINA_OK;
    const char *name = s->species.list[species_row].name;
    diag_error(d, "a filament is linked filially, and species %s has no such link", name);
    return diag_help(d, "link filial %s k 2e-11N/m break 2um", name);
}

static int check_placement(const scene *s, const placement *p, diag *d) {
    if (!isnan(p->gap) && !s->forces.term[FORCE_SUBSTRATUM].on) {
        diag_error(d, "gap needs a substratum to be measured from");
        return diag_help(d, "write 'substratum plane' before, or leave gap out");
    }
    if (p->orient == ORIENT_VECTOR && !(vec3_norm(vec3_load(p->axis)) > 0))
        return diag_error(d, "orient 0 0 0 is no direction");
    int status = flat_check_orient(s, p->orient, p->axis, d);
    return status ? status : check_filament(s, p, p->species, d);
}

static int no_room(size_t which, size_t wanted, int tries, diag *d) {
    diag_error(d, "no room for cell %zu of %zu after %d tries; none was created", which, wanted, tries);
    return diag_help(d, "take a larger region, a larger maxtry, or 'overlap yes'");
}

int scene_create_single(scene *s, const placement *p, const double centre[3], size_t *created, diag *d) {
    int status = check_placement(s, p, d);
    if (!status)
        status = flat_check_place(s, centre, d);
    if (status)
        return status;
    mark m = set_mark(s);
    gsl_rng *stream = rng_stream(s->rng, RNG_CREATE, m.next_id, 0);
    vec3 axis = draw_axis(s, p, stream);
    new_group g = add_group(s, p, p->species, draw_mass(p, stream), NAN);
    put_group(s, g, centre, axis, p->gap);
    if (!p->overlap && !group_has_room(s->colony, g, m.cells)) {
        return_to(s, m);
        diag_error(d, "the new cell would overlap one that is there");
        return diag_help(d, "move it, or write 'overlap yes'");
    }
    link_group(s, g);
    *created = g.n;
    return SARCINA_OK;
}

int scene_check_region(const region *where, diag *d) {
    const char *why = region_unbounded(where);
    if (!why)
        return SARCINA_OK;
    diag_error(d, "region %s has no bounds to draw places from: %s", where->name, why);
    return diag_help(d, "give it finite ends, and side in");
}

/* Draws places until there is one with room, and far enough from `apart` (NULL: anywhere); counts as one of the tries
 * what is too near. */
static bool find_place(scene *s, const placement *p, new_group g, const region *where, spots *apart, gsl_rng *stream) {
    for (int k = 0; k < p->maxtry; k++) {
        double point[3];
        (s->dimension == 2 ? region_draw_flat : region_draw)(where, stream, point);
        vec3 axis = draw_axis(s, p, stream);
        if (apart && !spots_are_free(apart, point))
            continue;
        put_group(s, g, point, axis, p->gap);
        if (!p->overlap && !group_has_room(s->colony, g, g.first))
            continue;
        if (apart)
            spots_add(apart, point);
        return true;
    }
    return false;
}

static int no_spot(size_t fitted, size_t wanted, const region *where, double spacing, int tries, diag *d) {
    diag_error(d, "%zu of %zu %s fitted into %s %.3g um apart, then %d tries found no place; none was created", fitted,
               wanted, number_noun(wanted, "cell", "cells"), where->name, spacing, tries);
    return diag_help(d, "take fewer cells, a smaller spacing, a larger region or a larger maxtry");
}

int scene_create_random(scene *s, const placement *p, size_t n, const region *where, double spacing, size_t *created,
                        diag *d) {
    int status = check_placement(s, p, d);
    if (!status)
        status = scene_check_region(where, d);
    if (!status)
        status = flat_check_region(s, where, d);
    if (status)
        return status;
    mark m = set_mark(s);
    spots *apart = spacing > 0 ? spots_create(n, spacing) : NULL;
    for (size_t i = 0; i < n; i++) {
        if (s->interrupt && *s->interrupt) {
            return_to(s, m);
            status = diag_fail(d, SARCINA_INTERRUPTED, "interrupted after %zu of %zu cells; none was created", i, n);
            break;
        }
        /* two streams a growth step: one that found no room is not tried again at the same places */
        gsl_rng *stream = rng_stream(s->rng, RNG_CREATE, s->colony->next_cell_id, 2 * s->growth_steps);
        double mass = draw_mass(p, stream);
        new_group g = add_group(s, p, p->species, mass, NAN);
        /* add_group has drawn from other streams: open this one again behind the mass */
        stream = rng_stream(s->rng, RNG_CREATE, s->colony->cell.id[g.first], 2 * s->growth_steps + 1);
        if (find_place(s, p, g, where, apart, stream)) {
            link_group(s, g);
            continue;
        }
        return_to(s, m);
        if (!p->may_fail)
            status = apart ? no_spot(i, n, where, spacing, p->maxtry, d) : no_room(i + 1, n, p->maxtry, d);
        break;
    }
    spots_free(apart);
    *created = s->colony->cell.count - m.cells;
    return status;
}

bool scene_create_arrival(scene *s, const placement *p, const region *where, uint64_t id, uint64_t step) {
    mark m = set_mark(s);
    double mass = draw_mass(p, rng_stream(s->rng, RNG_ATTACH, id, step));
    new_group g = add_group(s, p, p->species, mass, NAN);
    bool placed = find_place(s, p, g, where, NULL, rng_stream(s->rng, RNG_ATTACH, id + 1, step));
    if (!placed)
        return_to(s, m);
    return placed;
}

/* What a row knows beside its place: shape, particles, descent. */
static void restore_cell(scene *s, const cell_row *from, uint32_t row) {
    colony *c = s->colony;
    const species *sp = &s->species.list[from->species];
    if (from->aspect > 0 && c->cell.aspect[row] > 0) {
        c->cell.aspect[row] = from->aspect;
        species_shape_cell(sp, c, row);
        c->cell.limit[row] = division_limit(sp, s->rng, c->cell.id[row], c->cell.diameter[row], from->aspect);
    }
    for (uint32_t i = 0; i < from->nparticles; i++)
        for (int k = 0; k < 3; k++) {
            size_t at = 3 * ((size_t)c->cell.first[row] + i) + (size_t)k;
            c->particle.x[at] = from->particles[6 * i + (uint32_t)k];
            c->particle.v[at] = from->particles[6 * i + 3 + (uint32_t)k];
        }
    c->cell.parent[row] = from->parent;
    if (from->founder)
        c->cell.founder[row] = from->founder;
    c->cell.generation[row] = (int32_t)from->generation;
    c->cell.birth[row] = s->time - from->age;
    c->cell.groups[row] |= from->groups;
    memcpy(c->cell.frame + 4 * (size_t)row, from->frame, sizeof from->frame);
}

int scene_create_rows(scene *s, const placement *p, const cell_row *rows, size_t n, size_t *created, diag *d) {
    int status = check_placement(s, p, d);
    for (size_t i = 0; i < n && !status; i++) {
        status = check_filament(s, p, rows[i].species, d);
        if (!status)
            status = flat_check_row(s, &rows[i], d);
        if (!status && rows[i].nparticles && p->filament > 1)
            status = diag_error(d, "cell %zu has the places of its particles: it takes no filament", i + 1);
    }
    if (status)
        return status;
    mark m = set_mark(s);
    for (size_t i = 0; i < n; i++) {
        uint64_t next = s->colony->next_cell_id;
        s->colony->next_cell_id = rows[i].id ? rows[i].id : next;
        gsl_rng *stream = rng_stream(s->rng, RNG_CREATE, s->colony->next_cell_id, 0);
        vec3 axis = vec3_load(rows[i].axis);
        double length = vec3_norm(axis);
        axis = length > 0 ? vec3_scale(1 / length, axis) : draw_axis(s, p, stream);
        double mass = rows[i].mass > 0 ? rows[i].mass : draw_mass(p, stream);
        new_group g = add_group(s, p, rows[i].species, mass, rows[i].diameter);
        restore_cell(s, &rows[i], g.first); /* its aspect before its particles are put where that says */
        if (!rows[i].nparticles)
            put_group(s, g, rows[i].centre, axis, rows[i].on_plane && isnan(p->gap) ? 0 : p->gap);
        s->colony->next_cell_id = s->colony->next_cell_id > next ? s->colony->next_cell_id : next;
        if (!p->overlap && !group_has_room(s->colony, g, g.first)) {
            return_to(s, m);
            diag_error(d, "cell %zu of %zu would overlap another; none was created", i + 1, n);
            return diag_help(d, "write 'overlap yes' to allow it");
        }
        link_group(s, g);
    }
    *created = s->colony->cell.count - m.cells;
    return SARCINA_OK;
}

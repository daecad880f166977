/* SPDX-License-Identifier: GPL-3.0-or-later */
/* set GROUP KEY VALUE [where TEST]: a property of cells from a formula. */
#include "command/commands.h"

#include "command/session.h"

#include "base/alloc.h"
#include "base/table.h"
#include "biology/division.h"
#include "biology/growth.h"
#include "model/shape.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

typedef enum {
    KEY_X,
    KEY_Y,
    KEY_Z,
    KEY_VX,
    KEY_VY,
    KEY_VZ,
    KEY_MASS,
    KEY_DIAMETER,
    KEY_GENERATION,
    KEY_RATE,
    KEY_STIFFNESS,
    KEY_SPECIES
} set_key;

static const char *const dimensions[] = {"length", "length", "length", "velocity", "velocity", "velocity",
                                         "mass",   "length", "number", "rate",     "stiffness"};

static int check_value(const scene *s, set_key key, uint32_t row, double value, diag *d) {
    unsigned long long id = s->colony->cell.id[row];
    const species *sp = &s->species.list[s->colony->cell.species[row]];
    if (!isfinite(value))
        return diag_error(d, "the value of cell %llu is not finite", id);
    if ((key == KEY_MASS || key == KEY_DIAMETER || key == KEY_STIFFNESS) && !(value > 0))
        return diag_error(d, "the value of cell %llu must be more than 0", id);
    if (key == KEY_DIAMETER && s->colony->cell.aspect[row] > 0)
        return diag_error(d, "the diameter of cell %llu of %s follows from its mass (aspect)", id, sp->name);
    if (key == KEY_GENERATION && (value < 0 || value != floor(value) || value > INT32_MAX))
        return diag_error(d, "the generation of cell %llu must be a whole number from 0", id);
    if (key == KEY_RATE && (sp->growth.style < 0 || strcmp(growth_styles[sp->growth.style].name, "exponential") != 0))
        return diag_error(d, "cell %llu of %s has no rate to set: it does not grow exponentially", id, sp->name);
    if (key == KEY_STIFFNESS && !(sp->internal_k > 0))
        return diag_error(d, "cell %llu of %s has no spring inside to set (link internal)", id, sp->name);
    return SARCINA_OK;
}

/* Moves the whole cell so that its centre gets the coordinate. */
static void set_place(colony *c, uint32_t row, int axis, double value) {
    double centre[3];
    colony_centre(c, row, centre);
    double shift = value - centre[axis];
    for (uint32_t i = 0; i < c->cell.nparticles[row]; i++)
        c->particle.x[3 * ((size_t)c->cell.first[row] + i) + (size_t)axis] += shift;
}

static void set_value(scene *s, set_key key, uint32_t row, double value) {
    colony *c = s->colony;
    const species *sp = &s->species.list[c->cell.species[row]];
    switch (key) {
    case KEY_X:
    case KEY_Y:
    case KEY_Z:
        set_place(c, row, (int)(key - KEY_X), value);
        return;
    case KEY_VX:
    case KEY_VY:
    case KEY_VZ:
        for (uint32_t i = 0; i < c->cell.nparticles[row]; i++)
            c->particle.v[3 * ((size_t)c->cell.first[row] + i) + (size_t)(key - KEY_VX)] = value;
        return;
    case KEY_MASS:
        c->cell.mass[row] = value;
        break;
    case KEY_DIAMETER:
        if (sp->shape == SHAPE_COCCUS)
            c->cell.mass[row] = shape_coccus_mass(value, sp->density);
        else
            c->cell.diameter[row] = value;
        break;
    case KEY_GENERATION:
        c->cell.generation[row] = (int32_t)value;
        return;
    case KEY_RATE:
        c->cell.rate[row] = value;
        c->cell.own_rate[row] = 1;
        return;
    case KEY_STIFFNESS:
        c->cell.stiffness[row] = value;
        return;
    case KEY_SPECIES:
        return; /* set_species */
    }
    species_shape_cell(sp, c, row);
}

static int apply(interp *in, const args *a, const bool *flags, const double *si, dim seen, diag *d) {
    scene *s = interp_scene(in);
    set_key key = (set_key)args_choice(a, "KEY");
    dim wanted;
    dim_by_name(dimensions[key], &wanted);
    char got[48], due[48];
    if (s->dimension == 2 && (key == KEY_Z || key == KEY_VZ)) {
        diag_error(d, "%s stays 0 in a scene of two dimensions", args_text(a, "KEY"));
        return diag_help(d, "set x, y, vx and vy, or leave 'dimension 2' out");
    }
    bool plain = dim_is_none(seen) && !dim_is_none(wanted);
    if (!plain && !dim_equal(seen, wanted)) {
        diag_error(d, "%s is a %s, not a %s", args_text(a, "KEY"), dim_name(wanted, due), dim_name(seen, got));
        diag_place(d, args_span(a, "VALUE"));
        return SARCINA_ERROR;
    }
    double scale = plain ? interp_unit(in, wanted) : 1;
    int status = SARCINA_OK;
    for (uint32_t i = 0; i < s->colony->cell.count && !status; i++)
        if (flags[i])
            status = check_value(s, key, i, si[i] * scale, d);
    for (uint32_t i = 0; i < s->colony->cell.count && !status; i++)
        if (flags[i])
            set_value(s, key, i, dim_to_engine(si[i] * scale, wanted));
    scene_refresh_links(s); /* rest lengths follow sizes */
    s->colony->version++;
    return status;
}

/* The cell keeps its mass and particles, and becomes one of the species in size, law and limits. */
static void set_species(scene *s, uint32_t row, int to) {
    colony *c = s->colony;
    const species *sp = &s->species.list[to];
    c->cell.species[row] = to;
    c->cell.aspect[row] = 0;
    division_draw_size(sp, c, row, s->rng);
    species_shape_cell(sp, c, row);
    c->cell.limit[row] = division_limit(sp, s->rng, c->cell.id[row], c->cell.diameter[row], c->cell.aspect[row]);
}

static int apply_species(interp *in, const args *a, const bool *flags, diag *d) {
    scene *s = interp_scene(in);
    const char *name = expr_text(args_expr(a, "VALUE"));
    int to = species_find(&s->species, name), status = SARCINA_OK;
    if (to < 0)
        status = diag_error(d, "species takes the name of one, not '%s'", name);
    for (uint32_t i = 0; i < s->colony->cell.count && !status; i++) {
        const species *from = &s->species.list[s->colony->cell.species[i]];
        if (flags[i] && (from->shape != s->species.list[to].shape ||
                         species_particles(from) != species_particles(&s->species.list[to])))
            status = diag_error(d, "cell %llu of %s has another shape than the cells of %s, and keeps it",
                                (unsigned long long)s->colony->cell.id[i], from->name, name);
    }
    for (uint32_t i = 0; i < s->colony->cell.count && !status; i++)
        if (flags[i])
            set_species(s, i, to);
    if (status)
        diag_place(d, args_span(a, "VALUE"));
    scene_refresh_links(s); /* by the rules of the new species */
    s->colony->version++;
    return status;
}

static int run_set(interp *in, const args *a, diag *d) {
    size_t n = interp_scene(in)->colony->cell.count;
    bool *flags = alloc_zeroed(n, sizeof *flags), *where = alloc_zeroed(n, sizeof *where);
    double *si = alloc_zeroed(n, sizeof *si);
    dim seen = DIM_NONE;
    int status = session_members(in, args_row(a, "GROUP"), flags, d);
    if (!status && args_given(a, "where"))
        status = interp_flags(in, args_expr(a, "where"), where, d);
    for (size_t i = 0; i < n && args_given(a, "where"); i++)
        flags[i] = flags[i] && where[i];
    bool names_species = args_choice(a, "KEY") == KEY_SPECIES;
    if (!status && names_species)
        status = apply_species(in, a, flags, d);
    if (!status && !names_species)
        status = interp_cells(in, args_expr(a, "VALUE"), si, &seen, d);
    if (!status && !names_species)
        status = apply(in, a, flags, si, seen, d);
    free(flags);
    free(where);
    free(si);
    return status;
}

static const param params[] = {
    {"GROUP:group", "of these: all, a species, a region, a group"},
    {"KEY:{x|y|z|vx|vy|vz|mass|diameter|generation|rate|stiffness|species}",
     "what is set; x, y, z move the cell's centre"},
    {"VALUE:cell", "a formula per cell, one word; of species the name of one"},
    {"where:cellexpr", "only those for which this holds"},
};

static const command_form forms[] = {
    {"set GROUP:group KEY:{x|y|z|vx|vy|vz|mass|diameter|generation|rate|stiffness|species} VALUE:cell", params,
     TABLE_COUNT(params), "Sets a property of cells from a formula",
     "Every value is computed before the first is set. A cell whose species is set must have the shape of the new "
     "one; it keeps its mass, and grows, divides and is sized as its new kind. A rate or stiffness (of the spring "
     "inside a rod) that was set is the cell's own from then on, and its daughters'.",
     "set all z z+1um\nset all x 1.1*x\nset all y 0.9*y\nset all vx 0\nset all vy 0\nset all vz 1e-6\n"
     "set cf generation 0\nspecies pink coccus\nset cf species 'pink'\nset ecoli diameter 0.8um\nset ecoli mass "
     "1.1*mass where stage < 0.8\nset ecoli rate 0.6/1h\nset ecoli stiffness 1e-10N/1m",
     0, run_set, NULL, 0},
};

void command_set(command_table *t) {
    command_add(t, forms, TABLE_COUNT(forms));
}

/* SPDX-License-Identifier: GPL-3.0-or-later */
/* species NAME coccus|rod: shape, size, density, colour. */
#include "command/commands.h"

#include "base/build.h"
#include "base/table.h"
#include "biology/division.h"
#include "engine/flat.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

static size_t count_species(interp *in) {
    return interp_scene(in)->species.count;
}

static const char *get_species(interp *in, size_t i) {
    return interp_scene(in)->species.list[i].name;
}

static int species_members(interp *in, size_t i, const view *v, bool *flags, diag *d) {
    (void)in;
    (void)d;
    for (size_t row = 0; row < v->colony->cell.count; row++)
        flags[row] = (size_t)v->colony->cell.species[row] == i;
    return SARCINA_OK;
}

static const name_class species_class = {"species",     "a species", false,           true,
                                         count_species, get_species, species_members, NULL};

static bool has_cells(const scene *s, int row) {
    for (size_t i = 0; i < s->colony->cell.count; i++)
        if (s->colony->cell.species[i] == row)
            return true;
    return false;
}

static bool stands(interp *in, const args *a) {
    const scene *s = interp_scene(in);
    int row = species_find(&s->species, args_text(a, "NAME"));
    return row >= 0 && (int)s->species.list[row].shape == args_style(a);
}

static void amend_flexible(species *sp, const args *a, bool is_new) {
    sp->aspect = spread_fixed(0);
    if (args_given(a, "particles"))
        sp->particles = (uint32_t)args_int(a, "particles");
    if (is_new || args_given(a, "coil"))
        sp->coil.radius = args_number(a, "coil");
    if (args_given(a, "pitch"))
        sp->coil.pitch = args_number(a, "pitch");
    if (is_new || args_given(a, "hand"))
        sp->coil.left = args_choice(a, "hand") == 1;
}

/* A coil has a pitch, and a cell as many particles as before. */
static int check_flexible(const scene *s, int row, const species *sp, diag *d) {
    if (sp->shape != SHAPE_FLEXIBLE)
        return SARCINA_OK;
    if (sp->coil.radius > 0 && !(sp->coil.pitch > 0)) {
        diag_error(d, "species %s has a coil without a pitch", sp->name);
        return diag_help(d, "write 'pitch LENGTH', the height of one turn");
    }
    if (row >= 0 && s->species.list[row].particles != sp->particles && has_cells(s, row)) {
        diag_error(d, "species %s has cells: their number of particles cannot change", sp->name);
        return diag_help(d, "delete them before, or give the new shape another name");
    }
    return SARCINA_OK;
}

static void amend(species *sp, const args *a, bool is_new) {
    sp->shape = (shape_kind)args_style(a);
    if (is_new || args_given(a, "density"))
        sp->density = args_number(a, "density");
    if (args_given(a, "color"))
        snprintf(sp->color, sizeof sp->color, "%s", args_text(a, "color"));
    if (sp->shape != SHAPE_FLEXIBLE)
        sp->coil = (chain_coil){0};
    if (sp->shape == SHAPE_COCCUS) {
        sp->diameter = sp->aspect = spread_fixed(0);
        sp->internal_k = sp->bend_k = sp->twist_k = 0;
        return;
    }
    if (sp->shape == SHAPE_FLEXIBLE)
        amend_flexible(sp, a, is_new);
    /* one of the two is kept */
    if (args_given(a, "diameter")) {
        sp->diameter = args_spread(a, "diameter");
        sp->aspect = spread_fixed(0);
    }
    if (sp->shape == SHAPE_ROD && args_given(a, "aspect")) {
        sp->aspect = args_spread(a, "aspect");
        sp->diameter = spread_fixed(0);
    }
}

static int run_species(interp *in, const args *a, diag *d) {
    scene *s = interp_scene(in);
    const char *name = args_text(a, "NAME");
    int row = species_find(&s->species, name);
    int status = args_style(a) == SHAPE_FLEXIBLE ? build_check("flexible", d) : SARCINA_OK;
    if (status)
        return status;
    if (row < 0) {
        row = species_add(&s->species, name);
        amend(&s->species.list[row], a, true);
        status = check_flexible(s, -1, &s->species.list[row], d);
        if (!status)
            status = flat_check_species(s, &s->species.list[row], d);
        s->species.count -= status != SARCINA_OK;
        return status;
    }
    species changed = s->species.list[row];
    bool same_shape = (int)changed.shape == args_style(a);
    if (!same_shape && has_cells(s, row)) {
        diag_error(d, "species %s has cells: its shape cannot change", name);
        return diag_help(d, "delete them before, or give the new shape another name");
    }
    amend(&changed, a, !same_shape);
    if (!same_shape)
        changed.division.style = -1; /* a rule for another shape */
    status = check_flexible(s, row, &changed, d);
    return status ? status : scene_change_species(s, row, &changed, d);
}

static const param coccus_params[] = {
    {"density=1010kg/m3:density(0,)", "mass per volume of a cell"},
    {"color=auto:color", "in pictures; auto: by order"},
};
static const param rod_params[] = {
    {"diameter:length~!1(0,)", "of every cell, constant for life; with sd each cell draws its own"},
    {"aspect:number~!1(1,)", "or: total length over diameter, kept while the cell grows"},
    {"density=1010kg/m3:density(0,)", "mass per volume of a cell"},
    {"color=auto:color", "in pictures; auto: by order"},
};

static const param flexible_params[] = {
    {"diameter:length~!(0,)", "of every cell, constant for life; with sd each cell draws its own"},
    {"particles:int![3,10000]", "of each cell, whatever its length: segments grow with it"},
    {"coil=0:length[0,)", "radius of the helix that its particles form at rest; 0: it is straight"},
    {"pitch:length(0,)", "height of one turn of the helix; needed with coil"},
    {"hand=right:{right|left}", "of the helix"},
    {"density=1010kg/m3:density(0,)", "mass per volume of a cell"},
    {"color=auto:color", "in pictures; auto: by order"},
};

void command_species(command_table *t) {
    command_add_class(t, &species_class);
    const command_form common = {
        .details = "Naming a species again amends what is named; the shape may change while it has no "
                   "cells.",
        .flags = COMMAND_DECLARES,
        .run = run_species,
        .exists = stands};
    command_form coccus = common, rod = common, flexible = common;
    coccus.example = "species cc coccus density 1010kg/m3 color orange";
    rod.example = "species long rod diameter 0.75um sd 5% density 1010kg/m3 color blue\nspecies slim rod aspect 4";
    command_add_style(t, &coccus, "species NAME:+species coccus",
                      "A species of spheres, whose diameter follows their mass", coccus_params,
                      TABLE_COUNT(coccus_params), SHAPE_COCCUS);
    command_add_style(t, &rod, "species NAME:+species rod", "A species of rods: two particles and a spring", rod_params,
                      TABLE_COUNT(rod_params), SHAPE_ROD);
    flexible.details =
        "A chain of particles joined by springs (link internal), straight or coiled at rest; link bend and link twist "
        "hold it in shape. The length along it follows from the mass as that of a rod; radius and pitch of a coil stay "
        "as the cell grows. Half of a segment's mass is at each of its ends.";
    flexible.example = "species spiro flexible diameter 0.2um particles 32 coil 0.15um pitch 0.6um hand left density "
                       "1010kg/m3 color purple\nspecies bent flexible diameter 0.5um particles 5";
    command_add_style(t, &flexible, "species NAME:+species flexible", "A species of bent, coiled or pliant cells",
                      flexible_params, TABLE_COUNT(flexible_params), SHAPE_FLEXIBLE);
}

/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "engine/flat.h"

#include "biology/division.h"
#include "mechanics/force_style.h"

#include <math.h>

static int check_term(force_kind term, diag *d) {
    const force_style *style = force_styles[term];
    if (!(style->caps & FORCE_ALONG_Z))
        return SARCINA_OK;
    diag_error(d, "%s%s acts along z, and the scene has two dimensions", term == FORCE_SUBSTRATUM ? "" : "force ",
               style->name);
    return diag_help(d, "leave it out: cells cannot leave the plane z = 0; or leave 'dimension 2' out");
}

static int check_link(link_kind kind, diag *d) {
    if (kind != LINK_ANCHOR)
        return SARCINA_OK;
    diag_error(d, "link anchor holds cells to a substratum, and the scene has two dimensions");
    return diag_help(d, "leave it out, or leave 'dimension 2' out");
}

static int check_species(const species *sp, diag *d) {
    if (sp->shape == SHAPE_FLEXIBLE) {
        diag_error(d, "species %s is flexible, and the scene has two dimensions", sp->name);
        return diag_help(d, "flexible cells twist in space: leave 'dimension 2' out");
    }
    const char *why = division_leaves_plane(sp);
    if (!why)
        return SARCINA_OK;
    diag_error(d, "species %s divides %s, and the scene has two dimensions", sp->name, why);
    return diag_help(d, "in a plane: 'planes 1' or 'planes 2', and 'axis auto', 'axis x' or 'axis y'");
}

int flat_check_scene(const scene *s, diag *d) {
    int status = SARCINA_OK;
    for (int i = 0; i < FORCE_COUNT && !status; i++)
        if (s->forces.term[i].on)
            status = check_term((force_kind)i, d);
    if (!status && link_rules_any(&s->links, LINK_ANCHOR))
        status = check_link(LINK_ANCHOR, d);
    for (size_t i = 0; i < s->species.count && !status; i++)
        status = check_species(&s->species.list[i], d);
    for (size_t i = 0; i < s->attachments.count && !status; i++) {
        const scene flat = {.dimension = 2};
        const attachment *a = &s->attachments.list[i];
        status = flat_check_region(&flat, &a->where, d);
        if (!status)
            status = flat_check_orient(&flat, a->placement.orient, a->placement.axis, d);
    }
    return status;
}

int flat_check_term(const scene *s, force_kind term, diag *d) {
    return s->dimension == 2 ? check_term(term, d) : SARCINA_OK;
}

int flat_check_link(const scene *s, link_kind kind, diag *d) {
    return s->dimension == 2 ? check_link(kind, d) : SARCINA_OK;
}

int flat_check_species(const scene *s, const species *sp, diag *d) {
    return s->dimension == 2 ? check_species(sp, d) : SARCINA_OK;
}

int flat_check_region(const scene *s, const region *where, diag *d) {
    if (s->dimension != 2 || region_meets_plane(where))
        return SARCINA_OK;
    diag_error(d, "region %s does not meet the plane z = 0 of a scene of two dimensions", where->name);
    return diag_help(d, "cells are drawn from the part of the region where z is 0");
}

int flat_check_orient(const scene *s, orient_kind orient, const double axis[3], diag *d) {
    if (s->dimension != 2 || (orient != ORIENT_Z && (orient != ORIENT_VECTOR || axis[2] == 0)))
        return SARCINA_OK;
    diag_error(d, "the axis leads out of the plane z = 0 of a scene of two dimensions");
    return diag_help(d, "write 'orient x', 'orient y', 'orient xy' (random in the plane) or 'orient X Y 0'");
}

int flat_check_place(const scene *s, const double x[3], diag *d) {
    if (s->dimension != 2 || x[2] == 0)
        return SARCINA_OK;
    diag_error(d, "z is %g um, not in the plane z = 0 of a scene of two dimensions", x[2]);
    return diag_help(d, "write 0 for z, or leave 'dimension 2' out");
}

int flat_check_row(const scene *s, const cell_row *row, diag *d) {
    int status = flat_check_place(s, row->centre, d);
    if (!status)
        status = flat_check_orient(s, ORIENT_VECTOR, row->axis, d);
    for (uint32_t i = 0; i < row->nparticles && !status; i++) {
        status = flat_check_place(s, row->particles + (size_t)6 * i, d);
        if (!status && s->dimension == 2 && row->particles[(size_t)6 * i + 5] != 0)
            status = diag_error(d, "a velocity along z, and the scene has two dimensions");
    }
    return status;
}

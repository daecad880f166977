/* SPDX-License-Identifier: GPL-3.0-or-later */
/* link internal, bend, twist: what holds the cells of a species in shape. */
#include "command/commands.h"

#include "base/build.h"
#include "base/table.h"

static bool stands(interp *in, const args *a) {
    int row = args_row(a, "NAME");
    return row >= 0 && interp_scene(in)->species.list[row].internal_k > 0;
}

static int run_internal(interp *in, const args *a, diag *d) {
    scene *s = interp_scene(in);
    int status = build_check("internal", d);
    if (status)
        return status;
    double k = args_off(a) ? 0 : args_number(a, "k");
    s->colony->version++; /* the mechanics bind anew */
    if (args_all(a, "NAME")) {
        for (size_t i = 0; i < s->species.count; i++)
            if (s->species.list[i].shape != SHAPE_COCCUS)
                s->species.list[i].internal_k = k;
        return SARCINA_OK;
    }
    species *sp = &s->species.list[args_row(a, "NAME")];
    if (sp->shape == SHAPE_COCCUS) {
        diag_error(d, "species %s is a coccus: it has one particle and no internal spring", sp->name);
        return diag_help(d, "link internal is for rods and flexible cells; '*' means all of them");
    }
    if (args_off(a) || args_given(a, "k") || !(sp->internal_k > 0))
        sp->internal_k = k;
    return SARCINA_OK;
}

/* Constant and rest angle that a form sets. */
static double *constant_of(species *sp, const args *a) {
    return args_style(a) ? &sp->twist_k : &sp->bend_k;
}

static double *angle_of(species *sp, const args *a) {
    return args_style(a) ? &sp->twist_angle : &sp->bend_angle;
}

static bool angle_stands(interp *in, const args *a) {
    int row = args_row(a, "NAME");
    return row >= 0 && *constant_of(&interp_scene(in)->species.list[row], a) > 0;
}

static void set_angle(species *sp, const args *a) {
    double *k = constant_of(sp, a), *angle = angle_of(sp, a);
    bool is_new = !(*k > 0);
    if (args_off(a)) {
        *k = 0;
        return;
    }
    if (args_given(a, "k"))
        *k = args_number(a, "k");
    if (is_new || args_given(a, "angle"))
        *angle = args_number(a, "angle");
}

static int run_angle(interp *in, const args *a, diag *d) {
    scene *s = interp_scene(in);
    int status = build_check(args_style(a) ? "twist" : "bend", d);
    if (status)
        return status;
    for (size_t i = 0; i < s->species.count; i++)
        if (args_all(a, "NAME") && s->species.list[i].shape != SHAPE_COCCUS)
            set_angle(&s->species.list[i], a);
    if (args_all(a, "NAME"))
        return SARCINA_OK;
    species *sp = &s->species.list[args_row(a, "NAME")];
    if (sp->shape == SHAPE_COCCUS) {
        diag_error(d, "species %s is a coccus: it has one particle, which neither bends nor twists", sp->name);
        return diag_help(d, "link bend and link twist are for flexible cells; '*' means all of them");
    }
    set_angle(sp, a);
    return SARCINA_OK;
}

static const param bend_params[] = {
    {"NAME:species*", "a species of flexible cells, or * for every one so far"},
    {"k:bending!(0,)", "energy per angle squared: the bending stiffness EI over the length of a segment"},
    {"angle=shape:angle", "turning angle at rest, 0 straight; shape: that of the species' coil"},
};
static const param twist_params[] = {
    {"NAME:species*", "a species of flexible cells, or * for every one so far"},
    {"k:bending!(0,)", "energy per angle squared, for small twists"},
    {"angle=shape:angle", "torsion at rest, positive for a right-handed helix; shape: that of the species' coil"},
};

static const param internal_params[] = {
    {"NAME:species*", "a species of rods or flexible cells, or * for every one so far"},
    {"k=5e-11N/m:stiffness(0,)", "spring constant"},
};

static const command_form forms[] = {
    {"link internal NAME:species* @off", internal_params, TABLE_COUNT(internal_params),
     "The spring between neighbouring particles of a cell",
     "F = k (L - L_rest), energy k/2 (L - L_rest)^2, with L_rest from the cell's mass; a flexible cell has one spring "
     "a "
     "segment. A scene with rods or flexible cells needs it.",
     "link internal ecoli k 5e-11N/m", COMMAND_DECLARES, run_internal, stands, 0},
    {"link bend NAME:species* @off", bend_params, TABLE_COUNT(bend_params),
     "The resistance of flexible cells against bending",
     "Energy k/2 (theta - theta0)^2 at each inner particle, theta the turning angle between its two segments. A "
     "rod has no inner particle: it stays straight.",
     "species bent flexible diameter 0.5um particles 5\nlink bend bent k 1e-18N.m angle 20degree", COMMAND_DECLARES,
     run_angle, angle_stands, 0},
    {"link twist NAME:species* @off", twist_params, TABLE_COUNT(twist_params),
     "The resistance of flexible cells against twisting",
     "Energy k (1 - cos(phi - phi0)) for each four particles in a row, phi the torsion of their three segments; it "
     "fades "
     "out where two of them become parallel. Pitch and hand of a helix need it.",
     "species coiled flexible diameter 0.2um particles 32 coil 0.15um pitch 0.6um\nlink twist coiled k 1e-18N.m angle "
     "50degree",
     COMMAND_DECLARES, run_angle, angle_stands, 1},
};

void command_link(command_table *t) {
    command_add(t, forms, TABLE_COUNT(forms));
}

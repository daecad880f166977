/* SPDX-License-Identifier: GPL-3.0-or-later */
/* link internal: the spring inside each rod of a species. */
#include "command/commands.h"

#include "base/table.h"

static bool stands(interp *in, const args *a) {
    int row = args_row(a, "NAME");
    return row >= 0 && interp_scene(in)->species.list[row].internal_k > 0;
}

static int run_internal(interp *in, const args *a, diag *d) {
    scene *s = interp_scene(in);
    double k = args_off(a) ? 0 : args_number(a, "k");
    s->colony->version++; /* the mechanics bind anew */
    if (args_all(a, "NAME")) {
        for (size_t i = 0; i < s->species.count; i++)
            if (s->species.list[i].shape == SHAPE_ROD)
                s->species.list[i].internal_k = k;
        return SARCINA_OK;
    }
    species *sp = &s->species.list[args_row(a, "NAME")];
    if (sp->shape == SHAPE_COCCUS) {
        diag_error(d, "species %s is a coccus: it has one particle and no internal spring", sp->name);
        return diag_help(d, "link internal is for rods; '*' means all of them");
    }
    if (args_off(a) || args_given(a, "k") || !(sp->internal_k > 0))
        sp->internal_k = k;
    return SARCINA_OK;
}

static const param internal_params[] = {
    {"NAME:species*", "a species of rods, or * for every one so far"},
    {"k=5e-11N/m:stiffness(0,)", "spring constant"},
};

static const command_form forms[] = {
    {"link internal NAME:species* @off", internal_params, TABLE_COUNT(internal_params),
     "The spring between the two particles of a rod",
     "F = k (L - L_rest), energy k/2 (L - L_rest)^2, with L_rest from the cell's mass. A scene with rods needs it.",
     "link internal ecoli k 5e-11N/m", COMMAND_DECLARES, run_internal, stands, 0},
};

void command_link(command_table *t) {
    command_add(t, forms, TABLE_COUNT(forms));
}

/* SPDX-License-Identifier: GPL-3.0-or-later */
/* attach NAME REGION rate R ... | off: cells that arrive from the bulk. */
#include "command/commands.h"
#include "command/session.h"

#include "base/table.h"
#include "engine/flat.h"

#include <math.h>
#include <string.h>

static const attachment *find(interp *in, const args *a) {
    const scene *s = interp_scene(in);
    const char *where = s->regions.list[args_row(a, "REGION")].name;
    for (size_t i = 0; i < s->attachments.count; i++) {
        const attachment *at = &s->attachments.list[i];
        if (at->placement.species == args_row(a, "NAME") && strcmp(at->where.name, where) == 0)
            return at;
    }
    return NULL;
}

static bool stands(interp *in, const args *a) {
    return args_row(a, "NAME") >= 0 && args_row(a, "REGION") >= 0 && find(in, a);
}

/* Lays what the command names into an attachment; of a new one everything. */
static void amend(attachment *at, const args *a, bool is_new) {
    if (is_new || args_given(a, "rate"))
        at->rate = args_number(a, "rate");
    if (is_new || args_given(a, "orient"))
        at->placement.orient = args_orient(a, "orient", at->placement.axis);
    if (is_new || args_given(a, "overlap"))
        at->placement.overlap = args_flag(a, "overlap");
    if (is_new || args_given(a, "maxtry"))
        at->placement.maxtry = (int)args_int(a, "maxtry");
    if (is_new || args_given(a, "mass")) {
        at->placement.mass = args_spread(a, "mass");
        at->mass_is_part = !args_given(a, "mass") || args_percent(a, "mass");
    }
    at->placement.gap = NAN;
}

/* How often a species attaches elsewhere: said, lest it be taken for a change of place. */
static void tell_others(interp *in, const args *a) {
    const scene *s = interp_scene(in);
    size_t n = 0;
    for (size_t i = 0; i < s->attachments.count; i++)
        n += s->attachments.list[i].placement.species == args_row(a, "NAME");
    if (n > 1 && !interp_checking(in))
        interp_print(in, "%s attaches in %zu regions now", args_text(a, "NAME"), n);
}

static int run_attach(interp *in, const args *a, diag *d) {
    scene *s = interp_scene(in);
    const region *where = &s->regions.list[args_row(a, "REGION")];
    const attachment *old = find(in, a);
    attachment changed = old ? *old : (attachment){.placement = {.species = args_row(a, "NAME")}};
    amend(&changed, a, !old);
    int status = scene_check_region(where, d);
    if (!status)
        status = flat_check_region(s, where, d);
    if (status)
        diag_place(d, args_span(a, "REGION"));
    if (!status && changed.placement.orient == ORIENT_VECTOR) {
        const double *u = changed.placement.axis;
        if (!(hypot(u[0], hypot(u[1], u[2])) > 0))
            status = diag_error(d, "orient 0 0 0 is no direction");
    }
    if (status)
        return status;
    attachment *at = scene_attach(s, args_row(a, "NAME"), where);
    changed.where = at->where;
    changed.serial = at->serial;
    *at = changed;
    if (!old)
        tell_others(in, a);
    return SARCINA_OK;
}

static int run_off(interp *in, const args *a, diag *d) {
    (void)d;
    scene_attach_off(interp_scene(in), args_row(a, "NAME"));
    return SARCINA_OK;
}

static const param attach_params[] = {
    {"NAME:species", "whose cells"},
    {"REGION:region", "where their centres are drawn"},
    {"rate:rate!(0,)",
     "cells per growth time: their number in a growth step DT is Poisson distributed, of mean rate DT"},
    {"orient=random:orient", "axis: a letter, in the plane (xy), drawn (random), or three numbers"},
    {"mass=50%:mass%~(0,1e-9kg)", "of each cell; a percent is of the mass at division, as it is then"},
    {"overlap=no:flag", "may it overlap what is there?"},
    {"maxtry=1000:int[1,1000000000]", "places drawn for a cell before it goes past"},
};
static const param off_params[] = {{"NAME:species", "the species"}};

static const command_form forms[] = {
    {.head = "attach NAME:species REGION:region",
     .params = attach_params,
     .nparams = TABLE_COUNT(attach_params),
     .summary = "New cells arrive in a region at a rate",
     .details = "They come in the growth step of every cycle, and of 'grow', after the divisions and before the "
                "relaxation. A cell that finds no place is left out; a run says at its end how many were. The same "
                "species and region again amends what is named; another region is a second place of arrival.",
     .example = "attach ecoli box rate 6/h orient xy mass uniform 50% 100% overlap no maxtry 100",
     .flags = COMMAND_DECLARES,
     .run = run_attach,
     .exists = stands},
    {.head = "attach NAME:species off",
     .params = off_params,
     .nparams = TABLE_COUNT(off_params),
     .summary = "Cells of the species arrive no longer",
     .details = "In no region.",
     .example = "attach ecoli off",
     .flags = COMMAND_DECLARES,
     .run = run_off},
};

void command_attach(command_table *t) {
    command_add(t, forms, TABLE_COUNT(forms));
}

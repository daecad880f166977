/* SPDX-License-Identifier: GPL-3.0-or-later */
/* division NAME RULE ... | off, from the table of rules. */
#include "command/commands.h"

#include "command/style_values.h"

#include "base/alloc.h"
#include "biology/division.h"

#include <math.h>
#include <stdlib.h>

static species *named_species(interp *in, const args *a) {
    return &interp_scene(in)->species.list[args_row(a, "NAME")];
}

static bool stands(interp *in, const args *a) {
    return args_row(a, "NAME") >= 0 && named_species(in, a)->division.style == args_style(a);
}

static int run_division(interp *in, const args *a, diag *d) {
    scene *s = interp_scene(in);
    int row = args_row(a, "NAME");
    species changed = s->species.list[row];
    const division_style *style = division_styles[args_style(a)];
    style_choice *rule = &changed.division;
    bool amending = rule->style == args_style(a);
    style_values(a, style->params, style->nparams, amending, rule->values);
    rule->style = args_style(a);
    /* mass or size: the one named last counts */
    if (args_given(a, "mass"))
        rule->values[DIVISION_SIZE] = spread_fixed(NAN);
    else if (args_given(a, s->species.list[row].shape == SHAPE_COCCUS ? "diameter" : "length"))
        rule->values[DIVISION_MASS] = spread_fixed(NAN);
    return scene_change_species(s, row, &changed, d);
}

static int run_off(interp *in, const args *a, diag *d) {
    species changed = *named_species(in, a);
    changed.division.style = -1;
    return scene_change_species(interp_scene(in), args_row(a, "NAME"), &changed, d);
}

static const param off_params[] = {{"NAME:species", "the species"}};
static const command_form off_form = {"division NAME:species off",
                                      off_params,
                                      1,
                                      "Cells of the species no longer divide",
                                      NULL,
                                      "division ecoli off",
                                      COMMAND_DECLARES,
                                      run_off,
                                      NULL,
                                      0};

void command_division(command_table *t) {
    for (size_t i = 0; i < division_style_count; i++) {
        const division_style *s = division_styles[i];
        const command_form common = {
            .example = s->example, .flags = COMMAND_DECLARES, .run = run_division, .exists = stands};
        char *head = alloc_format("division NAME:species %s", s->head);
        command_add_style(t, &common, head, s->summary, s->params, s->nparams, (int)i);
        command_cite(t, NULL, s->source);
        free(head);
    }
    command_add(t, &off_form, 1);
}

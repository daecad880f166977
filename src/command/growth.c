/* SPDX-License-Identifier: GPL-3.0-or-later */
/* growth NAME LAW ... | off, from the table of laws. */
#include "command/commands.h"

#include "command/style_values.h"

#include "base/alloc.h"
#include "biology/growth.h"

#include <stdlib.h>

static species *named_species(interp *in, const args *a) {
    return &interp_scene(in)->species.list[args_row(a, "NAME")];
}

static bool stands(interp *in, const args *a) {
    return args_row(a, "NAME") >= 0 && named_species(in, a)->growth.style == args_style(a);
}

static int run_growth(interp *in, const args *a, diag *d) {
    (void)d;
    style_choice *law = &named_species(in, a)->growth;
    const growth_style *style = &growth_styles[args_style(a)];
    style_values(a, style->params, style->nparams, law->style == args_style(a), law->values);
    law->style = args_style(a);
    return SARCINA_OK;
}

static int run_off(interp *in, const args *a, diag *d) {
    (void)d;
    named_species(in, a)->growth.style = -1;
    return SARCINA_OK;
}

static const param off_params[] = {{"NAME:species", "the species"}};
static const command_form off_form = {"growth NAME:species off",
                                      off_params,
                                      1,
                                      "Cells of the species no longer grow",
                                      NULL,
                                      "growth ecoli off",
                                      COMMAND_DECLARES,
                                      run_off,
                                      NULL,
                                      0};

void command_growth(command_table *t) {
    for (size_t i = 0; i < growth_style_count; i++) {
        const growth_style *s = &growth_styles[i];
        const command_form common = {
            .example = s->example, .flags = COMMAND_DECLARES, .run = run_growth, .exists = stands};
        char *head = alloc_format("growth NAME:species %s", s->name);
        command_add_style(t, &common, head, s->summary, s->params, s->nparams, (int)i);
        command_cite(t, s->formula, s->source);
        free(head);
    }
    command_add(t, &off_form, 1);
}

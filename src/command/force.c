/* SPDX-License-Identifier: GPL-3.0-or-later */
/* force TERM ... | off and substratum plane ... | off, from the table of force terms. */
#include "command/commands.h"

#include "command/style_values.h"

#include "base/alloc.h"
#include "base/build.h"
#include "engine/flat.h"
#include "mechanics/force_style.h"

#include <stdlib.h>
#include <string.h>

static bool stands(interp *in, const args *a) {
    return interp_scene(in)->forces.term[args_style(a)].on;
}

static int run_force(interp *in, const args *a, diag *d) {
    int status = build_check(force_styles[args_style(a)]->name, d);
    if (!status && !args_off(a))
        status = flat_check_term(interp_scene(in), (force_kind)args_style(a), d);
    if (status)
        return status;
    force_settings *term = &interp_scene(in)->forces.term[args_style(a)];
    if (args_off(a)) {
        term->on = false;
        return SARCINA_OK;
    }
    const force_style *style = force_styles[args_style(a)];
    style_values_read(a, style->params, style->nparams, term->on, term->p);
    term->on = true;
    return SARCINA_OK;
}

static int run_substratum_off(interp *in, const args *a, diag *d) {
    (void)a;
    (void)d;
    interp_scene(in)->forces.term[FORCE_SUBSTRATUM].on = false;
    return SARCINA_OK;
}

static const command_form substratum_off = {
    "substratum off",   NULL, 0, "Takes the substratum out", NULL, "substratum off", COMMAND_DECLARES,
    run_substratum_off, NULL, 0};

void command_force(command_table *t) {
    for (int i = 0; i < FORCE_COUNT; i++) {
        const force_style *s = force_styles[i];
        bool is_substratum = i == FORCE_SUBSTRATUM;
        if (!is_substratum && (!s->command || strcmp(s->command, "force") != 0))
            continue;
        const command_form common = {
            .example = s->example, .flags = COMMAND_DECLARES, .run = run_force, .exists = stands};
        const char *rest = build_lacks(s->name) ? " PARAMETERS:rest?" : is_substratum ? "" : " @off";
        char *head = alloc_format("%s %s%s", s->command, is_substratum ? "plane" : s->name, rest);
        command_add_style(t, &common, head, s->summary, s->params, s->nparams, i);
        command_cite(t, s->formula, s->source);
        free(head);
    }
    command_add(t, &substratum_off, 1);
}

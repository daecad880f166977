/* SPDX-License-Identifier: GPL-3.0-or-later */
/* link filial, stick, anchor, remodel: the rules by which cells are linked to each other and to the substratum. */
#include "command/commands.h"

#include "command/style_values.h"

#include "base/alloc.h"
#include "base/build.h"
#include "base/number.h"
#include "base/table.h"
#include "engine/flat.h"
#include "model/link.h"

#include <stdlib.h>

/* The species a word stands for: one, or all of them. */
typedef struct span_of_species {
    int begin, end;
} span_of_species;

static span_of_species named(interp *in, const args *a, const char *name) {
    if (args_all(a, name))
        return (span_of_species){0, (int)interp_scene(in)->species.count};
    int row = args_row(a, name);
    return (span_of_species){row, row < 0 ? row : row + 1};
}

/* Calls `each` for every species or pair of species the command names; stops at the first false, and gives it. */
static bool for_each(interp *in, const args *a, bool (*each)(scene *s, const args *a, int first, int second)) {
    scene *s = interp_scene(in);
    bool pairs = link_rules_styles[args_style(a)].pairs;
    span_of_species first = named(in, a, pairs ? "A" : "NAME"), second = pairs ? named(in, a, "B") : first;
    for (int i = first.begin; i < first.end; i++)
        for (int j = pairs ? second.begin : i; j < (pairs ? second.end : i + 1); j++)
            if (!each(s, a, i, j))
                return false;
    return true;
}

static bool has_rule(scene *s, const args *a, int first, int second) {
    return link_rules_find(&s->links, (link_kind)args_style(a), first, second);
}

static bool stands(interp *in, const args *a) {
    return interp_scene(in)->species.count > 0 && for_each(in, a, has_rule);
}

static bool set_rule(scene *s, const args *a, int first, int second) {
    link_kind kind = (link_kind)args_style(a);
    const link_style *style = &link_rules_styles[kind];
    const link_rule *old = link_rules_find(&s->links, kind, first, second);
    link_rule rule = old ? *old : (link_rule){.on = true};
    if (args_off(a))
        rule.on = false;
    else
        style_values_read(a, style->params, style->nparams, old != NULL, rule.p);
    link_rules_set(&s->links, kind, first, second, &rule);
    return true;
}

/* A link needs its springs' force and, where it forms by nearness, what looks for that. */
static int check_build(link_kind kind, diag *d) {
    int status = build_check(link_rules_styles[kind].name, d);
    if (!status)
        status = build_check("springs", d);
    return status || kind == LINK_FILIAL ? status : build_check("remodel", d);
}

static int run_rule(interp *in, const args *a, diag *d) {
    scene *s = interp_scene(in);
    int status = check_build((link_kind)args_style(a), d);
    if (!status && !args_off(a))
        status = flat_check_link(s, (link_kind)args_style(a), d);
    if (status)
        return status;
    for_each(in, a, set_rule);
    if (args_off(a))
        link_drop_unruled(s->colony, &s->links, (link_kind)args_style(a));
    scene_refresh_links(s);
    return SARCINA_OK;
}

static int run_remodel(interp *in, const args *a, diag *d) {
    int status = build_check("remodel", d);
    if (status)
        return status;
    if (args_given(a, "every"))
        interp_scene(in)->links.every = args_number(a, "every");
    return SARCINA_OK;
}

static int run_stick_now(interp *in, const args *a, diag *d) {
    (void)a;
    size_t formed;
    int status = scene_stick(interp_scene(in), &formed, d);
    if (!status)
        interp_print(in, "formed %zu sticking %s", formed, number_noun(formed, "link", "links"));
    return status;
}

static const param remodel_params[] = {
    {"every=5ms:time[0,)", "time of relaxation between looks; 0: after every accepted step"},
};

static const command_form forms[] = {
    {"link remodel", remodel_params, TABLE_COUNT(remodel_params),
     "How often links form and break while a colony relaxes",
     "At the beginning of each relaxation and then at fixed times, which the steps of the integrator end at: so what "
     "forms and breaks does not depend on how exactly the motion is solved. 'every 0' looks after every accepted step, "
     "as published, and not before the first: a link that a division has stretched pulls for one step. What forms then "
     "depends on the step. A link breaks as a whole when one of its springs is longer "
     "than its rest length by more than 'break'; what has broken may form again at the next time.",
     "link remodel every 5ms", COMMAND_DECLARES, run_remodel, NULL, 0},
    {"link stick now", NULL, 0, "Sticks at once the cells that are near enough",
     "As the beginning of a relaxation would, without one: by the rules of 'link stick A B'.",
     "link stick ecoli cf\nlink stick now", 0, run_stick_now, NULL, 0},
};

void command_link_between(command_table *t) {
    for (int kind = 0; kind < LINK_STYLES; kind++) {
        const link_style *s = &link_rules_styles[kind];
        const command_form common = {
            .details = s->details, .example = s->example, .flags = COMMAND_DECLARES, .run = run_rule, .exists = stands};
        char *head = s->pairs ? alloc_format("link %s A:species* B:species* @off", s->name)
                              : alloc_format("link %s NAME:species* @off", s->name);
        command_add_style(t, &common, head, s->summary, s->params, s->nparams, kind);
        free(head);
    }
    command_add(t, forms, TABLE_COUNT(forms));
}

/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "command/info_lists.h"

#include "command/output_list.h"
#include "command/session.h"

#include "base/alloc.h"
#include "base/number.h"
#include "base/table.h"

#include <inttypes.h>
#include <stdlib.h>
#include <string.h>

static void show_groups(interp *in) {
    const scene *s = interp_scene(in);
    const session *own = session_of(in);
    for (int bit = 0; bit < GROUP_MAX; bit++) {
        size_t n = 0;
        for (uint32_t row = 0; row < s->colony->cell.count; row++)
            n += group_has(s->colony, row, bit);
        if (*s->groups.name[bit])
            interp_print(in, "group       %s: %zu of %zu %s", s->groups.name[bit], n, s->colony->cell.count,
                         number_noun(s->colony->cell.count, "cell", "cells"));
    }
    for (size_t i = 0; i < own->ndynamic; i++)
        interp_print(in, "group       %s: dynamic %s", own->dynamic[i].name, expr_text(own->dynamic[i].test));
    interp_print(in, "groups too  all, every species and every region");
}

static void show_regions(interp *in) {
    static const char *const kinds[] = {"block", "sphere", "cylinder", "plane"}, *const axes[] = {" x", " y", " z"};
    static const int numbers[] = {6, 4, 5, 6};
    const scene *s = interp_scene(in);
    for (size_t i = 0; i < s->regions.count; i++) {
        const region *r = &s->regions.list[i];
        char text[200] = "";
        for (int k = 0, used = 0; k < numbers[r->kind]; k++)
            used += snprintf(text + used, sizeof text - (size_t)used, " %g", r->p[k]);
        interp_print(in, "region      %s: %s%s%s%s (um)", r->name, kinds[r->kind],
                     r->kind == REGION_CYLINDER ? axes[r->axis] : "", text, r->outside ? " side out" : "");
    }
    for (size_t i = 0; i < s->attachments.count; i++) {
        const attachment *a = &s->attachments.list[i];
        interp_print(in, "attach      %s in %s, %g/h", s->species.list[a->placement.species].name, a->where.name,
                     3600 * a->rate);
    }
    if (s->regions.count == 0)
        interp_print(in, "no regions");
}

static void show_dumps(interp *in) {
    const outputs *o = session_of(in)->out;
    for (size_t i = 0; i < o->ndumps; i++)
        interp_print(in, "dump        %s of %s to %s", o->dumps[i].id, o->dumps[i].group,
                     dump_pattern(o->dumps[i].file));
    if (o->ndumps == 0)
        interp_print(in, "no dumps");
}

static void show_analyses(interp *in) {
    const outputs *o = session_of(in)->out;
    for (size_t i = 0; i < o->nanalyses; i++)
        interp_print(in, "analysis    %s of %s", o->analyses[i].id, o->analyses[i].group);
    if (o->nanalyses == 0)
        interp_print(in, "no analyses");
}

/* As restart files keep them, a line each. */
static void show_variables(interp *in) {
    char *all = interp_variables_list(in), *save;
    for (char *line = strtok_r(all, "\n", &save); line; line = strtok_r(NULL, "\n", &save))
        interp_print(in, "variable    %s", line);
    if (!*all)
        interp_print(in, "no variables");
    free(all);
}

static const struct {
    const char *name;
    void (*show)(interp *in);
} lists[] = {{"groups", show_groups},
             {"regions", show_regions},
             {"variables", show_variables},
             {"dumps", show_dumps},
             {"analyses", show_analyses}};

bool info_lists_show(interp *in, const char *topic) {
    ptrdiff_t row = table_find(lists, TABLE_COUNT(lists), sizeof *lists, topic);
    if (row >= 0)
        lists[row].show(in);
    return row >= 0;
}

const char *info_lists_topics(void) {
    return "groups, regions, variables, dumps, analyses";
}

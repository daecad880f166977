/* SPDX-License-Identifier: GPL-3.0-or-later */
/* region ID block|sphere ... | off; the groups all, one a species, and one a region (the cells inside it now). */
#include "command/commands.h"
#include "command/session.h"

#include "base/table.h"

#include <string.h>

static size_t count_regions(interp *in) {
    return interp_scene(in)->regions.count;
}

static const char *get_region(interp *in, size_t i) {
    return interp_scene(in)->regions.list[i].name;
}

static int region_members(interp *in, size_t i, const view *v, bool *flags, diag *d) {
    (void)d;
    const region *r = &interp_scene(in)->regions.list[i];
    for (uint32_t row = 0; row < v->colony->cell.count; row++) {
        double centre[3];
        colony_centre(v->colony, row, centre);
        flags[row] = region_contains(r, centre);
    }
    return SARCINA_OK;
}

static const name_class region_class = {"region",      "a region", false,          false,
                                        count_regions, get_region, region_members, NULL};

/* Groups: row 0 is all, then the species, then the regions. Their names belong to those classes: `free` here. */
static size_t count_groups(interp *in) {
    const scene *s = interp_scene(in);
    return 1 + s->species.count + s->regions.count;
}

static const char *get_group(interp *in, size_t i) {
    const scene *s = interp_scene(in);
    if (i == 0)
        return "all";
    return i <= s->species.count ? s->species.list[i - 1].name : s->regions.list[i - 1 - s->species.count].name;
}

int session_group_members(interp *in, size_t i, const view *v, bool *flags, diag *d) {
    size_t nspecies = interp_scene(in)->species.count;
    if (i > nspecies)
        return region_members(in, i - 1 - nspecies, v, flags, d);
    for (size_t row = 0; row < v->colony->cell.count; row++)
        flags[row] = i == 0 || (size_t)v->colony->cell.species[row] == i - 1;
    return SARCINA_OK;
}

static const name_class group_class = {"group", "a group", true, true, count_groups, get_group, session_group_members,
                                       NULL};

static int empty_interval(char axis, diag *d) {
    return diag_error(d, "the block is empty: %cLO is not below %cHI", axis, axis);
}

static int run_region(interp *in, const args *a, diag *d) {
    static const char *const block_names[] = {"XLO", "XHI", "YLO", "YHI", "ZLO", "ZHI"};
    static const char *const sphere_names[] = {"X", "Y", "Z", "R"};
    region r = {.kind = (region_kind)args_style(a), .outside = args_choice(a, "side") == 1};
    if (r.kind == REGION_BLOCK) {
        for (int i = 0; i < 6; i++)
            r.p[i] = args_number(a, block_names[i]);
        for (int i = 0; i < 3; i++)
            if (!(r.p[2 * i] < r.p[2 * i + 1]))
                return empty_interval((char)('X' + i), d);
    } else {
        for (int i = 0; i < 4; i++)
            r.p[i] = args_number(a, sphere_names[i]);
    }
    region *to = region_add(&interp_scene(in)->regions, args_text(a, "ID"));
    memcpy(r.name, to->name, sizeof r.name);
    *to = r;
    return SARCINA_OK;
}

static int run_off(interp *in, const args *a, diag *d) {
    (void)d;
    region_remove(&interp_scene(in)->regions, args_row(a, "ID"));
    return SARCINA_OK;
}

static const param block_params[] = {
    {"ID:+region", "its name"},
    {"XLO:bound", "lower end along x, or -INF"},
    {"XHI:bound", "upper end along x, or INF"},
    {"YLO:bound", "lower end along y"},
    {"YHI:bound", "upper end along y"},
    {"ZLO:bound", "lower end along z"},
    {"ZHI:bound", "upper end along z"},
    {"side=in:{in|out}", "out: everything but this"},
};
static const param sphere_params[] = {
    {"ID:+region", "its name"}, {"X:length", "centre"},     {"Y:length", "centre"},
    {"Z:length", "centre"},     {"R:length(0,)", "radius"}, {"side=in:{in|out}", "out: everything but this"},
};
static const param off_params[] = {{"ID:region", "the region to forget"}};

void command_region(command_table *t) {
    command_add_class(t, &region_class);
    command_add_class(t, &group_class);
    const char *about = "A region is a place to create cells in, and a group of the cells whose centre is inside.";
    const command_form block = {.details = about,
                                .example = "region half block -INF 0 INF INF 0 INF side in",
                                .flags = COMMAND_DECLARES,
                                .run = run_region};
    command_form sphere = block;
    sphere.example = "region drop sphere 0 0 5um 5um side out";
    command_add_style(t, &block, "region ID:+region block XLO:bound XHI:bound YLO:bound YHI:bound ZLO:bound ZHI:bound",
                      "A block of space", block_params, TABLE_COUNT(block_params), REGION_BLOCK);
    command_add_style(t, &sphere, "region ID:+region sphere X:length Y:length Z:length R:length(0,)", "A ball of space",
                      sphere_params, TABLE_COUNT(sphere_params), REGION_SPHERE);
    static const command_form off = {"region ID:region off",
                                     off_params,
                                     1,
                                     "Forgets a region",
                                     NULL,
                                     "region box off",
                                     COMMAND_DECLARES,
                                     run_off,
                                     NULL,
                                     0};
    command_add(t, &off, 1);
}

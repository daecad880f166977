/* SPDX-License-Identifier: GPL-3.0-or-later */
/* region ID block|sphere|cylinder|plane ... | off. */
#include "command/commands.h"
#include "command/session.h"

#include "base/table.h"

#include <math.h>
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

/* Each shape lays its arguments into p. */
static int read_block(const args *a, region *r, diag *d) {
    static const char *const names[] = {"XLO", "XHI", "YLO", "YHI", "ZLO", "ZHI"};
    for (int i = 0; i < 6; i++)
        r->p[i] = args_number(a, names[i]);
    for (int i = 0; i < 3; i++)
        if (r->p[2 * i] > r->p[2 * i + 1]) {
            diag_error(d, "the block is empty: %s is above %s", names[2 * i], names[2 * i + 1]);
            return diag_help(d, "the lower end stands first; two ends that are equal make a flat block");
        }
    return SARCINA_OK;
}

static int read_sphere(const args *a, region *r, diag *d) {
    static const char *const names[] = {"X", "Y", "Z", "R"};
    (void)d;
    for (int i = 0; i < 4; i++)
        r->p[i] = args_number(a, names[i]);
    return SARCINA_OK;
}

static int read_cylinder(const args *a, region *r, diag *d) {
    static const char *const names[] = {"C1", "C2", "R", "LO", "HI"};
    r->axis = args_choice(a, "AXIS");
    for (int i = 0; i < 5; i++)
        r->p[i] = args_number(a, names[i]);
    if (r->p[3] <= r->p[4])
        return SARCINA_OK;
    diag_error(d, "the cylinder is empty: LO is above HI");
    return diag_help(d, "the lower end stands first; two ends that are equal make a disc");
}

static int read_plane(const args *a, region *r, diag *d) {
    static const char *const names[] = {"PX", "PY", "PZ", "NX", "NY", "NZ"};
    for (int i = 0; i < 6; i++)
        r->p[i] = args_number(a, names[i]);
    double length = hypot(r->p[3], hypot(r->p[4], r->p[5]));
    if (!(length > 0))
        return diag_error(d, "the normal 0 0 0 of the plane is no direction");
    for (int i = 3; i < 6; i++)
        r->p[i] /= length;
    return SARCINA_OK;
}

static int run_region(interp *in, const args *a, diag *d) {
    static int (*const readers[])(const args *, region *, diag *) = {
        [REGION_BLOCK] = read_block,
        [REGION_SPHERE] = read_sphere,
        [REGION_CYLINDER] = read_cylinder,
        [REGION_PLANE] = read_plane,
    };
    region r = {.kind = (region_kind)args_style(a), .outside = args_choice(a, "side") == 1};
    int status = readers[r.kind](a, &r, d);
    if (status)
        return status;
    region *to = region_add(&interp_scene(in)->regions, args_text(a, "ID"));
    memcpy(r.name, to->name, sizeof r.name);
    *to = r;
    return SARCINA_OK;
}

/* What still needs the region stops its going. */
static int run_off(interp *in, const args *a, diag *d) {
    int status = session_check_unused(in, "region", args_text(a, "ID"), d);
    if (!status)
        region_remove(&interp_scene(in)->regions, args_row(a, "ID"));
    return status;
}

#define SIDE                                                                                                           \
    { "side=in:{in|out}", "out: everything but this" }
static const param block_params[] = {
    {"ID:+region", "its name"},
    {"XLO:bound", "lower end along x, or -INF"},
    {"XHI:bound", "upper end along x, or INF"},
    {"YLO:bound", "lower end along y"},
    {"YHI:bound", "upper end along y"},
    {"ZLO:bound", "lower end along z"},
    {"ZHI:bound", "upper end along z"},
    SIDE,
};
static const param sphere_params[] = {
    {"ID:+region", "its name"},      {"X:length", "x of its centre"}, {"Y:length", "y of its centre"},
    {"Z:length", "z of its centre"}, {"R:length(0,)", "radius"},      SIDE,
};
static const param cylinder_params[] = {
    {"ID:+region", "its name"},
    {"AXIS:{x|y|z}", "the direction it runs in"},
    {"C1:length", "where its axis is: y (axis x) or x (axis y, z)"},
    {"C2:length", "where its axis is: z (axis x, y) or y (axis z)"},
    {"R:length(0,)", "radius"},
    {"LO:bound", "lower end along the axis, or -INF"},
    {"HI:bound", "upper end along the axis, or INF"},
    SIDE,
};
static const param plane_params[] = {
    {"ID:+region", "its name"},
    {"PX:length", "x of a point of the plane"},
    {"PY:length", "y of that point"},
    {"PZ:length", "z of that point"},
    {"NX:number", "x of the normal, which points into the region; any length"},
    {"NY:number", "y of the normal"},
    {"NZ:number", "z of the normal"},
    SIDE,
};
static const param off_params[] = {{"ID:region", "the region to forget"}};

static const struct {
    region_kind kind;
    const char *head, *summary, *example;
    const param *params;
    size_t nparams;
} styles[] = {
    {REGION_BLOCK, "region ID:+region block XLO:bound XHI:bound YLO:bound YHI:bound ZLO:bound ZHI:bound",
     "A block of space", "region half block -INF 0 INF INF 0 INF side in", block_params, TABLE_COUNT(block_params)},
    {REGION_SPHERE, "region ID:+region sphere X:length Y:length Z:length R:length(0,)", "A ball of space",
     "region bulk sphere 0 0 5um 5um side out", sphere_params, TABLE_COUNT(sphere_params)},
    {REGION_CYLINDER, "region ID:+region cylinder AXIS:{x|y|z} C1:length C2:length R:length(0,) LO:bound HI:bound",
     "A cylinder along one of the axes",
     "region spot cylinder z 0 0 5um 0 1um side in\nregion pipe cylinder x 0 1um 5um -INF INF\n"
     "region duct cylinder y 0 1um 5um -INF INF",
     cylinder_params, TABLE_COUNT(cylinder_params)},
    {REGION_PLANE, "region ID:+region plane PX:length PY:length PZ:length NX:number NY:number NZ:number",
     "The half of space on one side of a plane", "region above plane 0 0 1um 0 0 1 side in", plane_params,
     TABLE_COUNT(plane_params)},
};

void command_region(command_table *t) {
    command_add_class(t, &region_class);
    for (size_t i = 0; i < TABLE_COUNT(styles); i++) {
        const command_form form = {
            .details = "A region is a place to create cells in, and a group of the cells whose centre is inside at "
                       "that moment; its surface belongs to it. Cells can be created only in a region with bounds: "
                       "not in a plane's, beyond an end at INF, nor with side out. A flat one will do.",
            .example = styles[i].example,
            .flags = COMMAND_DECLARES,
            .run = run_region};
        command_add_style(t, &form, styles[i].head, styles[i].summary, styles[i].params, styles[i].nparams,
                          (int)styles[i].kind);
    }
    static const command_form off = {.head = "region ID:region off",
                                     .params = off_params,
                                     .nparams = 1,
                                     .summary = "Forgets a region",
                                     .details =
                                         "Refused while something still uses it: an attach, a dump, an analysis.",
                                     .example = "region box off",
                                     .flags = COMMAND_DECLARES,
                                     .run = run_off};
    command_add(t, &off, 1);
}

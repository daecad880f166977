/* SPDX-License-Identifier: GPL-3.0-or-later */
/* create_cells NAME single|random|file ...: new cells, all of them or none. */
#include "command/commands.h"

#include "command/cell_file.h"
#include "command/creation.h"
#include "command/forecast.h"
#include "command/session.h"

#include "base/alloc.h"
#include "base/number.h"
#include "base/table.h"
#include "biology/division.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

/* Mass of the new cells: a percent is of the mass at division, which must then be known. */
static int read_mass(const scene *s, const args *a, int species_row, spread *mass, diag *d) {
    *mass = args_spread(a, "mass");
    if (args_given(a, "mass") && !args_percent(a, "mass"))
        return SARCINA_OK;
    double whole = division_mean_mass(&s->species.list[species_row]);
    if (isnan(whole)) {
        diag_error(d, "species %s has no division mass to take a part of", s->species.list[species_row].name);
        diag_help(d, "write the mass itself: mass 5e-16kg; or 'division %s ...' before",
                  s->species.list[species_row].name);
        if (args_given(a, "mass"))
            diag_place(d, args_span(a, "mass"));
        return SARCINA_ERROR;
    }
    mass->a *= whole;
    if (mass->law != SPREAD_LOGNORMAL)
        mass->b *= whole;
    return SARCINA_OK;
}

static int read_placement(interp *in, const args *a, placement *p, diag *d) {
    *p = (placement){.species = args_row(a, "NAME"),
                     .gap = args_given(a, "gap") ? args_number(a, "gap") : (double)NAN,
                     .overlap = args_flag(a, "overlap"),
                     .filament = (int)args_int(a, "filament"),
                     .maxtry = (int)args_int(a, "maxtry"),
                     .may_fail = session_of(in)->in_every};
    p->orient = args_orient(a, "orient", p->axis);
    return read_mass(interp_scene(in), a, p->species, &p->mass, d);
}

/* New cells stand behind those that were there, and join their group. */
static void finish(interp *in, const args *a, const placement *p, size_t created) {
    const scene *s = interp_scene(in);
    if (created == 0) {
        interp_warn(in, "no room for cells of %s; none was created", s->species.list[p->species].name);
        return;
    }
    int bit = args_given(a, "group") ? session_define_group(in, args_text(a, "group")) : -1;
    for (size_t row = s->colony->cell.count - created; row < s->colony->cell.count && bit >= 0; row++)
        s->colony->cell.groups[row] |= UINT64_C(1) << bit;
    interp_print(in, "created %zu %s of %s: %zu in all", created, number_noun(created, "cell", "cells"),
                 s->species.list[p->species].name, s->colony->cell.count);
}

/* Can the group be made? A check makes it, and no cells. */
static int begin(interp *in, const args *a, diag *d) {
    if (!args_given(a, "group"))
        return SARCINA_OK;
    int status = session_check_group(in, args_text(a, "group"), d);
    if (!status && interp_checking(in))
        session_define_group(in, args_text(a, "group"));
    return status;
}

/* In a check nothing is created; the forecast is told. */
static int create(interp *in, const args *a, creation *c, diag *d) {
    size_t created = 0;
    int status = begin(in, a, d);
    if (!status && interp_checking(in)) {
        if (read_placement(in, a, &c->placement, NULL) == SARCINA_OK)
            forecast_create(in, c);
        return SARCINA_OK;
    }
    if (!status)
        status = read_placement(in, a, &c->placement, d);
    if (status)
        return status;
    status = creation_make(interp_scene(in), c, &created, d);
    if (!status)
        finish(in, a, &c->placement, created);
    return status;
}

/* -1 is a region that a check does not know. */
static region region_of(interp *in, const args *a) {
    int row = args_row(a, "REGION");
    return row < 0 ? (region){0} : interp_scene(in)->regions.list[row];
}

static int run_single(interp *in, const args *a, diag *d) {
    creation c = {.kind = CREATION_SINGLE, .at = {args_number(a, "X"), args_number(a, "Y"), args_number(a, "Z")}};
    return create(in, a, &c, d);
}

static int run_random(interp *in, const args *a, diag *d) {
    creation c = {.kind = CREATION_RANDOM, .n = args_int(a, "N"), .where = region_of(in, a)};
    return create(in, a, &c, d);
}

static int run_poisson(interp *in, const args *a, diag *d) {
    creation c = {.kind = CREATION_RANDOM,
                  .n = args_int(a, "N"),
                  .spacing = args_number(a, "SPACING"),
                  .where = region_of(in, a)};
    return create(in, a, &c, d);
}

static int run_grid(interp *in, const args *a, diag *d) {
    creation c = {.kind = CREATION_GRID,
                  .step = {args_number(a, "DX"), args_number(a, "DY"), args_number(a, "DZ")},
                  .points = {args_int(a, "NX"), args_int(a, "NY"), args_int(a, "NZ")}};
    args_vector(a, "origin", c.at, 3);
    return create(in, a, &c, d);
}

/* The file may give every cell its mass: only if one lacks it is the command's asked for. */
static int run_file(interp *in, const args *a, diag *d) {
    cell_file f;
    size_t created;
    int status = begin(in, a, d);
    if (interp_checking(in))
        forecast_unknown(in, "cells from files");
    if (status || interp_checking(in))
        return status;
    status = cell_file_read(in, args_text(a, "FILE"), args_row(a, "NAME"), false, &f, d);
    if (status)
        return status;
    bool needs_mass = args_given(a, "mass");
    for (size_t i = 0; i < f.count; i++) {
        cell_row *row = &f.rows[i]; /* of a new cell: what it was elsewhere does not count */
        row->id = row->parent = row->founder = 0;
        row->generation = row->age = 0;
        memset(row->frame, 0, sizeof row->frame);
        needs_mass = needs_mass || !(row->mass > 0);
    }
    placement p = {.mass = spread_fixed(1)};
    diag lacks = {0};
    status = read_placement(in, a, &p, &lacks);
    if (status && needs_mass) {
        if (d)
            *d = lacks;
    } else {
        status = scene_create_rows(interp_scene(in), &p, f.rows, f.count, &created, d);
        if (!status)
            finish(in, a, &p, created);
    }
    cell_file_free(&f);
    return status;
}

#define COMMON                                                                                                         \
    {"orient=random:orient", "axis: a letter, in the plane (xy), drawn (random), or three numbers"},                   \
        {"mass=50%:mass%~(0,1e-9kg)", "of each cell; a percent is of the mass at division"},                           \
        {"gap:length", "height of the lowest surface above the substratum; takes the place of z"},                     \
        {"filament=1:int[1,100000]", "this many cells in a row, linked filially, in the place of each"},               \
        {"overlap=no:flag", "may it overlap what is there?"},                                                          \
        {"maxtry=1000:int[1,1000000000]", "places drawn for a cell before giving up"}, {                               \
        "group:+group", "group that the new cells join, made when there is none of that name"                          \
    }

static const param single_params[] = {
    {"NAME:species", "whose cells"}, {"X:length", "centre"}, {"Y:length", "centre"}, {"Z:length", "centre"}, COMMON};
static const param random_params[] = {{"NAME:species", "whose cells"},
                                      {"N:int[1,)", "how many"},
                                      {"REGION:region", "where their centres are drawn"},
                                      COMMON};
static const param poisson_params[] = {{"NAME:species", "whose cells"},
                                       {"N:int[1,)", "how many"},
                                       {"SPACING:length(0,)", "the least distance between the centres of these cells"},
                                       {"REGION:region", "where their centres are drawn"},
                                       COMMON};
static const param grid_params[] = {{"NAME:species", "whose cells"},
                                    {"NX:int[1,)", "how many along x"},
                                    {"NY:int[1,)", "how many along y"},
                                    {"NZ:int[1,)", "how many along z"},
                                    {"DX:length", "from one centre to the next along x"},
                                    {"DY:length", "the same along y"},
                                    {"DZ:length", "the same along z"},
                                    {"origin=0,0,0:length3", "centre of the first cell"},
                                    COMMON};
static const param file_params[] = {
    {"NAME:species", "whose cells, where the file names none"},
    {"FILE:file", "CSV with a header: species x y z mass diameter ux uy uz, units in brackets: x[um]"},
    COMMON};

#define ALL_OR_NONE                                                                                                    \
    "All of them or none: when there is no room the scene is as before. Room is judged by the cells' own surfaces; "   \
    "'overlap yes' asks for none. In a command of 'run ... every' cells come as by attach: where there is no room at " \
    "random places none is created, with a warning, and the run goes on."

static const command_form forms[] = {
    {.head = "create_cells NAME:species single X:length Y:length Z:length",
     .params = single_params,
     .nparams = TABLE_COUNT(single_params),
     .summary = "One cell at a place",
     .details = ALL_OR_NONE,
     .example =
         "link filial ecoli k 5e-13N/m break 1um\n"
         "create_cells ecoli single 0 5um 0 orient x gap 0 mass 86.5% filament 5 overlap no maxtry 10 group chain",
     .flags = COMMAND_SHADOW,
     .run = run_single},
    {.head = "create_cells NAME:species random N:int[1,) REGION:region",
     .params = random_params,
     .nparams = TABLE_COUNT(random_params),
     .summary = "Cells at random places in a region",
     .details = "Centres are uniform in the region, which must have bounds. " ALL_OR_NONE,
     .example =
         "create_cells ecoli random 3 box orient random mass uniform 50% 100% gap 0 filament 1 overlap no maxtry 500 "
         "group mothers",
     .flags = COMMAND_SHADOW,
     .run = run_random},
    {.head = "create_cells NAME:species poisson N:int[1,) SPACING:length(0,) REGION:region",
     .params = poisson_params,
     .nparams = TABLE_COUNT(poisson_params),
     .summary = "Cells at random places that keep a distance (dart throwing)",
     .details = "Centres are uniform in the region but for those nearer than SPACING to one of these cells, which are "
                "drawn again, maxtry times. " ALL_OR_NONE,
     .example = "create_cells ecoli poisson 10 1um box orient xy mass 60% gap 0 filament 1 overlap yes maxtry 1000 "
                "group mothers",
     .flags = COMMAND_SHADOW,
     .run = run_poisson},
    {.head = "create_cells NAME:species grid NX:int[1,) NY:int[1,) NZ:int[1,) DX:length DY:length DZ:length",
     .params = grid_params,
     .nparams = TABLE_COUNT(grid_params),
     .summary = "Cells on the points of a grid",
     .details = "Centre (i, j, k) is origin + (i DX, j DY, k DZ), from 0. Ids go along x, then y, then z. " ALL_OR_NONE,
     .example =
         "create_cells ecoli grid 3 3 1 2um 6um 0 origin 40um 40um 0 orient y mass 60% gap 0 filament 1 overlap no "
         "maxtry 1 "
         "group mothers",
     .flags = COMMAND_SHADOW,
     .run = run_grid},
    {.head = "create_cells NAME:species file FILE:file",
     .params = file_params,
     .nparams = TABLE_COUNT(file_params),
     .summary = "Cells from a CSV file",
     .details = "What a row leaves empty is drawn as for the others. " ALL_OR_NONE,
     .example =
         "create_cells ecoli file cells.csv orient y mass 60% gap 0 filament 1 overlap yes maxtry 1 group mothers",
     .flags = COMMAND_SHADOW,
     .run = run_file},
};

void command_create_cells(command_table *t) {
    command_add(t, forms, TABLE_COUNT(forms));
}

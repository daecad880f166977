/* SPDX-License-Identifier: GPL-3.0-or-later */
/* create_cells NAME single|random|file ...: new cells, all of them or none. */
#include "command/commands.h"

#include "command/cell_file.h"

#include "base/table.h"
#include "biology/division.h"

#include <math.h>
#include <stdlib.h>

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
                     .maxtry = (int)args_int(a, "maxtry")};
    p->orient = args_orient(a, "orient", p->axis);
    return read_mass(interp_scene(in), a, p->species, &p->mass, d);
}

static void report(interp *in, const placement *p, size_t created) {
    const scene *s = interp_scene(in);
    interp_print(in, "created %zu cell%s of %s: %zu in all", created, created == 1 ? "" : "s",
                 s->species.list[p->species].name, s->colony->cell.count);
}

static int run_single(interp *in, const args *a, diag *d) {
    placement p;
    size_t created;
    double centre[3] = {args_number(a, "X"), args_number(a, "Y"), args_number(a, "Z")};
    int status = read_placement(in, a, &p, d);
    if (!status)
        status = scene_create_single(interp_scene(in), &p, centre, &created, d);
    if (!status)
        report(in, &p, created);
    return status;
}

static int run_random(interp *in, const args *a, diag *d) {
    placement p;
    size_t created;
    scene *s = interp_scene(in);
    int status = read_placement(in, a, &p, d);
    if (!status)
        status =
            scene_create_random(s, &p, (size_t)args_int(a, "N"), &s->regions.list[args_row(a, "REGION")], &created, d);
    if (!status)
        report(in, &p, created);
    return status;
}

/* The file may give every cell its mass: only if one lacks it is the command's asked for. */
static int run_file(interp *in, const args *a, diag *d) {
    cell_row *rows;
    size_t count, created;
    int status = cell_file_read(in, args_text(a, "FILE"), args_row(a, "NAME"), &rows, &count, d);
    if (status)
        return status;
    bool needs_mass = args_given(a, "mass");
    for (size_t i = 0; i < count; i++)
        needs_mass = needs_mass || !(rows[i].mass > 0);
    placement p = {.mass = spread_fixed(1)};
    diag lacks = {0};
    status = read_placement(in, a, &p, &lacks);
    if (status && needs_mass) {
        if (d)
            *d = lacks;
    } else {
        status = scene_create_rows(interp_scene(in), &p, rows, count, &created, d);
        if (!status)
            report(in, &p, created);
    }
    free(rows);
    return status;
}

#define COMMON                                                                                                         \
    {"orient=random:orient", "axis: a letter, in the plane (xy), drawn (random), or three numbers"},                   \
        {"mass=50%:mass%~(0,1e-9kg)", "of each cell; a percent is of the mass at division"},                           \
        {"gap:length", "height of the lowest surface above the substratum; takes the place of z"},                     \
        {"filament=1:int[1,100000]", "this many cells in a row, linked filially, in the place of each"},               \
        {"overlap=no:flag", "may it overlap what is there?"}, {                                                        \
        "maxtry=1000:int[1,1000000000]", "places drawn for a cell before giving up"                                    \
    }

static const param single_params[] = {
    {"NAME:species", "whose cells"}, {"X:length", "centre"}, {"Y:length", "centre"}, {"Z:length", "centre"}, COMMON};
static const param random_params[] = {{"NAME:species", "whose cells"},
                                      {"N:int[1,)", "how many"},
                                      {"REGION:region", "where their centres are drawn"},
                                      COMMON};
static const param file_params[] = {
    {"NAME:species", "whose cells, where the file names none"},
    {"FILE:file", "CSV with a header: species x y z mass diameter ux uy uz, units in brackets: x[um]"},
    COMMON};

static const command_form forms[] = {
    {"create_cells NAME:species single X:length Y:length Z:length", single_params, TABLE_COUNT(single_params),
     "One cell at a place", NULL,
     "link filial ecoli k 5e-13N/m break 1um\n"
     "create_cells ecoli single 0 5um 0 orient x gap 0 mass 86.5% filament 5 overlap no maxtry 10",
     0, run_single, NULL, 0},
    {"create_cells NAME:species random N:int[1,) REGION:region", random_params, TABLE_COUNT(random_params),
     "Cells at random places in a region", "All of them or none: when there is no room the scene is as before.",
     "create_cells ecoli random 3 box orient random mass uniform 50% 100% gap 0 filament 1 overlap no maxtry 500", 0,
     run_random, NULL, 0},
    {"create_cells NAME:species file FILE:file", file_params, TABLE_COUNT(file_params), "Cells from a CSV file", NULL,
     "create_cells ecoli file cells.csv orient y mass 60% gap 0 filament 1 overlap yes maxtry 1", 0, run_file, NULL, 0},
};

void command_create_cells(command_table *t) {
    command_add(t, forms, TABLE_COUNT(forms));
}

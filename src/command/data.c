/* SPDX-License-Identifier: GPL-3.0-or-later */
/* write_data FILE, read_data FILE: the cells as a table. */
#include "command/commands.h"
#include "command/forecast.h"

#include "command/cell_file.h"
#include "command/session.h"

#include "base/alloc.h"
#include "base/number.h"
#include "base/table.h"

#include <math.h>
#include <stdlib.h>

static int run_write(interp *in, const args *a, diag *d) {
    char *file = session_file(args_text(a, "FILE"), interp_scene(in)->step);
    int status = cell_file_write(in, file, d);
    free(file);
    return status;
}

static int compare_ids(const void *a, const void *b) {
    uint64_t p = *(const uint64_t *)a, q = *(const uint64_t *)b;
    return (p > q) - (p < q);
}

/* Every cell has an id of its own, or none has one. */
static int check_ids(const cell_row *rows, size_t n, diag *d) {
    uint64_t *ids = alloc_zeroed(n, sizeof *ids);
    size_t given = 0;
    int status = SARCINA_OK;
    for (size_t i = 0; i < n; i++)
        given += (ids[i] = rows[i].id) != 0;
    if (given && given < n)
        status = diag_error(d, "%zu of %zu cells have no id", n - given, n);
    qsort(ids, n, sizeof *ids, compare_ids);
    for (size_t i = 1; i < given && !status; i++)
        if (ids[i] == ids[i - 1])
            status = diag_error(d, "cell %llu is there twice", (unsigned long long)ids[i]);
    free(ids);
    return status;
}

static int check_masses(const cell_row *rows, size_t n, diag *d) {
    for (size_t i = 0; i < n; i++)
        if (!(rows[i].mass > 0)) {
            diag_error(d, "cell %zu of the file has no mass", i + 1);
            return diag_help(d, "write a column mass[pg] or length[um]; 'create_cells NAME file' draws masses");
        }
    return SARCINA_OK;
}

/* A check knows the groups of a file that is there, and creates no cells. */
static int check_read(interp *in, const char *path, int species_row) {
    cell_file f;
    diag ignored = {0};
    forecast_unknown(in, "cells from files");
    if (cell_file_read(in, path, species_row, true, &f, &ignored) != SARCINA_OK) {
        interp_open_world(in); /* it may be written, or changed, before: with any groups */
        return SARCINA_OK;
    }
    cell_file_make_groups(in, &f);
    cell_file_free(&f);
    return SARCINA_OK;
}

static int run_read(interp *in, const args *a, diag *d) {
    scene *s = interp_scene(in);
    int only = s->species.count == 1 ? 0 : -1;
    if (interp_checking(in))
        return check_read(in, args_text(a, "FILE"), only);
    if (s->colony->cell.count) {
        diag_error(d, "read_data takes a scene without cells, and there are %zu", s->colony->cell.count);
        return diag_help(d, "'delete_cells all' before, or add to them: create_cells NAME file %s",
                         args_text(a, "FILE"));
    }
    cell_file f;
    size_t created = 0;
    int status = cell_file_read(in, args_text(a, "FILE"), only, true, &f, d);
    if (status)
        return status;
    status = check_ids(f.rows, f.count, d);
    if (!status)
        status = check_masses(f.rows, f.count, d);
    if (!status)
        status = link_file_check(&f.links, s, f.rows, f.count, d);
    const placement p = {.orient = ORIENT_RANDOM, .gap = NAN, .overlap = true, .mass = spread_fixed(1), .maxtry = 1};
    if (!status)
        status = scene_create_rows(s, &p, f.rows, f.count, &created, d);
    if (!status) {
        cell_file_make_groups(in, &f);
        link_file_add(&f.links, s);
        interp_print(in, "read %zu %s", created, number_noun(created, "cell", "cells"));
    }
    cell_file_free(&f);
    return status;
}

static const param write_params[] = {{"FILE:file", "its name; * is the step"}};
static const param read_params[] = {{"FILE:file", "a file that write_data made, or one like it"}};

static const command_form forms[] = {
    {.head = "write_data FILE:file",
     .params = write_params,
     .nparams = TABLE_COUNT(write_params),
     .summary = "Writes the cells to a CSV file",
     .details = "One a row: species, descent, age, mass, diameter, and the places and velocities of its particles, "
                "with units in the headings. 'read_data' and 'create_cells NAME file' take them back to the bit. "
                "Groups and the frames of divisions are columns where cells have them; links stand in a second table "
                "behind the line 'links', one spring a row. 'create_cells' makes new cells of the first table alone. "
                "Species and the clock are in restart files only (write_restart).",
     .example = "write_data colony.*.csv",
     .run = run_write},
    {.head = "read_data FILE:file",
     .params = read_params,
     .nparams = TABLE_COUNT(read_params),
     .summary = "Puts the cells of a file into a scene without cells",
     .details =
         "They keep their ids, mothers, generations and ages, where the file has them; groups that it names are "
         "made; its links come with them. A table of one's own, such as a segmented picture, needs the columns x, "
         "y and one of mass and length (over both caps); it may have species (where the scene has several), z "
         "(else cells lie on the substratum, or in the plane of 'dimension 2'), diameter, and angle (in the "
         "plane, from x towards y) or ux, uy, uz. Units stand in brackets in the header: x[um], "
         "angle[degree]. A column that is not known is warned of. Overlaps are taken as they are. "
         "To add new cells of the same places, write 'create_cells "
         "NAME file FILE'.",
     .example = "write_data colony.csv\ndelete_cells all\nread_data colony.csv",
     .run = run_read},
};

void command_data(command_table *t) {
    command_add(t, forms, TABLE_COUNT(forms));
}

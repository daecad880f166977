/* SPDX-License-Identifier: GPL-3.0-or-later */
/* write_data FILE, read_data FILE: the cells as a table. */
#include "command/commands.h"
#include "command/forecast.h"

#include "command/cell_file.h"
#include "command/session.h"

#include "base/alloc.h"
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

static int run_read(interp *in, const args *a, diag *d) {
    scene *s = interp_scene(in);
    if (interp_checking(in)) {
        forecast_unknown(in, "cells from files");
        return SARCINA_OK;
    }
    if (s->colony->cell.count) {
        diag_error(d, "read_data takes a scene without cells, and there are %zu", s->colony->cell.count);
        return diag_help(d, "'delete_cells all' before, or add to them: create_cells NAME file %s",
                         args_text(a, "FILE"));
    }
    cell_row *rows;
    size_t count, created = 0;
    link_file links = {0};
    int status = cell_file_read(in, args_text(a, "FILE"), -1, &rows, &count, &links, d);
    if (!status)
        status = check_ids(rows, count, d);
    for (size_t i = 0; i < count && !status; i++)
        if (!(rows[i].mass > 0))
            status = diag_error(d, "cell %zu of the file has no mass", i + 1);
    if (!status)
        status = link_file_check(&links, interp_scene(in), rows, count, d);
    const placement p = {.orient = ORIENT_RANDOM, .gap = NAN, .overlap = true, .mass = spread_fixed(1), .maxtry = 1};
    if (!status)
        status = scene_create_rows(s, &p, rows, count, &created, d);
    if (!status) {
        link_file_add(&links, s);
        interp_print(in, "read %zu cells", created);
    }
    cell_file_free(rows, count);
    link_file_free(&links);
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
     .details = "They keep their ids, mothers, generations and ages; their species and groups must be there, and "
                "every one needs a mass; their links come with them. Overlaps are taken as they are. To add new cells "
                "of the same places, write 'create_cells "
                "NAME file FILE'.",
     .example = "write_data colony.csv\ndelete_cells all\nread_data colony.csv",
     .run = run_read},
};

void command_data(command_table *t) {
    command_add(t, forms, TABLE_COUNT(forms));
}

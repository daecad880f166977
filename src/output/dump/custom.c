/* SPDX-License-Identifier: GPL-3.0-or-later */
/* LAMMPS's text dump (its manual, "dump command"), SI units, one line a cell in the order of ids.
 *
 * OVITO draws cells as spherocylinders from the columns quati quatj quatk quatw shapex shapey shapez (see
 * analysis/cell.c) once the particles' shape is set to Spherocylinder, and radius from `diameter`. A text that it knows
 * is a type's name: the column `species` is therefore headed `element`, as LAMMPS calls types by name. */
#include "output/dump/styles.h"

#include <inttypes.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

/* The smallest box around the whole cells, um; a box of 1 um where there are none. */
static void find_box(const colony *c, const uint32_t *rows, size_t n, double box[3][2]) {
    for (int k = 0; k < 3; k++) {
        box[k][0] = n ? INFINITY : 0;
        box[k][1] = n ? -INFINITY : 1;
    }
    for (size_t i = 0; i < n; i++) {
        const double *x = c->particle.x + 3 * (size_t)c->cell.first[rows[i]];
        double r = 0.5 * c->cell.diameter[rows[i]];
        for (size_t p = 0; p < c->cell.nparticles[rows[i]]; p++)
            for (size_t k = 0; k < 3; k++) {
                box[k][0] = fmin(box[k][0], x[3 * p + k] - r);
                box[k][1] = fmax(box[k][1], x[3 * p + k] + r);
            }
    }
}

static void put_head(const dump_frame *f, const uint32_t *rows, size_t n, FILE *out) {
    double box[3][2];
    find_box(f->view->colony, rows, n, box);
    fprintf(out, "ITEM: TIMESTEP\n%" PRIu64 "\nITEM: NUMBER OF ATOMS\n%zu\nITEM: BOX BOUNDS ff ff ff\n", f->view->step,
            n);
    for (int k = 0; k < 3; k++)
        fprintf(out, "%.9e %.9e\n", dim_from_engine(box[k][0], DIM_LENGTH), dim_from_engine(box[k][1], DIM_LENGTH));
    fputs("ITEM: ATOMS", out);
    for (size_t i = 0; i < f->ncolumns; i++)
        fprintf(out, " %s", strcmp(f->columns[i].name, "species") == 0 ? "element" : f->columns[i].name);
    fputc('\n', out);
}

static int put_row(const dump_frame *f, uint32_t row, FILE *out, diag *d) {
    for (size_t i = 0; i < f->ncolumns; i++) {
        char text[64];
        if (dump_text(f, i, row, text, d))
            return SARCINA_ERROR;
        fprintf(out, "%s%s", i ? " " : "", text);
    }
    fputc('\n', out);
    return SARCINA_OK;
}

static int write(const dump_frame *f, FILE *out, diag *d) {
    int status = SARCINA_OK;
    size_t n;
    uint32_t *rows = dump_rows(f, &n);
    put_head(f, rows, n, out);
    for (size_t i = 0; i < n && !status; i++)
        status = put_row(f, rows[i], out, d);
    free(rows);
    return status;
}

const dump_style dump_custom = {
    .name = "custom",
    .summary = "LAMMPS's text dump, which OVITO reads",
    .details = "One line a cell, in the order of ids, SI units. With the columns quati quatj quatk quatw shapex shapey "
               "shapez OVITO draws spherocylinders (particles: shape Spherocylinder). `species` is headed `element`. "
               "Without * in FILE all steps go to one file.",
    .example = "dump ovito all custom 5 colony.dump id species x y z quati quatj quatk quatw shapex shapey shapez",
    .now_example = "write_dump all custom now.dump id species x y z",
    .takes = DUMP_COLUMNS,
    .many = true,
    .blocks = STREAM_DUMP,
    .write = write,
};

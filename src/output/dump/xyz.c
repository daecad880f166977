/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Extended XYZ (as ASE defines it and OVITO reads it; OVITO manual, "XYZ file reader"): the number of lines, a line of
 * KEY=VALUE with the columns, then one capsule a line. A coccus and a rod are one capsule, a flexible cell is one for
 * each of its segments. OVITO's spherocylinder takes aspherical_shape (radius, radius, distance of the caps' centres)
 * and orientation, a quaternion x y z w that turns z into the axis. */
#include "output/dump/styles.h"

#include "analysis/cell.h"
#include "base/vec3.h"
#include "output/field.h"

#include <ctype.h>
#include <inttypes.h>
#include <stdlib.h>

static void put(FILE *out, double engine, dim d) {
    char digits[FIELD_ROOM];
    fprintf(out, " %s", field_number(dim_from_engine(engine, d), digits));
}

/* Blanks in a name would be a new column. */
static void put_word(FILE *out, const char *name) {
    for (; *name; name++)
        fputc(isspace((unsigned char)*name) ? '_' : *name, out);
}

static void put_capsule(const dump_frame *f, uint32_t row, vec3 a, vec3 b, FILE *out) {
    const colony *c = f->view->colony;
    vec3 axis = vec3_sub(b, a), centre = vec3_scale(0.5, vec3_add(a, b));
    double length = vec3_norm(axis), r = 0.5 * c->cell.diameter[row], q[4];
    const double unit[3] = {length > 0 ? axis.x / length : 0, length > 0 ? axis.y / length : 0,
                            length > 0 ? axis.z / length : 0};
    cell_quaternion(unit, q);
    put_word(out, f->view->species->list[c->cell.species[row]].name);
    put(out, centre.x, DIM_LENGTH);
    put(out, centre.y, DIM_LENGTH);
    put(out, centre.z, DIM_LENGTH);
    put(out, r, DIM_LENGTH);
    put(out, r, DIM_LENGTH);
    put(out, r, DIM_LENGTH);
    put(out, length, DIM_LENGTH);
    for (int i = 0; i < 4; i++)
        put(out, q[i], DIM_NONE);
    fprintf(out, " %" PRIu64 " %" PRId32 "\n", c->cell.id[row], c->cell.generation[row]);
}

static int write(const dump_frame *f, FILE *out, diag *d) {
    (void)d;
    const colony *c = f->view->colony;
    size_t n, lines = 0;
    char digits[FIELD_ROOM];
    uint32_t *rows = dump_rows(f, &n);
    for (size_t i = 0; i < n; i++)
        lines += c->cell.nparticles[rows[i]] > 1 ? c->cell.nparticles[rows[i]] - 1 : 1;
    fprintf(out,
            "%zu\nProperties=species:S:1:pos:R:3:radius:R:1:aspherical_shape:R:3:orientation:R:4:molecule:I:1:"
            "generation:I:1 Time=%s step=%" PRIu64 " pbc=\"F F F\"\n",
            lines, field_number(f->view->time, digits), f->view->step);
    for (size_t i = 0; i < n; i++) {
        const double *x = c->particle.x + 3 * (size_t)c->cell.first[rows[i]];
        uint32_t last = c->cell.nparticles[rows[i]] - 1;
        for (uint32_t p = 0; p == 0 || p < last; p++)
            put_capsule(f, rows[i], vec3_load(x + 3 * p), vec3_load(x + 3 * (last ? p + 1 : p)), out);
    }
    free(rows);
    return SARCINA_OK;
}

const dump_style dump_xyz = {
    .name = "xyz",
    .summary = "extended XYZ, which OVITO and ASE read: one capsule a line",
    .details =
        "SI units. A coccus or rod is one line, a flexible cell one for each segment; `molecule` is the cell's id. "
        "With radius, aspherical_shape and orientation OVITO draws the cells (particles: shape Spherocylinder). "
        "Lines stand in the order of ids; the second line of a frame has Time (growth, s) and step. Without * in "
        "FILE all steps go to one file.",
    .example = "dump ovito all xyz 5 colony.xyz",
    .now_example = "write_dump all xyz now.xyz",
    .takes = DUMP_NOTHING,
    .many = true,
    .blocks = STREAM_XYZ,
    .write = write,
};

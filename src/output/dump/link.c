/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Every spring, one a row, comma-separated, in SI: with a dump of the cells (id species mass diameter x y z ux uy uz
 * length) it holds the whole mechanical scene.
 *
 * link is the id of the link a spring belongs to (0: internal), kind internal, filial, stick, anchor or spring; the
 * spring joins particle_a of cell_a to particle_b of cell_b, or (cell_b 0) to the point anchorx anchory anchorz, which
 * with glides 1 follows below the particle. Of a group: the springs all of whose cells are in it. */
#include "output/dump/styles.h"

#include "output/field.h"
#include "output/spring_list.h"

#include <inttypes.h>
#include <math.h>
#include <stdlib.h>

static void put_number(FILE *out, double engine, dim d) {
    char digits[FIELD_ROOM];
    fprintf(out, ",%s", field_number(dim_from_engine(engine, d), digits));
}

static void put_spring(const dump_frame *f, const spring_item *s, FILE *out) {
    if (f->many)
        fprintf(out, "%" PRIu64 ",", f->view->step);
    fprintf(out, "%" PRIu64 ",%s,%" PRIu64 ",%" PRIu32 ",%" PRIu64 ",%" PRIu32, s->link, spring_list_kind(s->kind),
            s->cell_a, s->particle_a, s->cell_b, s->particle_b);
    put_number(out, s->k, DIM_STIFFNESS);
    put_number(out, s->rest, DIM_LENGTH);
    for (int i = 0; i < 3; i++)
        put_number(out, s->anchor ? s->anchor[i] : (double)NAN, DIM_LENGTH);
    fprintf(out, ",%d", s->glides);
    put_number(out, s->length, DIM_LENGTH);
    put_number(out, s->strain, DIM_NONE);
    put_number(out, s->age, DIM_TIME);
    fputc('\n', out);
}

static int write(const dump_frame *f, FILE *out, diag *d) {
    (void)d;
    size_t n;
    spring_item *list = spring_list_make(f, &n);
    if (f->fresh)
        fprintf(out,
                "%slink,kind,cell_a,particle_a,cell_b,particle_b,k,rest,anchorx,anchory,anchorz,glides,length,strain,"
                "age\n",
                f->many ? "step," : "");
    for (size_t i = 0; i < n; i++)
        put_spring(f, &list[i], out);
    free(list);
    return SARCINA_OK;
}

const dump_style dump_link = {
    .name = "link",
    .summary = "every spring of cells and links, comma-separated, in SI units",
    .details =
        "Columns link,kind,cell_a,particle_a,cell_b,particle_b,k,rest,anchorx,anchory,anchorz,glides,length,"
        "strain,age; particles are counted from 0 within their cell; cell_b 0 is the substratum; strain is "
        "(length - rest)/rest, age that of the link. With a dump of the cells' id species mass diameter x y z ux "
        "uy uz length it is enough to build the scene again. Without * in FILE all steps go to one file and the "
        "first column is the step.",
    .example = "dump springs all link 5 springs.csv",
    .now_example = "write_dump all link springs.csv",
    .takes = DUMP_NOTHING,
    .many = true,
    .blocks = STREAM_CSV,
    .write = write,
};

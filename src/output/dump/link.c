/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Every spring, one a row, comma-separated, in SI: with a dump of the cells (id species mass diameter x y z ux uy uz
 * length) it holds the whole mechanical scene.
 *
 * link is the id of the link a spring belongs to (0: internal), kind internal, filial, stick, anchor or spring; the
 * spring joins particle_a of cell_a to particle_b of cell_b, or (cell_b 0) to the point anchorx anchory anchorz, which
 * with glides 1 follows below the particle. Of a group: the springs all of whose cells are in it. */
#include "output/dump/styles.h"

#include "output/field.h"

#include <inttypes.h>
#include <math.h>
#include <stdlib.h>

typedef struct spring_row {
    uint64_t link, cell_a, cell_b;
    const char *kind;
    uint32_t particle_a, particle_b;
    double k, rest;
    const double *anchor; /* NULL: none */
    uint32_t glides;
} spring_row;

static void put_number(FILE *out, double engine, dim d) {
    char digits[FIELD_ROOM];
    fprintf(out, ",%s", field_number(dim_from_engine(engine, d), digits));
}

static void put_spring(const dump_frame *f, const spring_row *s, FILE *out) {
    if (f->many)
        fprintf(out, "%" PRIu64 ",", f->view->step);
    fprintf(out, "%" PRIu64 ",%s,%" PRIu64 ",%" PRIu32 ",%" PRIu64 ",%" PRIu32, s->link, s->kind, s->cell_a,
            s->particle_a, s->cell_b, s->particle_b);
    put_number(out, s->k, DIM_STIFFNESS);
    put_number(out, s->rest, DIM_LENGTH);
    for (int i = 0; i < 3; i++)
        put_number(out, s->anchor ? s->anchor[i] : (double)NAN, DIM_LENGTH);
    fprintf(out, ",%" PRIu32 "\n", s->glides);
}

/* The springs inside a cell; k is that of its species. */
static void put_internal(const dump_frame *f, uint32_t row, FILE *out) {
    const colony *c = f->view->colony;
    uint32_t n = c->cell.nparticles[row];
    double k = f->view->species->list[c->cell.species[row]].internal_k;
    for (uint32_t p = 0; p + 1 < n && k > 0; p++)
        put_spring(f,
                   &(spring_row){.kind = "internal",
                                 .cell_a = c->cell.id[row],
                                 .cell_b = c->cell.id[row],
                                 .particle_a = p,
                                 .particle_b = p + 1,
                                 .k = k,
                                 .rest = c->cell.rest[row] / (n - 1)},
                   out);
}

/* The cell whose particle this is, of the two of a link. */
static uint32_t owner(const colony *c, uint32_t particle, uint32_t row_a, uint32_t row_b) {
    uint32_t first = c->cell.first[row_a];
    return particle >= first && particle < first + c->cell.nparticles[row_a] ? row_a : row_b;
}

static void put_link(const dump_frame *f, uint32_t link, FILE *out) {
    static const char *const kinds[] = {
        [LINK_FILIAL] = "filial", [LINK_STICK] = "stick", [LINK_ANCHOR] = "anchor", [LINK_SPRING] = "spring"};
    colony *c = f->view->colony;
    uint32_t row_a = colony_row(c, c->link.cell_a[link]);
    uint32_t row_b = c->link.cell_b[link] ? colony_row(c, c->link.cell_b[link]) : row_a;
    if (f->members && !(f->members[row_a] && f->members[row_b]))
        return;
    for (uint32_t i = 0; i < c->link.nsprings[link]; i++) {
        uint32_t s = c->link.first[link] + i, a = owner(c, c->spring.a[s], row_a, row_b);
        bool anchored = c->spring.b[s] == SPRING_ANCHOR;
        uint32_t b = anchored ? a : owner(c, c->spring.b[s], row_a, row_b);
        put_spring(f,
                   &(spring_row){.link = c->link.id[link],
                                 .kind = kinds[c->link.kind[link]],
                                 .cell_a = c->cell.id[a],
                                 .particle_a = c->spring.a[s] - c->cell.first[a],
                                 .cell_b = anchored ? 0 : c->cell.id[b],
                                 .particle_b = anchored ? 0 : c->spring.b[s] - c->cell.first[b],
                                 .k = c->spring.k[s],
                                 .rest = c->spring.rest[s],
                                 .anchor = anchored ? c->spring.anchor + 3 * (size_t)s : NULL,
                                 .glides = c->spring.glides[s]},
                   out);
    }
}

static void put_links(const dump_frame *f, FILE *out) {
    const colony *c = f->view->colony;
    uint32_t *order = colony_links_by_id(c);
    for (size_t i = 0; i < c->link.count; i++)
        put_link(f, order[i], out);
    free(order);
}

static int write(const dump_frame *f, FILE *out, diag *d) {
    (void)d;
    size_t n;
    uint32_t *rows = dump_rows(f, &n);
    if (f->fresh)
        fprintf(out, "%slink,kind,cell_a,particle_a,cell_b,particle_b,k,rest,anchorx,anchory,anchorz,glides\n",
                f->many ? "step," : "");
    for (size_t i = 0; i < n; i++)
        put_internal(f, rows[i], out);
    free(rows);
    put_links(f, out);
    return SARCINA_OK;
}

const dump_style dump_link = {
    .name = "link",
    .summary = "every spring of cells and links, comma-separated, in SI units",
    .details = "Columns link,kind,cell_a,particle_a,cell_b,particle_b,k,rest,anchorx,anchory,anchorz,glides; particles "
               "are counted from 0 within their cell; cell_b 0 is the substratum. With a dump of the cells' id species "
               "mass diameter x y z ux uy uz length it is enough to build the scene again. Without * in FILE all steps "
               "go to one file and the first column is the step.",
    .example = "dump springs all link 5 springs.csv",
    .now_example = "write_dump all link springs.csv",
    .takes = DUMP_NOTHING,
    .many = true,
    .write = write,
};

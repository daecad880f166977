/* SPDX-License-Identifier: GPL-3.0-or-later */
/* VTK XML PolyData (.vtp; VTK file formats, "XML file formats"), text, SI: points are particles, cocci are vertices,
 * rods and flexible cells are lines. Point data: radius (for tubes and glyphs). Cell data: radius, then the named
 * columns; VTK wants it in the order of vertices before lines, so cocci come first, each kind in the order of ids. */
#include "output/dump/styles.h"

#include "base/alloc.h"
#include "base/table.h"
#include "output/field.h"
#include "output/spring_list.h"

#include <inttypes.h>
#include <stddef.h>
#include <stdlib.h>
#include <string.h>

typedef struct cells {
    uint32_t *rows; /* cocci, then the others */
    size_t count, cocci, points;
} cells;

static cells sort_cells(const dump_frame *f) {
    const colony *c = f->view->colony;
    cells k = {.rows = NULL};
    uint32_t *rows = dump_rows(f, &k.count);
    k.rows = alloc_zeroed(k.count, sizeof *k.rows);
    size_t n = 0;
    for (int pass = 0; pass < 2; pass++) {
        for (size_t i = 0; i < k.count; i++)
            if ((c->cell.nparticles[rows[i]] > 1) == pass)
                k.rows[n++] = rows[i];
        if (pass == 0)
            k.cocci = n;
    }
    for (size_t i = 0; i < k.count; i++)
        k.points += c->cell.nparticles[rows[i]];
    free(rows);
    return k;
}

static void put_number(FILE *out, double si) {
    char digits[FIELD_ROOM];
    fprintf(out, "%s\n", field_number(si, digits));
}

static void open_array(FILE *out, const char *type, const char *name, int components) {
    char *attribute = field_xml(name);
    fprintf(out, "<DataArray type=\"%s\" Name=\"%s\" NumberOfComponents=\"%d\" format=\"ascii\">\n", type, attribute,
            components);
    free(attribute);
}

static void close_array(FILE *out) {
    fputs("</DataArray>\n", out);
}

static void put_points(const colony *c, const cells *k, FILE *out) {
    fputs("<Points>\n", out);
    open_array(out, "Float64", "points", 3);
    for (size_t i = 0; i < k->count; i++) {
        const double *x = c->particle.x + 3 * (size_t)c->cell.first[k->rows[i]];
        for (uint32_t p = 0; p < 3 * c->cell.nparticles[k->rows[i]]; p++)
            put_number(out, dim_from_engine(x[p], DIM_LENGTH));
    }
    close_array(out);
    fputs("</Points>\n<PointData Scalars=\"radius\">\n", out);
    open_array(out, "Float64", "radius", 1);
    for (size_t i = 0; i < k->count; i++)
        for (uint32_t p = 0; p < c->cell.nparticles[k->rows[i]]; p++)
            put_number(out, dim_from_engine(0.5 * c->cell.diameter[k->rows[i]], DIM_LENGTH));
    close_array(out);
    fputs("</PointData>\n", out);
}

/* Verts or Lines: points are numbered in the order of the cells. *point: the next one. */
static void put_topology(const colony *c, const cells *k, size_t from, size_t to, size_t *point, const char *kind,
                         FILE *out) {
    fprintf(out, "<%s>\n", kind);
    open_array(out, "Int64", "connectivity", 1);
    for (size_t i = from; i < to; i++)
        for (uint32_t p = 0; p < c->cell.nparticles[k->rows[i]]; p++)
            fprintf(out, "%zu\n", (*point)++);
    close_array(out);
    open_array(out, "Int64", "offsets", 1);
    for (size_t i = from, end = 0; i < to; i++) {
        end += c->cell.nparticles[k->rows[i]];
        fprintf(out, "%zu\n", end);
    }
    close_array(out);
    fprintf(out, "</%s>\n", kind);
}

/* VTK's strings: the characters' codes, each string ended by 0. */
static void put_codes(FILE *out, const char *text) {
    for (; *text; text++)
        fprintf(out, "%d ", (unsigned char)*text);
    fputs("0\n", out);
}

static int put_column(const dump_frame *f, size_t i, const cells *k, FILE *out, diag *d) {
    const output_column *column = &f->columns[i];
    open_array(out, column->is_text ? "String" : "Float64", column->name, 1);
    for (size_t j = 0; j < k->count; j++) {
        char text[64];
        if (dump_text(f, i, k->rows[j], text, d))
            return SARCINA_ERROR;
        if (column->is_text)
            put_codes(out, text);
        else
            fprintf(out, "%s\n", text);
    }
    close_array(out);
    return SARCINA_OK;
}

static int put_cell_data(const dump_frame *f, const cells *k, FILE *out, diag *d) {
    const colony *c = f->view->colony;
    fputs("<CellData Scalars=\"radius\">\n", out);
    open_array(out, "Float64", "radius", 1);
    for (size_t i = 0; i < k->count; i++)
        put_number(out, dim_from_engine(0.5 * c->cell.diameter[k->rows[i]], DIM_LENGTH));
    close_array(out);
    for (size_t i = 0; i < f->ncolumns; i++)
        if (put_column(f, i, k, out, d))
            return SARCINA_ERROR;
    fputs("</CellData>\n", out);
    return SARCINA_OK;
}

static void put_clock(const view *v, FILE *out) {
    fputs("<FieldData>\n<DataArray type=\"Float64\" Name=\"TimeValue\" NumberOfTuples=\"1\" format=\"ascii\">\n", out);
    put_number(out, v->time);
    fputs("</DataArray>\n<DataArray type=\"Int64\" Name=\"step\" NumberOfTuples=\"1\" format=\"ascii\">\n", out);
    fprintf(out, "%" PRIu64 "\n</DataArray>\n</FieldData>\n", v->step);
}

static void open_file(const dump_frame *f, FILE *out, size_t points, size_t verts, size_t lines) {
    fputs("<?xml version=\"1.0\"?>\n<VTKFile type=\"PolyData\" version=\"1.0\" byte_order=\"LittleEndian\">\n"
          "<PolyData>\n",
          out);
    put_clock(f->view, out);
    fprintf(out,
            "<Piece NumberOfPoints=\"%zu\" NumberOfVerts=\"%zu\" NumberOfLines=\"%zu\" NumberOfStrips=\"0\" "
            "NumberOfPolys=\"0\">\n",
            points, verts, lines);
}

static void close_file(FILE *out) {
    fputs("</Piece>\n</PolyData>\n</VTKFile>\n", out);
}

static int write(const dump_frame *f, FILE *out, diag *d) {
    const colony *c = f->view->colony;
    cells k = sort_cells(f);
    size_t point = 0;
    open_file(f, out, k.points, k.cocci, k.count - k.cocci);
    put_points(c, &k, out);
    int status = put_cell_data(f, &k, out, d);
    put_topology(c, &k, 0, k.cocci, &point, "Verts", out);
    put_topology(c, &k, k.cocci, k.count, &point, "Lines", out);
    close_file(out);
    free(k.rows);
    return status;
}

/* ---- springs: each a line between two points of its own ---------------------------------------------------------- */

static void put_ends(const spring_item *list, size_t n, FILE *out) {
    fputs("<Points>\n", out);
    open_array(out, "Float64", "points", 3);
    for (size_t i = 0; i < 2 * n; i++) {
        vec3 p = i % 2 ? list[i / 2].to : list[i / 2].from;
        put_number(out, dim_from_engine(p.x, DIM_LENGTH));
        put_number(out, dim_from_engine(p.y, DIM_LENGTH));
        put_number(out, dim_from_engine(p.z, DIM_LENGTH));
    }
    close_array(out);
    fputs("</Points>\n", out);
}

static void put_whole(const spring_item *list, size_t n, const char *name, uint64_t (*get)(const spring_item *),
                      FILE *out) {
    open_array(out, "Int64", name, 1);
    for (size_t i = 0; i < n; i++)
        fprintf(out, "%" PRIu64 "\n", get(&list[i]));
    close_array(out);
}

static uint64_t get_kind(const spring_item *s) {
    return s->kind == SPRING_INTERNAL ? 0 : (uint64_t)s->kind + 1;
}
static uint64_t get_link(const spring_item *s) {
    return s->link;
}
static uint64_t get_cell_a(const spring_item *s) {
    return s->cell_a;
}
static uint64_t get_cell_b(const spring_item *s) {
    return s->cell_b;
}

/* Numbers of springs: where in the record, and of what dimension. */
static const struct {
    const char *name, *dimension;
    size_t offset;
} spring_numbers[] = {{"k", "stiffness", offsetof(spring_item, k)},
                      {"rest", "length", offsetof(spring_item, rest)},
                      {"length", "length", offsetof(spring_item, length)},
                      {"strain", "number", offsetof(spring_item, strain)},
                      {"age", "time", offsetof(spring_item, age)}};

static void put_spring_data(const spring_item *list, size_t n, FILE *out) {
    fputs("<CellData Scalars=\"strain\">\n", out);
    put_whole(list, n, "kind", get_kind, out);
    put_whole(list, n, "link", get_link, out);
    put_whole(list, n, "cell_a", get_cell_a, out);
    put_whole(list, n, "cell_b", get_cell_b, out);
    for (size_t k = 0; k < TABLE_COUNT(spring_numbers); k++) {
        dim d = DIM_NONE;
        dim_by_name(spring_numbers[k].dimension, &d);
        open_array(out, "Float64", spring_numbers[k].name, 1);
        for (size_t i = 0; i < n; i++) {
            const char *record = (const char *)&list[i];
            double x;
            memcpy(&x, record + spring_numbers[k].offset, sizeof x);
            put_number(out, dim_from_engine(x, d));
        }
        close_array(out);
    }
    fputs("</CellData>\n", out);
}

static bool has_springs(const dump_frame *f) {
    size_t n;
    free(spring_list_make(f, &n));
    return n > 0;
}

static int write_springs(const dump_frame *f, FILE *out, diag *d) {
    (void)d;
    size_t n;
    spring_item *list = spring_list_make(f, &n);
    open_file(f, out, 2 * n, 0, n);
    put_ends(list, n, out);
    put_spring_data(list, n, out);
    fputs("<Lines>\n", out);
    open_array(out, "Int64", "connectivity", 1);
    for (size_t i = 0; i < 2 * n; i++)
        fprintf(out, "%zu\n", i);
    close_array(out);
    open_array(out, "Int64", "offsets", 1);
    for (size_t i = 1; i <= n; i++)
        fprintf(out, "%zu\n", 2 * i);
    close_array(out);
    fputs("</Lines>\n", out);
    close_file(out);
    free(list);
    return SARCINA_OK;
}

const dump_style dump_vtk = {
    .name = "vtk",
    .summary = "VTK PolyData (.vtp), which ParaView reads: cells as lines and vertices, springs, and an index (.pvd)",
    .details = "SI units. Points are particles with their radius; a rod or flexible cell is a line, a coccus a vertex; "
               "cells carry their radius and the named columns. Where there are springs a second file beside it, "
               "colony.springs.*.vtp for colony.*.vtp, has each as a line with kind (0 internal, 1 filial, 2 stick, 3 "
               "anchor, 4 other), link, cell_a, cell_b, k, rest, length, strain and age. colony.pvd and "
               "colony.springs.pvd list the files with their growth times; they are whole after every step, and go on "
               "after a restart: open these. In ParaView: Extract Surface and Tube, radius by the array `radius`, for "
               "rods; Glyph for cocci.",
    .example = "dump cells all vtk 5 colony.*.vtp generation overlap",
    .now_example = "write_dump all vtk colony.vtp species",
    .takes = DUMP_ANY_COLUMNS,
    .many = false,
    .indexed = true,
    .write = write,
    .beside = "springs",
    .has_beside = has_springs,
    .write_beside = write_springs,
};

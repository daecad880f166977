/* SPDX-License-Identifier: GPL-3.0-or-later */
/* VTK XML PolyData (.vtp; VTK file formats, "XML file formats"), text, SI: points are particles, cocci are vertices and
 * rods are lines. Point data: radius (for tubes and glyphs). Cell data: radius, then the named columns; VTK wants it in
 * the order of vertices before lines, so cocci come first, each kind in the order of ids. */
#include "output/dump/styles.h"

#include "base/alloc.h"
#include "output/field.h"

#include <inttypes.h>
#include <stdlib.h>

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

/* A name as an XML attribute. */
static void put_name(FILE *out, const char *name) {
    for (; *name; name++)
        switch (*name) {
        case '&':
            fputs("&amp;", out);
            break;
        case '<':
            fputs("&lt;", out);
            break;
        case '"':
            fputs("&quot;", out);
            break;
        default:
            fputc(*name, out);
        }
}

static void open_array(FILE *out, const char *type, const char *name, int components) {
    fprintf(out, "<DataArray type=\"%s\" Name=\"", type);
    put_name(out, name);
    fprintf(out, "\" NumberOfComponents=\"%d\" format=\"ascii\">\n", components);
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

static int write(const dump_frame *f, FILE *out, diag *d) {
    const colony *c = f->view->colony;
    cells k = sort_cells(f);
    size_t point = 0;
    fputs("<?xml version=\"1.0\"?>\n<VTKFile type=\"PolyData\" version=\"1.0\" byte_order=\"LittleEndian\">\n"
          "<PolyData>\n",
          out);
    put_clock(f->view, out);
    fprintf(out,
            "<Piece NumberOfPoints=\"%zu\" NumberOfVerts=\"%zu\" NumberOfLines=\"%zu\" NumberOfStrips=\"0\" "
            "NumberOfPolys=\"0\">\n",
            k.points, k.cocci, k.count - k.cocci);
    put_points(c, &k, out);
    int status = put_cell_data(f, &k, out, d);
    put_topology(c, &k, 0, k.cocci, &point, "Verts", out);
    put_topology(c, &k, k.cocci, k.count, &point, "Lines", out);
    fputs("</Piece>\n</PolyData>\n</VTKFile>\n", out);
    free(k.rows);
    return status;
}

const dump_style dump_vtk = {
    .name = "vtk",
    .summary = "VTK PolyData (.vtp), which ParaView reads: rods as lines, cocci as vertices",
    .details = "SI units. Points are particles with their radius; cells carry their radius and the named columns. In "
               "ParaView: Extract Surface and Tube, radius by the array `radius`, for rods; Glyph for cocci.",
    .example = "dump cells all vtk 5 colony.*.vtp generation overlap",
    .now_example = "write_dump all vtk colony.vtp species",
    .takes = DUMP_ANY_COLUMNS,
    .many = false,
    .write = write,
};

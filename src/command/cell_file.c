/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "command/cell_file.h"

#include "base/alloc.h"
#include "base/number.h"
#include "base/table.h"
#include "base/units.h"
#include "model/shape.h"

#include <errno.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

/* A column the file may have, and where its number goes (engine units). */
typedef struct known_column {
    const char *name;
    const char *dimension; /* NULL: text */
    size_t offset;
} known_column;

static const known_column known[] = {
    {"species", NULL, 0},
    {"x", "length", offsetof(cell_row, centre[0])},
    {"y", "length", offsetof(cell_row, centre[1])},
    {"z", "length", offsetof(cell_row, centre[2])},
    {"mass", "mass", offsetof(cell_row, mass)},
    {"diameter", "length", offsetof(cell_row, diameter)},
    {"ux", "number", offsetof(cell_row, axis[0])},
    {"uy", "number", offsetof(cell_row, axis[1])},
    {"uz", "number", offsetof(cell_row, axis[2])},
};
enum { KNOWN = sizeof known / sizeof known[0], COLUMNS_MAX = 64 };

typedef struct reader {
    interp *in;
    const char *path;
    int line;
    int columns[COLUMNS_MAX]; /* row of `known`; -1: not ours, passed over */
    double to_si[COLUMNS_MAX];
    size_t ncolumns;
} reader;

/* The next cell of a CSV line, blanks at its ends taken off; NULL at the end. Quotes are not special. */
static char *next_word(char **line) {
    if (!*line)
        return NULL;
    char *word = strsep(line, ",");
    word += strspn(word, " \t");
    size_t n = strlen(word);
    while (n && strchr(" \t\r\n", word[n - 1]))
        word[--n] = '\0';
    return word;
}

static int read_unit(reader *r, const char *text, dim wanted, double *to_si, diag *d) {
    units *u = units_create(d);
    if (!u)
        return SARCINA_ERROR;
    units_value one;
    char *number = alloc_format("1%s", text);
    int status = units_read(u, number, strlen(number), &one, d);
    free(number);
    units_free(u);
    if (status)
        return status;
    if (!dim_equal(one.d, wanted))
        return diag_error(d, "%s:%d: '[%s]' is no unit of this column", r->path, r->line, text);
    *to_si = one.si;
    return SARCINA_OK;
}

static int read_heading(reader *r, char *word, diag *d) {
    char *bracket = strchr(word, '['), *suffix = NULL;
    if (bracket) {
        suffix = bracket + 1;
        *bracket = '\0';
        suffix[strcspn(suffix, "]")] = '\0';
    }
    ptrdiff_t k = table_find(known, KNOWN, sizeof known[0], word);
    size_t i = r->ncolumns++;
    r->columns[i] = (int)k;
    r->to_si[i] = 1;
    if (k < 0 || !known[k].dimension)
        return SARCINA_OK;
    dim wanted;
    dim_by_name(known[k].dimension, &wanted);
    if (suffix)
        return read_unit(r, suffix, wanted, &r->to_si[i], d);
    r->to_si[i] = interp_unit(r->in, wanted);
    return SARCINA_OK;
}

static int read_header(reader *r, char *line, diag *d) {
    int status = SARCINA_OK;
    bool has[KNOWN] = {false};
    for (char *word; !status && (word = next_word(&line));) {
        if (r->ncolumns == COLUMNS_MAX)
            return diag_error(d, "%s:%d: more than %d columns", r->path, r->line, COLUMNS_MAX);
        status = read_heading(r, word, d);
        if (!status && r->columns[r->ncolumns - 1] >= 0)
            has[r->columns[r->ncolumns - 1]] = true;
    }
    for (int k = 1; !status && k <= 3; k++)
        if (!has[k]) {
            status = diag_error(d, "%s:%d: the header lacks the column '%s'", r->path, r->line, known[k].name);
            diag_help(d, "columns: species x y z mass diameter ux uy uz, units in brackets: x[um]");
        }
    return status;
}

static int read_number(const reader *r, const char *word, size_t column, cell_row *row, diag *d) {
    const known_column *k = &known[r->columns[column]];
    if (!*word)
        return SARCINA_OK;
    size_t n = strlen(word);
    if (number_length(word, n, true) != n)
        return diag_error(d, "%s:%d: %s: '%s' is not a number", r->path, r->line, k->name, word);
    dim of;
    dim_by_name(k->dimension, &of);
    double value = dim_to_engine(number_read(word, n, 0) * r->to_si[column], of);
    bool is_size = strcmp(k->name, "mass") == 0 || strcmp(k->name, "diameter") == 0;
    if (!isfinite(value) || (is_size && !(value > 0)))
        return diag_error(d, "%s:%d: %s: '%s' is out of range", r->path, r->line, k->name, word);
    memcpy((char *)row + k->offset, &value, sizeof value);
    return SARCINA_OK;
}

static int read_row(reader *r, char *line, cell_row *row, diag *d) {
    const species_table *known_species = &interp_scene(r->in)->species;
    size_t i = 0;
    int status = SARCINA_OK;
    for (char *word; !status && (word = next_word(&line)); i++) {
        if (i >= r->ncolumns)
            return diag_error(d, "%s:%d: more values than columns (%zu)", r->path, r->line, r->ncolumns);
        if (r->columns[i] < 0)
            continue;
        if (known[r->columns[i]].dimension) {
            status = read_number(r, word, i, row, d);
        } else if (*word) {
            row->species = species_find(known_species, word);
            if (row->species < 0)
                return diag_error(d, "%s:%d: no species '%s'", r->path, r->line, word);
        }
    }
    if (!status && i < r->ncolumns)
        return diag_error(d, "%s:%d: %zu values for %zu columns", r->path, r->line, i, r->ncolumns);
    /* of a coccus, size and mass are one */
    const species *sp = &known_species->list[row->species];
    if (!status && sp->shape == SHAPE_COCCUS && row->diameter > 0 && !(row->mass > 0))
        row->mass = shape_coccus_mass(row->diameter, sp->density);
    return status;
}

int cell_file_read(interp *in, const char *path, int species_row, cell_row **rows, size_t *count, diag *d) {
    FILE *f = fopen(path, "r");
    if (!f)
        return diag_error(d, "cannot read '%s': %s", path, strerror(errno));
    reader r = {.in = in, .path = path};
    char *line = NULL;
    size_t room = 0, capacity = 0;
    int status = SARCINA_OK;
    *rows = NULL;
    *count = 0;
    while (!status && getline(&line, &room, f) >= 0) {
        r.line++;
        if (line[strspn(line, " \t\r\n")] == '\0' || line[0] == '#')
            continue;
        if (!r.ncolumns) {
            status = read_header(&r, line, d);
            continue;
        }
        *rows = alloc_grow(*rows, &capacity, *count + 1, sizeof **rows);
        (*rows)[*count] = (cell_row){.species = species_row, .mass = NAN, .diameter = NAN};
        status = read_row(&r, line, &(*rows)[(*count)++], d);
    }
    if (!status && !r.ncolumns)
        status = diag_error(d, "'%s' has no header line", path);
    free(line);
    fclose(f);
    if (status) {
        free(*rows);
        *rows = NULL;
    }
    return status;
}

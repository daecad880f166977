/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "command/cell_file.h"
#include "command/session.h"

#include "base/alloc.h"
#include "base/csv.h"
#include "base/number.h"
#include "base/table.h"
#include "base/units.h"
#include "model/shape.h"
#include "script/names.h"

#include <errno.h>
#include <inttypes.h>
#include <math.h>
#include <sleef.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

/* A column the file may have, and where its number goes (engine units). */
typedef struct known_column {
    const char *name;
    const char *dimension; /* NULL: text */
    size_t offset;
} known_column;

/* A row as it is read: what it says of a cell, and what that follows from. */
typedef struct read_cell {
    cell_row row; /* first: offsets of a cell_row hold */
    double length, angle;
} read_cell;

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
    {"length", "length", offsetof(read_cell, length)},
    {"angle", "angle", offsetof(read_cell, angle)},
    {"aspect", "number", offsetof(cell_row, aspect)},
    {"generation", "number", offsetof(cell_row, generation)},
    {"age", "time", offsetof(cell_row, age)},
    {"id", "id", offsetof(cell_row, id)},
    {"parent", "id", offsetof(cell_row, parent)},
    {"founder", "id", offsetof(cell_row, founder)},
    {"groups", NULL, 0},
    {"fi", "number", offsetof(cell_row, frame[0])},
    {"fj", "number", offsetof(cell_row, frame[1])},
    {"fk", "number", offsetof(cell_row, frame[2])},
    {"fw", "number", offsetof(cell_row, frame[3])},
};
static const char *const particle_names[] = {"x", "y", "z", "vx", "vy", "vz"};
enum { KNOWN = sizeof known / sizeof known[0], PARTICLES_MAX = 100000 };

/* A column of the file: one of those, or a coordinate or velocity of a particle. */
typedef struct column {
    int known;         /* row of `known`; -1: not one of them */
    uint32_t particle; /* from 1; 0: none */
    int component;     /* of the particle: 0 ... 5 of x y z vx vy vz */
    dim of;
    double to_si;
    bool is_engine; /* in the engine's own unit: the number stands as it is */
    bool has_unit;  /* of its own, in the heading */
} column;

typedef struct reader {
    interp *in;
    csv table;
    column *columns;
    size_t ncolumns, capacity;
    uint32_t particles;    /* of the longest cell the columns hold */
    bool lacks_z;          /* cells lie on the substratum, or in the plane of a scene of two dimensions */
    const char *separator; /* of another kind of table, as an error calls it; NULL */
    bool told_far;         /* that a place is far away for want of a unit */
    cell_file *file;
} reader;

/* A field without the blanks at its ends. */
static char *trim(char *word) {
    word += strspn(word, " \t");
    size_t n = strlen(word);
    while (n && strchr(" \t", word[n - 1]))
        word[--n] = '\0';
    return word;
}

static int read_unit(reader *r, const char *text, dim wanted, double *to_si, diag *d) {
    units_value one;
    char *number = alloc_format("1%s", text);
    int status = units_read(interp_units(r->in), number, strlen(number), &one, d);
    free(number);
    if (status)
        return status;
    if (!dim_equal(one.d, wanted))
        return diag_error(d, "%s:%zu: '[%s]' is no unit of this column", r->table.path, r->table.row, text);
    *to_si = one.si;
    return SARCINA_OK;
}

/* x1 ... vz3: a component of a particle. */
static bool find_particle(const char *word, column *c) {
    for (int k = 0; k < 6; k++) {
        size_t n = strlen(particle_names[k]);
        const char *digits = word + n;
        if (strncmp(word, particle_names[k], n) != 0 || !*digits || digits[strspn(digits, "0123456789")])
            continue;
        unsigned long particle = strtoul(digits, NULL, 10);
        if (particle == 0 || particle > PARTICLES_MAX)
            return false;
        c->component = k;
        c->particle = (uint32_t)particle;
        c->of = k < 3 ? DIM_LENGTH : DIM_VELOCITY;
        return true;
    }
    return false;
}

/* Whoever writes a table by hand, or by another program, should learn what of it is not used. */
static void tell_unknown(const reader *r, const char *heading, const char *word) {
    if (interp_checking(r->in))
        return;
    const char *near = table_nearest(known, KNOWN, sizeof known[0], word);
    interp_warn(r->in, "%s:%zu: there is no column '%s': it is left out%s%s%s", r->table.path, r->table.row, heading,
                near ? "; did you mean '" : "", near ? near : "", near ? "'?" : "");
}

/* Takes the unit off a heading: x[um], x [um] or x (um); NULL: there is none. */
static char *split_unit(char *word) {
    char *bracket = strpbrk(word, "[(");
    if (!bracket)
        return NULL;
    bracket[1 + strcspn(bracket + 1, "])")] = '\0';
    *bracket = '\0';
    trim(word);
    return trim(bracket + 1);
}

static int read_heading(reader *r, char *word, diag *d) {
    char *whole = alloc_copy(word), *suffix = split_unit(word);
    r->columns = alloc_grow(r->columns, &r->capacity, r->ncolumns + 1, sizeof *r->columns);
    column *c = &r->columns[r->ncolumns++];
    *c = (column){.known = (int)table_find(known, KNOWN, sizeof known[0], word), .to_si = 1, .has_unit = suffix};
    bool is_known = c->known >= 0 || find_particle(word, c);
    if (!is_known && *whole)
        tell_unknown(r, whole, word);
    free(whole);
    if (!is_known)
        return SARCINA_OK;
    r->particles = c->particle > r->particles ? c->particle : r->particles;
    if (c->known >= 0 && (!known[c->known].dimension || !dim_by_name(known[c->known].dimension, &c->of)))
        return SARCINA_OK; /* a text, or an id */
    if (!suffix && c->known >= 0 && strcmp(known[c->known].name, "angle") == 0) {
        diag_error(d, "%s:%zu: the column 'angle' lacks its unit", r->table.path, r->table.row);
        return diag_help(d, "angle[degree] or angle[rad]: from x towards y");
    }
    c->to_si = interp_unit(r->in, c->of);
    int status = suffix ? read_unit(r, suffix, c->of, &c->to_si, d) : SARCINA_OK;
    c->is_engine = fabs(dim_to_engine(c->to_si, c->of) - 1) < 1e-12;
    return status;
}

static bool has_column(const reader *r, const char *name) {
    for (size_t i = 0; i < r->ncolumns; i++)
        if (r->columns[i].known >= 0 && strcmp(known[r->columns[i].known].name, name) == 0)
            return true;
    return false;
}

/* Tables of spreadsheets may have other separators. */
static int refuse_lack(const reader *r, const char *heading, diag *d) {
    diag_error(d, "%s:%zu: the header lacks the column '%s'", r->table.path, r->table.row, heading);
    if (r->separator)
        return diag_help(d, "this header has %s; columns are parted by commas, and the decimal sign is a point",
                         r->separator);
    if (*heading == 'z')
        return diag_help(d,
                         "without z cells lie on the substratum, or in the plane: 'substratum plane' or 'dimension 2' "
                         "before");
    return diag_help(d, "columns: species x y z mass length diameter angle ux uy uz groups, units in brackets: x[um]");
}

/* A cell has one place, and one axis. */
static int check_header(reader *r, diag *d) {
    static const char *const centre[] = {"x", "y", "z"}, *const axis[] = {"ux", "uy", "uz"};
    scene *s = interp_scene(r->in);
    r->lacks_z = !r->particles && !has_column(r, "z");
    bool has_plane = s->dimension == 2 || s->forces.term[FORCE_SUBSTRATUM].on;
    for (int k = 0; k < 3; k++) {
        bool has = has_column(r, centre[k]);
        if (!has && !r->particles && !(k == 2 && has_plane))
            return refuse_lack(r, centre[k], d);
        if (has && r->particles)
            return diag_error(d,
                              "%s:%zu: a cell's place is that of its centre (%s) or of its particles (%s1 ...), "
                              "not both",
                              r->table.path, r->table.row, centre[k], centre[k]);
        if (has_column(r, "angle") && (r->particles || has_column(r, axis[k])))
            return diag_error(d, "%s:%zu: 'angle' says what '%s' says already: keep one of them", r->table.path,
                              r->table.row, r->particles ? "x1 ..." : axis[k]);
    }
    return SARCINA_OK;
}

static int read_header(reader *r, diag *d) {
    int status = SARCINA_OK;
    if (r->table.n == 1) /* before units are taken off */
        r->separator = strchr(*r->table.fields, ';') ? "';'" : strchr(*r->table.fields, '\t') ? "tabs" : NULL;
    for (size_t i = 0; !status && i < r->table.n; i++)
        status = read_heading(r, trim(r->table.fields[i]), d);
    return status ? status : check_header(r, d);
}

static int refuse_word(const reader *r, const column *c, const char *word, const char *what, diag *d) {
    char name[32];
    if (c->particle)
        snprintf(name, sizeof name, "%s%u", particle_names[c->component], c->particle);
    else
        snprintf(name, sizeof name, "%s", known[c->known].name);
    return diag_error(d, "%s:%zu: %s: '%s' is %s", r->table.path, r->table.row, name, word, what);
}

/* A whole number of a cell's descent. */
static int read_id(const reader *r, const char *word, const column *c, read_cell *cell, diag *d) {
    char *end;
    errno = 0;
    unsigned long long id = strtoull(word, &end, 10);
    if (*end || errno || !(*word >= '0' && *word <= '9'))
        return refuse_word(r, c, word, "not a cell's id", d);
    uint64_t value = id;
    memcpy((char *)cell + known[c->known].offset, &value, sizeof value);
    return SARCINA_OK;
}

/* A table in micrometres without saying so is read in metres. */
static void tell_far(reader *r, const column *c, const char *word, double value) {
    if (c->has_unit || r->told_far || !dim_equal(c->of, DIM_LENGTH) || !(fabs(value) > 1e4) || interp_checking(r->in))
        return;
    r->told_far = true;
    interp_warn(r->in, "%s:%zu: '%s' is %g m, for the column has no unit of its own: write it in the header, as x[um]",
                r->table.path, r->table.row, word, dim_from_engine(value, c->of));
}

static int read_number(reader *r, const char *word, const column *c, read_cell *cell, diag *d) {
    size_t n = strlen(word);
    if (number_length(word, n, true) != n)
        return refuse_word(r, c, word, "not a number", d);
    double value = number_read(word, n, 0);
    if (!c->is_engine)
        value = dim_to_engine(value * c->to_si, c->of);
    const char *name = c->particle ? "" : known[c->known].name;
    bool is_size = strcmp(name, "mass") == 0 || strcmp(name, "diameter") == 0 || strcmp(name, "length") == 0;
    bool is_count = strcmp(name, "generation") == 0;
    if (!isfinite(value) || (is_size && !(value > 0)) ||
        (is_count && !(value >= 0 && value <= INT32_MAX && value == floor(value))))
        return refuse_word(r, c, word, "out of range", d);
    tell_far(r, c, word, value);
    cell_row *row = &cell->row;
    if (!c->particle) {
        memcpy((char *)cell + known[c->known].offset, &value, sizeof value);
    } else if (row->particles) {
        row->particles[6 * (size_t)(c->particle - 1) + (size_t)c->component] = value;
        row->nparticles = c->particle > row->nparticles ? c->particle : row->nparticles;
    }
    return SARCINA_OK;
}

/* The bit the group has, or will have once the cells are there and it is made (cell_file_make_groups). */
static int group_bit(const reader *r, const char *name, diag *d) {
    cell_file *f = r->file;
    int bit = group_find(&f->groups, name);
    if (bit >= 0)
        return bit;
    diag why = {0};
    if (names_check_new(r->in, names_class(r->in, "+group"), name, &why) != SARCINA_OK) {
        diag_error(d, "%s:%zu: groups: %s", r->table.path, r->table.row, why.message);
        return -1;
    }
    bit = group_add(&f->groups, name);
    if (bit < 0) {
        diag_error(d, "%s:%zu: group '%s' is one more than there may be (%d)", r->table.path, r->table.row, name,
                   GROUP_MAX);
        return -1;
    }
    f->made[f->nmade++] = bit;
    return bit;
}

/* Names of groups, parted by blanks. */
static int read_groups(const reader *r, const char *word, read_cell *cell, diag *d) {
    for (const char *at = word + strspn(word, " "); *at; at += strspn(at, " ")) {
        char *name = alloc_copy_n(at, strcspn(at, " "));
        int bit = group_bit(r, name, d);
        if (bit >= 0)
            cell->row.groups |= (uint64_t)1 << bit;
        at += strlen(name);
        free(name);
        if (bit < 0)
            return SARCINA_ERROR;
    }
    return SARCINA_OK;
}

static int read_word(reader *r, const char *word, const column *c, read_cell *cell, diag *d) {
    if (!*word || (c->known < 0 && !c->particle))
        return SARCINA_OK;
    if (c->particle || strcmp(known[c->known].dimension ? known[c->known].dimension : "", "id") != 0) {
        if (c->particle || known[c->known].dimension)
            return read_number(r, word, c, cell, d);
        if (strcmp(known[c->known].name, "groups") == 0)
            return r->file->wants_groups ? read_groups(r, word, cell, d) : SARCINA_OK;
        cell->row.species = species_find(&interp_scene(r->in)->species, word);
        return cell->row.species < 0 ? diag_error(d, "%s:%zu: no species '%s'", r->table.path, r->table.row, word)
                                     : SARCINA_OK;
    }
    return read_id(r, word, c, cell, d);
}

/* The mass of a cell as long as this, caps included; what the file does not say of its width is the species' mean. */
static int take_length(const reader *r, const species *sp, const read_cell *cell, cell_row *row, diag *d) {
    double length = cell->length;
    if (row->mass > 0)
        return diag_error(d, "%s:%zu: length and mass of a cell follow from each other: keep one of them",
                          r->table.path, r->table.row);
    if (sp->shape == SHAPE_COCCUS) {
        row->mass = shape_coccus_mass(length, sp->density);
        return SARCINA_OK;
    }
    double aspect = row->aspect > 0 ? row->aspect : spread_mean(&sp->aspect);
    if (spread_mean(&sp->aspect) > 0)
        row->aspect = aspect, row->diameter = length / aspect;
    else if (!(row->diameter > 0))
        row->diameter = spread_mean(&sp->diameter);
    if (length < row->diameter)
        return diag_error(d, "%s:%zu: length: %g um is less than the diameter, %g um", r->table.path, r->table.row,
                          length, row->diameter);
    row->mass = shape_rod_mass(length - row->diameter, row->diameter, sp->density);
    return SARCINA_OK;
}

/* What the row says must fit its species. */
static int check_row(const reader *r, read_cell *cell, diag *d) {
    cell_row *row = &cell->row;
    if (row->species < 0) {
        diag_error(d, "%s:%zu: the row names no species", r->table.path, r->table.row);
        return diag_help(d, "write a column 'species'; it may be left out where the scene has one alone");
    }
    const species *sp = &interp_scene(r->in)->species.list[row->species];
    size_t wanted = species_particles(sp);
    if (r->particles && row->nparticles != wanted)
        return diag_error(d, "%s:%zu: a cell of %s has %zu %s, not %u", r->table.path, r->table.row, sp->name, wanted,
                          number_noun(wanted, "particle", "particles"), row->nparticles);
    if (!isnan(cell->angle)) {
        row->axis[0] = Sleef_cinz_cosd1_u10purec(cell->angle);
        row->axis[1] = Sleef_cinz_sind1_u10purec(cell->angle);
    }
    row->on_plane = r->lacks_z && interp_scene(r->in)->dimension == 3;
    if (cell->length > 0)
        return take_length(r, sp, cell, row, d);
    /* of a coccus, size and mass are one */
    if (sp->shape == SHAPE_COCCUS && row->diameter > 0 && !(row->mass > 0))
        row->mass = shape_coccus_mass(row->diameter, sp->density);
    return SARCINA_OK;
}

static int read_row(reader *r, cell_row *row, diag *d) {
    size_t n = r->table.n;
    int status = SARCINA_OK;
    read_cell cell = {.row = *row, .length = NAN, .angle = NAN};
    if (r->particles)
        cell.row.particles = alloc_zeroed(6 * (size_t)r->particles, sizeof *row->particles);
    for (size_t i = 0; !status && i < n && i < r->ncolumns; i++)
        status = read_word(r, trim(r->table.fields[i]), &r->columns[i], &cell, d);
    if (!status && n > r->ncolumns)
        status = diag_error(d, "%s:%zu: more values than columns (%zu)", r->table.path, r->table.row, r->ncolumns);
    if (!status && n < r->ncolumns)
        status = diag_error(d, "%s:%zu: %zu %s for %zu columns", r->table.path, r->table.row, n,
                            number_noun(n, "value", "values"), r->ncolumns);
    if (!status)
        status = check_row(r, &cell, d);
    *row = cell.row; /* also after an error: its particles are freed with it */
    return status;
}

void cell_file_free(cell_file *f) {
    for (size_t i = 0; i < f->count; i++)
        free(f->rows[i].particles);
    free(f->rows);
    link_file_free(&f->links);
    *f = (cell_file){0};
}

static int read_table(reader *r, int species_row, diag *d) {
    cell_file *f = r->file;
    int status = SARCINA_OK;
    size_t capacity = 0;
    while (!status && csv_next(&r->table)) {
        if (r->table.n == 1 && !*trim(r->table.fields[0]))
            continue;
        if (!r->ncolumns) {
            status = read_header(r, d);
            continue;
        }
        if (link_file_begins(&r->table))
            return f->wants_links ? link_file_read(&f->links, &r->table, d) : SARCINA_OK;
        f->rows = alloc_grow(f->rows, &capacity, f->count + 1, sizeof *f->rows);
        f->rows[f->count] = (cell_row){.species = species_row, .mass = NAN, .diameter = NAN};
        status = read_row(r, &f->rows[f->count++], d);
    }
    return status;
}

int cell_file_read(interp *in, const char *path, int species_row, bool as_they_were, cell_file *f, diag *d) {
    *f = (cell_file){.wants_links = as_they_were, .wants_groups = as_they_were, .groups = interp_scene(in)->groups};
    reader r = {.in = in, .file = f};
    int status = csv_open(&r.table, path, d);
    if (status)
        return status;
    status = read_table(&r, species_row, d);
    if (!status && !r.ncolumns)
        status = diag_error(d, "'%s' has no header line", path);
    csv_close(&r.table);
    free(r.columns);
    if (status)
        cell_file_free(f);
    return status;
}

void cell_file_make_groups(interp *in, const cell_file *f) {
    for (size_t i = 0; i < f->nmade; i++)
        session_define_group(in, f->groups.name[f->made[i]]);
}

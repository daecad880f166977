/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "command/cell_file.h"

#include "base/alloc.h"
#include "base/csv.h"
#include "base/number.h"
#include "base/path.h"
#include "base/table.h"
#include "base/units.h"
#include "model/shape.h"

#include <errno.h>
#include <inttypes.h>
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
} column;

typedef struct reader {
    interp *in;
    csv table;
    column *columns;
    size_t ncolumns, capacity;
    uint32_t particles; /* of the longest cell the columns hold */
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

static int read_heading(reader *r, char *word, diag *d) {
    char *bracket = strchr(word, '['), *suffix = NULL;
    if (bracket) {
        suffix = bracket + 1;
        *bracket = '\0';
        suffix[strcspn(suffix, "]")] = '\0';
    }
    r->columns = alloc_grow(r->columns, &r->capacity, r->ncolumns + 1, sizeof *r->columns);
    column *c = &r->columns[r->ncolumns++];
    *c = (column){.known = (int)table_find(known, KNOWN, sizeof known[0], word), .to_si = 1};
    if (c->known < 0 && !find_particle(word, c))
        return SARCINA_OK;
    r->particles = c->particle > r->particles ? c->particle : r->particles;
    if (c->known >= 0 && (!known[c->known].dimension || !dim_by_name(known[c->known].dimension, &c->of)))
        return SARCINA_OK; /* a text, or an id */
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

static int read_header(reader *r, diag *d) {
    static const char *const centre[] = {"x", "y", "z"};
    int status = SARCINA_OK;
    for (size_t i = 0; !status && i < r->table.n; i++)
        status = read_heading(r, trim(r->table.fields[i]), d);
    for (int k = 0; !status && k < 3; k++) {
        bool has = has_column(r, centre[k]);
        if (!has && !r->particles) {
            status = diag_error(d, "%s:%zu: the header lacks the column '%s'", r->table.path, r->table.row, centre[k]);
            diag_help(d, "columns: species x y z mass diameter ux uy uz, units in brackets: x[um]");
        } else if (has && r->particles) {
            status = diag_error(d,
                                "%s:%zu: a cell's place is that of its centre (%s) or of its particles (%s1 ...), "
                                "not both",
                                r->table.path, r->table.row, centre[k], centre[k]);
        }
    }
    return status;
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
static int read_id(const reader *r, const char *word, const column *c, cell_row *row, diag *d) {
    char *end;
    errno = 0;
    unsigned long long id = strtoull(word, &end, 10);
    if (*end || errno || !(*word >= '0' && *word <= '9'))
        return refuse_word(r, c, word, "not a cell's id", d);
    uint64_t value = id;
    memcpy((char *)row + known[c->known].offset, &value, sizeof value);
    return SARCINA_OK;
}

static int read_number(const reader *r, const char *word, const column *c, cell_row *row, diag *d) {
    size_t n = strlen(word);
    if (number_length(word, n, true) != n)
        return refuse_word(r, c, word, "not a number", d);
    double value = number_read(word, n, 0);
    if (!c->is_engine)
        value = dim_to_engine(value * c->to_si, c->of);
    const char *name = c->particle ? "" : known[c->known].name;
    bool is_size = strcmp(name, "mass") == 0 || strcmp(name, "diameter") == 0;
    bool is_count = strcmp(name, "generation") == 0;
    if (!isfinite(value) || (is_size && !(value > 0)) ||
        (is_count && !(value >= 0 && value <= INT32_MAX && value == floor(value))))
        return refuse_word(r, c, word, "out of range", d);
    if (!c->particle) {
        memcpy((char *)row + known[c->known].offset, &value, sizeof value);
    } else if (row->particles) {
        row->particles[6 * (size_t)(c->particle - 1) + (size_t)c->component] = value;
        row->nparticles = c->particle > row->nparticles ? c->particle : row->nparticles;
    }
    return SARCINA_OK;
}

static void refuse_group(const reader *r, const char *name, diag *d) {
    diag_error(d, "%s:%zu: no group '%s'", r->table.path, r->table.row, name);
    diag_help(d, "'group %s where 0' before makes an empty one, which these cells join", name);
}

/* Names of groups, parted by blanks. */
static int read_groups(const reader *r, const char *word, cell_row *row, diag *d) {
    for (const char *at = word + strspn(word, " "); *at; at += strspn(at, " ")) {
        char *name = alloc_copy_n(at, strcspn(at, " "));
        int bit = group_find(&interp_scene(r->in)->groups, name);
        if (bit >= 0)
            row->groups |= (uint64_t)1 << bit;
        else
            refuse_group(r, name, d);
        at += strlen(name);
        free(name);
        if (bit < 0)
            return SARCINA_ERROR;
    }
    return SARCINA_OK;
}

static int read_word(const reader *r, const char *word, const column *c, cell_row *row, diag *d) {
    if (!*word || (c->known < 0 && !c->particle))
        return SARCINA_OK;
    if (c->particle || strcmp(known[c->known].dimension ? known[c->known].dimension : "", "id") != 0) {
        if (c->particle || known[c->known].dimension)
            return read_number(r, word, c, row, d);
        if (strcmp(known[c->known].name, "groups") == 0)
            return read_groups(r, word, row, d);
        row->species = species_find(&interp_scene(r->in)->species, word);
        return row->species < 0 ? diag_error(d, "%s:%zu: no species '%s'", r->table.path, r->table.row, word)
                                : SARCINA_OK;
    }
    return read_id(r, word, c, row, d);
}

/* What the row says must fit its species. */
static int check_row(const reader *r, cell_row *row, diag *d) {
    if (row->species < 0)
        return diag_error(d, "%s:%zu: the row names no species", r->table.path, r->table.row);
    const species *sp = &interp_scene(r->in)->species.list[row->species];
    size_t wanted = species_particles(sp);
    if (r->particles && row->nparticles != wanted)
        return diag_error(d, "%s:%zu: a cell of %s has %zu particle%s, not %u", r->table.path, r->table.row, sp->name,
                          wanted, wanted == 1 ? "" : "s", row->nparticles);
    /* of a coccus, size and mass are one */
    if (sp->shape == SHAPE_COCCUS && row->diameter > 0 && !(row->mass > 0))
        row->mass = shape_coccus_mass(row->diameter, sp->density);
    return SARCINA_OK;
}

static int read_row(reader *r, cell_row *row, diag *d) {
    size_t n = r->table.n;
    int status = SARCINA_OK;
    if (r->particles)
        row->particles = alloc_zeroed(6 * (size_t)r->particles, sizeof *row->particles);
    for (size_t i = 0; !status && i < n && i < r->ncolumns; i++)
        status = read_word(r, trim(r->table.fields[i]), &r->columns[i], row, d);
    if (!status && n > r->ncolumns)
        status = diag_error(d, "%s:%zu: more values than columns (%zu)", r->table.path, r->table.row, r->ncolumns);
    if (!status && n < r->ncolumns)
        status = diag_error(d, "%s:%zu: %zu values for %zu columns", r->table.path, r->table.row, n, r->ncolumns);
    return status ? status : check_row(r, row, d);
}

void cell_file_free(cell_row *rows, size_t count) {
    for (size_t i = 0; rows && i < count; i++)
        free(rows[i].particles);
    free(rows);
}

int cell_file_read(interp *in, const char *path, int species_row, cell_row **rows, size_t *count, link_file *links,
                   diag *d) {
    *rows = NULL;
    *count = 0;
    reader r = {.in = in};
    size_t capacity = 0;
    int status = csv_open(&r.table, path, d);
    if (status)
        return status;
    while (!status && csv_next(&r.table)) {
        if (r.table.n == 1 && !*trim(r.table.fields[0]))
            continue;
        if (!r.ncolumns) {
            status = read_header(&r, d);
            continue;
        }
        if (link_file_begins(&r.table)) {
            status = links ? link_file_read(links, &r.table, d) : SARCINA_OK;
            break;
        }
        *rows = alloc_grow(*rows, &capacity, *count + 1, sizeof **rows);
        (*rows)[*count] = (cell_row){.species = species_row, .mass = NAN, .diameter = NAN};
        status = read_row(&r, &(*rows)[(*count)++], d);
    }
    if (!status && !r.ncolumns)
        status = diag_error(d, "'%s' has no header line", path);
    csv_close(&r.table);
    free(r.columns);
    if (status) {
        cell_file_free(*rows, *count);
        *rows = NULL;
        *count = 0;
    }
    return status;
}

/* ---- writing ---------------------------------------------------------------------------------------------------- */

/* Columns that not every scene needs. */
typedef struct extent {
    uint32_t particles; /* of the longest cell */
    bool aspect, groups, frame;
} extent;

static extent find_extent(const cell_columns *c) {
    extent e = {.particles = 1};
    for (size_t i = 0; i < c->count; i++) {
        const double *frame = c->frame + 4 * i;
        e.particles = c->nparticles[i] > e.particles ? c->nparticles[i] : e.particles;
        e.aspect = e.aspect || c->aspect[i] > 0;
        e.groups = e.groups || c->groups[i];
        e.frame = e.frame || frame[0] != 0 || frame[1] != 0 || frame[2] != 0 || frame[3] != 0;
    }
    return e;
}

static void write_header(FILE *f, const scene *s, const extent *e) {
    uint32_t particles = e->particles;
    fprintf(f, "# sarcina cells: step %" PRIu64 ", time %.17g s\n", s->step, s->time);
    fprintf(f, "species,id,parent,founder,generation,age[s],mass[pg],diameter[um]%s%s%s", e->aspect ? ",aspect" : "",
            e->groups ? ",groups" : "", e->frame ? ",fi,fj,fk,fw" : "");
    for (uint32_t i = 1; i <= particles; i++)
        fprintf(f, ",x%u[um],y%u[um],z%u[um]", i, i, i);
    for (uint32_t i = 1; i <= particles; i++)
        fprintf(f, ",vx%u[um/s],vy%u[um/s],vz%u[um/s]", i, i, i);
    fputc('\n', f);
}

/* Three numbers a particle; a cell with fewer of them leaves columns empty. */
static void write_vectors(FILE *f, const double *v, uint32_t n, uint32_t particles) {
    for (uint32_t i = 0; i < 3 * particles; i++)
        if (i < 3 * n)
            fprintf(f, ",%.17g", v[i]);
        else
            fputc(',', f);
}

static void write_groups(FILE *f, const scene *s, uint64_t groups) {
    const char *before = ",";
    if (!groups)
        fputc(',', f);
    for (int bit = 0; bit < GROUP_MAX; bit++)
        if (groups >> bit & 1) {
            fprintf(f, "%s%s", before, s->groups.name[bit]);
            before = " ";
        }
}

static void write_cell(FILE *f, const scene *s, uint32_t row, const extent *e) {
    const cell_columns *c = &s->colony->cell;
    uint32_t particles = e->particles;
    const double *frame = c->frame + 4 * (size_t)row;
    fprintf(f, "%s,%" PRIu64 ",%" PRIu64 ",%" PRIu64 ",%d,%.17g,%.17g,%.17g", s->species.list[c->species[row]].name,
            c->id[row], c->parent[row], c->founder[row], c->generation[row], s->time - c->birth[row], c->mass[row],
            c->diameter[row]);
    if (e->aspect)
        fprintf(f, ",%.17g", c->aspect[row]);
    if (e->groups)
        write_groups(f, s, c->groups[row]);
    if (e->frame)
        fprintf(f, ",%.17g,%.17g,%.17g,%.17g", frame[0], frame[1], frame[2], frame[3]);
    write_vectors(f, s->colony->particle.x + 3 * (size_t)c->first[row], c->nparticles[row], particles);
    write_vectors(f, s->colony->particle.v + 3 * (size_t)c->first[row], c->nparticles[row], particles);
    fputc('\n', f);
}

int cell_file_write(interp *in, const char *path, diag *d) {
    const scene *s = interp_scene(in);
    const cell_columns *c = &s->colony->cell;
    const extent e = find_extent(c);
    FILE *f = path_open(path, "w", d);
    if (!f)
        return SARCINA_ERROR;
    write_header(f, s, &e);
    const uint32_t *order = colony_by_id(s->colony);
    for (size_t i = 0; i < c->count; i++)
        write_cell(f, s, order[i], &e);
    link_file_write(f, s);
    return path_close(f, path, d);
}

/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "app/oracle_data.h"

#include "base/alloc.h"
#include "base/dim.h"
#include "base/path.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

static char *read_whole(const char *path) {
    FILE *file = fopen(path, "rb");
    char *text = file ? path_read_all(file, NULL) : NULL;
    if (file)
        fclose(file);
    return text;
}

static size_t count_char(const char *text, char c) {
    size_t n = 0;
    for (; *text; text++)
        n += *text == c;
    return n;
}

/* Splits a line at commas into at most n fields; returns how many it has. */
static size_t split(char *line, const char **fields, size_t n) {
    size_t count = 0;
    while (line) {
        char *comma = strchr(line, ',');
        if (comma)
            *comma = '\0';
        if (count < n)
            fields[count] = line;
        count++;
        line = comma ? comma + 1 : NULL;
    }
    return count;
}

bool oracle_table_read(oracle_table *t, const char *folder, const char *name) {
    memset(t, 0, sizeof *t);
    char *path = alloc_format("%s/%s", folder, name);
    t->text = read_whole(path);
    if (!t->text) {
        fprintf(stderr, "oracle: cannot read %s\n", path);
        free(path);
        return false;
    }
    size_t lines = count_char(t->text, '\n') + 1;
    char *rest = t->text, *line = strsep(&rest, "\n");
    t->ncolumns = count_char(line, ',') + 1;
    t->head = alloc_zeroed(t->ncolumns, sizeof *t->head);
    t->at = alloc_zeroed(lines * t->ncolumns, sizeof *t->at);
    split(line, t->head, t->ncolumns);
    bool regular = true;
    while ((line = strsep(&rest, "\n")))
        if (*line)
            regular = split(line, t->at + t->nrows++ * t->ncolumns, t->ncolumns) == t->ncolumns && regular;
    if (!regular)
        fprintf(stderr, "oracle: %s has rows of unequal length\n", path);
    free(path);
    return regular;
}

void oracle_table_free(oracle_table *t) {
    free(t->text);
    free(t->head);
    free(t->at);
    memset(t, 0, sizeof *t);
}

static bool read_tables(oracle_tables *t, const char *folder) {
    return oracle_table_read(&t->particles, folder, "particles.csv") &&
           oracle_table_read(&t->springs, folder, "springs.csv") && oracle_table_read(&t->params, folder, "params.csv");
}

int oracle_main(int argc, char **argv, oracle_check *check) {
    oracle_tables t = {0};
    if (argc != 2) {
        const char *slash = strrchr(argv[0], '/');
        fprintf(stderr, "usage: %s FOLDER\n", slash ? slash + 1 : argv[0]);
        return 2;
    }
    int count[2] = {0}, code = read_tables(&t, argv[1]) ? 0 : 2;
    for (size_t i = 0; i < t.params.nrows && !code; i++) {
        oracle_verdict v = check(oracle_table_text(&t.params, i, "state"), &t);
        if (v != ORACLE_SKIPPED)
            count[v == ORACLE_PASSED]++;
    }
    if (!code)
        printf("%d passed, %d failed\n", count[1], count[0]);
    oracle_table_free(&t.particles);
    oracle_table_free(&t.springs);
    oracle_table_free(&t.params);
    return code ? code : count[0] || !count[1];
}

const char *oracle_table_text(const oracle_table *t, size_t row, const char *column) {
    for (size_t i = 0; i < t->ncolumns; i++)
        if (strcmp(t->head[i], column) == 0)
            return t->at[row * t->ncolumns + i];
    fprintf(stderr, "oracle: no column %s\n", column);
    exit(2);
}

double oracle_table_number(const oracle_table *t, size_t row, const char *column) {
    return strtod(oracle_table_text(t, row, column), NULL);
}

static bool has_column(const oracle_table *t, const char *column) {
    for (size_t i = 0; i < t->ncolumns; i++)
        if (strcmp(t->head[i], column) == 0)
            return true;
    return false;
}

static bool is_of(const oracle_table *t, size_t row, const char *state) {
    return !has_column(t, "state") || strcmp(oracle_table_text(t, row, "state"), state) == 0;
}

static double number(const oracle_table *t, size_t row, const char *column, dim d) {
    return dim_to_engine(oracle_table_number(t, row, column), d);
}

static void read_vector(const oracle_table *t, size_t row, const char *const columns[3], dim d, double out[3]) {
    for (int k = 0; k < 3; k++)
        out[k] = number(t, row, columns[k], d);
}

/* The state's params row sets every force. */
static bool set_forces(oracle_scene *s, const char *state, const oracle_table *params) {
    size_t row = 0;
    while (row < params->nrows && strcmp(oracle_table_text(params, row, "state"), state) != 0)
        row++;
    if (row == params->nrows) {
        fprintf(stderr, "oracle: no parameters for state %s\n", state);
        return false;
    }
    force_settings *collision = &s->forces.term[FORCE_COLLISION], *wall = &s->forces.term[FORCE_SUBSTRATUM];
    force_settings *dlvo = &s->forces.term[FORCE_DLVO], *damping = &s->forces.term[FORCE_DAMPING];
    collision->on = true;
    collision->p[COLLISION_K] = number(params, row, "Kc", DIM_STIFFNESS);
    collision->p[COLLISION_REACH] = oracle_table_number(params, row, "radius_multiplier");
    collision->p[COLLISION_CONTACT] = CONTACT_CLOSEST;
    collision->p[COLLISION_EPSILON] = 0.01;
    wall->on = oracle_table_number(params, row, "wall") != 0;
    wall->p[SUBSTRATUM_K] = number(params, row, "Kw", DIM_STIFFNESS);
    dlvo->on = oracle_table_number(params, row, "dlvo") != 0;
    dlvo->p[DLVO_CES] = number(params, row, "Ces", DIM_ENERGY);
    dlvo->p[DLVO_CVDW] = number(params, row, "Cvdw", DIM(3, 1, -2));
    dlvo->p[DLVO_KAPPA] = number(params, row, "kappa", DIM(-1, 0, 0));
    dlvo->p[DLVO_CLAMP] = oracle_table_number(params, row, "dlimFactor");
    damping->on = true;
    damping->p[DAMPING_K] = number(params, row, "Kd", DIM(0, 1, -1));
    return true;
}

/* Cells of one or two particles, which follow each other in the table. */
static void add_cells(oracle_scene *s, const char *state, const oracle_table *t) {
    static const char *const positions[2][3] = {{"x", "y", "z"}, {"x_m", "y_m", "z_m"}};
    static const char *const velocities[3] = {"vx", "vy", "vz"};
    const char *const *place = positions[has_column(t, "x_m")];
    s->row = alloc_zeroed(t->nrows, sizeof *s->row);
    for (size_t i = 0; i < t->nrows;) {
        double x[6], v[6], mass = 0;
        size_t n = 0, first = i;
        const char *cell = oracle_table_text(t, i, "cell");
        if (!is_of(t, i, state)) {
            i++;
            continue;
        }
        for (; i < t->nrows && n < 2 && is_of(t, i, state) && strcmp(cell, oracle_table_text(t, i, "cell")) == 0; i++) {
            read_vector(t, i, place, DIM_LENGTH, x + 3 * n);
            read_vector(t, i, velocities, DIM_VELOCITY, v + 3 * n);
            mass += number(t, i, "mass_kg", DIM_MASS);
            n++;
        }
        uint32_t row = colony_add_cell(s->colony, n, x);
        memcpy(s->colony->particle.v + 3 * (size_t)s->colony->cell.first[row], v, 3 * n * sizeof *v);
        s->colony->cell.species[row] = n == 1 ? 0 : 1;
        s->colony->cell.mass[row] = mass;
        s->colony->cell.diameter[row] = 2 * number(t, first, "radius_m", DIM_LENGTH);
        for (size_t p = 0; p < n; p++)
            s->row[s->nparticles++] = s->colony->cell.first[row] + (uint32_t)p;
    }
}

static uint32_t cell_of(const colony *c, uint32_t particle) {
    for (uint32_t i = 0; i < c->cell.count; i++)
        if (particle - c->cell.first[i] < c->cell.nparticles[i])
            return i;
    return COLONY_NO_ROW;
}

/* The one constant of all rods' springs; 0 when they differ. */
static double internal_constant(const char *state, const oracle_table *t) {
    double k = 0;
    for (size_t i = 0; i < t->nrows; i++) {
        if (!is_of(t, i, state) || strcmp(oracle_table_text(t, i, "kind"), "rod") != 0)
            continue;
        double other = number(t, i, "K_N_per_m", DIM_STIFFNESS);
        if (k != 0 && other != k)
            return 0;
        k = other;
    }
    return k;
}

static void add_spring(oracle_scene *s, const oracle_table *t, size_t i, uint32_t a) {
    static const char *const anchor[3] = {"anchor_x", "anchor_y", "anchor_z"};
    colony *c = s->colony;
    bool anchors = strcmp(oracle_table_text(t, i, "kind"), "anchor") == 0;
    uint32_t b = anchors ? SPRING_ANCHOR : s->row[(size_t)oracle_table_number(t, i, "j")];
    uint64_t id_a = c->cell.id[cell_of(c, a)], id_b = anchors ? 0 : c->cell.id[cell_of(c, b)];
    uint32_t link = colony_add_link(c, anchors ? LINK_ANCHOR : LINK_SPRING, id_a, id_b, 1);
    uint32_t spring = c->link.first[link];
    c->spring.a[spring] = a;
    c->spring.b[spring] = b;
    c->spring.k[spring] = number(t, i, "K_N_per_m", DIM_STIFFNESS);
    c->spring.rest[spring] = number(t, i, "rest_m", DIM_LENGTH);
    c->spring.glides[spring] = oracle_table_number(t, i, "gliding") != 0;
    if (anchors)
        read_vector(t, i, anchor, DIM_LENGTH, c->spring.anchor + 3 * (size_t)spring);
}

static void add_springs(oracle_scene *s, const char *state, const oracle_table *t) {
    double k = internal_constant(state, t);
    s->species.list[1].internal_k = k;
    for (size_t i = 0; i < t->nrows; i++) {
        if (!is_of(t, i, state))
            continue;
        uint32_t a = s->row[(size_t)oracle_table_number(t, i, "i")];
        bool rod = strcmp(oracle_table_text(t, i, "kind"), "rod") == 0;
        if (rod)
            s->colony->cell.rest[cell_of(s->colony, a)] = number(t, i, "rest_m", DIM_LENGTH);
        if (!rod || k == 0)
            add_spring(s, t, i, a);
    }
}

bool oracle_scene_make(oracle_scene *s, const char *state, const oracle_table *particles, const oracle_table *springs,
                       const oracle_table *params) {
    memset(s, 0, sizeof *s);
    s->colony = colony_create();
    species_add(&s->species, "coccus");
    species_add(&s->species, "rod");
    s->species.list[1].shape = SHAPE_ROD;
    s->species.list[0].density = s->species.list[1].density = 1.01;
    if (!set_forces(s, state, params))
        return false;
    add_cells(s, state, particles);
    add_springs(s, state, springs);
    return true;
}

void oracle_scene_free(oracle_scene *s) {
    colony_free(s->colony);
    free(s->species.list);
    free(s->row);
    memset(s, 0, sizeof *s);
}

void oracle_scene_compare(const oracle_scene *s, const char *state, const oracle_table *particles, const double *force,
                          const double *mass, double *deviation, double *largest) {
    static const char *const columns[3] = {"ax", "ay", "az"};
    size_t p = 0;
    *deviation = *largest = 0;
    for (size_t i = 0; i < particles->nrows; i++) {
        if (!is_of(particles, i, state))
            continue;
        double square = 0, square_ref = 0;
        uint32_t row = s->row[p++];
        for (size_t k = 0; k < 3; k++) {
            double a = dim_from_engine(force[3 * (size_t)row + k] / mass[row], DIM(1, 0, -2));
            double ref = oracle_table_number(particles, i, columns[k]);
            square += (a - ref) * (a - ref);
            square_ref += ref * ref;
        }
        *deviation = fmax(*deviation, sqrt(square));
        *largest = fmax(*largest, sqrt(square_ref));
    }
}

int oracle_scene_bind(const oracle_scene *s, mechanics *m, diag *d) {
    const mechanics_input in = {
        .colony = s->colony, .species = &s->species, .forces = &s->forces, .neighbor = {.skin = -1}, .threads = 1};
    return mechanics_prepare(m, &in, d);
}

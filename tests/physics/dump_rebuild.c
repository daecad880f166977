/* SPDX-License-Identifier: GPL-3.0-or-later */
/* A `custom` dump of the cells and a `link` dump hold the whole mechanical scene: read back by a reader that knows only
 * the files, the forces are those of the scene that was written. */
#include "check.h"

#include "analysis/value.h"
#include "base/alloc.h"
#include "engine/scene.h"
#include "output/dump.h"

#include <gsl/gsl_rng.h>
#include <inttypes.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

enum { CELLS = 60 };

static void act(scene *s) {
    s->forces.term[FORCE_INTERNAL].on = true;
    s->forces.term[FORCE_SPRINGS].on = true;
    s->forces.term[FORCE_COLLISION] = (force_settings){true,
                                                       {[COLLISION_K] = 1e5,
                                                        [COLLISION_REACH] = 1.01,
                                                        [COLLISION_CONTACT] = CONTACT_REGULARISED,
                                                        [COLLISION_EPSILON] = 0.01}};
    s->forces.term[FORCE_SUBSTRATUM] = (force_settings){true, {[SUBSTRATUM_K] = 1e5}};
    s->forces.term[FORCE_DAMPING] = (force_settings){true, {[DAMPING_K] = 100}};
}

static void add_species(scene *s, const char *name, shape_kind shape, double k) {
    int row = species_add(&s->species, name);
    species *kind = &s->species.list[row];
    kind->shape = shape;
    kind->density = 1.01;
    kind->internal_k = k;
}

static void add_cell(scene *s, gsl_rng *r, int kind) {
    double x[6], length = 1 + gsl_rng_uniform(r);
    for (int i = 0; i < 3; i++)
        x[i] = 8 * gsl_rng_uniform(r);
    double angle = 2 * M_PI * gsl_rng_uniform(r), rise = gsl_rng_uniform(r) - 0.5;
    x[3] = x[0] + length * cos(angle);
    x[4] = x[1] + length * sin(angle);
    x[5] = x[2] + length * rise;
    uint32_t row = colony_add_cell(s->colony, kind ? 1 : 2, x);
    s->colony->cell.species[row] = kind;
    s->colony->cell.diameter[row] = 0.7 + 0.1 * gsl_rng_uniform(r);
    s->colony->cell.mass[row] = 1 + gsl_rng_uniform(r);
    s->colony->cell.rest[row] = kind ? 0 : 1.2 + gsl_rng_uniform(r);
}

/* A link with springs from every particle of a to every one of b, or to the substratum. */
static void add_link(colony *c, gsl_rng *r, link_kind kind, uint32_t a, uint32_t b) {
    uint32_t na = c->cell.nparticles[a], nb = kind == LINK_ANCHOR ? 1 : c->cell.nparticles[b];
    uint32_t link = colony_add_link(c, kind, c->cell.id[a], kind == LINK_ANCHOR ? 0 : c->cell.id[b], na * nb);
    for (uint32_t i = 0; i < na * nb; i++) {
        uint32_t s = c->link.first[link] + i;
        c->spring.a[s] = c->cell.first[a] + i / nb;
        c->spring.b[s] = kind == LINK_ANCHOR ? SPRING_ANCHOR : c->cell.first[b] + i % nb;
        c->spring.k[s] = 1e4 * gsl_rng_uniform(r);
        c->spring.rest[s] = gsl_rng_uniform(r);
        for (int k = 0; k < 2 && kind == LINK_ANCHOR; k++)
            c->spring.anchor[3 * (size_t)s + (size_t)k] = 8 * gsl_rng_uniform(r);
        c->spring.glides[s] = kind == LINK_ANCHOR && a % 2;
    }
}

static scene *make(void) {
    scene *s = scene_create();
    gsl_rng *r = gsl_rng_alloc(gsl_rng_mt19937);
    add_species(s, "rod", SHAPE_ROD, 5e4);
    add_species(s, "ball", SHAPE_COCCUS, 0);
    act(s);
    for (int i = 0; i < CELLS; i++)
        add_cell(s, r, i % 4 == 3);
    for (uint32_t i = 0; i < 30; i++)
        add_link(s->colony, r, (link_kind)(i % 3), i, (i * 17 + 1) % CELLS);
    uint32_t rows[CELLS]; /* ids are not in the order of rows */
    for (uint32_t i = 0; i < CELLS; i++)
        rows[i] = 7 * i % CELLS;
    colony_arrange(s->colony, rows, CELLS);
    gsl_rng_free(r);
    return s;
}

/* ---- writing ---------------------------------------------------------------------------------------------------- */

static const char *const names[] = {"id", "species", "mass", "diameter", "x", "y", "z", "ux", "uy", "uz", "length"};
enum { COLUMNS = sizeof names / sizeof names[0] };

typedef struct source {
    const value_style *style;
    view v;
} source;

static int give_number(void *self, uint32_t row, double *si, diag *d) {
    (void)d;
    source *from = self;
    *si = dim_from_engine(from->style->cell(&from->v, row), value_dim(from->style));
    return SARCINA_OK;
}

static int give_text(void *self, uint32_t row, char out[64], diag *d) {
    (void)d;
    source *from = self;
    snprintf(out, 64, "%s", from->style->text(&from->v, row));
    return SARCINA_OK;
}

static void write_files(scene *s, const char *cells, const char *links) {
    source from[COLUMNS];
    output_column columns[COLUMNS];
    view v = scene_view(s);
    for (int i = 0; i < COLUMNS; i++) {
        from[i] = (source){value_find(names[i]), v};
        columns[i] = (output_column){.name = (char *)names[i],
                                     .self = &from[i],
                                     .is_text = from[i].style->text != NULL,
                                     .number = give_number,
                                     .text = give_text};
    }
    const dump_frame f = {.view = &v, .columns = columns, .ncolumns = COLUMNS};
    assert_int_equal(dump_write_now(dump_find("custom"), cells, &f, NULL), SARCINA_OK);
    assert_int_equal(dump_write_now(dump_find("link"), links, &f, NULL), SARCINA_OK);
}

/* ---- reading: SI text to a colony ------------------------------------------------------------------------------- */

static void read_cells(scene *s, const char *path) {
    char line[1024], kind[64];
    unsigned long long id;
    double m, d, x, y, z, ux, uy, uz, l;
    FILE *f = fopen(path, "r");
    assert_non_null(f);
    do
        assert_non_null(fgets(line, sizeof line, f));
    while (strncmp(line, "ITEM: ATOMS", 11) != 0);
    assert_string_equal(line, "ITEM: ATOMS id element mass diameter x y z ux uy uz length\n");
    while (fgets(line, sizeof line, f)) {
        assert_int_equal(sscanf(line, "%llu %63s %lf %lf %lf %lf %lf %lf %lf %lf %lf", &id, kind, &m, &d, &x, &y, &z,
                                &ux, &uy, &uz, &l),
                         11);
        bool rod = strcmp(kind, "rod") == 0;
        double h = 0.5 * (l - d), p[6] = {x - h * ux, y - h * uy, z - h * uz, x + h * ux, y + h * uy, z + h * uz};
        for (int i = 0; i < 6; i++)
            p[i] *= 1e6;
        uint32_t row = colony_add_cell(s->colony, rod ? 2 : 1, p);
        s->colony->cell.id[row] = id;
        s->colony->cell.species[row] = !rod;
        s->colony->cell.mass[row] = m * 1e15;
        s->colony->cell.diameter[row] = d * 1e6;
    }
    fclose(f);
}

/* The k-th of a line's fields. */
static double field(const char *line, int k) {
    for (; k > 0; k--)
        line = strchr(line, ',') + 1;
    return strtod(line, NULL);
}

static void read_spring(scene *s, const char *line) {
    colony *c = s->colony;
    uint32_t a = colony_row(c, (uint64_t)field(line, 2));
    uint64_t cell_b = (uint64_t)field(line, 4);
    double k = field(line, 6) * 1e15, rest = field(line, 7) * 1e6;
    if (strncmp(strchr(line, ',') + 1, "internal", 8) == 0) {
        c->cell.rest[a] = rest;
        s->species.list[c->cell.species[a]].internal_k = k;
        return;
    }
    uint32_t link = colony_add_link(c, cell_b ? LINK_SPRING : LINK_ANCHOR, c->cell.id[a], cell_b, 1);
    uint32_t spring = c->link.first[link];
    c->spring.a[spring] = c->cell.first[a] + (uint32_t)field(line, 3);
    c->spring.b[spring] =
        cell_b ? c->cell.first[colony_row(c, cell_b)] + (uint32_t)field(line, 5) : (uint32_t)SPRING_ANCHOR;
    c->spring.k[spring] = k;
    c->spring.rest[spring] = rest;
    for (int i = 0; i < 3 && !cell_b; i++)
        c->spring.anchor[3 * (size_t)spring + (size_t)i] = field(line, 8 + i) * 1e6;
    c->spring.glides[spring] = (uint32_t)field(line, 11);
}

static void read_springs(scene *s, const char *path) {
    char line[1024];
    FILE *f = fopen(path, "r");
    assert_non_null(f);
    assert_non_null(fgets(line, sizeof line, f));
    while (fgets(line, sizeof line, f))
        read_spring(s, line);
    fclose(f);
}

static void check_forces(scene *written, scene *read) {
    view a = scene_view(written), b = scene_view(read);
    size_t n = a.colony->particle.count;
    double *fa = alloc_zeroed(3 * n, sizeof *fa), *fb = alloc_zeroed(3 * n, sizeof *fb), most = 0, worst = 0;
    assert_non_null(a.mechanics);
    assert_non_null(b.mechanics);
    assert_int_equal(b.colony->particle.count, n);
    mechanics_force(a.mechanics, a.colony->particle.x, a.colony->particle.v, fa);
    mechanics_force(b.mechanics, b.colony->particle.x, b.colony->particle.v, fb);
    for (uint32_t row = 0; row < CELLS; row++) {
        uint32_t twin = colony_row(b.colony, a.colony->cell.id[row]);
        for (size_t i = 0; i < 3 * (size_t)a.colony->cell.nparticles[row]; i++) {
            double x = fa[3 * (size_t)a.colony->cell.first[row] + i],
                   y = fb[3 * (size_t)b.colony->cell.first[twin] + i];
            most = fmax(most, fabs(x));
            worst = fmax(worst, fabs(x - y));
        }
    }
    assert_true(most > 1e4);
    assert_near(worst / most, 0, 1e-12);
    free(fa);
    free(fb);
}

static void test_the_scene_is_built_again(void **state) {
    (void)state;
    char cells[] = "cells.XXXXXX", links[] = "links.XXXXXX";
    close(mkstemp(cells));
    close(mkstemp(links));
    scene *written = make(), *read = scene_create();
    write_files(written, cells, links);
    add_species(read, "rod", SHAPE_ROD, 0);
    add_species(read, "ball", SHAPE_COCCUS, 0);
    act(read);
    read_cells(read, cells);
    read_springs(read, links);
    check_forces(written, read);
    scene_free(written);
    scene_free(read);
    remove(cells);
    remove(links);
}

int main(void) {
    const struct CMUnitTest tests[] = {cmocka_unit_test(test_the_scene_is_built_again)};
    return cmocka_run_group_tests(tests, NULL, NULL);
}

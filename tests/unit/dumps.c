/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Every text dump is written and read back by a reader that knows only the format. */
#include "check.h"
#include "scratch.h"

#include "base/alloc.h"
#include "output/dump.h"

#include <gsl/gsl_rng.h>
#include <inttypes.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

/* ---- the scene: rods of species "rod, long" and cocci "ball", with links of every kind -------------------------- */

typedef struct culture {
    colony *c;
    species_table species;
    view v;
} culture;

static double draw(gsl_rng *r) {
    return 20 * gsl_rng_uniform(r) - 10;
}

static void add_cell(culture *k, gsl_rng *r, int kind) {
    double x[6];
    for (int i = 0; i < 6; i++)
        x[i] = draw(r);
    colony *c = k->c;
    uint32_t row = colony_add_cell(c, kind ? 1 : 2, x);
    c->cell.species[row] = kind;
    c->cell.diameter[row] = 0.5 + gsl_rng_uniform(r);
    c->cell.mass[row] = 1 + gsl_rng_uniform(r);
    c->cell.rest[row] = kind ? 0 : 2 + gsl_rng_uniform(r);
}

static void fill_spring(colony *c, gsl_rng *r, uint32_t s, uint32_t a, uint32_t b) {
    c->spring.a[s] = a;
    c->spring.b[s] = b;
    c->spring.k[s] = 500 * gsl_rng_uniform(r);
    c->spring.rest[s] = 2 * gsl_rng_uniform(r);
    if (b == SPRING_ANCHOR) {
        for (int i = 0; i < 3; i++)
            c->spring.anchor[3 * (size_t)s + (size_t)i] = draw(r);
        c->spring.glides[s] = s % 2;
    }
}

/* A link with one spring from each particle of a to the last of b (b COLONY_NO_ROW: to the substratum). */
static void add_link(culture *k, gsl_rng *r, link_kind kind, uint32_t a, uint32_t b) {
    colony *c = k->c;
    uint32_t n = c->cell.nparticles[a];
    uint32_t link = colony_add_link(c, kind, c->cell.id[a], b == COLONY_NO_ROW ? 0 : c->cell.id[b], n);
    c->link.birth[link] = -60.0 * link;
    for (uint32_t i = 0; i < n; i++)
        fill_spring(c, r, c->link.first[link] + i, c->cell.first[a] + i,
                    b == COLONY_NO_ROW ? SPRING_ANCHOR : c->cell.first[b] + c->cell.nparticles[b] - 1);
}

static culture make(void) {
    culture k = {.c = colony_create()};
    gsl_rng *r = gsl_rng_alloc(gsl_rng_mt19937);
    species_add(&k.species, "rod, long");
    species_add(&k.species, "ball");
    k.species.list[0].internal_k = 5e4;
    k.species.list[1].shape = SHAPE_COCCUS;
    for (int i = 0; i < 12; i++)
        add_cell(&k, r, i % 3 == 1);
    add_link(&k, r, LINK_FILIAL, 0, 2);
    add_link(&k, r, LINK_STICK, 3, 4);
    add_link(&k, r, LINK_STICK, 1, 5);
    add_link(&k, r, LINK_ANCHOR, 6, COLONY_NO_ROW);
    add_link(&k, r, LINK_ANCHOR, 7, COLONY_NO_ROW);
    /* rows out of the order of ids */
    uint32_t rows[12];
    for (uint32_t i = 0; i < 12; i++)
        rows[i] = 5 * i % 12;
    colony_arrange(k.c, rows, 12);
    gsl_rng_free(r);
    return k;
}

static view *look(culture *k, uint64_t step) {
    k->v = (view){.colony = k->c, .species = &k->species, .step = step, .time = 240.0 * (double)step};
    return &k->v;
}

static void discard(culture *k) {
    colony_free(k->c);
    free(k->species.list);
}

/* ---- columns: id, species, mass and the centre, from the colony itself ------------------------------------------ */

static int give_id(void *self, uint32_t row, double *si, diag *d) {
    (void)d;
    *si = (double)((const colony *)self)->cell.id[row];
    return SARCINA_OK;
}

static int give_mass(void *self, uint32_t row, double *si, diag *d) {
    (void)d;
    *si = dim_from_engine(((const colony *)self)->cell.mass[row], DIM_MASS);
    return SARCINA_OK;
}

static int give_height(void *self, uint32_t row, double *si, diag *d) {
    (void)d;
    double centre[3];
    colony_centre(self, row, centre);
    *si = row % 4 ? dim_from_engine(centre[2], DIM_LENGTH) : (double)NAN;
    return SARCINA_OK;
}

static int give_species(void *self, uint32_t row, char out[64], diag *d) {
    (void)d;
    snprintf(out, 64, "%s", ((const colony *)self)->cell.species[row] ? "ball" : "rod, long");
    return SARCINA_OK;
}

enum { ID, SPECIES, MASS, HEIGHT, COLUMNS };

static void make_columns(culture *k, output_column columns[COLUMNS]) {
    static char names[COLUMNS][8] = {"id", "species", "mass", "z"};
    int (*const numbers[COLUMNS])(void *, uint32_t, double *, diag *) = {give_id, NULL, give_mass, give_height};
    for (int i = 0; i < COLUMNS; i++)
        columns[i] = (output_column){.name = names[i],
                                     .self = k->c,
                                     .is_text = i == SPECIES,
                                     .number = numbers[i],
                                     .text = i == SPECIES ? give_species : NULL};
}

/* ---- files ------------------------------------------------------------------------------------------------------ */

static FILE *open_file(const char *name) {
    char *path = alloc_format("%s/%s", folder, name);
    FILE *f = fopen(path, "r");
    free(path);
    assert_non_null(f);
    return f;
}

static void read_line(FILE *f, char line[1024]) {
    assert_non_null(fgets(line, 1024, f));
    line[strcspn(line, "\n")] = '\0';
}

/* Splits a line of comma-separated values in place, taking quotes off; returns how many. */
static int split(char *line, char *fields[], int most) {
    int n = 0;
    for (char *from = line; n < most; from++) {
        char *to = from;
        fields[n++] = to;
        for (bool quoted = false; *from && (quoted || *from != ','); from++) {
            if (*from == '"' && quoted && from[1] == '"')
                *to++ = *from++;
            else if (*from == '"')
                quoted = !quoted;
            else
                *to++ = *from;
        }
        bool ends = *from == '\0';
        *to = '\0';
        if (ends)
            return n;
    }
    return n;
}

/* A dump of this style and pattern, with all columns, of the steps named. */
static void write_steps(culture *k, const char *style, const char *pattern, const bool *members, int first, int last) {
    output_column columns[COLUMNS];
    char *path = alloc_format("%s/%s", folder, pattern);
    make_columns(k, columns);
    int row = dump_find(style);
    size_t ncolumns = dump_styles[row]->takes == DUMP_NOTHING ? 0 : COLUMNS;
    assert_int_equal(dump_check(row, path, false, NULL), SARCINA_OK);
    dump *p = dump_create(row, path);
    assert_int_equal(dump_open(p, NULL), SARCINA_OK);
    for (int step = first; step <= last; step++) {
        const dump_frame f = {
            .view = look(k, (uint64_t)step), .members = members, .columns = columns, .ncolumns = ncolumns};
        assert_int_equal(dump_write(p, &f, NULL), SARCINA_OK);
        assert_int_equal(dump_write(p, &f, NULL), SARCINA_OK); /* a step is written once */
    }
    dump_free(p);
    free(path);
}

/* The i-th cell in the order of ids, or the i-th coccus or rod. */
static uint32_t row_of(culture *k, size_t i) {
    return colony_by_id(k->c)[i];
}

static void check_cell(culture *k, uint32_t row, const char *id, const char *name, const char *mass,
                       const char *height) {
    double z;
    give_height(k->c, row, &z, NULL);
    assert_int_equal(strtoull(id, NULL, 10), k->c->cell.id[row]);
    assert_string_equal(name, k->c->cell.species[row] ? "ball" : "rod, long");
    assert_near(strtod(mass, NULL), dim_from_engine(k->c->cell.mass[row], DIM_MASS), 0);
    if (isnan(z))
        assert_string_equal(height, "nan");
    else
        assert_near(strtod(height, NULL), z, 0);
}

/* ---- tests ------------------------------------------------------------------------------------------------------ */

static void test_csv(void **state) {
    (void)state;
    culture k = make();
    char line[1024], *field[8];
    write_steps(&k, "csv", "c.*.csv", NULL, 5, 5);
    FILE *f = open_file("c.5.csv");
    read_line(f, line);
    assert_string_equal(line, "id,species,mass,z");
    for (size_t i = 0; i < 12; i++) {
        read_line(f, line);
        assert_int_equal(split(line, field, 8), 4);
        check_cell(&k, row_of(&k, i), field[0], field[1], field[2], field[3]);
    }
    assert_null(fgets(line, sizeof line, f));
    fclose(f);
    discard(&k);
}

static void test_csv_of_many_steps_and_some_cells(void **state) {
    (void)state;
    culture k = make();
    char line[1024], *field[8];
    bool members[12];
    for (uint32_t i = 0; i < 12; i++)
        members[i] = k.c->cell.species[i] == 1;
    write_steps(&k, "csv", "all.csv", members, 0, 2);
    FILE *f = open_file("all.csv");
    read_line(f, line);
    assert_string_equal(line, "step,id,species,mass,z");
    for (int step = 0; step <= 2; step++)
        for (size_t i = 0; i < 12; i++) {
            uint32_t row = row_of(&k, i);
            if (!members[row])
                continue;
            read_line(f, line);
            assert_int_equal(split(line, field, 8), 5);
            assert_int_equal(strtol(field[0], NULL, 10), step);
            check_cell(&k, row, field[1], field[2], field[3], field[4]);
        }
    assert_null(fgets(line, sizeof line, f));
    fclose(f);
    discard(&k);
}

static void check_box(culture *k, FILE *f) {
    char line[1024];
    for (size_t axis = 0; axis < 3; axis++) {
        double low, high, least = INFINITY, most = -INFINITY;
        for (uint32_t row = 0; row < 12; row++)
            for (size_t p = 0; p < k->c->cell.nparticles[row]; p++) {
                double x = k->c->particle.x[3 * (k->c->cell.first[row] + p) + axis], r = k->c->cell.diameter[row] / 2;
                least = fmin(least, x - r);
                most = fmax(most, x + r);
            }
        read_line(f, line);
        assert_int_equal(sscanf(line, "%lf %lf", &low, &high), 2);
        assert_near(low, 1e-6 * least, 1e-13);
        assert_near(high, 1e-6 * most, 1e-13);
    }
}

/* As LAMMPS writes it; its text columns hold no blanks, so the species is read to the number behind it. */
static void test_custom(void **state) {
    (void)state;
    culture k = make();
    char line[1024];
    write_steps(&k, "custom", "all.dump", NULL, 7, 9);
    FILE *f = open_file("all.dump");
    for (int step = 7; step <= 9; step++) {
        read_line(f, line);
        assert_string_equal(line, "ITEM: TIMESTEP");
        read_line(f, line);
        assert_int_equal(strtol(line, NULL, 10), step);
        read_line(f, line);
        assert_string_equal(line, "ITEM: NUMBER OF ATOMS");
        read_line(f, line);
        assert_string_equal(line, "12");
        read_line(f, line);
        assert_string_equal(line, "ITEM: BOX BOUNDS ff ff ff");
        check_box(&k, f);
        read_line(f, line);
        assert_string_equal(line, "ITEM: ATOMS id element mass z");
        for (size_t i = 0; i < 12; i++) {
            char id[32], name[64], mass[64], z[64];
            read_line(f, line);
            int n = sscanf(line, "%31s ball %63s %63s", id, mass, z) == 3;
            snprintf(name, sizeof name, n ? "ball" : "rod, long");
            if (!n)
                assert_int_equal(sscanf(line, "%31s rod, long %63s %63s", id, mass, z), 3);
            check_cell(&k, row_of(&k, i), id, name, mass, z);
        }
    }
    assert_null(fgets(line, sizeof line, f));
    fclose(f);
    discard(&k);
}

static void test_files_of_many_steps_go_on_after_a_restart(void **state) {
    (void)state;
    culture k = make();
    output_column columns[COLUMNS];
    const char *const styles[] = {"custom", "csv", "link"};
    for (size_t i = 0; i < 3; i++) {
        char *name = alloc_format("resume.%s", styles[i]), *path = alloc_format("%s/%s", folder, name);
        write_steps(&k, styles[i], "wanted", NULL, 0, 4);
        write_steps(&k, styles[i], name, NULL, 0, 6);
        dump *p = dump_create(dump_find(styles[i]), path);
        make_columns(&k, columns);
        assert_int_equal(dump_rewind(p, 3, NULL), SARCINA_OK);
        assert_int_equal(dump_open(p, NULL), SARCINA_OK);
        for (uint64_t step = 3; step <= 4; step++) {
            const dump_frame f = {.view = look(&k, step), .columns = columns, .ncolumns = i == 2 ? 0 : COLUMNS};
            assert_int_equal(dump_write(p, &f, NULL), SARCINA_OK);
        }
        dump_free(p);
        char *command = alloc_format("cmp %s/wanted %s", folder, path);
        assert_int_equal(system(command), 0);
        free(command);
        free(path);
        free(name);
    }
    discard(&k);
}

/* Finds spring s of the colony among the rows of the dump: by link id, in the order of the link's springs. */
static void check_spring(culture *k, uint32_t link, uint32_t i, char *line) {
    static const char *const kinds[] = {"filial", "stick", "anchor", "spring"};
    const colony *c = k->c;
    char *field[16];
    uint32_t s = c->link.first[link] + i;
    assert_int_equal(split(line, field, 16), 15);
    assert_int_equal(strtoull(field[0], NULL, 10), c->link.id[link]);
    assert_string_equal(field[1], kinds[c->link.kind[link]]);
    uint32_t a = colony_row(k->c, strtoull(field[2], NULL, 10));
    assert_int_equal(c->cell.first[a] + strtoul(field[3], NULL, 10), c->spring.a[s]);
    if (c->spring.b[s] == SPRING_ANCHOR) {
        assert_string_equal(field[4], "0");
        for (size_t j = 0; j < 3; j++)
            assert_near(strtod(field[8 + j], NULL), dim_from_engine(c->spring.anchor[3 * s + j], DIM_LENGTH), 0);
    } else {
        uint32_t b = colony_row(k->c, strtoull(field[4], NULL, 10));
        assert_int_equal(c->cell.first[b] + strtoul(field[5], NULL, 10), c->spring.b[s]);
        assert_string_equal(field[8], "nan");
    }
    assert_near(strtod(field[6], NULL), dim_from_engine(c->spring.k[s], DIM_STIFFNESS), 0);
    assert_near(strtod(field[7], NULL), dim_from_engine(c->spring.rest[s], DIM_LENGTH), 0);
    assert_int_equal(strtol(field[11], NULL, 10), c->spring.glides[s]);
    double length = colony_spring_length(c, s), rest = c->spring.rest[s];
    assert_near(strtod(field[12], NULL), dim_from_engine(length, DIM_LENGTH), 0);
    assert_near(strtod(field[13], NULL), (length - rest) / rest, 0);
    assert_near(strtod(field[14], NULL), k->v.time - c->link.birth[link], 0);
}

static void test_link(void **state) {
    (void)state;
    culture k = make();
    char line[1024], *field[16];
    write_steps(&k, "link", "s.*.csv", NULL, 0, 0);
    FILE *f = open_file("s.0.csv");
    read_line(f, line);
    assert_string_equal(line, "link,kind,cell_a,particle_a,cell_b,particle_b,k,rest,anchorx,anchory,anchorz,glides,"
                              "length,strain,age");
    for (size_t i = 0; i < 12; i++) { /* springs inside rods */
        uint32_t row = row_of(&k, i);
        if (k.c->cell.species[row])
            continue;
        read_line(f, line);
        assert_int_equal(split(line, field, 16), 15);
        assert_string_equal(field[1], "internal");
        assert_int_equal(strtoull(field[2], NULL, 10), k.c->cell.id[row]);
        assert_string_equal(field[3], "0");
        assert_string_equal(field[5], "1");
        assert_near(strtod(field[6], NULL), 5e-11, 1e-26);
        assert_near(strtod(field[7], NULL), dim_from_engine(k.c->cell.rest[row], DIM_LENGTH), 0);
    }
    for (uint32_t link = 0; link < k.c->link.count; link++)
        for (uint32_t i = 0; i < k.c->link.nsprings[link]; i++) {
            read_line(f, line);
            check_spring(&k, link, i, line);
        }
    assert_null(fgets(line, sizeof line, f));
    fclose(f);
    discard(&k);
}

/* The text between <DataArray ... Name="name" ...> and its end behind `section`; it must be there. */
static char *find_array(const char *text, const char *section, const char *name) {
    char *head = alloc_format("Name=\"%s\"", name);
    const char *from = strstr(text, section);
    assert_non_null(from);
    from = strstr(from, head);
    assert_non_null(from);
    from = strchr(from, '>') + 1;
    free(head);
    return alloc_copy_n(from, (size_t)(strstr(from, "</DataArray>") - from));
}

/* The next number of an array's text. */
static double next(char **at) {
    char *end;
    while (strspn(*at, " \n"))
        (*at)++;
    double x = strncmp(*at, "nan", 3) == 0 ? (end = *at + 3, (double)NAN) : strtod(*at, &end);
    assert_true(end > *at);
    *at = end;
    return x;
}

static char *read_whole(const char *name) {
    FILE *f = open_file(name);
    char *text = alloc_zeroed(1, 1 << 20);
    assert_true(fread(text, 1, (1 << 20) - 1, f) > 0);
    fclose(f);
    return text;
}

static void test_vtk(void **state) {
    (void)state;
    culture k = make();
    const colony *c = k.c;
    write_steps(&k, "vtk", "v.*.vtp", NULL, 3, 3);
    char *text = read_whole("v.3.vtp");
    assert_non_null(strstr(text, "<VTKFile type=\"PolyData\""));
    assert_non_null(strstr(text, "NumberOfPoints=\"20\" NumberOfVerts=\"4\" NumberOfLines=\"8\""));
    char *points = find_array(text, "<Points>", "points"), *radii = find_array(text, "<PointData", "radius");
    char *verts = find_array(text, "<Verts>", "connectivity"), *lines = find_array(text, "<Lines>", "connectivity");
    char *vert_ends = find_array(text, "<Verts>", "offsets"), *line_ends = find_array(text, "<Lines>", "offsets");
    char *ids = find_array(text, "<CellData", "id"), *names = find_array(text, "<CellData", "species");
    char *p = points, *r = radii, *v = verts, *l = lines, *ve = vert_ends, *le = line_ends, *i = ids, *s = names;
    int point = 0, vert_end = 0, line_end = 0;
    for (int rods = 0; rods < 2; rods++)
        for (size_t j = 0; j < 12; j++) {
            uint32_t row = row_of(&k, j);
            if ((c->cell.species[row] == 0) != rods)
                continue;
            assert_near(next(&i), (double)c->cell.id[row], 0);
            for (const char *name = rods ? "rod, long" : "ball"; *name; name++)
                assert_near(next(&s), *name, 0);
            assert_near(next(&s), 0, 0);
            for (size_t q = 0; q < c->cell.nparticles[row]; q++) {
                assert_near(next(rods ? &l : &v), point++, 0);
                assert_near(next(&r), dim_from_engine(c->cell.diameter[row] / 2, DIM_LENGTH), 0);
                for (size_t a = 0; a < 3; a++)
                    assert_near(next(&p), dim_from_engine(c->particle.x[3 * (c->cell.first[row] + q) + a], DIM_LENGTH),
                                0);
            }
            if (rods)
                assert_near(next(&le), line_end += 2, 0);
            else
                assert_near(next(&ve), vert_end += 1, 0);
        }
    char *all[] = {points, radii, verts, lines, vert_ends, line_ends, ids, names, text};
    for (size_t j = 0; j < 9; j++)
        free(all[j]);
    discard(&k);
}

static void test_names_of_files(void **state) {
    (void)state;
    const struct {
        const char *pattern, *wanted;
        int pad;
    } cases[] = {{"film.*.png", "film.70.png", 0},
                 {"film.*.png", "film.0070.png", 4},
                 {"a*b*", "a70b70", 2},
                 {"plain", "plain", 4}};
    for (size_t i = 0; i < sizeof cases / sizeof *cases; i++) {
        char *name = dump_file_name(cases[i].pattern, 70, cases[i].pad);
        assert_string_equal(name, cases[i].wanted);
        free(name);
    }
}

static void test_what_cannot_be_written(void **state) {
    (void)state;
    diag d = {0};
    assert_int_equal(dump_check(dump_find("vtk"), "colony.vtp", false, &d), SARCINA_ERROR);
    assert_string_equal(d.message,
                        "a dump of style vtk writes one file a step: 'colony.vtp' needs a * where the step goes");
    assert_int_equal(dump_check(dump_find("vtk"), "colony.vtp", true, &d), SARCINA_OK);
    assert_int_equal(dump_check(dump_find("csv"), "/dev/null/*.csv", false, &d), SARCINA_ERROR);
    assert_string_equal(d.message, "cannot write '/dev/null/0.csv': Not a directory");
    assert_int_equal(dump_write_now(dump_find("csv"), "/dev/null/x.csv", &(dump_frame){0}, &d), SARCINA_ERROR);
    assert_string_equal(d.message, "cannot write '/dev/null/x.csv': Not a directory");
    assert_int_equal(dump_find("cvs"), -1);
}

/* A full disk is an error, not a short file. */
static void test_full_disk(void **state) {
    (void)state;
    if (access("/dev/full", W_OK))
        skip();
    culture k = make();
    output_column columns[COLUMNS];
    make_columns(&k, columns);
    const char *const styles[] = {"csv", "custom", "link", "vtk"};
    for (size_t i = 0; i < 4; i++) {
        diag d = {0};
        const dump_frame f = {.view = look(&k, 1), .columns = columns, .ncolumns = COLUMNS};
        assert_int_equal(dump_write_now(dump_find(styles[i]), "/dev/full", &f, &d), SARCINA_ERROR);
        assert_string_equal(d.message, "cannot write '/dev/full': No space left on device");
    }
    discard(&k);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_csv),
        cmocka_unit_test(test_csv_of_many_steps_and_some_cells),
        cmocka_unit_test(test_custom),
        cmocka_unit_test(test_files_of_many_steps_go_on_after_a_restart),
        cmocka_unit_test(test_link),
        cmocka_unit_test(test_vtk),
        cmocka_unit_test(test_names_of_files),
        cmocka_unit_test(test_what_cannot_be_written),
        cmocka_unit_test(test_full_disk),
    };
    return cmocka_run_group_tests(tests, make_folder, drop_folder);
}

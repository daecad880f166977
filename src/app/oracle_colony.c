/* SPDX-License-Identifier: GPL-3.0-or-later */
/* oracle-colony FOLDER [CASE]: E. coli colonies of the original authors' program, seeds 1 to 10, with the very numbers
 * that it drew. Its generator is java.util.Random, whose algorithm the Java API documents (a linear congruential
 * generator of 48 bits; normal draws by the polar method), begun anew at every growth step with
 * (seed + 1) (step + 1) (5 step + 1). A step draws a growth rate for each cell in the order of birth, then a radius for
 * each daughter. Such small beginnings give draws that are much alike from seed to seed.
 *   without CASE: growth and division alone, nothing moves. The mean number of cells must be the original's at every
 * step, and the last number of every colony.
 *   CASE (default, anchor, anchor2x, anchor05x, filial): whole colonies with the original's rules and draws. C and
 * thickness at equal cell number must agree by the rule of study_original.h: what differs is not mechanics or links,
 * but chaos. Exit 0: all agree; 1: not; 2: the data cannot be read. */
#include "app/study_original.h"

#include "analysis/extent.h"
#include "analysis/orientation.h"
#include "base/alloc.h"
#include "base/table.h"
#include "base/vec3.h"
#include "command/commands.h"
#include "script/command.h"
#include "script/interp.h"

#include <gsl/gsl_errno.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

enum { STEPS = 70 };
static const double rate_mean = 1.23, rate_sd = 0.277;                    /* 1/h */
static const double radius_mean = 0.375, radius_sd = 0.05;                /* um; of the mean */
static const double rest_most = 5, density = 1010, step_h = 240.0 / 3600; /* um, kg/m3, h */

/* ---- java.util.Random ---- */

typedef struct java_random {
    uint64_t state;
    double kept;
    bool has_kept;
} java_random;

static java_random java_begin(int64_t seed) {
    return (java_random){.state = ((uint64_t)seed ^ 0x5DEECE66DULL) & 0xFFFFFFFFFFFFULL};
}

static uint64_t java_bits(java_random *r, int n) {
    r->state = (r->state * 0x5DEECE66DULL + 11) & 0xFFFFFFFFFFFFULL;
    return r->state >> (48 - n);
}

static double java_uniform(java_random *r) {
    uint64_t high = java_bits(r, 26) << 27;
    return (double)(high + java_bits(r, 27)) * 0x1p-53;
}

static double java_normal(java_random *r) {
    r->has_kept = !r->has_kept;
    if (!r->has_kept)
        return r->kept;
    double a, b, square;
    do {
        a = 2 * java_uniform(r) - 1;
        b = 2 * java_uniform(r) - 1;
        square = a * a + b * b;
    } while (square >= 1 || square == 0);
    double scale = sqrt(-2 * log(square) / square);
    r->kept = b * scale;
    return a * scale;
}

/* ---- the original's scene ---- */

/* %s: mass at division, kg; number and unit of each thing else as in Table 1. */
static const char scene_text[] = "accuracy paper\n"
                                 "species ecoli rod diameter 0.75um density 1010kg/m3\n"
                                 "growth ecoli exponential rate 1.23/h\n"
                                 "division ecoli midpoint mass %.17gkg jitter 0\n"
                                 "link internal ecoli k 5e-11N/m\n"
                                 "substratum plane z 0 k 1e-10N/m\n"
                                 "force collision k 1e-10N/m contact closest\n"
                                 "force dlvo ces 1e-22N.m cvdw 1e-31N.m2 kappa 5e7/m\n"
                                 "force damping k 1e-13N.s/m\n"
                                 "link remodel every 0s\n";

typedef struct colony_case {
    const char *name, *link; /* as in the files; command, or NULL */
} colony_case;

static const colony_case cases[] = {
    {"default", NULL},
    {"anchor", "link anchor ecoli k 1e-11N/m form 0.5um break 1um handover mother"},
    {"anchor2x", "link anchor ecoli k 1e-11N/m form 0.5um break 2um handover mother"},
    {"anchor05x", "link anchor ecoli k 1e-11N/m form 0.5um break 0.5um handover mother"},
    {"filial", "link filial ecoli k 5e-13N/m break 1um short 0.5 long 1.7"},
};

/* A sphere and a cylinder, kg. */
static double division_mass(void) {
    return M_PI * radius_mean * radius_mean * (4.0 / 3 * radius_mean + rest_most) * density * 1e-18;
}

/* The founder lies flat; mass, radius, direction and place are drawn in this order. */
static int place_founder(interp *in, int64_t seed, diag *d) {
    java_random r = java_begin(seed);
    double part = 0.5 * (1 + java_uniform(&r)), radius = radius_mean * (1 + radius_sd * java_normal(&r));
    double ux = java_uniform(&r) - 0.5, uy = java_uniform(&r) - 0.5;
    double x = java_uniform(&r) - 0.5, y = java_uniform(&r) - 0.5;
    double mass = part * division_mass(), along = sqrt(ux * ux + uy * uy);
    double rest = part * (4.0 / 3 * radius_mean + rest_most) - 4.0 / 3 * radius_mean;
    char *text = alloc_format("create_cells ecoli single %.17gum %.17gum %.17gum orient %.17g %.17g 0 mass %.17gkg",
                              x + 0.5 * rest * ux / along, y + 0.5 * rest * uy / along, radius, ux, uy, mass);
    int status = interp_execute(in, text, d);
    free(text);
    text = alloc_format("set all diameter %.17gum", 2 * radius);
    if (!status)
        status = interp_execute(in, text, d);
    free(text);
    return status;
}

static int make_scene(interp *in, const colony_case *c, int64_t seed, diag *d) {
    char *text = alloc_format(scene_text, division_mass());
    int status = SARCINA_OK;
    for (char *rest = text, *line; !status && (line = strtok_r(rest, "\n", &rest));)
        status = interp_execute(in, line, d);
    free(text);
    if (!status && c && c->link)
        status = interp_execute(in, c->link, d);
    return status ? status : place_founder(in, seed, d);
}

/* ---- its steps ---- */

static void draw_rates(scene *s, java_random *r) {
    colony *c = s->colony;
    const uint32_t *order = colony_by_id(c);
    for (size_t i = 0; i < c->cell.count; i++) {
        c->cell.rate[order[i]] = (rate_mean + rate_sd * java_normal(r)) / 3600;
        c->cell.own_rate[order[i]] = 1;
    }
}

/* The two inner particles stand a mother's radius from the middle, hers 10 nm aside along y; the daughter's own radius
 * is drawn after that. */
static void settle_daughter(scene *s, uint32_t daughter, java_random *r) {
    colony *c = s->colony;
    uint32_t mother = colony_row(c, c->cell.parent[daughter]);
    double *x = c->particle.x, radius = 0.5 * c->cell.diameter[mother];
    double *hers = x + 3 * ((size_t)c->cell.first[mother] + 1), *own = x + 3 * (size_t)c->cell.first[daughter];
    vec3 a = vec3_load(hers - 3), b = vec3_load(own + 3), middle = vec3_scale(0.5, vec3_add(a, b));
    vec3 along = vec3_scale(radius / vec3_norm(vec3_sub(b, a)), vec3_sub(b, a));
    vec3_store(hers, vec3_add(vec3_sub(middle, along), vec3_of(0, 0.01, 0)));
    vec3_store(own, vec3_add(middle, along));
    hers[2] = fmax(hers[2], radius);
    c->cell.diameter[daughter] = 2 * radius_mean * (1 + radius_sd * java_normal(r));
    own[2] = fmax(own[2], 0.5 * c->cell.diameter[daughter]);
    own[5] = fmax(own[5], 0.5 * c->cell.diameter[daughter]);
    species_shape_cell(&s->species.list[c->cell.species[daughter]], c, daughter);
}

static int step(scene *s, int64_t seed, bool moves, diag *d) {
    int64_t k = (int64_t)s->growth_steps;
    java_random r = java_begin((seed + 1) * (k + 1) * (5 * k + 1));
    draw_rates(s, &r);
    uint64_t newborn = s->colony->next_cell_id;
    int status = scene_grow(s, step_h * 3600, d);
    if (status)
        return status;
    for (uint64_t id = newborn; id < s->colony->next_cell_id; id++)
        settle_daughter(s, colony_row(s->colony, id), &r);
    s->colony->version++;
    scene_refresh_links(s); /* a filial link is as long as the daughter's own radius makes it */
    relax_result result;
    return moves ? scene_relax(s, 1, 0, &result, d) : SARCINA_OK;
}

/* ---- colonies ---- */

enum { CELLS, C, THICKNESS, COLUMNS };

static study_table table_create(void) {
    static const char *const names[COLUMNS] = {"cells", "C", "thickness"};
    study_table t = {.ncolumns = COLUMNS, .nrows = STEPS + 1};
    t.names = alloc_zeroed(COLUMNS, sizeof *t.names);
    t.at = alloc_zeroed((STEPS + 1) * COLUMNS, sizeof *t.at);
    for (size_t i = 0; i < COLUMNS; i++)
        t.names[i] = alloc_copy(names[i]);
    return t;
}

static void note(scene *s, double *row, bool moves) {
    row[CELLS] = (double)s->colony->cell.count;
    row[C] = row[THICKNESS] = NAN;
    if (!moves)
        return;
    view v = scene_view(s);
    bool *all = alloc_zeroed(s->colony->cell.count, sizeof *all);
    memset(all, 1, s->colony->cell.count);
    orientation_measure(&v, all, &row[C], NULL);
    extent_thickness(&v, all, &row[THICKNESS], NULL);
    row[THICKNESS] *= 1e-6; /* the rule takes SI */
    free(all);
}

/* One colony, a row a step. */
static int grow_colony(const interp_host *host, const colony_case *c, int64_t seed, study_table *t, diag *d) {
    interp *in = interp_create(host);
    *t = table_create();
    int status = make_scene(in, c, seed, d);
    for (size_t i = 0; i <= STEPS && !status; i++) {
        if (i > 0)
            status = step(interp_scene(in), seed, c != NULL, d);
        note(interp_scene(in), t->at + i * COLUMNS, c != NULL);
    }
    interp_free(in);
    return status;
}

/* ---- judgements ---- */

static int judge_curve(int curve, const study_table *const *ours, const study_table *series) {
    study_original_curve c = study_original_compare(curve, ours, ORIGINAL_SEEDS, series);
    for (size_t i = 0; i < c.npoints; i++)
        printf("%-10s %4.0f cells: %8.4f %8.4f %+9.4f ± %.4f %-3s %s\n", c.name, c.points[i].cells,
               c.points[i].ours.mean, c.points[i].theirs.mean, c.points[i].difference.value,
               inference_width(c.points[i].difference, 0.95), c.unit, c.points[i].agrees ? "agrees" : "differs");
    printf("%s: %zu of %zu points agree with the original\n", c.name, c.nagree, c.npoints);
    return c.agrees;
}

/* Cells at the end of the original's colonies: version,case,seed, ... final_cells (13th) ... */
static bool read_final_cells(const char *folder, double cells[ORIGINAL_SEEDS]) {
    char *path = alloc_format("%s/stacking_per_seed.csv", folder), line[1024];
    FILE *f = fopen(path, "r");
    free(path);
    int found = 0;
    while (f && fgets(line, sizeof line, f)) {
        int seed, count;
        if (sscanf(line, "2015k,default,%d,%*[^,],%*[^,],%*[^,],%*[^,],%*[^,],%*[^,],%*[^,],%*[^,],%*[^,],%d", &seed,
                   &count) == 2 &&
            seed >= 1 && seed <= ORIGINAL_SEEDS) {
            cells[seed - 1] = count;
            found++;
        }
    }
    if (f)
        fclose(f);
    return found == ORIGINAL_SEEDS;
}

static bool judge_step(size_t i, const study_table *ours, const study_table *series) {
    double sum = 0;
    for (int k = 0; k < ORIGINAL_SEEDS; k++)
        sum += ours[k].at[i * COLUMNS + CELLS];
    double theirs = study_table_number(series, i, "n_cells_mean");
    if (fabs(sum / ORIGINAL_SEEDS - theirs) < 1e-3)
        return true;
    printf("step %zu: %g cells, the original has %g\n", i, sum / ORIGINAL_SEEDS, theirs);
    return false;
}

static int judge_growth(const study_table *ours, const study_table *series, const char *folder, int *questions) {
    double final[ORIGINAL_SEEDS];
    int passed = 0;
    for (size_t i = 0; i <= STEPS; i++)
        passed += judge_step(i, ours, series);
    bool read = read_final_cells(folder, final);
    for (int k = 0; k < ORIGINAL_SEEDS; k++)
        passed += read && ours[k].at[STEPS * COLUMNS + CELLS] == final[k];
    *questions = STEPS + 1 + ORIGINAL_SEEDS;
    printf("cells: %d of %d numbers are the original's\n", passed, *questions);
    return passed;
}

static int judge(const char *folder, const colony_case *c, const study_table *ours) {
    char *path = alloc_format("%s/series_2015k_%s.csv", folder, c ? c->name : "default");
    study_table series;
    diag d = {0};
    if (study_table_read(&series, path, &d)) {
        fprintf(stderr, "oracle-colony: %s\n", d.message);
        exit(2);
    }
    free(path);
    int passed = 0, questions = ORIGINAL_CURVES;
    const study_table *rows[ORIGINAL_SEEDS];
    for (int k = 0; k < ORIGINAL_SEEDS; k++)
        rows[k] = &ours[k];
    if (!c)
        passed = judge_growth(ours, &series, folder, &questions);
    for (int curve = 0; c && curve < ORIGINAL_CURVES; curve++)
        passed += judge_curve(curve, rows, &series);
    printf("%d passed, %d failed\n", passed, questions - passed);
    study_table_free(&series);
    return passed == questions ? 0 : 1;
}

static int run(const interp_host *host, const char *folder, const colony_case *c) {
    study_table ours[ORIGINAL_SEEDS];
    for (int64_t seed = 1; seed <= ORIGINAL_SEEDS; seed++) {
        diag d = {0};
        if (grow_colony(host, c, seed, &ours[seed - 1], &d)) {
            fprintf(stderr, "oracle-colony: seed %lld: %s\n", (long long)seed, d.message);
            return 1;
        }
    }
    int code = judge(folder, c, ours);
    for (int k = 0; k < ORIGINAL_SEEDS; k++)
        study_table_free(&ours[k]);
    return code;
}

int main(int argc, char **argv) {
    ptrdiff_t row = argc == 3 ? table_find(cases, TABLE_COUNT(cases), sizeof *cases, argv[2]) : -1;
    if (argc < 2 || argc > 3 || (argc == 3 && row < 0)) {
        fputs("usage: oracle-colony FOLDER [default|anchor|anchor2x|anchor05x|filial]\n", stderr);
        return 2;
    }
    gsl_set_error_handler_off();
    interp_host host = {.units = units_create(NULL)};
    command_table *commands = commands_create(host.units);
    host.commands = commands;
    int code = run(&host, argv[1], row < 0 ? NULL : &cases[row]);
    command_table_free(commands);
    units_free(host.units);
    return code;
}

/* SPDX-License-Identifier: GPL-3.0-or-later */
/* oracle-links FOLDER: the links of the original authors' states made anew by this program from particles, cells and
 * the published parameters. Each spring must have the original's particles, constant, rest length and anchor to 1e-12,
 * and the accelerations with these links must be the original's to 1e-9. Sticking and anchoring links are formed where
 * the original formed them: its rest lengths say how far apart the particles were. The colony of state 09, relaxed for
 * 1 s with its links as they are, must end at the same places to 1e-4 um at two tolerances. Exit 0: all hold; 1: not;
 * 2: the data cannot be read. */
#include "app/oracle_data.h"

#include "base/alloc.h"
#include "base/dim.h"
#include "base/table.h"
#include "model/link.h"
#include "relax/relax.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

static const double spring_bound = 1e-12, force_bound = 1e-9, place_bound = 1e-4;

/* The published parameters of the links in each state, by the beginning of its name; pg/s2, diameters. */
typedef struct published {
    const char *state;
    link_rule rules[LINK_STYLES];
} published;

#define FILIAL(k) [LINK_FILIAL] = {true, {[FILIAL_K] = (k), [FILIAL_SHORT] = 0.5, [FILIAL_LONG] = 1.7}}
#define STICK [LINK_STICK] = {true, {[STICK_K] = 1e4}}
#define ANCHOR(glide) [LINK_ANCHOR] = {true, {[ANCHOR_K] = 1e4, [ANCHOR_GLIDE] = (glide)}}

static const published states[] = {
    {"05", {FILIAL(5e2)}}, {"06", {FILIAL(2e4)}}, {"07", {STICK}},
    {"08a", {ANCHOR(0)}},  {"08b", {ANCHOR(1)}},  {"09", {ANCHOR(0)}},
};

/* The springs of one link: rows begin ... end - 1 of the table. */
typedef struct spring_group {
    size_t begin, end;
    link_kind kind;
} spring_group;

typedef struct comparison {
    oracle_scene *s;
    const oracle_table *springs;
    const link_rule *rules;
    double worst; /* relative deviation of a constant, rest length or anchor */
    size_t compared;
} comparison;

static uint32_t particle_of(const comparison *c, size_t row, const char *column) {
    double index = oracle_table_number(c->springs, row, column);
    return index < 0 ? SPRING_ANCHOR : c->s->row[(size_t)index];
}

static uint32_t cell_of(const colony *c, uint32_t particle) {
    for (uint32_t i = 0; i < c->cell.count; i++)
        if (particle - c->cell.first[i] < c->cell.nparticles[i])
            return i;
    return COLONY_NO_ROW;
}

static link_end end_of(const colony *c, uint32_t particle) {
    return particle == c->cell.first[cell_of(c, particle)] ? LINK_FIRST_END : LINK_LAST_END;
}

static double rest_of(const comparison *c, size_t row) {
    return dim_to_engine(oracle_table_number(c->springs, row, "rest_m"), DIM_LENGTH);
}

static double *place_of(const comparison *c, uint32_t particle) {
    return c->s->colony->particle.x + 3 * (size_t)particle;
}

static void put(double *x, double to_x, double to_y, double to_z) {
    x[0] = to_x;
    x[1] = to_y;
    x[2] = to_z;
}

/* Distance between the particles of a sticking link when it formed. */
static double formed_length(const comparison *c, spring_group g, uint32_t a, uint32_t b) {
    for (size_t row = g.begin; row < g.end; row++) {
        uint32_t i = particle_of(c, row, "i"), j = particle_of(c, row, "j");
        if ((i == a && j == b) || (i == b && j == a))
            return rest_of(c, row);
    }
    return NAN;
}

/* A length of the second cell that is a side of triangles with all the lengths of the link. */
static double common_side(const comparison *c, spring_group g, uint32_t one, uint32_t first) {
    const colony *k = c->s->colony;
    double least = 0, most = INFINITY;
    for (uint32_t i = k->cell.first[one]; i < k->cell.first[one] + k->cell.nparticles[one]; i++) {
        double near = formed_length(c, g, i, first), far = formed_length(c, g, i, first + 1);
        least = fmax(least, fabs(near - far));
        most = fmin(most, near + far);
    }
    return 0.5 * (least + most);
}

/* Puts the particles of two cells as far apart as they were when they stuck: the second cell along x, each particle of
 * the first by its distances from the second's. */
static void place_sticking(const comparison *c, spring_group g) {
    const colony *k = c->s->colony;
    uint32_t one = cell_of(k, particle_of(c, g.begin, "i")), two = cell_of(k, particle_of(c, g.begin, "j"));
    uint32_t first = k->cell.first[two], count = k->cell.nparticles[two];
    double length = count == 2 ? common_side(c, g, one, first) : 0;
    put(place_of(c, first), 0, 0, 0);
    if (count == 2)
        put(place_of(c, first + 1), length, 0, 0);
    for (uint32_t i = k->cell.first[one]; i < k->cell.first[one] + k->cell.nparticles[one]; i++) {
        double near = formed_length(c, g, i, first);
        double far = count == 2 ? formed_length(c, g, i, first + 1) : near;
        double x = count == 2 ? (near * near - far * far + length * length) / (2 * length) : near;
        put(place_of(c, i), x, sqrt(fmax(0, near * near - x * x)), 0);
    }
}

/* Over its anchor point, as high as it was. */
static void place_anchored(const comparison *c, spring_group g) {
    static const char *const anchor[3] = {"anchor_x", "anchor_y", "anchor_z"};
    for (size_t row = g.begin; row < g.end; row++) {
        double *x = place_of(c, particle_of(c, row, "i"));
        for (int k = 0; k < 3; k++)
            x[k] = dim_to_engine(oracle_table_number(c->springs, row, anchor[k]), DIM_LENGTH);
        x[2] += rest_of(c, row);
    }
}

/* The link that this program makes; its row. */
static uint32_t make_link(const comparison *c, spring_group g) {
    colony *k = c->s->colony;
    size_t bytes = 3 * k->particle.count * sizeof(double);
    double *kept = alloc_zeroed(bytes, 1);
    memcpy(kept, k->particle.x, bytes);
    uint32_t i = particle_of(c, g.begin, "i"), j = particle_of(c, g.begin, "j"), link;
    if (g.kind == LINK_FILIAL) {
        bool branched = oracle_table_number(c->springs, g.begin, "filtype") >= 6;
        link = link_add_filial(k, &c->rules[LINK_FILIAL], branched ? LINK_BRANCHED : LINK_STRAIGHT, cell_of(k, i),
                               end_of(k, i), cell_of(k, j), end_of(k, j), 0);
    } else if (g.kind == LINK_STICK) {
        place_sticking(c, g);
        link = link_add_stick(k, &c->rules[LINK_STICK], cell_of(k, i), cell_of(k, j), 0);
    } else {
        place_anchored(c, g);
        link = link_add_anchor(k, &c->rules[LINK_ANCHOR], cell_of(k, i), 0, 0);
    }
    memcpy(k->particle.x, kept, bytes);
    free(kept);
    return link;
}

static void note(comparison *c, double seen, double wanted) {
    double scale = fmax(fabs(wanted), 1e-6), deviation = fabs(seen - wanted) / scale;
    c->worst = deviation <= c->worst ? c->worst : deviation;
}

static void compare_spring(comparison *c, size_t row, uint32_t link) {
    static const char *const anchor[3] = {"anchor_x", "anchor_y", "anchor_z"};
    const colony *k = c->s->colony;
    uint32_t i = particle_of(c, row, "i"), j = particle_of(c, row, "j"), s = k->link.first[link];
    uint32_t end = s + k->link.nsprings[link];
    while (s < end && !((k->spring.a[s] == i && k->spring.b[s] == j) || (k->spring.a[s] == j && k->spring.b[s] == i)))
        s++;
    if (s == end) {
        c->worst = INFINITY; /* joins other particles */
        return;
    }
    c->compared++;
    note(c, k->spring.k[s], dim_to_engine(oracle_table_number(c->springs, row, "K_N_per_m"), DIM_STIFFNESS));
    note(c, k->spring.rest[s], rest_of(c, row));
    note(c, k->spring.glides[s], oracle_table_number(c->springs, row, "gliding"));
    for (int d = 0; d < 3 && j == SPRING_ANCHOR; d++)
        note(c, k->spring.anchor[3 * (size_t)s + (size_t)d],
             dim_to_engine(oracle_table_number(c->springs, row, anchor[d]), DIM_LENGTH));
}

/* The group of springs from a row on: of one kind between the same two cells. */
static spring_group find_group(const comparison *c, const char *state, size_t begin) {
    static const struct {
        const char *name;
        link_kind kind;
    } kinds[] = {{"fil", LINK_FILIAL}, {"stick", LINK_STICK}, {"anchor", LINK_ANCHOR}};
    const colony *k = c->s->colony;
    spring_group g = {begin, begin, LINK_SPRING};
    for (int i = 0; i < 3; i++)
        if (strcmp(oracle_table_text(c->springs, begin, "kind"), kinds[i].name) == 0)
            g.kind = kinds[i].kind;
    uint32_t one = cell_of(k, particle_of(c, begin, "i")), other = particle_of(c, begin, "j");
    uint32_t two = other == SPRING_ANCHOR ? COLONY_NO_ROW : cell_of(k, other);
    for (; g.end < c->springs->nrows && strcmp(oracle_table_text(c->springs, g.end, "state"), state) == 0; g.end++) {
        other = particle_of(c, g.end, "j");
        if (strcmp(oracle_table_text(c->springs, g.end, "kind"), oracle_table_text(c->springs, begin, "kind")) != 0 ||
            cell_of(k, particle_of(c, g.end, "i")) != one ||
            (other == SPRING_ANCHOR ? COLONY_NO_ROW : cell_of(k, other)) != two)
            break;
    }
    return g;
}

/* Takes out the state's own springs and makes its links anew. */
static void make_links(comparison *c, const char *state) {
    colony *k = c->s->colony;
    bool *all = alloc_zeroed(k->link.count, sizeof *all);
    memset(all, true, k->link.count);
    colony_drop_links(k, all);
    free(all);
    for (size_t row = 0; row < c->springs->nrows;) {
        bool rod = strcmp(oracle_table_text(c->springs, row, "kind"), "rod") == 0;
        if (rod || strcmp(oracle_table_text(c->springs, row, "state"), state) != 0) {
            row++;
            continue;
        }
        spring_group g = find_group(c, state, row);
        uint32_t link = make_link(c, g);
        if (k->link.nsprings[link] != g.end - g.begin)
            c->worst = INFINITY;
        for (; row < g.end; row++)
            compare_spring(c, row, link);
    }
}

/* Relaxes the scene as it stands for 1 s; the places go to x (the caller frees). */
static double *relax(const oracle_scene *s, double tolerance, size_t *evaluations) {
    size_t n = 3 * s->colony->particle.count;
    oracle_scene copy = *s;
    copy.colony = colony_create();
    colony_copy(copy.colony, s->colony);
    copy.forces.term[FORCE_COLLISION].p[COLLISION_CONTACT] = CONTACT_REGULARISED;
    mechanics *m = mechanics_create();
    const relax_settings how = {.integrator = INTEGRATOR_DOPRI5, .tolerance = tolerance};
    const relax_goal goal = {.time = 1};
    relax_result result = {0};
    double *x = NULL;
    diag d = {0};
    if (oracle_scene_bind(&copy, m, &d) || relax_run(m, &how, &goal, &result, &d)) {
        printf("%s\n", d.message);
    } else {
        x = alloc_zeroed(n, sizeof *x);
        memcpy(x, copy.colony->particle.x, n * sizeof *x);
    }
    *evaluations = result.evaluations;
    mechanics_free(m);
    colony_free(copy.colony);
    return x;
}

/* Largest distance between the ends of two relaxations at these tolerances, um. */
static bool check_relaxed(const oracle_scene *s, const char *state, double one, double two) {
    size_t evaluations[2];
    double *x = relax(s, one, &evaluations[0]), *y = relax(s, two, &evaluations[1]), most = x && y ? 0 : INFINITY;
    for (size_t i = 0; x && y && i < s->colony->particle.count; i++)
        most = fmax(most, sqrt(pow(x[3 * i] - y[3 * i], 2) + pow(x[3 * i + 1] - y[3 * i + 1], 2) +
                               pow(x[3 * i + 2] - y[3 * i + 2], 2)));
    bool passed = most <= place_bound;
    printf("%-40s 1 s at tolerance %.0e and %.0e um: %zu and %zu evaluations, apart by %.1e um  %s\n", state, one, two,
           evaluations[0], evaluations[1], most, passed ? "ok" : "FAILED");
    free(x);
    free(y);
    return passed;
}

static bool check_links(const char *state, const link_rule *rules, const oracle_tables *t) {
    oracle_scene s;
    mechanics *m = mechanics_create();
    diag d = {0};
    bool passed = false, made = oracle_scene_make(&s, state, &t->particles, &t->springs, &t->params);
    comparison c = {.s = &s, .springs = &t->springs, .rules = rules};
    if (made)
        make_links(&c, state);
    if (made && oracle_scene_bind(&s, m, &d) == SARCINA_OK) {
        double *force = alloc_zeroed(3 * s.nparticles, sizeof *force), deviation, largest;
        mechanics_force(m, s.colony->particle.x, s.colony->particle.v, force);
        oracle_scene_compare(&s, state, &t->particles, force, mechanics_mass(m), &deviation, &largest);
        passed = c.compared > 0 && c.worst <= spring_bound && deviation <= force_bound * largest;
        printf("%-40s %3zu springs in %2zu links  %8.1e  accelerations %8.1e  %s\n", state, c.compared,
               s.colony->link.count, c.worst, deviation / largest, passed ? "ok" : "FAILED");
        free(force);
    } else {
        printf("%-40s FAILED %s\n", state, d.message);
    }
    if (passed && strncmp(state, "09", 2) == 0)
        passed = check_relaxed(&s, state, 1e-6, 1e-7);
    mechanics_free(m);
    oracle_scene_free(&s);
    return passed;
}

static oracle_verdict check_state(const char *state, const oracle_tables *t) {
    for (size_t k = 0; k < TABLE_COUNT(states); k++)
        if (strncmp(state, states[k].state, strlen(states[k].state)) == 0)
            return check_links(state, states[k].rules, t) ? ORACLE_PASSED : ORACLE_FAILED;
    return ORACLE_SKIPPED;
}

int main(int argc, char **argv) {
    return oracle_main(argc, argv, check_state);
}

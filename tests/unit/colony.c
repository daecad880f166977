/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The state against a naive model of it: thousands of random insertions, deletions, sortings and broken links, after
 * which every column of every row must be where the identities say it is. */
#include "check.h"

#include "base/alloc.h"
#include "model/colony.h"

#include <stdlib.h>
#include <string.h>

/* ---- random numbers of the test's own: xorshift64* -------------------------------------------------------------- */

static uint64_t rolled = 88172645463325252u;

static uint64_t roll(uint64_t n) {
    rolled ^= rolled >> 12;
    rolled ^= rolled << 25;
    rolled ^= rolled >> 27;
    return rolled * 2685821657736338717u % n;
}

/* ---- the naive model: records that hold what belongs to them, springs by identity -------------------------------- */

enum { CELLS_MAX = 400, LINKS_MAX = 600, PARTICLES_MAX = 4, SPRINGS_MAX = 4 };

typedef struct naive_cell {
    uint64_t id, groups;
    uint32_t n;
    double mass, x[3 * PARTICLES_MAX], v[3 * PARTICLES_MAX];
} naive_cell;

typedef struct naive_spring {
    uint64_t cell_a, cell_b; /* cell_b 0: anchored */
    uint32_t particle_a, particle_b;
    double k, anchor[3];
} naive_spring;

typedef struct naive_link {
    uint64_t id, cell_a, cell_b;
    int kind;
    uint32_t n;
    naive_spring springs[SPRINGS_MAX];
} naive_link;

typedef struct naive {
    size_t ncells, nlinks;
    naive_cell cells[CELLS_MAX];
    naive_link links[LINKS_MAX];
    uint64_t last_cell, last_link;
} naive;

static bool naive_has(const naive *m, uint64_t id) {
    for (size_t i = 0; i < m->ncells; i++)
        if (m->cells[i].id == id)
            return true;
    return false;
}

/* Links of cells that are no more go; the order of the others stays. */
static void naive_forget_links(naive *m) {
    size_t kept = 0;
    for (size_t l = 0; l < m->nlinks; l++)
        if (naive_has(m, m->links[l].cell_a) && (!m->links[l].cell_b || naive_has(m, m->links[l].cell_b)))
            m->links[kept++] = m->links[l];
    m->nlinks = kept;
}

/* ---- events, done to both --------------------------------------------------------------------------------------- */

static void insert_cell(colony *c, naive *m) {
    if (m->ncells == CELLS_MAX)
        return;
    naive_cell *cell = &m->cells[m->ncells];
    *cell = (naive_cell){.id = ++m->last_cell, .groups = roll(1000), .n = 1 + (uint32_t)roll(PARTICLES_MAX)};
    cell->mass = (double)roll(1000);
    for (uint32_t i = 0; i < 3 * cell->n; i++) {
        cell->x[i] = (double)roll(1000000);
        cell->v[i] = (double)roll(1000000);
    }
    uint32_t row = colony_add_cell(c, cell->n, cell->x);
    assert_int_equal(row, m->ncells++);
    assert_int_equal(c->cell.id[row], cell->id); /* the next, never one used before */
    assert_true(c->cell.mass[row] == 0 && c->cell.parent[row] == 0);
    c->cell.mass[row] = cell->mass;
    c->cell.groups[row] = cell->groups;
    memcpy(c->particle.v + 3 * (size_t)c->cell.first[row], cell->v, 3 * cell->n * sizeof(double));
}

static void fill_spring(colony *c, const naive *m, size_t a, size_t b, bool anchored, uint32_t row, naive_spring *s) {
    *s = (naive_spring){.cell_a = m->cells[a].id, .cell_b = anchored ? 0 : m->cells[b].id, .k = (double)roll(1000)};
    s->particle_a = (uint32_t)roll(m->cells[a].n);
    s->particle_b = (uint32_t)roll(m->cells[b].n);
    s->anchor[0] = (double)roll(1000);
    c->spring.k[row] = s->k;
    c->spring.anchor[3 * (size_t)row] = s->anchor[0];
    c->spring.a[row] = c->cell.first[a] + s->particle_a;
    c->spring.b[row] = anchored ? SPRING_ANCHOR : c->cell.first[b] + s->particle_b;
}

static void insert_link(colony *c, naive *m) {
    if (m->nlinks == LINKS_MAX || m->ncells < 2)
        return;
    size_t a = roll(m->ncells), b = roll(m->ncells);
    bool anchored = roll(3) == 0;
    naive_link *link = &m->links[m->nlinks];
    *link = (naive_link){.id = ++m->last_link, .cell_a = m->cells[a].id, .n = (uint32_t)roll(SPRINGS_MAX + 1)};
    link->cell_b = anchored ? 0 : m->cells[b].id;
    link->kind = anchored ? LINK_ANCHOR : LINK_STICK;
    uint32_t row = colony_add_link(c, (link_kind)link->kind, link->cell_a, link->cell_b, link->n);
    assert_int_equal(row, m->nlinks++);
    for (uint32_t s = 0; s < link->n; s++)
        fill_spring(c, m, a, b, anchored, c->link.first[row] + s, &link->springs[s]);
}

/* Keeps a random part of the cells (of 64: `keep` on average) in a random order, or in the order of identities. */
static void arrange(colony *c, naive *m, uint64_t keep, bool sorted) {
    uint32_t rows[CELLS_MAX];
    size_t n = 0;
    const uint32_t *by_id = colony_by_id(c);
    for (size_t i = 0; i < m->ncells; i++)
        if (roll(64) < keep)
            rows[n++] = by_id[i];
    for (size_t i = n; !sorted && i > 1; i--) {
        size_t j = roll(i);
        uint32_t swapped = rows[i - 1];
        rows[i - 1] = rows[j];
        rows[j] = swapped;
    }
    naive *before = alloc_zeroed(1, sizeof *before);
    memcpy(before, m, sizeof *before);
    for (size_t i = 0; i < n; i++)
        m->cells[i] = before->cells[rows[i]];
    free(before);
    m->ncells = n;
    naive_forget_links(m);
    colony_arrange(c, rows, n);
}

static void drop_links(colony *c, naive *m) {
    bool drop[LINKS_MAX];
    size_t kept = 0;
    for (size_t l = 0; l < m->nlinks; l++) {
        drop[l] = roll(4) == 0;
        if (!drop[l])
            m->links[kept++] = m->links[l];
    }
    m->nlinks = kept;
    colony_drop_links(c, drop);
}

/* ---- comparison ------------------------------------------------------------------------------------------------- */

static void compare_cells(colony *c, const naive *m) {
    assert_int_equal(c->cell.count, m->ncells);
    uint32_t particles = 0;
    for (size_t i = 0; i < m->ncells; i++) {
        const naive_cell *cell = &m->cells[i];
        assert_int_equal(c->cell.id[i], cell->id);
        assert_int_equal(c->cell.groups[i], cell->groups);
        assert_true(c->cell.mass[i] == cell->mass);
        assert_int_equal(c->cell.nparticles[i], cell->n);
        assert_int_equal(c->cell.first[i], particles);
        assert_memory_equal(c->particle.x + 3 * (size_t)particles, cell->x, 3 * cell->n * sizeof(double));
        assert_memory_equal(c->particle.v + 3 * (size_t)particles, cell->v, 3 * cell->n * sizeof(double));
        assert_int_equal(colony_row(c, cell->id), i);
        particles += cell->n;
    }
    assert_int_equal(c->particle.count, particles);
    const uint32_t *by_id = colony_by_id(c);
    for (size_t i = 1; i < m->ncells; i++)
        assert_true(c->cell.id[by_id[i - 1]] < c->cell.id[by_id[i]]);
}

static void compare_spring(colony *c, uint32_t row, const naive_spring *s) {
    assert_int_equal(c->spring.a[row], c->cell.first[colony_row(c, s->cell_a)] + s->particle_a);
    if (s->cell_b)
        assert_int_equal(c->spring.b[row], c->cell.first[colony_row(c, s->cell_b)] + s->particle_b);
    else
        assert_int_equal(c->spring.b[row], SPRING_ANCHOR);
    assert_true(c->spring.k[row] == s->k);
    assert_memory_equal(c->spring.anchor + 3 * (size_t)row, s->anchor, sizeof s->anchor);
}

static void compare_links(colony *c, const naive *m) {
    assert_int_equal(c->link.count, m->nlinks);
    uint32_t springs = 0;
    for (size_t l = 0; l < m->nlinks; l++) {
        const naive_link *link = &m->links[l];
        assert_int_equal(c->link.id[l], link->id);
        assert_int_equal(c->link.kind[l], link->kind);
        assert_int_equal(c->link.cell_a[l], link->cell_a);
        assert_int_equal(c->link.cell_b[l], link->cell_b);
        assert_int_equal(c->link.first[l], springs);
        assert_int_equal(c->link.nsprings[l], link->n);
        for (uint32_t s = 0; s < link->n; s++)
            compare_spring(c, springs++, &link->springs[s]);
    }
    assert_int_equal(c->spring.count, springs);
}

static void test_random_events(void **state) {
    (void)state;
    colony *c = colony_create();
    naive *m = alloc_zeroed(1, sizeof *m);
    size_t deletions = 0;
    for (int event = 0; event < 6000; event++) {
        uint64_t before = c->version, kind = roll(100);
        size_t cells = m->ncells;
        if (kind < 55)
            insert_cell(c, m);
        else if (kind < 90)
            insert_link(c, m);
        else if (kind < 94)
            arrange(c, m, 64, kind == 90); /* all of them: a sort */
        else if (kind < 97)
            arrange(c, m, 58, kind == 94);
        else if (kind < 98)
            arrange(c, m, roll(4) ? 40 : 0, false);
        else
            drop_links(c, m);
        deletions += m->ncells < cells;
        assert_true(c->version != before || m->ncells == CELLS_MAX || m->nlinks == LINKS_MAX || m->ncells < 2);
        compare_cells(c, m);
        compare_links(c, m);
    }
    assert_true(deletions > 100);
    assert_int_equal(c->next_cell_id, m->last_cell + 1);
    assert_int_equal(c->next_link_id, m->last_link + 1);
    assert_int_equal(colony_row(c, m->last_cell + 1), COLONY_NO_ROW);
    assert_int_equal(colony_row(c, 0), COLONY_NO_ROW);
    free(m);
    colony_free(c);
}

/* ---- every column ----------------------------------------------------------------------------------------------- */

typedef struct listed {
    const char *table, *column;
    size_t row_bytes;
} listed;

/* columns.def read once more, by macros of the test's own */
static const listed list[] = {
#define PARTICLE_COLUMN(type, name, width, unit, meaning) {"particle", #name, sizeof(type) * (width)},
#define CELL_COLUMN(type, name, width, unit, meaning) {"cell", #name, sizeof(type) * (width)},
#define LINK_COLUMN(type, name, width, unit, meaning) {"link", #name, sizeof(type) * (width)},
#define SPRING_COLUMN(type, name, width, unit, meaning) {"spring", #name, sizeof(type) * (width)},
#include "model/columns.def"
};
enum { LISTED = sizeof list / sizeof list[0] };

typedef struct walk {
    size_t columns;
    size_t rows[4];
    const void *data[LISTED];
} walk;

static int check_column(void *self, const char *table, const char *column, void *data, size_t row_bytes, size_t rows) {
    walk *w = self;
    assert_true(w->columns < LISTED);
    const listed *l = &list[w->columns];
    assert_string_equal(table, l->table);
    assert_string_equal(column, l->column);
    assert_int_equal(row_bytes, l->row_bytes);
    w->data[w->columns++] = data;
    size_t t = table[0] == 'p' ? 0 : table[0] == 'c' ? 1 : table[0] == 'l' ? 2 : 3;
    w->rows[t] = rows;
    return 0;
}

static void fill_column(void *data, size_t bytes) {
    unsigned char *p = data;
    for (size_t i = 0; i < bytes; i++)
        p[i] = (unsigned char)roll(256);
}

static int fill(void *self, const char *table, const char *column, void *data, size_t row_bytes, size_t rows) {
    (void)self, (void)table, (void)column;
    fill_column(data, row_bytes * rows);
    return 0;
}

static int stop_at_third(void *self, const char *table, const char *column, void *data, size_t row_bytes, size_t rows) {
    (void)table, (void)column, (void)data, (void)row_bytes, (void)rows;
    return ++*(int *)self == 3 ? 7 : 0;
}

static void test_walk_covers_every_column(void **state) {
    (void)state;
    colony *c = colony_create();
    colony_resize(c, 50, 20, 11, 30);
    walk w = {0};
    assert_int_equal(colony_walk(c, check_column, &w), 0);
    assert_int_equal(w.columns, LISTED);
    assert_int_equal(w.rows[0], 50);
    assert_int_equal(w.rows[1], 20);
    assert_int_equal(w.rows[2], 11);
    assert_int_equal(w.rows[3], 30);
    assert_ptr_equal(w.data[0], c->particle.x);
    int visited = 0;
    assert_int_equal(colony_walk(c, stop_at_third, &visited), 7);
    assert_int_equal(visited, 3);
    colony_free(c);
}

/* A pattern in every byte of every column arrives in the copy, which held something else, larger or smaller. */
static void test_copy_is_equal_to_the_bit(void **state) {
    (void)state;
    const size_t sizes[][4] = {{50, 20, 11, 30}, {5, 2, 0, 0}, {3000, 1500, 700, 2000}, {0, 0, 0, 0}, {8, 4, 2, 3}};
    colony *to = colony_create();
    for (size_t i = 0; i < sizeof sizes / sizeof sizes[0]; i++) {
        colony *from = colony_create();
        colony_resize(from, sizes[i][0], sizes[i][1], sizes[i][2], sizes[i][3]);
        colony_walk(from, fill, NULL);
        from->next_cell_id = 1000 + i;
        from->next_link_id = 2000 + i;
        colony_copy(to, from);
        walk a = {0}, b = {0};
        colony_walk(from, check_column, &a);
        colony_walk(to, check_column, &b);
        assert_memory_equal(a.rows, b.rows, sizeof a.rows);
        for (size_t k = 0; k < LISTED; k++) {
            size_t t = list[k].table[0] == 'p' ? 0 : list[k].table[0] == 'c' ? 1 : list[k].table[0] == 'l' ? 2 : 3;
            if (a.rows[t])
                assert_memory_equal(a.data[k], b.data[k], a.rows[t] * list[k].row_bytes);
        }
        assert_int_equal(to->next_cell_id, 1000 + i);
        assert_int_equal(to->next_link_id, 2000 + i);
        colony_free(from);
    }
    colony_free(to);
}

static int check_zero(void *self, const char *table, const char *column, void *data, size_t row_bytes, size_t rows) {
    (void)column;
    const unsigned char *p = data;
    size_t kept = table[0] == 'c' ? *(size_t *)self : 0;
    for (size_t i = kept * row_bytes; i < rows * row_bytes; i++)
        assert_int_equal(p[i], 0);
    return 0;
}

/* Rows that come anew are zero even where rows were before. */
static void test_new_rows_are_zero(void **state) {
    (void)state;
    colony *c = colony_create();
    colony_resize(c, 40, 20, 10, 30);
    colony_walk(c, fill, NULL);
    colony_resize(c, 0, 5, 0, 0);
    colony_resize(c, 40, 20, 10, 30);
    size_t kept = 5;
    colony_walk(c, check_zero, &kept);
    assert_true(colony_bytes(c) > sizeof *c + 40 * 6 * sizeof(double));
    colony_clear(c);
    assert_int_equal(c->cell.count + c->particle.count + c->link.count + c->spring.count, 0);
    double x[3] = {1, 2, 3};
    assert_int_equal(colony_add_cell(c, 1, x), 0);
    assert_int_equal(c->cell.id[0], 1);
    colony_free(c);
}

static void test_centre_and_axis(void **state) {
    (void)state;
    colony *c = colony_create();
    double rod[6] = {1, 2, 3, 1, 6, 6}, coccus[3] = {7, 8, 9}, helix[9] = {0, 0, 0, 5, 5, 5, 0, 0, -4};
    double point[6] = {1, 1, 1, 1, 1, 1}, u[3];
    uint32_t rows[4] = {colony_add_cell(c, 2, rod), colony_add_cell(c, 1, coccus), colony_add_cell(c, 3, helix),
                        colony_add_cell(c, 2, point)};
    colony_centre(c, rows[0], u);
    assert_true(u[0] == 1 && u[1] == 4 && u[2] == 4.5);
    colony_axis(c, rows[0], u);
    assert_true(u[0] == 0 && u[1] == 0.8 && u[2] == 0.6);
    colony_centre(c, rows[1], u);
    assert_true(u[0] == 7 && u[1] == 8 && u[2] == 9);
    colony_axis(c, rows[1], u);
    assert_true(u[0] == 0 && u[1] == 0 && u[2] == 0);
    colony_centre(c, rows[2], u);
    assert_true(u[0] == 2.5 && u[1] == 2.5 && u[2] == 1.5); /* half of the mass is in the middle */
    colony_axis(c, rows[2], u);
    assert_true(u[0] == 0 && u[1] == 0 && u[2] == -1);
    colony_axis(c, rows[3], u);
    assert_true(u[0] == 0 && u[1] == 0 && u[2] == 0);
    colony_free(c);
    colony_free(NULL);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_random_events),
        cmocka_unit_test(test_walk_covers_every_column),
        cmocka_unit_test(test_copy_is_equal_to_the_bit),
        cmocka_unit_test(test_new_rows_are_zero),
        cmocka_unit_test(test_centre_and_axis),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}

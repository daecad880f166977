/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "model/colony.h"

#include "base/alloc.h"
#include "base/search.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

/* A column as the generic functions see it: where its pointer is, and how wide a row. */
typedef struct column {
    const char *name;
    size_t offset, row_bytes;
} column;

#define COLUMN_RECORD(table, type, name, width) {#name, offsetof(table, name), sizeof(type) * (width)},

static const column particle_list[] = {
#define PARTICLE_COLUMN(type, name, width, unit, meaning) COLUMN_RECORD(particle_columns, type, name, width)
#include "model/columns.def"
#undef PARTICLE_COLUMN
};
static const column cell_list[] = {
#define CELL_COLUMN(type, name, width, unit, meaning) COLUMN_RECORD(cell_columns, type, name, width)
#include "model/columns.def"
#undef CELL_COLUMN
};
static const column link_list[] = {
#define LINK_COLUMN(type, name, width, unit, meaning) COLUMN_RECORD(link_columns, type, name, width)
#include "model/columns.def"
#undef LINK_COLUMN
};
static const column spring_list[] = {
#define SPRING_COLUMN(type, name, width, unit, meaning) COLUMN_RECORD(spring_columns, type, name, width)
#include "model/columns.def"
#undef SPRING_COLUMN
};

/* The four tables begin alike: count, capacity, then one pointer a column. */
typedef struct table_head {
    size_t count, capacity;
} table_head;

typedef struct table_info {
    const char *name;
    size_t offset;
    const column *columns;
    size_t ncolumns;
} table_info;

#define LIST_COUNT(a) (sizeof(a) / sizeof(a)[0])
enum { PARTICLES, CELLS, LINKS, SPRINGS, TABLES = COLONY_TABLES };
static const table_info tables[TABLES] = {
    [PARTICLES] = {"particle", offsetof(colony, particle), particle_list, LIST_COUNT(particle_list)},
    [CELLS] = {"cell", offsetof(colony, cell), cell_list, LIST_COUNT(cell_list)},
    [LINKS] = {"link", offsetof(colony, link), link_list, LIST_COUNT(link_list)},
    [SPRINGS] = {"spring", offsetof(colony, spring), spring_list, LIST_COUNT(spring_list)},
};

static table_head *head_of(colony *c, int table) {
    return (void *)((char *)c + tables[table].offset);
}

static char **data_of(colony *c, int table, size_t column_index) {
    return (void *)((char *)head_of(c, table) + tables[table].columns[column_index].offset);
}

static void reserve(colony *c, int table, size_t rows) {
    table_head *head = head_of(c, table);
    if (rows <= head->capacity)
        return;
    size_t capacity = head->capacity + head->capacity / 2;
    capacity = capacity > rows ? capacity : rows;
    capacity = capacity > 16 ? capacity : 16;
    for (size_t i = 0; i < tables[table].ncolumns; i++) {
        char **data = data_of(c, table, i);
        *data = alloc_resize(*data, capacity, tables[table].columns[i].row_bytes);
    }
    head->capacity = capacity;
}

static void set_count(colony *c, int table, size_t rows) {
    reserve(c, table, rows);
    table_head *head = head_of(c, table);
    if (rows > head->count)
        for (size_t i = 0; i < tables[table].ncolumns; i++) {
            size_t width = tables[table].columns[i].row_bytes;
            memset(*data_of(c, table, i) + head->count * width, 0, (rows - head->count) * width);
        }
    head->count = rows;
    c->version++;
    c->cell_version += table == CELLS;
}

colony *colony_create(void) {
    colony *c = alloc_zeroed(1, sizeof *c);
    c->next_cell_id = c->next_link_id = 1;
    c->version = c->cell_version = 1;
    return c;
}

void colony_free(colony *c) {
    if (!c)
        return;
    for (int t = 0; t < TABLES; t++)
        for (size_t i = 0; i < tables[t].ncolumns; i++)
            free(*data_of(c, t, i));
    free(c->order);
    free(c);
}

void colony_clear(colony *c) {
    for (int t = 0; t < TABLES; t++)
        set_count(c, t, 0);
    c->next_cell_id = c->next_link_id = 1;
    c->links_formed = c->links_broken = 0;
    memset(c->caps, 0, sizeof c->caps);
}

void colony_resize(colony *c, size_t particles, size_t cells, size_t links, size_t springs) {
    const size_t rows[TABLES] = {particles, cells, links, springs};
    for (int t = 0; t < TABLES; t++)
        set_count(c, t, rows[t]);
}

void colony_copy(colony *to, const colony *from) {
    colony *source = (colony *)from; /* only read */
    for (int t = 0; t < TABLES; t++) {
        size_t rows = head_of(source, t)->count;
        set_count(to, t, rows);
        for (size_t i = 0; i < tables[t].ncolumns && rows; i++)
            memcpy(*data_of(to, t, i), *data_of(source, t, i), rows * tables[t].columns[i].row_bytes);
    }
    to->next_cell_id = from->next_cell_id;
    to->next_link_id = from->next_link_id;
    to->links_formed = from->links_formed;
    to->links_broken = from->links_broken;
    memcpy(to->caps, from->caps, sizeof to->caps);
}

/* The order of ids stays known: the new cell's is the highest. */
static void append_order(colony *c, uint32_t row) {
    c->order = alloc_grow(c->order, &c->order_capacity, (size_t)row + 1, sizeof *c->order);
    c->order[row] = row;
    c->order_version = c->cell_version;
}

uint32_t colony_add_cell(colony *c, size_t n, const double *x) {
    uint32_t row = (uint32_t)c->cell.count, first = (uint32_t)c->particle.count;
    bool ordered = c->order_version == c->cell_version;
    set_count(c, CELLS, row + 1);
    set_count(c, PARTICLES, first + n);
    if (ordered)
        append_order(c, row);
    c->cell.id[row] = c->next_cell_id++;
    c->cell.first[row] = first;
    c->cell.nparticles[row] = (uint32_t)n;
    memcpy(c->particle.x + 3 * (size_t)first, x, 3 * n * sizeof *x);
    return row;
}

uint32_t colony_add_link(colony *c, link_kind kind, uint64_t cell_a, uint64_t cell_b, size_t count) {
    uint32_t row = (uint32_t)c->link.count, first = (uint32_t)c->spring.count;
    set_count(c, LINKS, row + 1);
    set_count(c, SPRINGS, first + count);
    c->link.id[row] = c->next_link_id++;
    c->link.kind[row] = kind;
    c->link.cell_a[row] = cell_a;
    c->link.cell_b[row] = cell_b;
    c->link.first[row] = first;
    c->link.nsprings[row] = (uint32_t)count;
    return row;
}

/* Rows of a table in a new order: each column through one scratch buffer. */
static void take_rows(colony *c, int table, const uint32_t *rows, size_t n) {
    table_head *head = head_of(c, table);
    char *scratch = NULL;
    size_t room = 0;
    for (size_t i = 0; i < tables[table].ncolumns && n; i++) {
        size_t width = tables[table].columns[i].row_bytes;
        scratch = alloc_grow(scratch, &room, n * width, 1);
        char *data = *data_of(c, table, i);
        for (size_t r = 0; r < n; r++)
            memcpy(scratch + r * width, data + (size_t)rows[r] * width, width);
        memcpy(data, scratch, n * width);
    }
    free(scratch);
    head->count = n;
    c->version++;
    c->cell_version += table == CELLS;
}

/* Drops the links of the cells that `kept` does not mark. */
static void drop_links_of_dropped_cells(colony *c, const bool *kept) {
    if (!c->link.count)
        return;
    uint64_t *dropped = alloc_zeroed(c->cell.count, sizeof *dropped);
    size_t ndropped = 0;
    const uint32_t *order = colony_by_id(c);
    for (size_t i = 0; i < c->cell.count; i++)
        if (!kept[order[i]])
            dropped[ndropped++] = c->cell.id[order[i]];
    if (ndropped) {
        bool *drop = alloc_zeroed(c->link.count, sizeof *drop);
        for (size_t l = 0; l < c->link.count; l++)
            drop[l] = search_id(dropped, ndropped, c->link.cell_a[l]) < ndropped ||
                      search_id(dropped, ndropped, c->link.cell_b[l]) < ndropped;
        colony_drop_links(c, drop);
        free(drop);
    }
    free(dropped);
}

void colony_arrange(colony *c, const uint32_t *rows, size_t n) {
    bool *kept = alloc_zeroed(c->cell.count, sizeof *kept);
    for (size_t i = 0; i < n; i++)
        kept[rows[i]] = true;
    drop_links_of_dropped_cells(c, kept);
    free(kept);

    /* the particles follow their cells; springs are told where they went */
    uint32_t *particles = alloc_zeroed(c->particle.count, sizeof *particles);
    uint32_t *moved_to = alloc_zeroed(c->particle.count, sizeof *moved_to);
    uint32_t nparticles = 0;
    for (size_t i = 0; i < n; i++) {
        uint32_t first = c->cell.first[rows[i]], count = c->cell.nparticles[rows[i]];
        for (uint32_t p = 0; p < count; p++) {
            moved_to[first + p] = nparticles;
            particles[nparticles++] = first + p;
        }
    }
    take_rows(c, CELLS, rows, n);
    take_rows(c, PARTICLES, particles, nparticles);
    uint32_t first = 0;
    for (size_t i = 0; i < n; i++) {
        c->cell.first[i] = first;
        first += c->cell.nparticles[i];
    }
    for (size_t s = 0; s < c->spring.count; s++) {
        c->spring.a[s] = moved_to[c->spring.a[s]];
        if (c->spring.b[s] != SPRING_ANCHOR)
            c->spring.b[s] = moved_to[c->spring.b[s]];
    }
    free(particles);
    free(moved_to);
}

void colony_drop_links(colony *c, const bool *drop) {
    uint32_t *links = alloc_zeroed(c->link.count, sizeof *links);
    uint32_t *springs = alloc_zeroed(c->spring.count, sizeof *springs);
    uint32_t nlinks = 0, nsprings = 0;
    for (uint32_t l = 0; l < c->link.count; l++) {
        if (drop[l])
            continue;
        links[nlinks++] = l;
        for (uint32_t s = 0; s < c->link.nsprings[l]; s++)
            springs[nsprings++] = c->link.first[l] + s;
    }
    take_rows(c, LINKS, links, nlinks);
    take_rows(c, SPRINGS, springs, nsprings);
    uint32_t first = 0;
    for (uint32_t l = 0; l < nlinks; l++) {
        c->link.first[l] = first;
        first += c->link.nsprings[l];
    }
    free(links);
    free(springs);
}

typedef struct id_row {
    uint64_t id;
    uint32_t row;
} id_row;

static int compare_id(const void *a, const void *b) {
    const id_row *p = a, *q = b;
    return (p->id > q->id) - (p->id < q->id);
}

/* Rows 0 ... n - 1 into `rows`, in the order of their ids. */
static void sort_by_id(const uint64_t *ids, size_t n, uint32_t *rows) {
    bool sorted = true;
    for (size_t i = 0; i < n; i++) {
        rows[i] = (uint32_t)i;
        sorted = sorted && (i == 0 || ids[i - 1] < ids[i]);
    }
    if (sorted)
        return;
    id_row *pairs = alloc_zeroed(n, sizeof *pairs);
    for (size_t i = 0; i < n; i++)
        pairs[i] = (id_row){ids[i], (uint32_t)i};
    qsort(pairs, n, sizeof *pairs, compare_id);
    for (size_t i = 0; i < n; i++)
        rows[i] = pairs[i].row;
    free(pairs);
}

const uint32_t *colony_by_id(colony *c) {
    if (c->order_version == c->cell_version)
        return c->order;
    c->order = alloc_grow(c->order, &c->order_capacity, c->cell.count, sizeof *c->order);
    sort_by_id(c->cell.id, c->cell.count, c->order);
    c->order_version = c->cell_version;
    return c->order;
}

uint32_t *colony_links_by_id(const colony *c) {
    uint32_t *rows = alloc_zeroed(c->link.count, sizeof *rows);
    sort_by_id(c->link.id, c->link.count, rows);
    return rows;
}

double colony_spring_length(const colony *c, uint32_t spring) {
    const double *a = c->particle.x + 3 * (size_t)c->spring.a[spring];
    bool anchored = c->spring.b[spring] == SPRING_ANCHOR;
    const double *b =
        anchored ? c->spring.anchor + 3 * (size_t)spring : c->particle.x + 3 * (size_t)c->spring.b[spring];
    double d[3] = {b[0] - a[0], b[1] - a[1], b[2] - a[2]};
    if (anchored && c->spring.glides[spring])
        return fabs(d[2]);
    return sqrt(d[0] * d[0] + d[1] * d[1] + d[2] * d[2]);
}

uint32_t colony_row(colony *c, uint64_t id) {
    const uint32_t *order = colony_by_id(c);
    size_t low = 0, high = c->cell.count;
    while (low < high) {
        size_t middle = (low + high) / 2;
        if (c->cell.id[order[middle]] < id)
            low = middle + 1;
        else
            high = middle;
    }
    return low < c->cell.count && c->cell.id[order[low]] == id ? order[low] : COLONY_NO_ROW;
}

int colony_walk(colony *c, colony_visit *visit, void *self) {
    for (int t = 0; t < TABLES; t++)
        for (size_t i = 0; i < tables[t].ncolumns; i++) {
            const column *col = &tables[t].columns[i];
            int status =
                visit(self, tables[t].name, col->name, *data_of(c, t, i), col->row_bytes, head_of(c, t)->count);
            if (status)
                return status;
        }
    return 0;
}

void colony_centre(const colony *c, uint32_t row, double centre[3]) {
    colony_mean(c, row, c->particle.x, centre);
}

void colony_mean(const colony *c, uint32_t row, const double *values, double mean[3]) {
    size_t n = c->cell.nparticles[row];
    const double *a = values + 3 * (size_t)c->cell.first[row], *b = a + 3 * (n - 1);
    for (size_t i = 0; i < 3; i++)
        mean[i] = 0.5 * (a[i] + b[i]);
    if (n < 3)
        return;
    /* half of a segment's mass is at each of its ends */
    for (size_t p = 1; p + 1 < n; p++)
        for (size_t i = 0; i < 3; i++)
            mean[i] += a[3 * p + i];
    for (size_t i = 0; i < 3; i++)
        mean[i] /= (double)(n - 1);
}

void colony_axis(const colony *c, uint32_t row, double axis[3]) {
    const double *a = c->particle.x + 3 * (size_t)c->cell.first[row];
    const double *b = a + 3 * ((size_t)c->cell.nparticles[row] - 1);
    double d[3] = {b[0] - a[0], b[1] - a[1], b[2] - a[2]};
    double length = sqrt(d[0] * d[0] + d[1] * d[1] + d[2] * d[2]);
    for (int i = 0; i < 3; i++)
        axis[i] = length > 0 ? d[i] / length : 0;
}

void colony_memory(const colony *c, size_t bytes[COLONY_TABLES]) {
    colony *source = (colony *)c; /* only read */
    for (int t = 0; t < TABLES; t++) {
        bytes[t] = 0;
        for (size_t i = 0; i < tables[t].ncolumns; i++)
            bytes[t] += head_of(source, t)->capacity * tables[t].columns[i].row_bytes;
    }
}

size_t colony_bytes(const colony *c) {
    size_t by_table[COLONY_TABLES], bytes = sizeof *c + c->order_capacity * sizeof *c->order;
    colony_memory(c, by_table);
    for (int t = 0; t < TABLES; t++)
        bytes += by_table[t];
    return bytes;
}

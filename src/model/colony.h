/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The state: particles, cells, links and springs as structures of arrays, and nothing else.
 *
 * A cell's particles are consecutive rows; a link's springs too. Rows may be reordered at any time by
 * colony_arrange, so whoever keeps something longer keeps an id. No result may depend on row order: loops whose order
 * matters go by id (colony_by_id). */
#ifndef SARCINA_MODEL_COLONY_H
#define SARCINA_MODEL_COLONY_H

#include "model/cap.h"

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

#define SPRING_ANCHOR UINT32_MAX
#define COLONY_NO_ROW UINT32_MAX

typedef enum {
    LINK_FILIAL,
    LINK_STICK,
    LINK_ANCHOR,
    LINK_SPRING /* a bare spring, as the oracles list them */
} link_kind;

typedef struct particle_columns {
    size_t count, capacity;
#define PARTICLE_COLUMN(type, name, width, unit, meaning) type *name; /* (count x width) */
#include "model/columns.def"
#undef PARTICLE_COLUMN
} particle_columns;

typedef struct cell_columns {
    size_t count, capacity;
#define CELL_COLUMN(type, name, width, unit, meaning) type *name;
#include "model/columns.def"
#undef CELL_COLUMN
} cell_columns;

typedef struct link_columns {
    size_t count, capacity;
#define LINK_COLUMN(type, name, width, unit, meaning) type *name;
#include "model/columns.def"
#undef LINK_COLUMN
} link_columns;

typedef struct spring_columns {
    size_t count, capacity;
#define SPRING_COLUMN(type, name, width, unit, meaning) type *name;
#include "model/columns.def"
#undef SPRING_COLUMN
} spring_columns;

typedef struct colony {
    particle_columns particle;
    cell_columns cell;
    link_columns link;
    spring_columns spring;
    uint64_t next_cell_id, next_link_id; /* from 1 */
    uint64_t links_formed, links_broken; /* since the beginning: at division or by nearness; by stretching */
    uint64_t caps[CAP_COUNT];            /* since the beginning: limits on motion that were met */
    uint64_t version;      /* changes with every insertion, deletion and reordering: caches of rows compare it */
    uint64_t cell_version; /* the same of cells alone */
    /* rows in the order of their ids; see colony_by_id */
    uint32_t *order;
    size_t order_capacity;
    uint64_t order_version;
} colony;

/* An empty colony; free with colony_free, which takes NULL. */
colony *colony_create(void);
void colony_free(colony *c);

/* Takes out every cell, link and spring; ids start again at 1. */
void colony_clear(colony *c);

/* A copy of all of it into `to` (an existing colony), to the bit. */
void colony_copy(colony *to, const colony *from);

/* Appends a cell of n particles at rest at x (n x 3), with the next id; every other column is 0. Returns its row. */
uint32_t colony_add_cell(colony *c, size_t n, const double *x);

/* Appends a link between two cells (cell_b 0: the substratum) with count springs, whose columns are 0. Returns its row.
 */
uint32_t colony_add_link(colony *c, link_kind kind, uint64_t cell_a, uint64_t cell_b, size_t count);

/* The one function that moves rows: keeps the cells of `rows` (n distinct cell rows) in that order and drops the
 * others, with their particles, and every link that touches a dropped cell. Deletion and sorting are calls of it. */
void colony_arrange(colony *c, const uint32_t *rows, size_t n);

/* Drops the links whose flag is set (c->link.count flags), with their springs; the others keep their order. */
void colony_drop_links(colony *c, const bool *drop);

/* Cell rows in the order of their ids (c->cell.count of them). Holds until the colony changes. */
const uint32_t *colony_by_id(colony *c);

/* Link rows in the order of their ids (c->link.count of them); the caller frees. */
uint32_t *colony_links_by_id(const colony *c);

/* Present length of a spring, um; of a gliding anchor: along z only. */
double colony_spring_length(const colony *c, uint32_t spring);

/* Row of the cell with this id; COLONY_NO_ROW when it is not there. */
uint32_t colony_row(colony *c, uint64_t id);

/* Calls visit for every column of every table: a table's name, the column's, its data, bytes a row and rows.
 * Snapshots, hashes and dumps of memory use walk the state by it. Stops at the first non-zero return and gives it. */
typedef int colony_visit(void *self, const char *table, const char *column, void *data, size_t row_bytes, size_t rows);
int colony_walk(colony *c, colony_visit *visit, void *self);

/* Sets the number of rows of each table, for loading: new rows are zero. */
void colony_resize(colony *c, size_t particles, size_t cells, size_t links, size_t springs);

/* Centre of a cell: its centre of mass; and its axis, a unit vector from its first to its last particle, 0 0 0 for a
 * coccus or a rod of length zero. */
void colony_centre(const colony *c, uint32_t row, double centre[3]);

/* Mean of a particle column of width 3 over a cell, by mass: with x the centre, with v its velocity. */
void colony_mean(const colony *c, uint32_t row, const double *values, double mean[3]);
void colony_axis(const colony *c, uint32_t row, double axis[3]);

/* Memory the state occupies, bytes; and by table: particles, cells, links, springs. */
enum { COLONY_TABLES = 4 };
size_t colony_bytes(const colony *c);
void colony_memory(const colony *c, size_t bytes[COLONY_TABLES]);

#endif

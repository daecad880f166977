/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The second table of a data file: the links between its cells and to the substratum, behind a line `links`, one spring
 * a row.
 *
 *     links
 *     link,kind,joint,age[s],cell_a,cell_b,a,a_particle,b,b_particle,k[pg/s2],rest[um],x[um],y[um],z[um],glides
 *
 * link counts from 1 in the order in which they formed; kind: filial, stick, anchor; cell_a, cell_b: ids of the cells,
 * 0 the substratum; a and b: the cells whose particles (from 1) the spring holds, b 0: the point x, y, z. These
 * columns, in this order. */
#ifndef SARCINA_COMMAND_LINK_FILE_H
#define SARCINA_COMMAND_LINK_FILE_H

#include "base/csv.h"
#include "engine/scene.h"

typedef struct link_file_row {
    uint64_t link, cell_a, cell_b, a, b, a_particle, b_particle, joint, glides;
    int kind; /* link_kind */
    double age, k, rest, anchor[3];
} link_file_row;

typedef struct link_file {
    link_file_row *rows; /* a spring each, those of a link together */
    size_t n, capacity;
} link_file;

/* Is this row of the file the line that the table begins behind? */
bool link_file_begins(const csv *t);

/* Reads the rest of the file. The caller frees, also after an error. */
int link_file_read(link_file *l, csv *t, diag *d);
void link_file_free(link_file *l);

/* Whether the cells and particles they hold are among these, and the scene may have links of their kinds. */
int link_file_check(const link_file *l, const scene *s, const cell_row *rows, size_t n, diag *d);

/* Adds them to a scene that has those cells. */
void link_file_add(const link_file *l, scene *s);

/* Writes the links of the scene; nothing where there are none. */
void link_file_write(FILE *f, const scene *s);

#endif

/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Cells in a CSV file: a header line of column names, then one cell a line.
 *
 *     species,x[um],y[um],z[um],mass[pg],ux,uy,uz
 *     species,id,parent,founder,generation,age[s],mass[pg],diameter[um],x1[um],y1[um],z1[um],x2[um] ... vx1[um/s] ...
 *
 *     x[um],y[um],length[um],angle[degree]
 *
 * Columns in any order. A place is due: x, y, z of the centre, or those of every particle (x1, y1, z1, x2 ...), as
 * write_data writes them; without z cells lie on the substratum, or in the plane of a scene of two dimensions. The axis
 * is ux, uy, uz, or an angle in the plane z = const, from x towards y. The length, over both caps, stands for a mass.
 * What else is not given or empty is drawn. A unit stands in brackets behind the name; else numbers are in the units of
 * the script. In um, pg, s and um/s numbers are read to the bit. Lines that begin with # are comments; a column that is
 * not known is warned of. write_data adds groups (names parted by blanks), fi, fj, fk, fw (the frame of the next
 * division) where cells have them, and a second table (link_file.h). */
#ifndef SARCINA_COMMAND_CELL_FILE_H
#define SARCINA_COMMAND_CELL_FILE_H

#include "command/link_file.h"
#include "script/command.h"

typedef struct cell_file {
    cell_row *rows; /* the cells */
    size_t count;
    link_file links;
    group_table groups;  /* of the scene, with those that the file names */
    int made[GROUP_MAX]; /* bits of these, in their order */
    size_t nmade;
    bool wants_links, wants_groups;
} cell_file;

/* Reads all of it or fails, naming line and column; nothing changes in the scene. species_row: of rows that name none;
 * -1: each must. as_they_were: with links and groups; else these are left out. The caller frees *f after success. */
int cell_file_read(interp *in, const char *path, int species_row, bool as_they_were, cell_file *f, diag *d);
void cell_file_free(cell_file *f);

/* Makes the groups that the file names and the scene does not have, with the bits that the rows say. */
void cell_file_make_groups(interp *in, const cell_file *f);

/* Writes every cell, in the order of ids, and the links. */
int cell_file_write(interp *in, const char *path, diag *d);

#endif

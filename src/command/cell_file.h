/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Cells in a CSV file: a header line of column names, then one cell a line.
 *
 *     species,x[um],y[um],z[um],mass[pg],ux,uy,uz
 *     species,id,parent,founder,generation,age[s],mass[pg],diameter[um],x1[um],y1[um],z1[um],x2[um] ... vx1[um/s] ...
 *
 * Columns in any order. A place is due: x, y, z of the centre, or those of every particle (x1, y1, z1, x2 ...), as
 * write_data writes them. What else is not given or empty is drawn. A unit stands in brackets behind the name; else
 * numbers are in the units of the script. In um, pg, s and um/s numbers are read to the bit. Lines that begin with #
 * are comments. write_data adds groups (names parted by blanks), fi, fj, fk, fw (the frame of the next division) where
 * cells have them, and a second table (link_file.h). */
#ifndef SARCINA_COMMAND_CELL_FILE_H
#define SARCINA_COMMAND_CELL_FILE_H

#include "command/link_file.h"
#include "script/command.h"

/* Reads all of it or fails, naming line and column. species_row: of rows that name none; -1: each must. links: what the
 * second table holds; NULL: it is left out. The caller frees *rows with cell_file_free, and the links. */
int cell_file_read(interp *in, const char *path, int species_row, cell_row **rows, size_t *count, link_file *links,
                   diag *d);
void cell_file_free(cell_row *rows, size_t count);

/* Writes every cell, in the order of ids, and the links. */
int cell_file_write(interp *in, const char *path, diag *d);

#endif

/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Cells from a CSV file: a header line of column names, then one cell a line.
 *
 *     species,x[um],y[um],z[um],mass[pg],ux,uy,uz
 *
 * Columns in any order; x, y, z are due. species (else that of the command), mass, diameter, ux, uy, uz may be left
 * out or empty: what is not given is drawn. A unit stands in brackets behind the name; else numbers are in the units of
 * the script. Lines that begin with # are comments. */
#ifndef SARCINA_COMMAND_CELL_FILE_H
#define SARCINA_COMMAND_CELL_FILE_H

#include "script/command.h"

/* Reads all of it or fails, naming line and column. species_row: of rows that name none. The caller frees *rows. */
int cell_file_read(interp *in, const char *path, int species_row, cell_row **rows, size_t *count, diag *d);

#endif

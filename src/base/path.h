/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Files. Those to write: a missing folder is made when the file is, so that `-var out DIR` needs no other command. */
#ifndef SARCINA_BASE_PATH_H
#define SARCINA_BASE_PATH_H

#include "base/diag.h"

#include <stdio.h>

/* Can a file of this name be written? Nothing is touched: a folder that is not there counts if it could be made. */
int path_check(const char *path, diag *d);

/* Makes the folders of a file's name that are not there. */
int path_make_folders(const char *path, diag *d);

/* Opens a file to write ("w", "a", "wb" ...), making its folders. NULL: d says why. */
FILE *path_open(const char *path, const char *mode, diag *d);

/* Closes a file that was written to; an error where any of it was lost, now or before (a full disk). */
int path_close(FILE *f, const char *path, diag *d);

/* All that a file or stream still has, with a NUL behind; *length without that, NULL allowed. The caller frees. */
char *path_read_all(FILE *f, size_t *length);

/* The error of a file that cannot be written, from errno. */
int path_error(const char *path, diag *d);

#endif

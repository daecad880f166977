/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Named blocks of bytes in one file: what a restart file is. Every layer puts in what is its own. The file begins with
 * a line that names the format, and each block carries its length and checksum, so that a file cut short or damaged is
 * found out before anything is changed. */
#ifndef SARCINA_ENGINE_ARCHIVE_H
#define SARCINA_ENGINE_ARCHIVE_H

#include "base/diag.h"

#include <stdbool.h>
#include <stddef.h>

typedef struct archive archive;

archive *archive_create(void);
void archive_free(archive *a);

/* Adds a block (its bytes are copied); names are distinct. */
void archive_put(archive *a, const char *name, const void *bytes, size_t n);

/* The block of that name and its size; NULL when there is none. It belongs to the archive; a zero byte follows it, so
 * that text can be read as it is. */
const char *archive_get(const archive *a, const char *name, size_t *n);

/* Keeps once in memory what two archives have in common, block by block in order: a's blocks become b's. Whether they
 * are the same altogether. */
bool archive_share(archive *a, const archive *b);

/* Memory it occupies, bytes; of a block that others have too its part. */
size_t archive_bytes(const archive *a);

/* Writes the file by way of a temporary one beside it, so that a failure leaves what was there; a device or pipe of
 * that name is written to as it is. */
int archive_write(const archive *a, const char *path, diag *d);

/* Reads a whole file; *out is the caller's to free. */
int archive_read(const char *path, archive **out, diag *d);

#endif

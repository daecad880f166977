/* SPDX-License-Identifier: GPL-3.0-or-later */
/* A column of a table or dump: a name, a dimension and where its numbers come from. The script layer makes them from
 * expressions; the writers know nothing of scripts. */
#ifndef SARCINA_ENGINE_COLUMN_H
#define SARCINA_ENGINE_COLUMN_H

#include "base/diag.h"
#include "base/dim.h"

#include <stdbool.h>
#include <stdint.h>

typedef struct output_column {
    char *name; /* heading; owned */
    dim d;
    bool is_text;
    void *self; /* passed to the callbacks */
    /* Per cell (row: cell row), or for the whole scene (row ignored). Numbers come in SI; undefined: NaN. */
    int (*number)(void *self, uint32_t row, double *si, diag *d);
    int (*text)(void *self, uint32_t row, char out[64], diag *d);
    void (*release)(void *self); /* NULL: nothing to free */
} output_column;

#endif

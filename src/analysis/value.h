/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The table of values that expressions, thermo columns, dumps and analyses read: one record a name, with its
 * dimension, fields, definition and function. Numbers are in the engine's units; dim_from_engine gives SI. */
#ifndef SARCINA_ANALYSIS_VALUE_H
#define SARCINA_ANALYSIS_VALUE_H

#include "analysis/view.h"
#include "base/diag.h"
#include "base/dim.h"

typedef enum {
    VALUE_CELL,    /* one number (or text) a cell: z, length, species */
    VALUE_STATE,   /* one for the scene: step, cells, fmax */
    VALUE_ANALYSIS /* a measure of a set of cells: thickness, ellipse; `analyze` takes it for a group */
} value_scope;

#define VALUE_FIELDS_MAX 16

typedef struct value_style {
    const char *name;
    value_scope scope;
    const char *dimension; /* "length" ...; "text" for a cell's text; of the bare name */
    const char *fields;    /* "area:area,major:length,angle:angle": NAME:DIMENSION of each field; NULL: none.
                            * The bare name is a value of its own, out[0]; field i is out[1 + i] */
    const char *summary;   /* one line: the definition */
    const char *source;    /* where the definition comes from; NULL */
    bool near;             /* reads view.radius */
    bool of;               /* reads view.of */
    double (*cell)(const view *v, uint32_t row);      /* VALUE_CELL, numbers */
    const char *(*text)(const view *v, uint32_t row); /* VALUE_CELL, text; holds while the view does */
    /* VALUE_STATE, VALUE_ANALYSIS: fills out (1 + fields); members: flag a cell row, NULL: all cells.
     * What is undefined for these cells (the orientation of one cell) is NaN, not an error. */
    int (*measure)(const view *v, const bool *members, double *out, diag *d);
} value_style;

extern const value_style value_styles[];
extern const size_t value_style_count;

/* The record called name; NULL. */
const value_style *value_find(const char *name);

/* Number of fields, and the i-th field's name and dimension. */
size_t value_field_count(const value_style *s);
int value_field_find(const value_style *s, const char *field); /* row; -1 */
void value_field(const value_style *s, size_t i, char name[32], dim *d);

/* Dimension of the bare name; of a text value: pure number. */
dim value_dim(const value_style *s);

#endif

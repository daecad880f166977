/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The values of expressions: a number with its dimension in SI, a truth, or a text; one, one a cell, or a list. */
#ifndef SARCINA_SCRIPT_OPERAND_H
#define SARCINA_SCRIPT_OPERAND_H

#include "base/dim.h"
#include "script/interp.h"

typedef enum { OPERAND_ONE, OPERAND_CELLS, OPERAND_LIST } operand_extent;

typedef struct operand {
    operand_extent extent;
    bool is_text, is_truth;
    bool plain;   /* of plain numbers only: takes the dimension of what it meets */
    bool unknown; /* only its type counts: in a check, or while types are checked */
    bool wild;    /* and not even its dimension is known */
    dim d;
    size_t n;   /* of v or t */
    double one; /* OPERAND_ONE */
    double *v;  /* OPERAND_CELLS by cell row, OPERAND_LIST; owned */
    char *text; /* OPERAND_ONE, text; owned */
    char **t;   /* OPERAND_CELLS, OPERAND_LIST of text; owned with its texts */
} operand;

void operand_free(operand *o);

operand operand_number(double si, dim d);
operand operand_truth(bool b);
operand operand_text(const char *text);
operand operand_unknown(operand_extent extent, dim d);
operand operand_wild(void);

/* The i-th number; of OPERAND_ONE the one. */
double operand_get(const operand *o, size_t i);

/* Turns a text into the number it reads as (with its unit), if it does. */
void operand_parse(interp *in, operand *o);

/* Gives plain numbers the dimension of the other operand; false: the two differ. */
bool operand_adapt(interp *in, operand *a, operand *b);

/* "length", "text", "pure number" ... for errors. */
const char *operand_kind(const operand *o, char buffer[48]);

#endif

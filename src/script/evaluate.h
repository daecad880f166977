/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Evaluation of expression trees on the scene as it stands, or of their types alone. */
#ifndef SARCINA_SCRIPT_EVALUATE_H
#define SARCINA_SCRIPT_EVALUATE_H

#include "analysis/view.h"
#include "script/expr.h"
#include "script/operand.h"

/* What an evaluation needs. */
typedef struct evaluation {
    interp *in;
    bool types_only; /* what depends on the scene is unknown: dimensions are checked, little is computed */
    int untaken;     /* > 0: a part that does not count (0 && 1/0): its numbers are unknown */
    bool lenient;    /* names that are not there yet are no error */
    bool repeatable; /* random() is refused */
    int per_cell;    /* > 0: random() draws once a cell */
    int depth;       /* of variables within variables */
    bool has_view;
    view view;
} evaluation;

/* The value of a tree; the caller frees it with operand_free, also after an error. */
int evaluate_node(evaluation *e, const node *n, operand *out, diag *d);

/* Its parts, in files of their own. */
int evaluate_name(evaluation *e, const node *n, operand *out, diag *d);
int evaluate_call(evaluation *e, const node *n, operand *out, diag *d);
int evaluate_reduction(evaluation *e, const node *n, operand *out, diag *d);
int evaluate_unary(const node *n, operand *a, operand *out, diag *d);
int evaluate_binary(evaluation *e, const node *n, operand *a, operand *b, operand *out, diag *d);

/* The view, made at the first call. */
int evaluate_view(evaluation *e, const view **v, diag *d);

/* An error placed at a node. */
int evaluate_refuse(const node *n, diag *d);

/* The tree of an expression that must have one value (per_cell: one a cell, or one for all). */
int evaluate_whole(evaluation *e, const expr *x, bool per_cell, operand *out, diag *d);

#endif

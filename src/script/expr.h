/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Expressions: their tree, their parser, and their values.
 *
 *     expr    = and { "||" and }              and   = compare { "&&" compare }
 *     compare = sum [ ("=="|"!="|"<"|"<="|">"|">=") sum ]
 *     sum     = product { ("+"|"-") product } product = unary { ("*"|"/"|"%") unary }
 *     unary   = ("-"|"+"|"!") unary | power   power = primary [ "^" unary ]
 *     primary = NUMBER[UNIT] | quoted | "(" expr ")" | NAME [ "." FIELD ] [ "[" expr "]" ] | call
 *     call    = FUNCTION "(" expr { "," expr } ")" | REDUCTION "(" [ expr "," ] expr [ "where" expr ] ")"
 *
 * Values carry their dimension, in SI. A formula of plain numbers only takes the dimension of what it meets. */
#ifndef SARCINA_SCRIPT_EXPR_H
#define SARCINA_SCRIPT_EXPR_H

#include "script/interp.h"
#include "script/reader.h"

typedef enum {
    NODE_NUMBER,
    NODE_TEXT,
    NODE_UNKNOWN, /* replaced text a check does not know */
    NODE_NAME,
    NODE_UNARY,
    NODE_BINARY,
    NODE_CALL
} node_kind;

typedef enum {
    OP_NONE,
    OP_OR,
    OP_AND,
    OP_EQ,
    OP_NE,
    OP_LT,
    OP_LE,
    OP_GT,
    OP_GE,
    OP_ADD,
    OP_SUB,
    OP_MUL,
    OP_DIV,
    OP_MOD,
    OP_POW,
    OP_NOT,
    OP_NEG
} op_kind;

enum { NODE_ARGS_MAX = 8 };

typedef struct node {
    node_kind kind;
    op_kind op;
    span at;   /* of the operator, name or number */
    double si; /* NODE_NUMBER */
    dim d;
    bool plain, wild;   /* number without a unit; unknown of unknown dimension */
    char *text;         /* NODE_TEXT; name of NODE_NAME, NODE_CALL */
    char *field;        /* NODE_NAME: behind the point; NULL */
    struct node *index; /* NODE_NAME: in brackets; NULL */
    struct node *args[NODE_ARGS_MAX];
    int nargs;
    struct node *where; /* NODE_CALL of a reduction; NULL */
} node;

struct expr {
    int references;
    char *text;
    span at;
    node *root;
    bool replaced; /* a $ was replaced in it */
};

/* How far an expression goes. */
typedef enum {
    EXPR_LONGEST, /* to the first word that cannot continue it */
    EXPR_ONEWORD, /* to the first blank outside ( ) and quotes */
    EXPR_OPEN     /* longest, and no quotes around the whole: inside $( ) */
} expr_extent;

/* Reads an expression at r->at and moves behind it; NULL on an error. The caller frees with expr_free. */
expr *expr_read(reader *r, expr_extent extent, diag *d);

void expr_free_node(node *n);

/* An expression from text alone, all of it. */
expr *expr_of_text(interp *in, const char *text, diag *d);

/* Whether a name stands in it whose value may change: not the constants of a replaced $. */
bool expr_can_change(const expr *e);
bool expr_node_can_change(const node *n);

/* Checks types without computing: the expression must be one value (or one a cell); its dimension goes to *d0. */
typedef struct expr_type {
    bool is_text, is_truth, unknown, plain, wild;
    dim d;
} expr_type;
int expr_check(interp *in, const expr *e, bool per_cell, bool repeatable, expr_type *out, diag *d);

/* The types of a formula that is read when used: what is not there yet is no error. */
int expr_check_formula(interp *in, const expr *e, diag *d);

/* expr_explain, expr_keep, expr_free, expr_text: interp.h. */

/* As $( ) prints it: 3e-06m, 0.5, text; with a format the bare number in the script's units. NULL on an error; the
 * caller frees. *note: what the reader of that text is to know of it. */
char *expr_print(interp *in, const expr *e, const char *format, replacement *note, diag *d);

#endif

/* SPDX-License-Identifier: GPL-3.0-or-later */
/* What the files of the expression parser share: its state and its tokens. */
#ifndef SARCINA_SCRIPT_EXPR_PARSER_H
#define SARCINA_SCRIPT_EXPR_PARSER_H

#include "script/expr.h"

typedef struct expr_parser {
    reader *r;
    size_t end; /* behind the last token taken */
    bool oneword;
    int parens;
    int depth; /* of the recursion */
    bool replaced;
    diag *d;
} expr_parser;

enum { EXPR_DEPTH_MAX = 200 };

node *expr_parser_node(expr_parser *p, node_kind kind, size_t from, size_t to);

/* Places the error about [from, to) and frees what was read; NULL. */
node *expr_parser_refuse(expr_parser *p, size_t from, size_t to, node *n);

/* The next character that belongs to the expression, blanks skipped and $ replaced; 0: none. *failed: a replacement
 * failed. */
char expr_parser_look(expr_parser *p, bool *failed);
void expr_parser_take(expr_parser *p, size_t n);

/* Characters of the replaced number, sign included, that begins here; 0: none does. */
size_t expr_parser_replaced_number(const expr_parser *p);

/* The operator at c, n characters long; OP_NONE: none. */
op_kind expr_parser_operator_at(const char *c, size_t *n);

/* The operator that comes next, not taken; OP_NONE: none. */
op_kind expr_parser_operator(expr_parser *p, size_t *n, bool *failed);

/* Rules of the grammar: the lowest and the highest. before: the operator it would be the right side of. */
node *expr_parser_or(expr_parser *p);
node *expr_parser_primary(expr_parser *p, op_kind before);

#endif

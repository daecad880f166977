/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The parser of expressions: one function a rule of the grammar in expr.h. */
#include "script/expr_parser.h"

#include "base/alloc.h"
#include "script/line.h"
#include "script/state.h"

#include <string.h>

static node *read_unary(expr_parser *p);

/* ---- operators ---- */

static node *binary(op_kind op, span where, node *left, node *right) {
    if (!right) {
        expr_free_node(left);
        return NULL;
    }
    node *n = alloc_zeroed(1, sizeof *n);
    n->kind = NODE_BINARY;
    n->op = op;
    n->at = where;
    n->args[0] = left;
    n->args[1] = right;
    n->nargs = 2;
    return n;
}

static node *read_power(expr_parser *p, op_kind before) {
    node *left = expr_parser_primary(p, before);
    size_t n = 0;
    bool failed;
    if (!left)
        return NULL;
    if (expr_parser_operator(p, &n, &failed) != OP_POW) {
        if (!failed)
            return left;
        expr_free_node(left);
        return NULL;
    }
    span where = reader_span(p->r, p->r->at, p->r->at + n);
    expr_parser_take(p, n);
    return binary(OP_POW, where, left, read_unary(p));
}

static node *read_unary_after(expr_parser *p, op_kind before) {
    bool failed;
    char c = expr_parser_look(p, &failed);
    if (failed)
        return NULL;
    if ((c != '-' && c != '+' && c != '!') || expr_parser_replaced_number(p))
        return read_power(p, before);
    if (++p->depth > EXPR_DEPTH_MAX) {
        diag_error(p->d, "the expression is nested too deeply");
        return expr_parser_refuse(p, p->r->at, p->r->at + 1, NULL);
    }
    node *n = expr_parser_node(p, NODE_UNARY, p->r->at, p->r->at + 1);
    n->op = c == '!' ? OP_NOT : c == '-' ? OP_NEG : OP_ADD;
    expr_parser_take(p, 1);
    n->args[0] = read_unary(p);
    p->depth--;
    if (!n->args[0])
        return expr_parser_refuse(p, p->r->at, p->r->at, n);
    n->nargs = 1;
    return n;
}

static node *read_unary(expr_parser *p) {
    return read_unary_after(p, OP_NONE);
}

/* Binding strength of the binary operators but ^; 0: none of them. */
static int strength(op_kind op) {
    switch (op) {
    case OP_OR:
        return 1;
    case OP_AND:
        return 2;
    case OP_EQ:
    case OP_NE:
    case OP_LT:
    case OP_LE:
    case OP_GT:
    case OP_GE:
        return 3;
    case OP_ADD:
    case OP_SUB:
        return 4;
    case OP_MUL:
    case OP_DIV:
    case OP_MOD:
        return 5;
    default:
        return 0;
    }
}

/* Operators of at least this strength, left to right. */
static node *read_binary(expr_parser *p, int least, op_kind before) {
    node *left = least > 5 ? read_unary_after(p, before) : read_binary(p, least + 1, before);
    bool compared = false;
    while (left && least <= 5) {
        size_t n = 0;
        bool failed;
        op_kind op = expr_parser_operator(p, &n, &failed);
        if (failed) {
            expr_free_node(left);
            return NULL;
        }
        if (strength(op) != least)
            return left;
        span where = reader_span(p->r, p->r->at, p->r->at + n);
        if (compared) {
            diag_error(p->d, "comparisons do not chain; write a < b && b < c");
            diag_place(p->d, where);
            expr_free_node(left);
            return NULL;
        }
        compared = least == 3;
        expr_parser_take(p, n);
        left = binary(op, where, left, read_binary(p, least + 1, op));
    }
    return left;
}

node *expr_parser_or(expr_parser *p) {
    if (++p->depth > EXPR_DEPTH_MAX) {
        diag_error(p->d, "the expression is nested too deeply");
        return expr_parser_refuse(p, p->r->at, p->r->at + 1, NULL);
    }
    node *n = read_binary(p, 1, OP_NONE);
    p->depth--;
    return n;
}

/* ---- the whole ---- */

static expr *expr_new(expr_parser *p, node *root, size_t from) {
    expr *e = alloc_zeroed(1, sizeof *e);
    e->references = 1;
    e->root = root;
    e->text = alloc_copy_n(p->r->text.chars + from, p->end - from);
    e->at = reader_span(p->r, from, p->end);
    e->replaced = p->replaced;
    p->r->at = p->end;
    return e;
}

/* Length of the quotes when the whole expression is one quoted word; 0: it is not. */
static size_t quoted_whole(reader *r) {
    size_t quote = line_quote(r->text.chars, r->at, r->at), n;
    if (!quote || piece_is_replaced(&r->text, r->at))
        return 0;
    size_t end = line_quote_end(&r->text, r->at, quote);
    if (end == (size_t)-1 || end > reader_end(r))
        return 0;
    size_t next = end;
    while (next < reader_end(r) && line_is_blank(r->text.chars[next]))
        next++;
    bool goes_on = next < reader_end(r) && expr_parser_operator_at(r->text.chars + next, &n) != OP_NONE;
    return goes_on ? 0 : quote;
}

/* The expression inside the quotes at r->at, which must be all of what they hold. */
static expr *read_inside(reader *r, size_t quote, diag *d) {
    size_t tail = r->tail, end = line_quote_end(&r->text, r->at, quote);
    r->tail = r->text.n - (end - quote);
    r->at += quote;
    expr *e = expr_read(r, EXPR_OPEN, d);
    if (e && !reader_at_end(r)) {
        diag_error(d, "unexpected '%.*s' behind the expression", (int)(reader_end(r) - r->at), r->text.chars + r->at);
        diag_place(d, reader_span(r, r->at, reader_end(r)));
        expr_free(e);
        e = NULL;
    }
    r->at = reader_end(r) + quote;
    r->tail = tail;
    return e;
}

expr *expr_read(reader *r, expr_extent extent, diag *d) {
    bool end = reader_at_end(r);
    size_t quote = end || extent == EXPR_OPEN ? 0 : quoted_whole(r);
    if (quote)
        return read_inside(r, quote, d);
    expr_parser p = {.r = r, .end = r->at, .oneword = extent == EXPR_ONEWORD, .d = d};
    size_t from = r->at;
    node *root = expr_parser_or(&p);
    return root ? expr_new(&p, root, from) : NULL;
}

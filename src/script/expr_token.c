/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The tokens of expressions. $ is replaced as the parser comes to it. */
#include "script/expr_parser.h"

#include "base/alloc.h"
#include "base/number.h"
#include "base/table.h"
#include "script/line.h"
#include "script/state.h"

#include <string.h>

node *expr_parser_node(expr_parser *p, node_kind kind, size_t from, size_t to) {
    node *n = alloc_zeroed(1, sizeof *n);
    n->kind = kind;
    n->at = reader_span(p->r, from, to);
    return n;
}

/* Places the error about [from, to) and frees what was read; NULL. */
node *expr_parser_refuse(expr_parser *p, size_t from, size_t to, node *n) {
    diag_place(p->d, reader_span(p->r, from, to));
    expr_free_node(n);
    return NULL;
}

static const char *at(const expr_parser *p) {
    return p->r->text.chars + p->r->at;
}

/* The next character that belongs to the expression, blanks skipped and $ replaced; 0: none. -1 never; *failed: a
 * replacement failed. */
char expr_parser_look(expr_parser *p, bool *failed) {
    reader *r = p->r;
    *failed = false;
    for (;;) {
        while ((!p->oneword || p->parens) && r->at < reader_end(r) && line_is_blank(*at(p)))
            r->at++;
        if (r->at >= reader_end(r) || (p->oneword && !p->parens && line_is_blank(*at(p))))
            return 0;
        if (*at(p) != '$' || piece_is_replaced(&r->text, r->at)) {
            p->replaced = p->replaced || piece_is_replaced(&r->text, r->at);
            return *at(p);
        }
        if (reader_replace(r, r->at, p->d) != SARCINA_OK) {
            *failed = true;
            return 0;
        }
    }
}

void expr_parser_take(expr_parser *p, size_t n) {
    p->r->at += n;
    p->end = p->r->at;
}

/* Characters of the replaced number, sign included, that begins at r->at; 0: none does. */
size_t expr_parser_replaced_number(const expr_parser *p) {
    const piece *t = &p->r->text;
    size_t i = p->r->at;
    uint32_t serial = t->marks[i].serial;
    if (!serial || (i > 0 && t->marks[i - 1].serial == serial))
        return 0;
    size_t n = 0;
    while (i + n < reader_end(p->r) && t->marks[i + n].serial == serial)
        n++;
    return number_length(t->chars + i, n, true);
}

op_kind expr_parser_operator_at(const char *c, size_t *n) {
    static const struct {
        const char *text;
        op_kind op;
    } ops[] = {{"||", OP_OR}, {"&&", OP_AND}, {"==", OP_EQ}, {"!=", OP_NE}, {"<=", OP_LE},
               {">=", OP_GE}, {"<", OP_LT},   {">", OP_GT},  {"+", OP_ADD}, {"-", OP_SUB},
               {"*", OP_MUL}, {"/", OP_DIV},  {"%", OP_MOD}, {"^", OP_POW}};
    for (size_t i = 0; i < TABLE_COUNT(ops); i++)
        if (strncmp(c, ops[i].text, strlen(ops[i].text)) == 0) {
            *n = strlen(ops[i].text);
            return ops[i].op;
        }
    return OP_NONE;
}

/* The operator that comes next, not taken; OP_NONE: none. */
op_kind expr_parser_operator(expr_parser *p, size_t *n, bool *failed) {
    char c = expr_parser_look(p, failed);
    if (c == 0 || expr_parser_replaced_number(p))
        return OP_NONE;
    op_kind op = expr_parser_operator_at(at(p), n);
    if (op != OP_NONE)
        return op;
    const char *instead = c == '='   ? "'=' does not compare; write '=='"
                          : c == '&' ? "a single '&' is no operator; write '&&'"
                          : c == '|' ? "a single '|' is no operator; write '||'"
                                     : NULL;
    if (instead) {
        diag_error(p->d, "%s", instead);
        expr_parser_refuse(p, p->r->at, p->r->at + 1, NULL);
        *failed = true;
    }
    return OP_NONE;
}

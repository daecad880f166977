/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The parser of expressions: one function a rule of the grammar in expr.h. */
#include "script/expr.h"

#include "base/alloc.h"
#include "base/number.h"
#include "base/table.h"
#include "script/function.h"
#include "script/line.h"
#include "script/reduction.h"
#include "script/state.h"

#include <ctype.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

typedef struct parser {
    reader *r;
    size_t end; /* behind the last token taken */
    bool oneword;
    int parens;
    int depth; /* of the recursion */
    bool replaced;
    diag *d;
} parser;

enum { DEPTH_MAX = 200 };

static node *node_new(parser *p, node_kind kind, size_t from, size_t to) {
    node *n = alloc_zeroed(1, sizeof *n);
    n->kind = kind;
    n->at = reader_span(p->r, from, to);
    return n;
}

/* Places the error about [from, to) and frees what was read; NULL. */
static node *refuse(parser *p, size_t from, size_t to, node *n) {
    diag_place(p->d, reader_span(p->r, from, to));
    expr_free_node(n);
    return NULL;
}

/* ---- tokens ---- */

static const char *at(const parser *p) {
    return p->r->text.chars + p->r->at;
}

/* The next character that belongs to the expression, blanks skipped and $ replaced; 0: none. -1 never; *failed: a
 * replacement failed. */
static char look(parser *p, bool *failed) {
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

static void take(parser *p, size_t n) {
    p->r->at += n;
    p->end = p->r->at;
}

/* Characters of the replaced number, sign included, that begins at r->at; 0: none does. */
static size_t replaced_number(const parser *p) {
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

static op_kind operator_here(const char *c, size_t *n) {
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
static op_kind next_operator(parser *p, size_t *n, bool *failed) {
    char c = look(p, failed);
    if (c == 0 || replaced_number(p))
        return OP_NONE;
    op_kind op = operator_here(at(p), n);
    if (op != OP_NONE)
        return op;
    const char *instead = c == '='   ? "'=' does not compare; write '=='"
                          : c == '&' ? "a single '&' is no operator; write '&&'"
                          : c == '|' ? "a single '|' is no operator; write '||'"
                                     : NULL;
    if (instead) {
        diag_error(p->d, "%s", instead);
        refuse(p, p->r->at, p->r->at + 1, NULL);
        *failed = true;
    }
    return OP_NONE;
}

/* ---- primaries ---- */

static node *read_or(parser *p);
static node *read_unary(parser *p);

static bool is_letter(char c) {
    return isalpha((unsigned char)c) || c == '_';
}

/* Bytes of LETTERS [ DIGITS ], a unit in an expression, µ and superscripts included. */
static size_t unit_length(const char *c) {
    size_t n = 0;
    while (isalpha((unsigned char)c[n]) || (unsigned char)c[n] >= 0x80)
        n++;
    while (n && isdigit((unsigned char)c[n]))
        n++;
    return n;
}

static node *read_number(parser *p, size_t digits) {
    reader *r = p->r;
    size_t from = r->at, letters = unit_length(at(p) + digits);
    node *n = node_new(p, NODE_NUMBER, from, from + digits + letters);
    units_value v;
    if (units_read(r->in->host->units, at(p), digits + letters, &v, p->d) != SARCINA_OK)
        return refuse(p, from, from + digits + letters, n);
    n->si = v.si;
    n->d = v.d;
    n->plain = !v.has_unit;
    take(p, digits + letters);
    if (letters && *at(p) == '(') {
        bool call = function_find(reader_keep(r, r->text.chars + from + digits, letters)) ||
                    reduction_find(reader_keep(r, r->text.chars + from + digits, letters));
        diag_error(p->d, "'%.*s' is a number with a unit, not a call%s%.*s%s%.*s%s", (int)(digits + letters),
                   r->text.chars + from, call ? ": write " : "", call ? (int)digits : 0, r->text.chars + from,
                   call ? "*" : "", call ? (int)letters : 0, r->text.chars + from + digits, call ? "(...)" : "");
        return refuse(p, from, r->at, n);
    }
    return n;
}

static node *read_text(parser *p, size_t quote) {
    reader *r = p->r;
    size_t from = r->at, i = from + quote;
    for (;; i++) {
        while (i < reader_end(r) && r->text.chars[i] == '$' && !piece_is_replaced(&r->text, i))
            if (reader_replace(r, i, p->d) != SARCINA_OK)
                return NULL;
        if (i + quote > reader_end(r)) {
            diag_error(p->d, "the quote is not closed");
            return refuse(p, from, from + quote, NULL);
        }
        if (!piece_is_replaced(&r->text, i) && strncmp(r->text.chars + i, r->text.chars + from, quote) == 0)
            break;
    }
    node *n = node_new(p, NODE_TEXT, from, i + quote);
    n->text = alloc_copy_n(r->text.chars + from + quote, i - from - quote);
    for (size_t k = from + quote; k < i; k++) {
        uint32_t serial = r->text.marks[k].serial;
        if (serial && r->replaced[serial - 1].unknown)
            n->kind = NODE_UNKNOWN, n->wild = true;
    }
    take(p, i + quote - from);
    return n;
}

/* A replaced text that this check does not know. */
static node *read_unknown(parser *p) {
    reader *r = p->r;
    const replacement *note = &r->replaced[r->text.marks[r->at].serial - 1];
    node *n = node_new(p, NODE_UNKNOWN, r->at, r->at + 1);
    n->wild = note->wild || !note->number;
    n->d = note->d;
    take(p, 1);
    /* ${unknown}um: whatever it is, it has a unit */
    size_t letters = unit_length(at(p));
    if (letters)
        n->wild = true;
    take(p, letters);
    return n;
}

static bool is_unknown(const parser *p) {
    uint32_t serial = p->r->text.marks[p->r->at].serial;
    return serial && p->r->at < reader_end(p->r) && p->r->replaced[serial - 1].unknown;
}

static node *read_parentheses(parser *p) {
    size_t from = p->r->at;
    bool failed;
    take(p, 1);
    p->parens++;
    node *n = read_or(p);
    if (!n)
        return NULL;
    char c = look(p, &failed);
    if (failed)
        return refuse(p, p->r->at, p->r->at + 1, n);
    if (c != ')') {
        diag_error(p->d, "this '(' is not closed");
        return refuse(p, from, from + 1, n);
    }
    p->parens--;
    take(p, 1);
    size_t letters = is_letter(*at(p)) || (unsigned char)*at(p) >= 0x80 ? unit_length(at(p)) : 0;
    if (letters && p->r->at < reader_end(p->r)) {
        diag_error(p->d, "a unit follows a number, not ')': write (...)*1%.*s", (int)letters, at(p));
        return refuse(p, p->r->at, p->r->at + letters, n);
    }
    return n;
}

/* Reads "where EXPR" of a reduction, if it stands here. */
static bool read_where(parser *p, node *call) {
    bool failed;
    look(p, &failed);
    if (failed)
        return false;
    if (strncmp(at(p), "where", 5) != 0 || is_letter(at(p)[5]) || isdigit((unsigned char)at(p)[5]))
        return true;
    take(p, 5);
    call->where = read_or(p);
    return call->where != NULL;
}

/* The arguments of a call, after its "(". */
static node *read_arguments(parser *p, node *call) {
    bool failed;
    p->parens++;
    char c = look(p, &failed);
    while (!failed && c != ')') {
        if (call->nargs == NODE_ARGS_MAX) {
            diag_error(p->d, "%s has too many arguments", call->text);
            return refuse(p, p->r->at, p->r->at + 1, call);
        }
        node *argument = read_or(p);
        if (!argument)
            return refuse(p, p->r->at, p->r->at, call);
        call->args[call->nargs++] = argument;
        if (!read_where(p, call))
            return refuse(p, p->r->at, p->r->at, call);
        c = look(p, &failed);
        if (c == ',') {
            take(p, 1);
            c = look(p, &failed);
            if (c == ')')
                c = ' ';
        } else if (c != ')') {
            if (!failed)
                diag_error(p->d, "expected ',' or ')' in %s(...)", call->text);
            return refuse(p, p->r->at, p->r->at + 1, call);
        }
    }
    if (failed)
        return refuse(p, p->r->at, p->r->at + 1, call);
    p->parens--;
    take(p, 1);
    return call;
}

/* Words of other languages where an operand is due. */
static const char *foreign_word(const char *name) {
    static const struct {
        const char *word, *hint;
    } words[] = {
        {"not", "write ! for not"},
        {"and", "write && for and"},
        {"or", "write || for or"},
    };
    for (size_t i = 0; i < TABLE_COUNT(words); i++)
        if (strcmp(words[i].word, name) == 0)
            return words[i].hint;
    return NULL;
}

static node *read_index(parser *p, node *n) {
    bool failed;
    take(p, 1);
    p->parens++;
    n->index = read_or(p);
    if (!n->index)
        return refuse(p, p->r->at, p->r->at, n);
    char c = look(p, &failed);
    if (c != ']') {
        if (!failed)
            diag_error(p->d, "this '[' is not closed");
        return refuse(p, p->r->at, p->r->at + 1, n);
    }
    p->parens--;
    take(p, 1);
    return n;
}

static node *read_name(parser *p) {
    size_t from = p->r->at, i = 0;
    while (is_letter(at(p)[i]) || isdigit((unsigned char)at(p)[i]))
        i++;
    const char *name = reader_keep(p->r, at(p), i);
    const char *hint = foreign_word(name);
    if (hint) {
        diag_error(p->d, "'%s' is no operator; %s", name, hint);
        return refuse(p, from, from + i, NULL);
    }
    node *n = node_new(p, NODE_NAME, from, from + i);
    n->text = alloc_copy(name);
    take(p, i);
    if (*at(p) == '(') {
        n->kind = NODE_CALL;
        take(p, 1);
        return read_arguments(p, n);
    }
    if (*at(p) == '.' && is_letter(at(p)[1])) {
        size_t k = 1;
        while (is_letter(at(p)[k]) || isdigit((unsigned char)at(p)[k]))
            k++;
        n->field = alloc_copy_n(at(p) + 1, k - 1);
        take(p, k);
        n->at = reader_span(p->r, from, p->r->at);
    }
    return *at(p) == '[' ? read_index(p, n) : n;
}

/* Nothing an operand could begin with. before: the operator it would be the right side of. */
static node *no_operand(parser *p, op_kind before, char c) {
    size_t to = p->r->at + (c != 0);
    if (before == OP_MOD)
        diag_error(p->d, "'%%' is the remainder in an expression and lacks its right side; write 0.05 for 5%%");
    else if (c == 0)
        diag_error(p->d, "expected a value");
    else if (c == '=')
        diag_error(p->d, "'=' does not compare; write '=='");
    else
        diag_error(p->d, "expected a value, not '%c'", c);
    return refuse(p, p->r->at, to, NULL);
}

static node *read_primary(parser *p, op_kind before) {
    bool failed;
    char c = look(p, &failed);
    if (failed)
        return NULL;
    if (c && is_unknown(p))
        return read_unknown(p);
    size_t digits = c ? replaced_number(p) : 0;
    if (!digits && c)
        digits = number_length(at(p), reader_end(p->r) - p->r->at, false);
    if (digits)
        return read_number(p, digits);
    size_t quote = c ? line_quote(p->r->text.chars, p->r->at, p->r->at) : 0;
    if (quote)
        return read_text(p, quote);
    if (c == '(')
        return read_parentheses(p);
    if (is_letter(c))
        return read_name(p);
    if ((unsigned char)c >= 0x80 && reader_check_ascii(p->r, p->r->at, p->r->at + 1, p->d) != SARCINA_OK)
        return NULL;
    return no_operand(p, before, c);
}

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

static node *read_power(parser *p, op_kind before) {
    node *left = read_primary(p, before);
    size_t n = 0;
    bool failed;
    if (!left)
        return NULL;
    if (next_operator(p, &n, &failed) != OP_POW) {
        if (!failed)
            return left;
        expr_free_node(left);
        return NULL;
    }
    span where = reader_span(p->r, p->r->at, p->r->at + n);
    take(p, n);
    return binary(OP_POW, where, left, read_unary(p));
}

static node *read_unary_after(parser *p, op_kind before) {
    bool failed;
    char c = look(p, &failed);
    if (failed)
        return NULL;
    if ((c != '-' && c != '+' && c != '!') || replaced_number(p))
        return read_power(p, before);
    if (++p->depth > DEPTH_MAX) {
        diag_error(p->d, "the expression is nested too deeply");
        return refuse(p, p->r->at, p->r->at + 1, NULL);
    }
    node *n = node_new(p, NODE_UNARY, p->r->at, p->r->at + 1);
    n->op = c == '!' ? OP_NOT : c == '-' ? OP_NEG : OP_ADD;
    take(p, 1);
    n->args[0] = read_unary(p);
    p->depth--;
    if (!n->args[0])
        return refuse(p, p->r->at, p->r->at, n);
    n->nargs = 1;
    return n;
}

static node *read_unary(parser *p) {
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
static node *read_binary(parser *p, int least, op_kind before) {
    node *left = least > 5 ? read_unary_after(p, before) : read_binary(p, least + 1, before);
    bool compared = false;
    while (left && least <= 5) {
        size_t n = 0;
        bool failed;
        op_kind op = next_operator(p, &n, &failed);
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
        take(p, n);
        left = binary(op, where, left, read_binary(p, least + 1, op));
    }
    return left;
}

static node *read_or(parser *p) {
    if (++p->depth > DEPTH_MAX) {
        diag_error(p->d, "the expression is nested too deeply");
        return refuse(p, p->r->at, p->r->at + 1, NULL);
    }
    node *n = read_binary(p, 1, OP_NONE);
    p->depth--;
    return n;
}

/* ---- the whole ---- */

static expr *expr_new(parser *p, node *root, size_t from) {
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
    bool goes_on = next < reader_end(r) && operator_here(r->text.chars + next, &n) != OP_NONE;
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
    parser p = {.r = r, .end = r->at, .oneword = extent == EXPR_ONEWORD, .d = d};
    size_t from = r->at;
    node *root = read_or(&p);
    return root ? expr_new(&p, root, from) : NULL;
}

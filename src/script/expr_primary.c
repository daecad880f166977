/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The operands of expressions: numbers with a unit, texts, names, calls, parentheses. */
#include "script/expr_parser.h"

#include "base/alloc.h"
#include "base/number.h"
#include "base/table.h"
#include "base/units.h"
#include "script/function.h"
#include "script/line.h"
#include "script/reduction.h"
#include "script/state.h"

#include <ctype.h>
#include <string.h>

static const char *at(const expr_parser *p) {
    return p->r->text.chars + p->r->at;
}

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

static node *read_number(expr_parser *p, size_t digits) {
    reader *r = p->r;
    size_t from = r->at, letters = unit_length(at(p) + digits);
    node *n = expr_parser_node(p, NODE_NUMBER, from, from + digits + letters);
    units_value v;
    if (units_read(r->in->host->units, at(p), digits + letters, &v, p->d) != SARCINA_OK)
        return expr_parser_refuse(p, from, from + digits + letters, n);
    n->si = v.si;
    n->d = v.d;
    n->plain = !v.has_unit;
    expr_parser_take(p, digits + letters);
    if (letters && *at(p) == '(') {
        bool call = function_find(reader_keep(r, r->text.chars + from + digits, letters)) ||
                    reduction_find(reader_keep(r, r->text.chars + from + digits, letters));
        diag_error(p->d, "'%.*s' is a number with a unit, not a call%s%.*s%s%.*s%s", (int)(digits + letters),
                   r->text.chars + from, call ? ": write " : "", call ? (int)digits : 0, r->text.chars + from,
                   call ? "*" : "", call ? (int)letters : 0, r->text.chars + from + digits, call ? "(...)" : "");
        return expr_parser_refuse(p, from, r->at, n);
    }
    return n;
}

/* The number that $ put here, so many characters without its unit: N.s/m, which one wrote by hand would be read as a
 * quotient, is that of the number. */
static node *read_quantity(expr_parser *p, size_t digits) {
    const reader *r = p->r;
    size_t from = r->at, to = from + digits;
    uint32_t serial = r->text.marks[from].serial;
    while (to < reader_end(r) && r->text.marks[to].serial == serial)
        to++;
    if (!r->replaced[serial - 1].quantity || to == from + digits)
        return read_number(p, digits);
    node *n = expr_parser_node(p, NODE_NUMBER, from, to);
    n->si = number_read(at(p), digits, 0);
    n->d = r->replaced[serial - 1].d;
    expr_parser_take(p, to - from);
    return n;
}

static node *read_text(expr_parser *p, size_t quote) {
    reader *r = p->r;
    size_t from = r->at, i = from + quote;
    for (;; i++) {
        while (i < reader_end(r) && r->text.chars[i] == '$' && !piece_is_replaced(&r->text, i))
            if (reader_replace(r, i, p->d) != SARCINA_OK)
                return NULL;
        if (i + quote > reader_end(r)) {
            diag_error(p->d, "the quote is not closed");
            return expr_parser_refuse(p, from, from + quote, NULL);
        }
        if (!piece_is_replaced(&r->text, i) && strncmp(r->text.chars + i, r->text.chars + from, quote) == 0)
            break;
    }
    node *n = expr_parser_node(p, NODE_TEXT, from, i + quote);
    n->text = alloc_copy_n(r->text.chars + from + quote, i - from - quote);
    for (size_t k = from + quote; k < i; k++) {
        uint32_t serial = r->text.marks[k].serial;
        if (serial && r->replaced[serial - 1].unknown)
            n->kind = NODE_UNKNOWN, n->wild = true;
    }
    expr_parser_take(p, i + quote - from);
    return n;
}

/* A replaced text that this check does not know. */
static node *read_unknown(expr_parser *p) {
    reader *r = p->r;
    const replacement *note = &r->replaced[r->text.marks[r->at].serial - 1];
    node *n = expr_parser_node(p, NODE_UNKNOWN, r->at, r->at + 1);
    n->wild = note->wild || !note->number;
    n->d = note->d;
    expr_parser_take(p, 1);
    /* ${unknown}um: whatever it is, it has a unit */
    size_t letters = unit_length(at(p));
    if (letters)
        n->wild = true;
    expr_parser_take(p, letters);
    return n;
}

static bool is_unknown(const expr_parser *p) {
    uint32_t serial = p->r->text.marks[p->r->at].serial;
    return serial && p->r->at < reader_end(p->r) && p->r->replaced[serial - 1].unknown;
}

static node *read_parentheses(expr_parser *p) {
    size_t from = p->r->at;
    bool failed;
    expr_parser_take(p, 1);
    p->parens++;
    node *n = expr_parser_or(p);
    if (!n)
        return NULL;
    char c = expr_parser_look(p, &failed);
    if (failed)
        return expr_parser_refuse(p, p->r->at, p->r->at + 1, n);
    if (c != ')') {
        diag_error(p->d, "this '(' is not closed");
        return expr_parser_refuse(p, from, from + 1, n);
    }
    p->parens--;
    expr_parser_take(p, 1);
    size_t letters = is_letter(*at(p)) || (unsigned char)*at(p) >= 0x80 ? unit_length(at(p)) : 0;
    if (letters && p->r->at < reader_end(p->r)) {
        diag_error(p->d, "a unit follows a number, not ')': write (...)*1%.*s", (int)letters, at(p));
        return expr_parser_refuse(p, p->r->at, p->r->at + letters, n);
    }
    return n;
}

/* Reads "where EXPR" of a reduction, if it stands here. */
static bool read_where(expr_parser *p, node *call) {
    bool failed;
    expr_parser_look(p, &failed);
    if (failed)
        return false;
    if (strncmp(at(p), "where", 5) != 0 || is_letter(at(p)[5]) || isdigit((unsigned char)at(p)[5]))
        return true;
    expr_parser_take(p, 5);
    call->where = expr_parser_or(p);
    return call->where != NULL;
}

/* The arguments of a call, after its "(". */
static node *read_arguments(expr_parser *p, node *call) {
    bool failed;
    p->parens++;
    char c = expr_parser_look(p, &failed);
    while (!failed && c != ')') {
        if (call->nargs == NODE_ARGS_MAX) {
            diag_error(p->d, "%s has too many arguments", call->text);
            return expr_parser_refuse(p, p->r->at, p->r->at + 1, call);
        }
        node *argument = expr_parser_or(p);
        if (!argument)
            return expr_parser_refuse(p, p->r->at, p->r->at, call);
        call->args[call->nargs++] = argument;
        if (!read_where(p, call))
            return expr_parser_refuse(p, p->r->at, p->r->at, call);
        c = expr_parser_look(p, &failed);
        if (c == ',') {
            expr_parser_take(p, 1);
            c = expr_parser_look(p, &failed);
            if (c == ')')
                c = ' ';
        } else if (c != ')') {
            if (!failed)
                diag_error(p->d, "expected ',' or ')' in %s(...)", call->text);
            return expr_parser_refuse(p, p->r->at, p->r->at + 1, call);
        }
    }
    if (failed)
        return expr_parser_refuse(p, p->r->at, p->r->at + 1, call);
    p->parens--;
    expr_parser_take(p, 1);
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

static node *read_index(expr_parser *p, node *n) {
    bool failed;
    expr_parser_take(p, 1);
    p->parens++;
    n->index = expr_parser_or(p);
    if (!n->index)
        return expr_parser_refuse(p, p->r->at, p->r->at, n);
    char c = expr_parser_look(p, &failed);
    if (c != ']') {
        if (!failed)
            diag_error(p->d, "this '[' is not closed");
        return expr_parser_refuse(p, p->r->at, p->r->at + 1, n);
    }
    p->parens--;
    expr_parser_take(p, 1);
    return n;
}

static node *read_name(expr_parser *p) {
    size_t from = p->r->at, i = 0;
    while (is_letter(at(p)[i]) || isdigit((unsigned char)at(p)[i]))
        i++;
    const char *name = reader_keep(p->r, at(p), i);
    const char *hint = foreign_word(name);
    if (hint) {
        diag_error(p->d, "'%s' is no operator; %s", name, hint);
        return expr_parser_refuse(p, from, from + i, NULL);
    }
    node *n = expr_parser_node(p, NODE_NAME, from, from + i);
    n->text = alloc_copy(name);
    expr_parser_take(p, i);
    if (*at(p) == '(') {
        n->kind = NODE_CALL;
        expr_parser_take(p, 1);
        return read_arguments(p, n);
    }
    if (*at(p) == '.' && is_letter(at(p)[1])) {
        size_t k = 1;
        while (is_letter(at(p)[k]) || isdigit((unsigned char)at(p)[k]))
            k++;
        n->field = alloc_copy_n(at(p) + 1, k - 1);
        expr_parser_take(p, k);
        n->at = reader_span(p->r, from, p->r->at);
    }
    return *at(p) == '[' ? read_index(p, n) : n;
}

/* Nothing an operand could begin with. before: the operator it would be the right side of. */
static node *no_operand(expr_parser *p, op_kind before, char c) {
    size_t to = p->r->at + (c != 0);
    if (before == OP_MOD)
        diag_error(p->d, "'%%' is the remainder in an expression and lacks its right side; write 0.05 for 5%%");
    else if (c == 0)
        diag_error(p->d, "expected a value");
    else if (c == '=')
        diag_error(p->d, "'=' does not compare; write '=='");
    else
        diag_error(p->d, "expected a value, not '%c'", c);
    return expr_parser_refuse(p, p->r->at, to, NULL);
}

node *expr_parser_primary(expr_parser *p, op_kind before) {
    bool failed;
    char c = expr_parser_look(p, &failed);
    if (failed)
        return NULL;
    if (c && is_unknown(p))
        return read_unknown(p);
    size_t digits = c ? expr_parser_replaced_number(p) : 0;
    if (digits)
        return read_quantity(p, digits);
    if (c)
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

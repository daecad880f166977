/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "script/evaluate.h"

#include "base/alloc.h"
#include "script/function.h"
#include "script/reduction.h"
#include "script/state.h"

#include <math.h>
#include <string.h>

int evaluate_refuse(const node *n, diag *d) {
    diag_place(d, n->at);
    return SARCINA_ERROR;
}

int evaluate_view(evaluation *e, const view **v, diag *d) {
    (void)d;
    if (!e->has_view)
        e->view = scene_view(e->in->scene);
    e->has_view = true;
    *v = &e->view;
    return SARCINA_OK;
}

/* ---- operators ---- */

static const char *op_text(op_kind op) {
    static const char *const texts[] = {
        "", "||", "&&", "==", "!=", "<", "<=", ">", ">=", "+", "-", "*", "/", "%", "^", "!", "-"};
    return texts[op];
}

static bool is_comparison(op_kind op) {
    return op >= OP_EQ && op <= OP_GE;
}

/* Elements of a result of both: the longer one's; an error when lists or cells do not fit together. */
static int join_extents(const node *n, const operand *a, const operand *b, operand *out, diag *d) {
    const operand *longer = a->extent != OPERAND_ONE ? a : b;
    if (a->extent != OPERAND_ONE && b->extent != OPERAND_ONE) {
        bool known = !a->unknown && !b->unknown;
        if (a->extent != b->extent || (known && a->n != b->n)) {
            diag_error(d, "'%s' between lists of different length", op_text(n->op));
            return evaluate_refuse(n, d);
        }
    }
    *out = (operand){.extent = longer->extent, .n = longer->n, .unknown = a->unknown || b->unknown};
    if (out->unknown)
        out->n = 0;
    else if (out->extent != OPERAND_ONE)
        out->v = alloc_zeroed(out->n, sizeof *out->v);
    return SARCINA_OK;
}

static double *element(operand *o, size_t i) {
    return o->extent == OPERAND_ONE ? &o->one : &o->v[i];
}

static size_t elements(const operand *o) {
    return o->unknown ? 0 : o->extent == OPERAND_ONE ? 1 : o->n;
}

static const char *text_at(const operand *o, size_t i) {
    return o->extent == OPERAND_ONE ? o->text : o->t[i];
}

/* == and != of texts. */
static int compare_texts(const node *n, const operand *a, const operand *b, operand *out, diag *d) {
    if (n->op != OP_EQ && n->op != OP_NE) {
        diag_error(d, "'%s' between texts; only == and != compare texts", op_text(n->op));
        return evaluate_refuse(n, d);
    }
    int status = join_extents(n, a, b, out, d);
    out->is_truth = true;
    for (size_t i = 0; !status && i < elements(out); i++)
        *element(out, i) = (strcmp(text_at(a, i), text_at(b, i)) == 0) == (n->op == OP_EQ);
    return status;
}

static double compare(op_kind op, double x, double y) {
    switch (op) {
    case OP_EQ:
        return x == y;
    case OP_NE:
        return x != y && !isnan(x) && !isnan(y);
    case OP_LT:
        return x < y;
    case OP_LE:
        return x <= y;
    case OP_GT:
        return x > y;
    default:
        return x >= y;
    }
}

static double combine(op_kind op, double x, double y) {
    switch (op) {
    case OP_OR:
        return (x != 0 && !isnan(x)) || (y != 0 && !isnan(y));
    case OP_AND:
        return (x != 0 && !isnan(x)) && (y != 0 && !isnan(y));
    case OP_ADD:
        return x + y;
    case OP_SUB:
        return x - y;
    case OP_MUL:
        return x * y;
    case OP_DIV:
        return x / y;
    case OP_MOD:
        return fmod(x, y);
    case OP_POW:
        return pow(x, y);
    default:
        return compare(op, x, y);
    }
}

/* Every element; a result that is not finite is an error unless it came from what was undefined already. */
static int combine_all(const node *n, const operand *a, const operand *b, operand *out, diag *d) {
    for (size_t i = 0; i < elements(out); i++) {
        double x = operand_get(a, i), y = operand_get(b, i), z = combine(n->op, x, y);
        *element(out, i) = z;
        if (isfinite(z) || isnan(x) || isnan(y))
            continue;
        if (y == 0 && (n->op == OP_DIV || n->op == OP_MOD))
            diag_error(d, "division by zero");
        else
            diag_error(d, "the result of '%s' is not finite", op_text(n->op));
        return evaluate_refuse(n, d);
    }
    return SARCINA_OK;
}

/* The dimension of a power: its exponent must be one number that does not depend on the scene. */
static int power_dim(const node *n, const operand *a, const operand *b, operand *out, diag *d) {
    char name[48];
    if (!b->wild && !dim_is_none(b->d)) {
        diag_error(d, "an exponent is a pure number, not a %s", dim_name(b->d, name));
        return evaluate_refuse(n, d);
    }
    if (a->wild || dim_is_none(a->d))
        return SARCINA_OK;
    if (b->wild) {
        out->wild = out->unknown = true;
        return SARCINA_OK;
    }
    double p = b->one;
    dim x = a->d;
    double t[3] = {x.length * p, x.mass * p, x.time * p};
    for (int k = 0; k < 3; k++)
        if (expr_node_can_change(n->args[1]) || fabs(t[k] - nearbyint(t[k])) > 1e-9 || fabs(t[k]) > 30000) {
            diag_error(d, "a %s needs a constant exponent: a small whole number or simple fraction", dim_name(x, name));
            return evaluate_refuse(n, d);
        }
    out->d = (dim){(int16_t)lround(t[0]), (int16_t)lround(t[1]), (int16_t)lround(t[2])};
    return SARCINA_OK;
}

/* Checks the dimensions and sets that of the result. */
static int result_dim(evaluation *e, const node *n, operand *a, operand *b, operand *out, diag *d) {
    char left[48], right[48];
    bool logic = n->op == OP_AND || n->op == OP_OR;
    out->is_truth = logic || is_comparison(n->op);
    out->wild = (a->wild || b->wild) && !out->is_truth;
    out->plain = a->plain && b->plain && !out->is_truth;
    if (n->op == OP_POW)
        return power_dim(n, a, b, out, d);
    if (n->op == OP_MUL || n->op == OP_DIV) {
        int s = n->op == OP_MUL ? 1 : -1;
        out->d = (dim){(int16_t)(a->d.length + s * b->d.length), (int16_t)(a->d.mass + s * b->d.mass),
                       (int16_t)(a->d.time + s * b->d.time)};
        return SARCINA_OK;
    }
    bool fits = logic ? (a->wild || dim_is_none(a->d)) && (b->wild || dim_is_none(b->d)) : operand_adapt(e->in, a, b);
    if (!fits) {
        diag_error(d, "'%s' between %s and %s", op_text(n->op), operand_kind(a, left), operand_kind(b, right));
        return evaluate_refuse(n, d);
    }
    if (!out->is_truth)
        out->d = a->wild ? b->d : a->d;
    return SARCINA_OK;
}

int evaluate_binary(evaluation *e, const node *n, operand *a, operand *b, operand *out, diag *d) {
    if (a->is_text && b->is_text)
        return compare_texts(n, a, b, out, d);
    if ((a->is_text && !b->wild) || (b->is_text && !a->wild)) {
        diag_error(d, "'%s' between a text and a number", op_text(n->op));
        return evaluate_refuse(n, d);
    }
    /* result_dim may scale plain numbers, so it comes before the arithmetic */
    operand typed = {0};
    int status = result_dim(e, n, a, b, &typed, d);
    if (!status)
        status = join_extents(n, a, b, out, d);
    if (status)
        return status;
    out->is_truth = typed.is_truth;
    out->wild = typed.wild;
    out->unknown = out->unknown || typed.wild;
    out->plain = typed.plain;
    out->d = typed.d;
    return combine_all(n, a, b, out, d);
}

int evaluate_unary(const node *n, operand *a, operand *out, diag *d) {
    if (a->is_text) {
        diag_error(d, "'%s' of a text", op_text(n->op));
        return evaluate_refuse(n, d);
    }
    *out = *a;
    *a = (operand){0};
    if (n->op == OP_NOT) {
        if (!out->wild && !dim_is_none(out->d)) {
            char name[48];
            diag_error(d, "'!' takes a truth, not a %s", dim_name(out->d, name));
            return evaluate_refuse(n, d);
        }
        out->is_truth = true;
        out->plain = out->wild = false;
    }
    for (size_t i = 0; i < elements(out); i++) {
        double *x = element(out, i);
        *x = n->op == OP_NEG ? -*x : n->op == OP_NOT ? *x == 0 || isnan(*x) : *x;
    }
    return SARCINA_OK;
}

/* && and || look at the right side only when the left does not decide; its types are checked all the same. */
static bool is_decided(const node *n, const operand *left) {
    if ((n->op != OP_AND && n->op != OP_OR) || left->unknown || left->is_text || left->extent != OPERAND_ONE)
        return false;
    bool holds = left->one != 0 && !isnan(left->one);
    return n->op == OP_AND ? !holds : holds;
}

static int evaluate_pair(evaluation *e, const node *n, operand *out, diag *d) {
    operand a = {0}, b = {0};
    int status = evaluate_node(e, n->args[0], &a, d);
    bool decided = !status && is_decided(n, &a);
    int untaken = e->untaken;
    /* an exponent gives the dimension, so it is always known */
    e->untaken = n->op == OP_POW ? 0 : untaken + decided;
    if (!status)
        status = evaluate_node(e, n->args[1], &b, d);
    e->untaken = untaken;
    if (!status)
        status = evaluate_binary(e, n, &a, &b, out, d);
    if (!status && decided && out->extent == OPERAND_ONE)
        *out = operand_truth(n->op == OP_OR);
    operand_free(&a);
    operand_free(&b);
    return status;
}

/* min and max of several arguments are functions. */
static bool is_reduction(const node *n) {
    return reduction_find(n->text) && (n->nargs == 1 || n->where || !function_find(n->text));
}

int evaluate_node(evaluation *e, const node *n, operand *out, diag *d) {
    operand a = {0};
    int status;
    *out = (operand){0};
    switch (n->kind) {
    case NODE_NUMBER:
        *out = operand_number(n->si, n->d);
        out->plain = n->plain;
        out->unknown = e->untaken > 0;
        return SARCINA_OK;
    case NODE_TEXT:
        *out = operand_text(n->text);
        return SARCINA_OK;
    case NODE_UNKNOWN:
        *out = n->wild ? operand_wild() : operand_unknown(OPERAND_ONE, n->d);
        return SARCINA_OK;
    case NODE_NAME:
        return evaluate_name(e, n, out, d);
    case NODE_CALL:
        return is_reduction(n) ? evaluate_reduction(e, n, out, d) : evaluate_call(e, n, out, d);
    case NODE_UNARY:
        status = evaluate_node(e, n->args[0], &a, d);
        if (!status)
            status = evaluate_unary(n, &a, out, d);
        operand_free(&a);
        return status;
    case NODE_BINARY:
        break;
    }
    return evaluate_pair(e, n, out, d);
}

int evaluate_whole(evaluation *e, const expr *x, bool per_cell, operand *out, diag *d) {
    e->per_cell += per_cell;
    int status = evaluate_node(e, x->root, out, d);
    e->per_cell -= per_cell;
    if (status)
        return status;
    if (out->extent == OPERAND_LIST) {
        diag_error(d, "'%s' is a list", x->text);
        diag_help(d, "mean(%s), max(%s), count(%s), or %s[1] for one of it", x->text, x->text, x->text, x->text);
    } else if (out->extent == OPERAND_CELLS && !per_cell) {
        diag_error(d, "'%s' has a value per cell", x->text);
        diag_help(d, "take mean(...), max(...), count(...) of it, or z[ID] for one cell");
    } else {
        return SARCINA_OK;
    }
    diag_place(d, x->at);
    return SARCINA_ERROR;
}

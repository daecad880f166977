/* SPDX-License-Identifier: GPL-3.0-or-later */
/* What expressions are asked for from outside: their type, their text, one value, one a cell, a column. */
#include "script/evaluate.h"

#include "base/alloc.h"
#include "script/format.h"
#include "script/state.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

/* ---- types ---- */

int expr_check(interp *in, const expr *e, bool per_cell, bool repeatable, expr_type *out, diag *d) {
    evaluation ev = {.in = in, .types_only = true, .repeatable = repeatable};
    operand o = {0};
    int status = evaluate_whole(&ev, e, per_cell, &o, d);
    *out = (expr_type){o.is_text, o.is_truth, o.unknown, o.plain, o.wild, o.d};
    operand_free(&o);
    return status;
}

int expr_check_formula(interp *in, const expr *e, diag *d) {
    evaluation ev = {.in = in, .types_only = true, .lenient = true};
    operand o = {0};
    int status = evaluate_node(&ev, e->root, &o, d);
    operand_free(&o);
    return status;
}

/* ---- text ---- */

static char *print_number(interp *in, const operand *o, const char *format, diag *d) {
    if (!format)
        return format_quantity(o->one, o->d);
    return format_number(format, o->one / interp_unit(in, o->d), d);
}

char *expr_print(interp *in, const expr *e, const char *format, replacement *note, diag *d) {
    evaluation ev = {.in = in, .types_only = in->check.on};
    operand o = {0};
    char *text = NULL;
    *note = (replacement){0};
    int status = evaluate_whole(&ev, e, false, &o, d);
    if (!status && o.is_text && format) {
        diag_error(d, "a format prints a number, not a text");
    } else if (!status && o.unknown) {
        *note = (replacement){.unknown = true,
                              .number = !o.is_text && (!o.wild || format),
                              .wild = o.wild || format,
                              .d = format ? DIM_NONE : o.d};
        text = alloc_copy("");
    } else if (!status) {
        note->quantity = !o.is_text && !format;
        note->d = note->quantity ? o.d : DIM_NONE;
        text = o.is_text ? alloc_copy(o.text) : print_number(in, &o, format, d);
    }
    if (!text)
        diag_place(d, e->at);
    operand_free(&o);
    return text;
}

void expr_explain(interp *in, const expr *e, diag *d) {
    const node *n = e->root;
    evaluation ev = {.in = in};
    operand a = {0}, b = {0};
    bool comparison = n->kind == NODE_BINARY && n->op >= OP_EQ && n->op <= OP_GE;
    if (comparison && evaluate_node(&ev, n->args[0], &a, NULL) == SARCINA_OK &&
        evaluate_node(&ev, n->args[1], &b, NULL) == SARCINA_OK && a.extent == OPERAND_ONE && b.extent == OPERAND_ONE) {
        char *left = a.is_text ? alloc_copy(a.text) : format_quantity(a.one, a.d);
        char *right = b.is_text ? alloc_copy(b.text) : format_quantity(b.one, b.d);
        diag_help(d, "its sides are %s and %s", left, right);
        free(left);
        free(right);
    }
    operand_free(&a);
    operand_free(&b);
}

/* ---- values ---- */

int interp_number(interp *in, expr *e, quantity *out, diag *d) {
    evaluation ev = {.in = in};
    operand o = {0};
    int status = evaluate_whole(&ev, e, false, &o, d);
    if (!status && o.is_text) {
        diag_error(d, "'%s' is a text, not a number", e->text);
        diag_place(d, e->at);
        status = SARCINA_ERROR;
    }
    *out = (quantity){o.one, o.d, o.plain};
    operand_free(&o);
    return status;
}

int interp_truth(interp *in, expr *e, bool *out, diag *d) {
    quantity q;
    int status = interp_number(in, e, &q, d);
    *out = !status && q.si != 0 && !isnan(q.si);
    return status;
}

int interp_cells(interp *in, expr *e, double *si, dim *dimension, diag *d) {
    evaluation ev = {.in = in};
    operand o = {0};
    int status = evaluate_whole(&ev, e, true, &o, d);
    if (!status && o.is_text) {
        diag_error(d, "'%s' is a text, not a number", e->text);
        diag_place(d, e->at);
        status = SARCINA_ERROR;
    }
    for (size_t i = 0; !status && i < in->scene->colony->cell.count; i++)
        si[i] = operand_get(&o, i);
    *dimension = o.d;
    operand_free(&o);
    return status;
}

int interp_check_repeatable(interp *in, const expr *e, diag *d) {
    expr_type type;
    return expr_check(in, e, true, true, &type, d);
}

int interp_flags(interp *in, expr *e, bool *flags, diag *d) {
    size_t n = in->scene->colony->cell.count;
    double *si = alloc_zeroed(n, sizeof *si);
    dim dimension;
    int status = interp_cells(in, e, si, &dimension, d);
    for (size_t i = 0; i < n; i++)
        flags[i] = !status && si[i] != 0 && !isnan(si[i]);
    free(si);
    return status;
}

/* ---- columns ---- */

/* A column remembers the values of all cells while a writer goes from row to row. */
typedef struct column {
    interp *in;
    expr *e;
    bool per_cell, filled;
    operand values;
    uint32_t last_row;
    uint64_t epoch, version, step;
    double time, relaxed;
} column;

/* Rows are asked for in ascending order; one that is not begins another pass. */
static bool is_fresh(const column *c, uint32_t row) {
    const scene *s = c->in->scene;
    return c->filled && row > c->last_row && c->epoch == c->in->epoch && c->version == s->colony->version &&
           c->step == s->step && c->time == s->time && c->relaxed == s->relaxed;
}

static int fill(column *c, uint32_t row, diag *d) {
    const scene *s = c->in->scene;
    if (is_fresh(c, row)) {
        c->last_row = row;
        return SARCINA_OK;
    }
    operand_free(&c->values);
    evaluation ev = {.in = c->in};
    int status = evaluate_whole(&ev, c->e, c->per_cell, &c->values, d);
    c->filled = c->per_cell && !status;
    c->last_row = row;
    c->epoch = c->in->epoch;
    c->version = s->colony->version;
    c->step = s->step;
    c->time = s->time;
    c->relaxed = s->relaxed;
    return status;
}

static int column_number(void *self, uint32_t row, double *si, diag *d) {
    column *c = self;
    int status = fill(c, row, d);
    *si = status || c->values.is_text ? (double)NAN : operand_get(&c->values, row);
    return status;
}

static int column_text(void *self, uint32_t row, char out[64], diag *d) {
    column *c = self;
    int status = fill(c, row, d);
    if (status || !c->values.is_text)
        return status ? status : diag_error(d, "'%s' is a number now, no text", c->e->text);
    snprintf(out, 64, "%s", c->values.extent == OPERAND_ONE ? c->values.text : c->values.t[row]);
    return SARCINA_OK;
}

static void column_release(void *self) {
    column *c = self;
    operand_free(&c->values);
    expr_free(c->e);
    free(c);
}

int interp_column(interp *in, expr *e, bool per_cell, output_column *out, diag *d) {
    expr_type type;
    int status = expr_check(in, e, per_cell, true, &type, d);
    if (status)
        return status;
    column *c = alloc_zeroed(1, sizeof *c);
    *c = (column){.in = in, .e = expr_keep(e), .per_cell = per_cell};
    *out = (output_column){.name = alloc_copy(e->text),
                           .d = type.d,
                           .is_text = type.is_text,
                           .self = c,
                           .number = column_number,
                           .text = column_text,
                           .release = column_release};
    return SARCINA_OK;
}

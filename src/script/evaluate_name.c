/* SPDX-License-Identifier: GPL-3.0-or-later */
/* What a name stands for: a value of the table, a variable, a constant, or what the commands' classes own. */
#include "base/alloc.h"
#include "base/number.h"
#include "base/table.h"
#include "script/evaluate.h"
#include "script/function.h"
#include "script/names.h"
#include "script/reduction.h"
#include "script/state.h"

#include "analysis/value.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

enum { VARIABLE_DEPTH_MAX = 50 };

static bool is_unknown_scene(const evaluation *e) {
    return e->types_only || e->untaken || e->in->check.on;
}

/* ---- values per cell ---- */

static int fill_cells(evaluation *e, const value_style *s, operand *out, diag *d) {
    const view *v;
    int status = evaluate_view(e, &v, d);
    if (status)
        return status;
    out->n = v->colony->cell.count;
    if (s->text) {
        out->t = alloc_zeroed(out->n, sizeof *out->t);
        for (uint32_t i = 0; i < out->n; i++)
            out->t[i] = alloc_copy(s->text(v, i));
        return SARCINA_OK;
    }
    out->v = alloc_zeroed(out->n, sizeof *out->v);
    for (uint32_t i = 0; i < out->n; i++)
        out->v[i] = dim_from_engine(s->cell(v, i), out->d);
    return SARCINA_OK;
}

static int value_of_cells(evaluation *e, const value_style *s, operand *out, diag *d) {
    *out = (operand){.extent = OPERAND_CELLS, .d = value_dim(s), .is_text = s->text != NULL};
    out->unknown = is_unknown_scene(e);
    return out->unknown ? SARCINA_OK : fill_cells(e, s, out, d);
}

/* ---- values of the scene ---- */

static int refuse_field(const node *n, const value_style *s, diag *d) {
    name_list fields = {0};
    char names[VALUE_FIELDS_MAX][32];
    dim of;
    for (size_t i = 0; i < value_field_count(s) && i < VALUE_FIELDS_MAX; i++) {
        value_field(s, i, names[i], &of);
        names_add(&fields, names[i]);
    }
    diag_error(d, "%s has no '%s'", n->text, n->field);
    names_suggest(&fields, n->field, "fields", d);
    return evaluate_refuse(n, d);
}

static int value_of_scene(evaluation *e, const node *n, const value_style *s, operand *out, diag *d) {
    dim dimension = value_dim(s);
    int field = -1;
    if (n->field) {
        char name[32];
        field = value_field_find(s, n->field);
        if (field < 0)
            return refuse_field(n, s, d);
        value_field(s, (size_t)field, name, &dimension);
    }
    if (is_unknown_scene(e)) {
        *out = operand_unknown(OPERAND_ONE, dimension);
        return SARCINA_OK;
    }
    double values[1 + VALUE_FIELDS_MAX];
    const view *v;
    int status = evaluate_view(e, &v, d);
    if (!status)
        status = s->measure(v, NULL, values, d);
    *out = operand_number(status ? (double)NAN : dim_from_engine(values[1 + field], dimension), dimension);
    return status;
}

/* ---- variables ---- */

/* A list's elements: all numbers of one dimension, or texts. */
static int list_of(evaluation *e, const node *n, const variable *var, operand *out, diag *d) {
    *out = (operand){.extent = OPERAND_LIST, .n = var->count};
    if (var->unknown) {
        *out = (operand){.extent = OPERAND_LIST, .unknown = true, .wild = true};
        return SARCINA_OK;
    }
    out->v = alloc_zeroed(var->count, sizeof *out->v);
    for (size_t i = 0; i < var->count; i++) {
        units_value u;
        if (units_read(e->in->host->units, var->list[i], strlen(var->list[i]), &u, NULL) != SARCINA_OK) {
            out->is_text = true;
            continue;
        }
        if (i && !dim_equal(u.d, out->d)) {
            char a[48], b[48];
            diag_error(d, "the list %s holds a %s and a %s", var->name, dim_name(out->d, a), dim_name(u.d, b));
            return evaluate_refuse(n, d);
        }
        out->d = u.d;
        out->plain = !u.has_unit;
        out->v[i] = u.si;
    }
    if (!out->is_text)
        return SARCINA_OK;
    free(out->v);
    out->v = NULL;
    out->t = alloc_zeroed(var->count, sizeof *out->t);
    for (size_t i = 0; i < var->count; i++)
        out->t[i] = alloc_copy(var->list[i]);
    return SARCINA_OK;
}

static int formula_of(evaluation *e, const node *n, const variable *var, operand *out, diag *d) {
    if (e->depth >= VARIABLE_DEPTH_MAX) {
        diag_error(d, "variable '%s' depends on itself", var->name);
        return evaluate_refuse(n, d);
    }
    expr *formula = expr_keep(var->formula); /* it may be redefined meanwhile */
    e->depth++;
    int status = evaluate_node(e, formula->root, out, d);
    e->depth--;
    expr_free(formula);
    return status;
}

static int value_of_variable(evaluation *e, const node *n, variable *var, operand *out, diag *d) {
    var->read = true;
    if (var->kind == VARIABLE_LIST)
        return list_of(e, n, var, out, d);
    if (var->kind == VARIABLE_FORMULA)
        return formula_of(e, n, var, out, d);
    if (var->unknown) {
        *out = var->note.number && !var->note.wild ? operand_unknown(OPERAND_ONE, var->note.d) : operand_wild();
        return SARCINA_OK;
    }
    *out = operand_text(var->text);
    operand_parse(e->in, out);
    out->unknown = e->untaken > 0;
    return SARCINA_OK;
}

/* ---- names of the commands ---- */

static int members_of(evaluation *e, const name_class *c, size_t row, operand *out, diag *d) {
    *out = (operand){.extent = OPERAND_CELLS, .is_truth = true, .unknown = is_unknown_scene(e)};
    if (out->unknown)
        return SARCINA_OK;
    const view *v;
    int status = evaluate_view(e, &v, d);
    if (status)
        return status;
    out->n = v->colony->cell.count;
    out->v = alloc_zeroed(out->n, sizeof *out->v);
    bool *flags = alloc_zeroed(out->n, sizeof *flags);
    status = c->members(e->in, row, v, flags, d);
    for (size_t i = 0; i < out->n; i++)
        out->v[i] = flags[i];
    free(flags);
    return status;
}

static int mark_all(interp *in, size_t row, const view *v, bool *flags, diag *d) {
    (void)in, (void)row, (void)d;
    for (size_t i = 0; i < v->colony->cell.count; i++)
        flags[i] = true;
    return SARCINA_OK;
}

static const name_class everything = {.name = "all", .members = mark_all};

/* The number in brackets; NAN without brackets. */
static int index_of(evaluation *e, const node *n, double *index, diag *d) {
    *index = NAN;
    if (!n->index)
        return SARCINA_OK;
    operand o = {0};
    int status = evaluate_node(e, n->index, &o, d);
    if (!status && (o.is_text || o.extent != OPERAND_ONE || (!o.wild && !dim_is_none(o.d)))) {
        diag_error(d, "what stands in [ ] is one pure number");
        status = evaluate_refuse(n->index, d);
    }
    *index = o.one;
    if (!status && !o.unknown && (*index != nearbyint(*index) || *index < 1)) {
        diag_error(d, "what stands in [ ] is a whole number from 1, not %g", *index);
        status = evaluate_refuse(n->index, d);
    }
    operand_free(&o);
    return status;
}

static int value_of_class(evaluation *e, const node *n, const name_class *c, size_t row, operand *out, diag *d) {
    double index, si = NAN;
    dim dimension = DIM_NONE;
    int status = index_of(e, n, &index, d);
    bool unknown = is_unknown_scene(e);
    if (!status)
        status = c->value(e->in, row, n->field, index, &dimension, unknown ? NULL : &si, d);
    if (status)
        return evaluate_refuse(n, d);
    *out = unknown ? operand_unknown(OPERAND_ONE, dimension) : operand_number(si, dimension);
    return SARCINA_OK;
}

/* ---- indices ---- */

static int pick_row(evaluation *e, const node *n, const operand *all, double index, size_t *row, diag *d) {
    if (all->extent == OPERAND_LIST) {
        *row = (size_t)index - 1;
        if (*row < all->n)
            return SARCINA_OK;
        diag_error(d, "%s has %zu %s, not %g", n->text, all->n, number_noun(all->n, "element", "elements"), index);
        return evaluate_refuse(n, d);
    }
    const view *v;
    int status = evaluate_view(e, &v, d);
    for (*row = 0; !status && *row < all->n; ++*row)
        if ((double)v->colony->cell.id[*row] == index)
            return SARCINA_OK;
    if (status)
        return status;
    diag_error(d, "there is no cell %g", index);
    return evaluate_refuse(n, d);
}

/* One element of cells or a list. */
static int pick(evaluation *e, const node *n, operand *out, diag *d) {
    double index;
    size_t row;
    int status = index_of(e, n, &index, d);
    if (status)
        return status;
    if (out->extent == OPERAND_ONE) {
        diag_error(d, "%s is one value: it takes no [ ]", n->text);
        return evaluate_refuse(n, d);
    }
    operand one = *out;
    one.extent = OPERAND_ONE;
    one.v = NULL;
    one.t = NULL;
    if (out->unknown) {
        *out = one;
        return SARCINA_OK;
    }
    status = pick_row(e, n, out, index, &row, d);
    if (status)
        return status;
    if (out->is_text)
        one.text = alloc_copy(out->t[row]);
    else
        one.one = out->v[row];
    operand_free(out);
    *out = one;
    return SARCINA_OK;
}

/* ---- the name ---- */

/* v_NAME and c_NAME of LAMMPS. */
static const char *without_prefix(interp *in, const char *name) {
    bool prefixed = (name[0] == 'v' || name[0] == 'c') && name[1] == '_' && name[2];
    if (!prefixed || variables_find(&in->variables, name))
        return name;
    return name + 2;
}

static int no_field(const node *n, diag *d) {
    diag_error(d, "%s has no '%s'", n->text, n->field);
    return evaluate_refuse(n, d);
}

static int resolve(evaluation *e, const node *n, const char *name, operand *out, diag *d) {
    const value_style *s = value_find(name);
    if (s && s->scope != VALUE_CELL)
        return value_of_scene(e, n, s, out, d);
    variable *var = variables_find(&e->in->variables, name);
    ptrdiff_t row;
    const name_class *c = s || var ? NULL : names_owner(e->in, name, &row);
    if (c && c->value)
        return value_of_class(e, n, c, (size_t)row, out, d);
    if (n->field && (s || var || c))
        return no_field(n, d);
    if (s)
        return value_of_cells(e, s, out, d);
    if (var)
        return value_of_variable(e, n, var, out, d);
    if (c && c->members)
        return members_of(e, c, (size_t)row, out, d);
    if (strcmp(name, "all") == 0)
        return members_of(e, &everything, 0, out, d);
    if (e->lenient || names_is_doubtful(e->in, name)) {
        *out = operand_wild();
        return SARCINA_OK;
    }
    names_refuse_value(e->in, name, d);
    return evaluate_refuse(n, d);
}

int evaluate_name(evaluation *e, const node *n, operand *out, diag *d) {
    static const double pi = 3.14159265358979323846;
    if (strcmp(n->text, "pi") == 0) {
        *out = operand_number(pi, DIM_NONE);
        return SARCINA_OK;
    }
    const char *name = without_prefix(e->in, n->text);
    int status = resolve(e, n, name, out, d);
    if (status)
        return status;
    ptrdiff_t row;
    const name_class *c = names_owner(e->in, name, &row);
    bool indexed = n->index && !(c && c->value) && !out->wild;
    return indexed ? pick(e, n, out, d) : SARCINA_OK;
}

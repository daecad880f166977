/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Calls: functions, element by element, and reductions of cells or lists. */
#include "base/alloc.h"
#include "base/table.h"
#include "script/evaluate.h"
#include "script/function.h"
#include "script/names.h"
#include "script/reduction.h"
#include "script/state.h"

#include "analysis/value.h"
#include "model/colony.h"

#include <gsl/gsl_randist.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

static int refuse_arguments(const node *n, const char *usage, diag *d) {
    diag_error(d, "%s takes other arguments: %s", n->text, usage);
    return evaluate_refuse(n, d);
}

static int refuse_call(interp *in, const node *n, diag *d) {
    name_list l = {0};
    for (size_t i = 0; i < function_style_count; i++)
        names_add(&l, function_styles[i].name);
    for (size_t i = 0; i < reduction_style_count; i++)
        names_add(&l, reduction_styles[i].name);
    if (strcmp(n->text, "log") == 0) {
        diag_error(d, "'log' may be two things: write ln or log10");
    } else if (value_find(n->text) || variables_find(&in->variables, n->text)) {
        diag_error(d, "'%s' is a value, not a function", n->text);
    } else {
        diag_error(d, "no function '%s'", n->text);
        names_suggest(&l, n->text, "functions", d);
    }
    return evaluate_refuse(n, d);
}

/* ---- functions of numbers ---- */

static int argument_dims(evaluation *e, const node *n, const function_style *f, operand *a, operand *out, diag *d) {
    char left[48], right[48];
    for (int i = 0; i < n->nargs; i++) {
        out->wild = out->wild || a[i].wild;
        if (a[i].is_text) {
            diag_error(d, "%s takes numbers, not a text", n->text);
            return evaluate_refuse(n->args[i], d);
        }
        if (f->rule == FUNCTION_PURE && !a[i].wild && !dim_is_none(a[i].d)) {
            diag_error(d, "%s takes a pure number, not a %s", n->text, dim_name(a[i].d, left));
            return evaluate_refuse(n->args[i], d);
        }
        /* plain numbers among the later arguments may have to give their dimension to earlier ones: twice over */
        for (int k = 0; k < i; k++)
            if (!operand_adapt(e->in, &a[k], &a[i])) {
                diag_error(d, "%s between %s and %s", n->text, operand_kind(&a[k], left), operand_kind(&a[i], right));
                return evaluate_refuse(n, d);
            }
    }
    out->plain = true;
    for (int i = 0; i < n->nargs; i++)
        out->plain = out->plain && a[i].plain;
    if (f->rule == FUNCTION_SAME || f->rule == FUNCTION_RANDOM)
        out->d = a[0].wild && n->nargs > 1 ? a[1].d : a[0].d;
    if (f->rule == FUNCTION_ROOT)
        out->d = (dim){(int16_t)(a[0].d.length / 2), (int16_t)(a[0].d.mass / 2), (int16_t)(a[0].d.time / 2)};
    return SARCINA_OK;
}

/* Extent and room of a result of all arguments. */
static void shape_result(const node *n, const operand *a, operand *out) {
    out->unknown = out->wild;
    for (int i = 0; i < n->nargs; i++) {
        out->unknown = out->unknown || a[i].unknown;
        if (a[i].extent != OPERAND_ONE) {
            out->extent = a[i].extent;
            out->n = a[i].n;
        }
    }
    if (!out->unknown && out->extent != OPERAND_ONE)
        out->v = alloc_zeroed(out->n, sizeof *out->v);
}

static double apply(const node *n, const function_style *f, const operand *a, size_t i) {
    double x = operand_get(&a[0], i);
    if (f->one)
        return f->one(x);
    for (int k = 1; k < n->nargs; k++)
        x = f->two(x, operand_get(&a[k], i));
    return x;
}

static int apply_all(const node *n, const function_style *f, const operand *a, operand *out, diag *d) {
    size_t count = out->unknown ? 0 : out->extent == OPERAND_ONE ? 1 : out->n;
    for (size_t i = 0; i < count; i++) {
        double y = apply(n, f, a, i);
        bool undefined = false;
        for (int k = 0; k < n->nargs; k++)
            undefined = undefined || isnan(operand_get(&a[k], i));
        if (!isfinite(y) && !undefined) {
            diag_error(d, "%s(%.15g) is not finite", n->text, operand_get(&a[0], i));
            return evaluate_refuse(n, d);
        }
        if (out->extent == OPERAND_ONE)
            out->one = y;
        else
            out->v[i] = y;
    }
    return SARCINA_OK;
}

/* ---- random numbers ---- */

static double draw(gsl_rng *stream, const char *name, double a, double b) {
    if (strcmp(name, "random") == 0)
        return gsl_ran_flat(stream, a, b);
    if (strcmp(name, "normal") == 0)
        return a + gsl_ran_gaussian_ziggurat(stream, b);
    return (double)gsl_ran_poisson(stream, a);
}

static int draw_all(evaluation *e, const node *n, const operand *a, operand *out, diag *d) {
    if (e->repeatable) {
        diag_error(d, "%s is drawn anew at every look; freeze it with $(...)", n->text);
        return evaluate_refuse(n, d);
    }
    if (e->per_cell && out->extent == OPERAND_ONE)
        out->extent = OPERAND_CELLS;
    out->plain = false;
    out->unknown = out->unknown || e->types_only || e->untaken || e->in->check.on;
    if (out->unknown)
        return SARCINA_OK;
    uint64_t look = e->in->draws++;
    rng *r = e->in->scene->rng;
    if (out->extent == OPERAND_ONE) {
        double b = n->nargs > 1 ? a[1].one : 0;
        out->one = draw(rng_stream(r, RNG_SCRIPT, 0, look), n->text, a[0].one, b);
        return SARCINA_OK;
    }
    const colony *c = e->in->scene->colony;
    if (!out->v) {
        out->n = c->cell.count;
        out->v = alloc_zeroed(out->n, sizeof *out->v);
    }
    for (size_t i = 0; i < out->n; i++) {
        double b = n->nargs > 1 ? operand_get(&a[1], i) : 0;
        out->v[i] = draw(rng_stream(r, RNG_SCRIPT, c->cell.id[i], look), n->text, operand_get(&a[0], i), b);
    }
    return SARCINA_OK;
}

/* ---- functions of texts ---- */

static int ask(evaluation *e, const node *n, const function_style *f, const operand *a, operand *out, diag *d) {
    if (!a->is_text && !a->wild) {
        diag_error(d, "%s takes a text in quotes", n->text);
        return evaluate_refuse(n->args[0], d);
    }
    *out = operand_unknown(OPERAND_ONE, DIM_NONE);
    out->is_truth = true;
    if (a->unknown || e->types_only || e->untaken || e->in->check.on)
        return SARCINA_OK;
    ptrdiff_t row;
    bool yes;
    if (f->rule == FUNCTION_FILE) {
        FILE *file = fopen(a->text, "rb");
        yes = file != NULL;
        if (file)
            fclose(file);
    } else {
        yes = variables_find(&e->in->variables, a->text) || value_find(a->text) || names_owner(e->in, a->text, &row);
    }
    *out = operand_truth(yes);
    return SARCINA_OK;
}

/* descends(ID): across the dead too. */
static int descend(evaluation *e, const node *n, const operand *a, operand *out, diag *d) {
    if (a->is_text || a->extent != OPERAND_ONE || (!a->wild && !dim_is_none(a->d))) {
        diag_error(d, "descends takes the id of one cell");
        return evaluate_refuse(n->args[0], d);
    }
    *out = (operand){.extent = OPERAND_CELLS, .is_truth = true};
    out->unknown = a->unknown || e->types_only || e->untaken || e->in->check.on;
    if (out->unknown)
        return SARCINA_OK;
    const view *v;
    int status = evaluate_view(e, &v, d);
    if (status)
        return status;
    if (!(a->one >= 1) || a->one != floor(a->one) || a->one >= (double)v->colony->next_cell_id) {
        diag_error(d, "there has never been a cell %g", a->one);
        return evaluate_refuse(n->args[0], d);
    }
    out->n = v->colony->cell.count;
    out->v = alloc_zeroed(out->n, sizeof *out->v);
    bool *flags = alloc_zeroed(out->n, sizeof *flags);
    lineage_mark(v->dead, v->colony, (uint64_t)a->one, flags);
    for (size_t i = 0; i < out->n; i++)
        out->v[i] = flags[i];
    free(flags);
    return SARCINA_OK;
}

/* ternary(test, yes, no): only the one that is taken is computed. */
static int choose(evaluation *e, const node *n, operand *out, diag *d) {
    operand test = {0}, yes = {0}, no = {0};
    int untaken = e->untaken;
    int status = evaluate_node(e, n->args[0], &test, d);
    bool one = test.extent == OPERAND_ONE && !test.unknown, holds = one && test.one != 0 && !isnan(test.one);
    e->untaken = untaken + (one && !holds);
    status = status ? status : evaluate_node(e, n->args[1], &yes, d);
    e->untaken = untaken + (one && holds);
    status = status ? status : evaluate_node(e, n->args[2], &no, d);
    e->untaken = untaken;
    bool adapts = status || (yes.is_text == no.is_text && operand_adapt(e->in, &yes, &no)) || yes.wild || no.wild;
    if (!adapts) {
        char left[48], right[48];
        diag_error(d, "%s between %s and %s", n->text, operand_kind(&yes, left), operand_kind(&no, right));
        status = evaluate_refuse(n, d);
    }
    if (!status && test.extent == OPERAND_ONE) {
        operand *taken = holds ? &yes : &no;
        *out = *taken;
        *taken = (operand){0};
        out->unknown = out->unknown || test.unknown;
    } else if (!status && (yes.is_text || no.is_text)) {
        diag_error(d, "%s of texts takes one truth, not one per cell", n->text);
        status = evaluate_refuse(n, d);
    } else if (!status) {
        operand a[3] = {test, yes, no};
        out->d = yes.d;
        shape_result(n, a, out);
        for (size_t i = 0; !out->unknown && i < out->n; i++) {
            double t = operand_get(&test, i);
            out->v[i] = operand_get(t != 0 && !isnan(t) ? &yes : &no, i);
        }
    }
    operand_free(&test);
    operand_free(&yes);
    operand_free(&no);
    return status;
}

int evaluate_call(evaluation *e, const node *n, operand *out, diag *d) {
    const function_style *f = function_find(n->text);
    const reduction_style *r = reduction_find(n->text);
    if (!f)
        return r ? refuse_arguments(n, r->signature, d) : refuse_call(e->in, n, d);
    if (n->nargs < f->least || n->nargs > f->most || n->where)
        return refuse_arguments(n, f->signature, d);
    if (f->rule == FUNCTION_CHOICE)
        return choose(e, n, out, d);
    operand a[NODE_ARGS_MAX] = {0};
    int status = SARCINA_OK;
    for (int i = 0; i < n->nargs && !status; i++)
        status = evaluate_node(e, n->args[i], &a[i], d);
    if (!status && (f->rule == FUNCTION_FILE || f->rule == FUNCTION_DEFINED)) {
        status = ask(e, n, f, a, out, d);
    } else if (!status && f->rule == FUNCTION_DESCENDS) {
        status = descend(e, n, a, out, d);
    } else if (!status) {
        status = argument_dims(e, n, f, a, out, d);
        if (!status)
            shape_result(n, a, out);
        if (!status)
            status = f->rule == FUNCTION_RANDOM ? draw_all(e, n, a, out, d) : apply_all(n, f, a, out, d);
    }
    for (int i = 0; i < n->nargs; i++)
        operand_free(&a[i]);
    return status;
}

/* ---- reductions ---- */

/* The numbers of the cells (in the order of their ids) or list elements for which `where` holds; undefined ones are
 * left out. Returns how many; *total: with the undefined. */
static size_t gather(evaluation *e, const operand *x, const operand *where, double *numbers, size_t *total) {
    size_t n = 0;
    const uint32_t *order = x->extent == OPERAND_CELLS ? colony_by_id(e->in->scene->colony) : NULL;
    *total = 0;
    for (size_t k = 0; k < x->n; k++) {
        size_t i = order ? order[k] : k;
        double holds = where ? operand_get(where, i) : 1;
        if (holds == 0 || isnan(holds))
            continue;
        ++*total;
        double value = x->t ? 1 : x->v[i];
        if (!isnan(value))
            numbers[n++] = value;
    }
    return n;
}

static size_t count_true(const double *numbers, size_t n) {
    size_t yes = 0;
    for (size_t i = 0; i < n; i++)
        yes += numbers[i] != 0;
    return yes;
}

static double reduce(evaluation *e, const reduction_style *r, const operand *x, const operand *where, double p) {
    size_t total;
    double *numbers = alloc_zeroed(x->n, sizeof *numbers);
    size_t n = gather(e, x, where, numbers, &total);
    double result = NAN;
    if (r->rule == REDUCTION_COUNT)
        result = x->extent == OPERAND_LIST ? (double)total : (double)count_true(numbers, n);
    else if (r->rule == REDUCTION_FRACTION)
        result = total ? (double)count_true(numbers, n) / (double)total : (double)NAN;
    else if (n)
        result = r->reduce(numbers, n, p);
    else if (r->rule == REDUCTION_SUM)
        result = 0;
    free(numbers);
    return result;
}

/* Checks what is reduced and by what. */
static int check_reduction(const node *n, const reduction_style *r, const operand *x, const operand *where, diag *d) {
    const node *what = n->args[r->rule == REDUCTION_QUANTILE];
    char name[48];
    bool counts = r->rule == REDUCTION_COUNT || r->rule == REDUCTION_FRACTION;
    if (x->extent == OPERAND_ONE && !x->wild)
        diag_error(d, "%s takes a value per cell or a list, not one value", n->text);
    else if (x->is_text && !(r->rule == REDUCTION_COUNT && x->extent == OPERAND_LIST))
        diag_error(d, "%s takes numbers, not a text", n->text);
    else if (counts && x->extent == OPERAND_CELLS && !x->wild && !dim_is_none(x->d))
        diag_error(d, "%s takes a truth per cell, not a %s", n->text, dim_name(x->d, name));
    else if (where && (where->is_text || (!where->wild && !dim_is_none(where->d)) || where->extent == OPERAND_LIST))
        diag_error(d, "where takes a truth per cell");
    else if (where && x->extent == OPERAND_LIST)
        diag_error(d, "where chooses cells; a list has none");
    else
        return SARCINA_OK;
    return evaluate_refuse(what, d);
}

static int probability(evaluation *e, const node *n, double *p, diag *d) {
    operand o = {0};
    int status = evaluate_node(e, n, &o, d);
    *p = o.one;
    bool number = !o.is_text && o.extent == OPERAND_ONE && (o.wild || dim_is_none(o.d));
    if (!status && (!number || (!o.unknown && !(*p >= 0 && *p <= 1)))) {
        diag_error(d, "the probability of a quantile is a number from 0 to 1");
        status = evaluate_refuse(n, d);
    }
    operand_free(&o);
    return status;
}

int evaluate_reduction(evaluation *e, const node *n, operand *out, diag *d) {
    const reduction_style *r = reduction_find(n->text);
    bool quantile = r->rule == REDUCTION_QUANTILE;
    int last = quantile; /* the argument that is reduced; a truth behind it is its where */
    const node *test = n->where ? n->where : n->nargs == last + 2 ? n->args[last + 1] : NULL;
    if (n->nargs != last + 1 + (test && !n->where))
        return refuse_arguments(n, r->signature, d);
    operand x = {0}, where = {0};
    double p = 0;
    int status = quantile ? probability(e, n->args[0], &p, d) : SARCINA_OK;
    e->per_cell++;
    if (!status)
        status = evaluate_node(e, n->args[last], &x, d);
    if (!status && test)
        status = evaluate_node(e, test, &where, d);
    e->per_cell--;
    if (!status)
        status = check_reduction(n, r, &x, test ? &where : NULL, d);
    bool pure = r->rule == REDUCTION_COUNT || r->rule == REDUCTION_FRACTION;
    if (!status) {
        *out = operand_number(0, pure ? DIM_NONE : x.d);
        out->plain = x.plain && !pure;
        out->wild = x.wild && !pure;
        out->unknown = x.unknown || where.unknown;
    }
    if (!status && !out->unknown)
        out->one = reduce(e, r, &x, test ? &where : NULL, p);
    operand_free(&x);
    operand_free(&where);
    return status;
}

/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "command/results.h"

#include "command/analyze_bins.h"
#include "command/output_list.h"

#include "base/alloc.h"
#include "base/path.h"
#include "output/field.h"
#include "script/expr.h"

#include <inttypes.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

/* ---- fields ---- */

static void put_quantity(FILE *out, const char *name, dim d) {
    char suffix[48];
    field_put_csv(out, name);
    fprintf(out, ",%s,", dim_suffix(d, suffix));
}

static void put_number(FILE *out, double si) {
    char text[FIELD_ROOM];
    fprintf(out, "%s\n", field_number(si, text));
}

/* The value of a formula given as text; false where it has no one number now. */
static bool value_of(interp *in, const char *text, quantity *q) {
    expr *e = expr_of_text(in, text, NULL);
    bool known = e && interp_number(in, e, q, NULL) == SARCINA_OK;
    expr_free(e);
    return known;
}

/* ---- along the way ---- */

typedef struct row {
    FILE *out;
    uint64_t step;
    double time;
} row;

static void put_value(const row *r, const char *name, dim d, double si) {
    char time[FIELD_ROOM];
    fprintf(r->out, "%" PRIu64 ",%s,", r->step, field_number(r->time, time));
    put_quantity(r->out, name, d);
    put_number(r->out, si);
}

static bool is_column(const thermo *t, const char *name) {
    for (size_t i = 0; i < thermo_count(t); i++)
        if (strcmp(thermo_column(t, i)->name, name) == 0)
            return true;
    return false;
}

/* A quantity that is a column too is there already: twice, it would count twice in an ensemble's mean. */
static void put_analysis(interp *in, const thermo *t, const row *r, const output_analysis *p) {
    quantity q;
    if (!is_column(t, p->id) && value_of(in, p->id, &q))
        put_value(r, p->id, q.d, q.si);
    for (size_t i = 0; i < value_field_count(p->style); i++) {
        char field[32];
        dim d;
        value_field(p->style, i, field, &d);
        char *name = alloc_format("%s.%s", p->id, field);
        if (!is_column(t, name) && value_of(in, name, &q))
            put_value(r, name, q.d, q.si);
        free(name);
    }
}

static void put_bin(void *self, const char *name, dim d, double si) {
    put_value(self, name, d, si);
}

/* What analyses say of the step. Histograms and profiles: every bin is a quantity of its own. */
static int put_analyses(outputs *o, row *r, diag *d) {
    int status = SARCINA_OK;
    for (size_t i = 0; i < o->nanalyses && !status; i++) {
        const output_analysis *p = &o->analyses[i];
        if (p->style)
            put_analysis(o->in, o->table, r, p);
        else if (p->bins)
            status = analyze_bins_each(o->in, p, put_bin, r, d);
    }
    return status;
}

static int open_results(outputs *o, diag *d) {
    o->results = stream_create("results.csv", STREAM_CSV, 0);
    int status = SARCINA_OK;
    if (o->resumed_step)
        status = stream_rewind(o->results, o->resumed_step, d);
    if (!status)
        status = stream_open(o->results, d);
    if (status || !stream_is_empty(o->results))
        return status;
    fputs("step,time,quantity,unit,value\n", stream_file(o->results));
    return stream_flush(o->results, d);
}

int results_row(outputs *o, diag *d) {
    const scene *s = interp_scene(o->in);
    if (!interp_results(o->in))
        return SARCINA_OK;
    int status = o->results ? SARCINA_OK : open_results(o, d);
    if (status || stream_has(o->results, s->step))
        return status;
    row r = {stream_file(o->results), s->step, s->time};
    for (size_t i = 0; i < thermo_count(o->table); i++) {
        const output_column *c = thermo_column(o->table, i);
        if (!c->is_text && strcmp(c->name, "step") != 0)
            put_value(&r, c->name, c->d, thermo_last(o->table, i));
    }
    status = put_analyses(o, &r, d);
    return status ? status : stream_end(o->results, s->step, d);
}

/* ---- at the end ---- */

static void put_first_time(FILE *out, const output_analysis *p) {
    for (size_t i = 0; i < 2 + p->nkept; i++) {
        const output_column *kept = i < 2 ? NULL : &p->kept[i - 2];
        char *name = alloc_format("%s.%s", p->id, i == 0 ? "step" : i == 1 ? "time" : kept->name);
        put_quantity(out, name, i == 0 ? DIM_NONE : i == 1 ? DIM_TIME : kept->d);
        free(name);
        if (p->happened)
            put_number(out, i == 0 ? p->step : i == 1 ? p->time : p->values[i - 2]);
        else
            fputs("never\n", out);
    }
}

int results_scalars(interp *in, diag *d) {
    if (!interp_results(in))
        return SARCINA_OK;
    FILE *out = path_open("scalars.csv", "w", d);
    if (!out)
        return SARCINA_ERROR;
    const outputs *o = output_list_of(in);
    fputs("quantity,unit,value\n", out);
    for (size_t i = 0; i < o->nanalyses; i++)
        if (!o->analyses[i].style && !o->analyses[i].bins)
            put_first_time(out, &o->analyses[i]);
    const char *name;
    for (size_t i = 0; (name = interp_formula(in, i)); i++) {
        quantity q;
        if (!value_of(in, name, &q))
            continue;
        put_quantity(out, name, q.d);
        put_number(out, q.si);
    }
    return path_close(out, "scalars.csv", d);
}

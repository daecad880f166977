/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "script/args.h"

#include "script/argument.h"

#include <assert.h>
#include <stdlib.h>
#include <string.h>

void args_free(args *a) {
    for (size_t i = 0; a->values && i < a->form->nhead + a->form->nkey; i++)
        argument_free(&a->values[i]);
    free(a->values);
    free(a->defines);
    *a = (args){0};
}

/* A name that is not in the record is a mistake in the program. */
static const argument *find(const args *a, const char *name) {
    size_t index = 0;
    const slot *s = signature_find(a->form, name, &index);
    assert(s && "the form has no such argument");
    (void)s;
    return &a->values[index];
}

bool args_given(const args *a, const char *name) {
    size_t index;
    return signature_find(a->form, name, &index) && a->values[index].given;
}

bool args_off(const args *a) {
    return a->off;
}

int args_style(const args *a) {
    return a->form->form.style;
}

const char *args_head(const args *a) {
    return a->form->head[0].name;
}

double args_number(const args *a, const char *name) {
    return find(a, name)->number;
}

bool args_percent(const args *a, const char *name) {
    return find(a, name)->percent;
}

spread args_spread(const args *a, const char *name) {
    return find(a, name)->range;
}

long long args_int(const args *a, const char *name) {
    return (long long)find(a, name)->number;
}

bool args_flag(const args *a, const char *name) {
    return find(a, name)->number != 0;
}

int args_choice(const args *a, const char *name) {
    return (int)find(a, name)->number;
}

const char *args_text(const args *a, const char *name) {
    return find(a, name)->text;
}

bool args_unknown(const args *a, const char *name, replacement *note) {
    const argument *v = find(a, name);
    *note = v->note;
    return v->note.unknown;
}

bool args_all(const args *a, const char *name) {
    return find(a, name)->all;
}

int args_row(const args *a, const char *name) {
    return (int)find(a, name)->number;
}

size_t args_count(const args *a, const char *name) {
    return find(a, name)->n;
}

const char *args_text_at(const args *a, const char *name, size_t i) {
    return find(a, name)->texts[i];
}

expr *args_expr(const args *a, const char *name) {
    const argument *v = find(a, name);
    return v->exprs ? v->exprs[0] : NULL;
}

expr *args_expr_at(const args *a, const char *name, size_t i) {
    return find(a, name)->exprs[i];
}

command_text *args_command(const args *a, const char *name) {
    return find(a, name)->command;
}

void args_vector(const args *a, const char *name, double *out, size_t n) {
    memcpy(out, find(a, name)->vector, n * sizeof *out);
}

orient_kind args_orient(const args *a, const char *name, double axis[3]) {
    const argument *v = find(a, name);
    memcpy(axis, v->vector, 3 * sizeof *axis);
    return v->orient;
}

args_cycles_value args_cycles(const args *a, const char *name) {
    return find(a, name)->cycles;
}

void args_relaxation(const args *a, const char *name, double *time, double *force) {
    const argument *v = find(a, name);
    *time = v->time;
    *force = v->force;
}

size_t args_every_count(const args *a, const char *name) {
    return find(a, name)->nevery;
}

args_cycles_value args_every(const args *a, const char *name, size_t i, command_text *const **commands, size_t *n) {
    const argument_every *e = &find(a, name)->every[i];
    *commands = e->commands;
    *n = e->n;
    return e->cycles;
}

quantity args_quantity(const args *a, const char *name) {
    return find(a, name)->quantity;
}

void args_column_format(const args *a, const char *name, const char **column, const char **format) {
    const argument *v = find(a, name);
    *column = v->texts[0];
    *format = v->texts[1];
}

span args_span(const args *a, const char *name) {
    return find(a, name)->at;
}

span args_span_at(const args *a, const char *name, size_t i) {
    return find(a, name)->spans[i];
}

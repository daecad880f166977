/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The prompt's side of the interpreter: lines as they are typed, and the state that `undo` goes back to. */
#include "base/alloc.h"
#include "script/execute.h"
#include "script/state.h"

#include <inttypes.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

/* ---- bare expressions -------------------------------------------------------------------------------------------- */

/* Whether the line is an expression and no command: its first word is none and it parses whole. */
static expr *line_expression(interp *in, const source *s) {
    piece p = piece_of_source(s);
    reader r;
    reader_open(&r, in, &p);
    piece_free(&p);
    word w;
    expr *e = NULL;
    bool command = reader_peek(&r, &w, NULL) != SARCINA_OK || !w.text || execute_is_command(in, w.text);
    if (!command)
        e = expr_read(&r, EXPR_OPEN, NULL);
    expr_type type;
    if (e && (!reader_at_end(&r) || expr_check_formula(in, e, NULL) != SARCINA_OK)) {
        expr_free(e);
        e = NULL;
    }
    /* a lone word that nothing knows is a slip of a command, not of an expression */
    if (e && e->root->kind == NODE_NAME && expr_check(in, e, true, false, &type, NULL) != SARCINA_OK) {
        expr_free(e);
        e = NULL;
    }
    reader_close(&r);
    return e;
}

/* A value per cell cannot be printed: which one value of it may be meant. */
static int refuse_cells(const expr *e, const expr_type *type, diag *d) {
    const char *text = expr_text(e), *suffix[1] = {""};
    bool name = e->root->kind == NODE_NAME && !e->root->index;
    diag_error(d, "%s has a value per cell", text);
    if (!dim_is_none(type->d))
        units_usual(type->d, suffix, 1);
    if (type->is_text)
        return diag_help(d, "count(%s == \"...\")%s%s%s", text, name ? ", or " : "", name ? text : "",
                         name ? "[ID] for one" : "");
    if (type->is_truth)
        return diag_help(d, "count(%s), fraction(%s)", text, text);
    return diag_help(d, "mean(%s), max(%s), count(%s > 1%s)%s%s%s", text, text, text, suffix[0], name ? ", or " : "",
                     name ? text : "", name ? "[ID] for one" : "");
}

static int print_value(interp *in, expr *e) {
    diag d = {0};
    expr_type type;
    replacement note;
    if (expr_check(in, e, false, false, &type, NULL) && !expr_check(in, e, true, false, &type, NULL)) {
        refuse_cells(e, &type, &d);
        return interp_tell(in, &d);
    }
    char *value = expr_print(in, e, NULL, &note, &d);
    if (value)
        interp_screen(in, "%s", value);
    free(value);
    return value ? SARCINA_OK : interp_tell(in, &d);
}

bool interp_is_expression(interp *in, const char *text) {
    source *s = source_of_text("", text);
    expr *e = line_expression(in, s);
    bool is = e != NULL;
    expr_free(e);
    source_free(s);
    return is;
}

static int evaluate_text(interp *in, const source *s, bool per_cell, double *si, diag *d) {
    piece p = piece_of_source(s);
    quantity one = {0};
    dim dimension;
    reader r;
    reader_open(&r, in, &p);
    piece_free(&p);
    expr *e = expr_read(&r, EXPR_OPEN, d);
    int status = e ? SARCINA_OK : SARCINA_ERROR;
    if (e && !reader_at_end(&r))
        status = diag_error(d, "'%s' is not one expression", s->text);
    if (!status)
        status = per_cell ? interp_cells(in, e, si, &dimension, d) : interp_number(in, e, &one, d);
    if (!status && !per_cell)
        *si = one.si;
    if (status)
        diag_place(d, piece_span(&r.text, 0, r.text.n));
    expr_free(e);
    reader_close(&r);
    return status;
}

int interp_run_expression(interp *in, const char *name, const char *text, bool per_cell, double *si) {
    diag d = {0};
    source *s = source_of_text(name, text);
    int status = evaluate_text(in, s, per_cell, si, &d);
    if (status)
        interp_tell(in, &d);
    source_free(s);
    return status;
}

/* ---- a line ------------------------------------------------------------------------------------------------------ */

static int run_line(interp *in, source *s) {
    diag d = {0};
    expr *e = line_expression(in, s);
    in->noted = false;
    int status = e ? print_value(in, e) : execute_source(in, s, "text", &d);
    if (!e && status)
        interp_tell(in, &d);
    expr_free(e);
    return status;
}

/* ? stands for help. */
static source *line_source(const char *text) {
    size_t blanks = strspn(text, " \t");
    if (text[blanks] != '?')
        return source_of_text("", text);
    char *help = alloc_format("help %s", text + blanks + 1);
    source *s = source_of_text("", help);
    free(help);
    return s;
}

int interp_run_line(interp *in, const char *text) {
    const command_table *t = in->host->commands;
    if (t->line_begins)
        t->line_begins(in);
    in->prompt = true;
    int status = run_line(in, interp_keep_source(in, line_source(text)));
    in->prompt = false;
    if (t->line_ended)
        t->line_ended(in, text, status);
    return status;
}

/* ---- what undo goes back to -------------------------------------------------------------------------------------- */

char *interp_settings_save(const interp *in) {
    return alloc_format("units %d echo %d warn %d threads %d", (int)in->units, (int)in->echo, (int)in->warn,
                        in->scene->threads);
}

void interp_settings_load(interp *in, const char *text) {
    int given_units, echo, warn, threads;
    if (sscanf(text, "units %d echo %d warn %d threads %d", &given_units, &echo, &warn, &threads) != 4)
        return;
    in->units = (unit_system)given_units;
    in->echo = (echo_mode)echo;
    in->warn = (warn_mode)warn;
    in->scene->threads = threads;
}

int interp_variables_restore(interp *in, const char *text, diag *d) {
    variables before = in->variables;
    in->variables = (variables){0};
    int status = interp_variables_load(in, text, d);
    for (size_t i = 0; i < before.count; i++) {
        const variable *old = &before.list[i];
        variable *v = variables_find(&in->variables, old->name);
        if (v)
            v->command_line = old->command_line;
    }
    variables_free(&before);
    return status;
}

interp_terminal interp_terminal_of(const interp *in) {
    if (in->host->terminal)
        return in->host->terminal(in->host->self);
    return (interp_terminal){.columns = 80, .rows = 24};
}

const char *interp_date(const interp *in) {
    return in->host->date ? in->host->date(in->host->self) : "";
}

int interp_edit(interp *in, char **text, diag *d) {
    return in->host->edit ? in->host->edit(in->host->self, text, d) : diag_error(d, "there is no editor here");
}

size_t interp_undo_bytes(const interp *in) {
    return in->host->undo_bytes ? in->host->undo_bytes : (size_t)256 << 20;
}

bool interp_skips_runs(const interp *in) {
    return in->host->skip_runs;
}

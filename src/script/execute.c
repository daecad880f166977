/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "script/execute.h"

#include "base/alloc.h"
#include "base/table.h"
#include "script/argument.h"
#include "script/foreign.h"
#include "script/names.h"
#include "script/state.h"

#include <ctype.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

/* ---- errors ---- */

void execute_note(interp *in, const reader *r, const diag *d) {
    if (!d || in->noted)
        return;
    in->noted = true;
    free(in->expanded);
    in->expanded = r && r->count ? alloc_copy_n(r->text.chars, r->text.n) : NULL;
    free(in->trace);
    in->trace = alloc_copy("");
    for (int i = in->depth - 1; i >= 0; i--) {
        const frame *f = &in->stack[i];
        if (!f->at.source)
            continue;
        char place[32] = "";
        if (*f->at.source->name) /* lines of the prompt have neither name nor number */
            snprintf(place, sizeof place, ":%u: ", f->at.line);
        char *longer = alloc_format("%s%s%sin this %s%s%s\n", in->trace, f->at.source->name, place, f->kind,
                                    *f->detail ? ", " : "", f->detail);
        free(in->trace);
        in->trace = longer;
    }
}

void execute_report(interp *in, const diag *d) {
    in->check.errors++;
    execute_note(in, NULL, d);
    char *text = interp_explain(in, d);
    if (in->host->error)
        in->host->error(in->host->self, text);
    free(text);
    in->noted = false;
}

int execute_push(interp *in, const char *kind, span at, const source *running, diag *d) {
    if (in->depth == FRAME_MAX) {
        diag_error(d, "blocks, includes and commands in commands are nested too deeply (%d)", FRAME_MAX);
        diag_place(d, at);
        return SARCINA_ERROR;
    }
    in->stack[in->depth++] = (frame){.kind = kind, .at = at, .running = running};
    return SARCINA_OK;
}

void execute_pop(interp *in) {
    in->depth--;
}

/* ---- commands ---- */

static const char *const words[] = {"if", "for", "while", "repeat", "end", "elif", "else", "break", "continue"};

static int refuse_command(interp *in, reader *r, const word *w, diag *d) {
    word name; /* what it would have defined */
    if (in->check.on && reader_peek(r, &name, NULL) == SARCINA_OK && name.text)
        names_doubt(in, name.text);
    name_list l = {0};
    const command_table *t = in->host->commands;
    for (size_t i = 0; i < t->count; i++)
        names_add(&l, t->list[i].head[0].name);
    for (size_t i = 0; i < TABLE_COUNT(words); i++)
        names_add(&l, words[i]);
    if (foreign_explain(w->text, d))
        return SARCINA_ERROR;
    diag_error(d, "unknown command '%s'", w->text);
    names_suggest(&l, w->text, "commands", d);
    return SARCINA_ERROR;
}

static bool is_command(const interp *in, const char *name) {
    const command_table *t = in->host->commands;
    for (size_t i = 0; i < t->count; i++)
        if (strcmp(t->list[i].head[0].name, name) == 0)
            return true;
    return false;
}

bool execute_is_command(const interp *in, const char *name) {
    for (size_t i = 0; i < TABLE_COUNT(words); i++)
        if (strcmp(words[i], name) == 0)
            return true;
    return is_command(in, name);
}

static void keep_journal(interp *in, const reader *r) {
    char *text = reader_text(r);
    interp_journal_add(in, text);
    free(text);
}

/* Warnings under `warn error` are errors of the command that gave them. */
static int check_warned(interp *in, diag *d) {
    if (!*in->warned)
        return SARCINA_OK;
    diag_error(d, "%s", in->warned);
    diag_help(d, "'warn error' makes warnings errors");
    *in->warned = '\0';
    return SARCINA_ERROR;
}

/* Whether a line of the prompt is running, and no file that it includes. */
static bool is_typed(const interp *in) {
    for (int i = 0; i < in->depth; i++)
        if (in->stack[i].running && *in->stack[i].running->name)
            return false;
    return in->prompt;
}

static int check_prompt(interp *in, const command_form *form, const args *a, diag *d) {
    if (!is_typed(in))
        return diag_error(d, "%s is for the prompt: it does not stand in scripts", args_head(a));
    bool alone = in->depth == 1 && in->commands == 1;
    if ((form->flags & COMMAND_ALONE) == COMMAND_ALONE && !alone)
        return diag_error(d, "%s stands on a line of its own, in no block and no other command", args_head(a));
    return SARCINA_OK;
}

static int call(interp *in, const command_form *form, const args *a, diag *d) {
    bool shadow = form->flags & COMMAND_SHADOW;
    if ((form->flags & COMMAND_PROMPT) && check_prompt(in, form, a, d) != SARCINA_OK)
        return SARCINA_ERROR;
    if (in->check.on && (!shadow || a->unknown || a->nameless || a->redefines))
        return SARCINA_OK;
    if ((form->flags & COMMAND_UNSAFE) && in->host->safe)
        return diag_error(d, "%s is refused under -safe", args_head(a));
    int status = form->run(in, a, d);
    in->epoch++;
    if (!status && in->warn == WARN_ERROR)
        status = check_warned(in, d);
    /* a value that only stands for an unknown one may have been at fault */
    return in->check.on && a->guessed ? SARCINA_OK : status;
}

static int run_form(interp *in, const signature *form, reader *r, diag *d) {
    args a;
    *in->warned = '\0';
    int status = args_read(in, form, r, &a, d);
    if (status) {
        char *usage = signature_usage(form);
        diag_help(d, "%s", usage);
        free(usage);
    } else {
        status = call(in, &form->form, &a, d);
    }
    if (in->check.on && a.defines && (status || a.unknown || a.nameless))
        names_doubt(in, a.defines);
    if (!status && (form->form.flags & COMMAND_JOURNAL) && !in->check.on)
        keep_journal(in, r);
    args_free(&a);
    return status;
}

/* break and continue. */
static int request_loop(interp *in, reader *r, loop_request request, const word *w, diag *d) {
    if (!interp_in_loop(in))
        return diag_error(d, "'%s' outside a loop", w->text);
    if (!reader_at_end(r))
        return diag_error(d, "%s takes no argument", w->text);
    in->loop = in->check.on ? LOOP_NONE : request;
    return SARCINA_OK;
}

static int dispatch(interp *in, reader *r, diag *d) {
    word w;
    bool unknown = false;
    int status = reader_peek(r, &w, d);
    if (status || !w.text || w.unknown)
        return status;
    size_t at = r->at;
    reader_take(r, &w);
    if (strcmp(w.text, "if") == 0)
        status = execute_one_line_if(in, r, d);
    else if (strcmp(w.text, "break") == 0 || strcmp(w.text, "continue") == 0)
        status = request_loop(in, r, *w.text == 'b' ? LOOP_BREAK : LOOP_CONTINUE, &w, d);
    else if (w.quote || !is_command(in, w.text))
        status = refuse_command(in, r, &w, d);
    else {
        r->at = at;
        const signature *form = args_read_form(in, r, &unknown, d);
        if (!form)
            return unknown ? SARCINA_OK : SARCINA_ERROR;
        status = run_form(in, form, r, d);
    }
    if (status)
        diag_place(d, reader_word_span(r, &w));
    return status;
}

static void echo(interp *in, const piece *line) {
    if (in->check.on)
        return;
    if (in->echo == ECHO_SCREEN || in->echo == ECHO_BOTH)
        interp_screen(in, "%s", line->chars);
    if (in->echo == ECHO_LOG || in->echo == ECHO_BOTH)
        interp_log(in, "%s", line->chars);
}

int execute_command(interp *in, const piece *line, diag *d) {
    diag own = {0};
    reader r;
    span before = in->at;
    echo(in, line);
    in->at = piece_span(line, 0, line->n);
    in->noted = false;
    reader_open(&r, in, line);
    in->commands++;
    int status = dispatch(in, &r, &own);
    in->commands--;
    if (status) {
        own.status = (sarcina_status)status;
        execute_note(in, &r, &own);
    }
    reader_close(&r);
    in->at = before;
    if (d && status)
        *d = own;
    return status;
}

/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Blocks: conditions and bodies are read anew at every pass. */
#include "base/alloc.h"
#include "base/number.h"
#include "script/execute.h"
#include "script/names.h"
#include "script/state.h"
#include "script/text.h"

#include <limits.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

/* ---- conditions ---- */

/* An error when something stands behind a condition or count. */
static int expect_end(reader *r, diag *d) {
    word w;
    int status = reader_peek(r, &w, d);
    if (status || !w.text)
        return status;
    diag_error(d, "unexpected '%s' behind the condition", w.text);
    if (strcmp(w.text, "and") == 0 || strcmp(w.text, "or") == 0)
        diag_help(d, "write && for and, || for or");
    diag_place(d, reader_word_span(r, &w));
    return SARCINA_ERROR;
}

static int read_truth(interp *in, reader *r, bool *holds, diag *d) {
    expr_type type;
    expr *e = expr_read(r, EXPR_LONGEST, d);
    int status = e ? expr_check(in, e, false, false, &type, d) : SARCINA_ERROR;
    if (!status && !in->check.on)
        status = interp_truth(in, e, holds, d);
    expr_free(e);
    return status;
}

/* The condition of `if`, `elif`, `while`. */
static int condition(interp *in, const piece *line, bool *holds, diag *d) {
    reader r;
    word w;
    reader_open(&r, in, line);
    int status = reader_peek(&r, &w, d);
    reader_take(&r, &w);
    *holds = true;
    if (!status && reader_at_end(&r))
        status = diag_error(d, "%s needs a condition", w.text);
    if (!status)
        status = read_truth(in, &r, holds, d);
    if (!status)
        status = expect_end(&r, d);
    if (status) {
        diag_place(d, reader_word_span(&r, &w));
        execute_note(in, &r, d);
    }
    reader_close(&r);
    return status;
}

/* ---- if ---- */

static bool is_else(const statement *s) {
    return strncmp(s->line.chars, "else", 4) == 0;
}

/* As far as a check can know: conditions of variables are as they will be. */
static bool likely(interp *in, const piece *line) {
    reader r;
    word w;
    expr_type type;
    bool holds = false;
    reader_open(&r, in, line);
    if (reader_peek(&r, &w, NULL) == SARCINA_OK) {
        reader_take(&r, &w);
        expr *e = expr_read(&r, EXPR_LONGEST, NULL);
        if (!e || expr_check(in, e, false, false, &type, NULL) || interp_truth(in, e, &holds, NULL))
            holds = false;
        expr_free(e);
    }
    reader_close(&r);
    return holds;
}

/* In a check all branches are gone through. */
static int check_branches(interp *in, const statement *s, diag *d) {
    double passes = in->check.passes, left = passes;
    in->check.branch++;
    for (; s; s = s->next) {
        bool holds;
        *d = (diag){0};
        if (!is_else(s) && condition(in, &s->line, &holds, d) != SARCINA_OK)
            execute_report(in, d);
        in->check.passes = left > 0 && (is_else(s) || likely(in, &s->line)) ? left : 0;
        left = in->check.passes > 0 ? 0 : left;
        execute_block(in, &s->body, d);
    }
    in->check.passes = passes;
    in->check.branch--;
    return SARCINA_OK;
}

static int run_if(interp *in, const statement *s, diag *d) {
    if (in->check.on)
        return check_branches(in, s, d);
    for (; s; s = s->next) {
        bool holds = true;
        int status = is_else(s) ? SARCINA_OK : condition(in, &s->line, &holds, d);
        if (status)
            return status;
        if (holds)
            return execute_block(in, &s->body, d);
    }
    return SARCINA_OK;
}

/* ---- loops ---- */

static bool is_interrupted(const interp *in) {
    return in->host->interrupt && *in->host->interrupt;
}

/* One pass of a body; *stop: the loop ends. */
static int pass(interp *in, const statement *s, bool *stop, diag *d) {
    if (is_interrupted(in)) {
        diag_fail(d, SARCINA_INTERRUPTED, "interrupted");
        diag_place(d, piece_span(&s->line, 0, s->line.n));
        return SARCINA_INTERRUPTED;
    }
    int status = execute_block(in, &s->body, d);
    *stop = in->quit || in->loop == LOOP_BREAK || in->check.on;
    in->loop = LOOP_NONE;
    return status;
}

static int run_while(interp *in, const statement *s, diag *d) {
    bool holds, stop = false;
    int status = condition(in, &s->line, &holds, d);
    while (!status && holds && !stop) {
        status = pass(in, s, &stop, d);
        stop = stop || in->host->skip_runs; /* what nothing grows may never come true */
        if (!status && !stop)
            status = condition(in, &s->line, &holds, d);
    }
    return status;
}

static int run_repeat(interp *in, const statement *s, diag *d) {
    reader r;
    word w;
    units_value v = {0};
    reader_open(&r, in, &s->line);
    int status = reader_peek(&r, &w, d);
    reader_take(&r, &w);
    if (!status)
        status = reader_peek(&r, &w, d);
    bool number = !status && w.text && !w.unknown && units_read(in->host->units, w.text, w.n, &v, NULL) == SARCINA_OK &&
                  !v.has_unit;
    bool whole = number && v.si >= 0 && v.si < 9e15 && v.si == (double)(uint64_t)v.si;
    if (!status && !whole && !w.unknown)
        status = diag_error(d, "repeat takes a whole number of passes%s%s%s", w.text ? ", not '" : "",
                            w.text ? w.text : "", w.text ? "'" : "");
    reader_take(&r, &w);
    if (!status)
        status = expect_end(&r, d);
    if (status) {
        diag_place(d, reader_word_span(&r, &w));
        execute_note(in, &r, d);
    }
    reader_close(&r);
    bool stop = false;
    uint64_t n = in->check.on ? 1 : (uint64_t)v.si;
    double passes = in->check.passes;
    in->check.passes *= v.si;
    for (uint64_t i = 0; i < n && !stop && !status; i++) {
        snprintf(in->stack[in->depth - 1].detail, sizeof in->stack->detail, "pass %llu", (unsigned long long)i + 1);
        status = pass(in, s, &stop, d);
    }
    in->check.passes = passes;
    return status;
}

/* What a for goes through: words, or a range. */
typedef struct sequence {
    char *name;
    char **words;
    size_t n, capacity;
    bool is_range;
    long long from, to, step;
} sequence;

static void sequence_free(sequence *q) {
    free(q->name);
    for (size_t i = 0; i < q->n; i++)
        free(q->words[i]);
    free(q->words);
}

/* A..B[..STEP], whole numbers. */
static bool parse_range(const char *text, sequence *q) {
    char *end;
    q->from = strtoll(text, &end, 10);
    if (end == text || strncmp(end, "..", 2) != 0)
        return false;
    text = end + 2;
    q->to = strtoll(text, &end, 10);
    if (end == text)
        return false;
    q->step = 1;
    if (*end) {
        text = end + 2;
        if (strncmp(end, "..", 2) != 0)
            return false;
        q->step = strtoll(text, &end, 10);
        if (end == text || *end || q->step == 0)
            return false;
    }
    q->is_range = true;
    return true;
}

static bool looks_like_range(const char *text) {
    size_t sign = strspn(text, "+-");
    return strstr(text, "..") && text[sign] >= '0' && text[sign] <= '9';
}

static int read_items(reader *r, sequence *q, diag *d) {
    word w;
    int status;
    while (!(status = reader_peek(r, &w, d)) && w.text) {
        if (!w.quote && !w.unknown && looks_like_range(w.text) && !parse_range(w.text, q)) {
            diag_error(d, "'%s' is no range: A..B or A..B..STEP, whole numbers", w.text);
            diag_place(d, reader_word_span(r, &w));
            return SARCINA_ERROR;
        }
        reader_take(r, &w);
        q->words = alloc_grow(q->words, &q->capacity, q->n + 1, sizeof *q->words);
        q->words[q->n++] = alloc_copy(w.text);
        if (w.unknown)
            q->is_range = false;
    }
    if (!status && q->is_range && q->n > 1)
        status = diag_error(d, "for takes one range, or words");
    return status;
}

/* for NAME in ... */
static int read_for(interp *in, reader *r, sequence *q, diag *d) {
    word w;
    int status = reader_peek(r, &w, d);
    reader_take(r, &w);
    if (!status)
        status = reader_peek(r, &w, d);
    if (status)
        return status;
    if (!w.text)
        return diag_error(d, "for needs a name: for i in 1..3");
    if (!variables_find(&in->variables, w.text) && names_check_new(in, NULL, w.text, d) != SARCINA_OK) {
        diag_place(d, reader_word_span(r, &w));
        return SARCINA_ERROR;
    }
    q->name = alloc_copy(w.text);
    reader_take(r, &w);
    status = reader_peek(r, &w, d);
    if (!status && (!w.text || strcmp(w.text, "in") != 0)) {
        diag_error(d, "for: expected in, not '%s'", w.text ? w.text : "");
        diag_place(d, reader_word_span(r, &w));
        return SARCINA_ERROR;
    }
    reader_take(r, &w);
    return status ? status : read_items(r, q, d);
}

static int for_pass(interp *in, const statement *s, const sequence *q, const char *text, bool *stop, diag *d) {
    variable *old = variables_find(&in->variables, q->name);
    bool command_line = old && old->command_line, read = old && old->read;
    variables_set_text(&in->variables, q->name, text);
    variable *v = variables_find(&in->variables, q->name);
    v->command_line = command_line;
    v->read = read;
    snprintf(in->stack[in->depth - 1].detail, sizeof in->stack->detail, "%.30s = %.40s", q->name, text);
    return pass(in, s, stop, d);
}

static int run_for(interp *in, const statement *s, diag *d) {
    reader r;
    sequence q = {0};
    reader_open(&r, in, &s->line);
    int status = read_for(in, &r, &q, d);
    if (status) {
        diag_place(d, piece_span(&s->line, 0, 3));
        execute_note(in, &r, d);
    }
    reader_close(&r);
    bool stop = false;
    size_t passes = q.is_range ? SIZE_MAX : q.n;
    double checked = in->check.passes;
    in->check.passes *= q.is_range ? fmax(0, 1 + floor((double)(q.to - q.from) / (double)q.step)) : (double)q.n;
    for (size_t i = 0; i < passes && !stop && !status; i++) {
        char number[32];
        long long x = q.from + (long long)i * q.step;
        bool over = q.is_range && (q.step > 0 ? x > q.to : x < q.to);
        if (over && !(in->check.on && i == 0))
            break;
        snprintf(number, sizeof number, "%lld", x);
        status = for_pass(in, s, &q, q.is_range ? number : q.words[i], &stop, d);
    }
    in->check.passes = checked;
    sequence_free(&q);
    return status;
}

/* ---- the one-line if ---- */

/* Behind `then`, or an elif's condition: texts up to the next keyword. They run when chosen; in a check all are gone
 * through. */
static int run_texts(interp *in, reader *r, bool chosen, diag *d) {
    word w;
    size_t n = 0;
    int status;
    while (!(status = reader_peek_raw(r, &w, d)) && w.text) {
        bool keyword = !w.quote && (strcmp(w.text, "elif") == 0 || strcmp(w.text, "else") == 0);
        if (keyword)
            break;
        n++;
        reader_take(r, &w);
        piece text = piece_slice(&r->text, w.from + w.quote, w.to - w.quote);
        command_text *t = text_create(&text);
        if (in->check.on)
            status = text_check(in, t, d);
        else if (chosen && in->loop == LOOP_NONE && !in->quit)
            status = interp_run_text(in, t, d);
        interp_free_text(t);
        if (status)
            return status;
    }
    if (!status && n == 0)
        status = diag_error(d, "a branch of the one-line if needs a command in quotes");
    return status;
}

static int take_word(reader *r, const char *text, bool *there, diag *d) {
    word w;
    int status = reader_peek_raw(r, &w, d);
    *there = !status && w.text && !w.quote && strcmp(w.text, text) == 0;
    if (*there)
        reader_take(r, &w);
    return status;
}

int execute_one_line_if(interp *in, reader *r, diag *d) {
    bool holds = true, done = false, there;
    int status = read_truth(in, r, &holds, d);
    if (!status)
        status = take_word(r, "then", &there, d);
    if (!status && !there)
        status = expect_end(r, d);
    if (!status)
        status = run_texts(in, r, holds, d);
    done = holds;
    while (!status && !reader_at_end(r)) {
        status = take_word(r, "elif", &there, d);
        if (!status && there) {
            status = read_truth(in, r, &holds, d);
            if (!status)
                status = run_texts(in, r, holds && !done, d);
            done = done || holds;
            continue;
        }
        if (!status)
            status = take_word(r, "else", &there, d);
        if (!status)
            return run_texts(in, r, !done, d);
    }
    return status;
}

/* ---- statements ---- */

static int run_statement(interp *in, const statement *s, diag *d) {
    static const char *const kinds[] = {"command", "if", "for", "while", "repeat"};
    if (s->kind == STATEMENT_COMMAND) {
        if (s->commented && !in->check.on) {
            in->at = piece_span(&s->line, 0, s->line.n);
            interp_warn(in, "a comment behind &: the line goes on");
        }
        return execute_command(in, &s->line, d);
    }
    if (s->kind == STATEMENT_IF)
        return run_if(in, s, d);
    span at = piece_span(&s->line, 0, s->line.n);
    int status = execute_push(in, kinds[s->kind], at, NULL, d);
    if (status)
        return status;
    status = s->kind == STATEMENT_FOR     ? run_for(in, s, d)
             : s->kind == STATEMENT_WHILE ? run_while(in, s, d)
                                          : run_repeat(in, s, d);
    execute_pop(in);
    if (!in->check.on && !interp_in_loop(in) && in->host->commands->client_loop_end)
        in->host->commands->client_loop_end(in);
    return status;
}

int execute_block(interp *in, const block *b, diag *d) {
    diag own;
    for (size_t i = 0; i < b->count; i++) {
        own = (diag){0};
        int status = run_statement(in, &b->list[i], &own);
        if (status && in->check.on) {
            execute_report(in, &own);
        } else if (status) {
            if (d)
                *d = own;
            return status;
        }
        if (in->quit || in->loop != LOOP_NONE)
            break;
    }
    return SARCINA_OK;
}

/* ---- sources ---- */

/* The first fault of a structure, or in a check every one. */
typedef struct faults {
    interp *in;
    diag first;
} faults;

static void take_fault(void *self, const diag *d) {
    faults *f = self;
    if (f->in->check.on)
        execute_report(f->in, d);
    else if (!f->first.status)
        f->first = *d;
}

int execute_source(interp *in, source *s, const char *kind, diag *d) {
    block b = {0};
    faults f = {.in = in};
    int status = execute_push(in, kind, kind && strcmp(kind, "include") == 0 ? in->at : (span){0}, s, d);
    if (status)
        return status;
    piece script = piece_of_source(s);
    block_parse(&script, &b, take_fault, &f);
    piece_free(&script);
    if (f.first.status) {
        if (d)
            *d = f.first;
        execute_note(in, NULL, d);
        status = f.first.status;
    } else {
        status = execute_block(in, &b, d);
    }
    block_free(&b);
    execute_pop(in);
    return status;
}

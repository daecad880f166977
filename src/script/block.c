/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "script/block.h"

#include "base/alloc.h"
#include "script/line.h"

#include <stdlib.h>
#include <string.h>

typedef struct parser {
    const piece *script;
    size_t at;
    size_t errors;
    bool open; /* a block, quote or continued line was cut by the end of the text */
    block_report report;
    void *self;
} parser;

static void report(parser *p, diag *d) {
    p->errors++;
    if (p->report)
        p->report(p->self, d);
}

/* Whether the line's first word is this one. */
static bool begins(const piece *line, const char *word) {
    size_t n = strlen(word);
    return line->n >= n && strncmp(line->chars, word, n) == 0 && (line->n == n || line_is_blank(line->chars[n]));
}

/* Index behind the word or quoted stretch at i. */
static size_t skip_word(const piece *line, size_t i) {
    size_t depth = 0;
    while (i < line->n && (depth || !line_is_blank(line->chars[i]))) {
        size_t quote = line_quote(line->chars, 0, i);
        size_t end = quote ? line_quote_end(line, i, quote) : i + 1;
        if (!quote && line->chars[i] == '(')
            depth++;
        if (!quote && line->chars[i] == ')' && depth)
            depth--;
        i = end == (size_t)-1 ? line->n : end;
    }
    return i;
}

static size_t skip_blanks(const piece *line, size_t i) {
    while (i < line->n && line_is_blank(line->chars[i]))
        i++;
    return i;
}

/* Index of the bare word `then`; (size_t)-1: there is none. */
static size_t find_then(const piece *line) {
    for (size_t i = skip_blanks(line, 0); i < line->n;) {
        size_t end = skip_word(line, i);
        if (end - i == 4 && strncmp(line->chars + i, "then", 4) == 0)
            return i;
        i = skip_blanks(line, end > i ? end : i + 1);
    }
    return (size_t)-1;
}

static statement_kind kind_of(const piece *line) {
    if (begins(line, "if")) {
        size_t then = find_then(line);
        bool one_line = then != (size_t)-1 && skip_blanks(line, then + 4) < line->n;
        return one_line ? STATEMENT_COMMAND : STATEMENT_IF;
    }
    return begins(line, "for")      ? STATEMENT_FOR
           : begins(line, "while")  ? STATEMENT_WHILE
           : begins(line, "repeat") ? STATEMENT_REPEAT
                                    : STATEMENT_COMMAND;
}

static const char *const kind_names[] = {"", "if", "for", "while", "repeat"};

static statement *append(block *b) {
    b->list = alloc_grow(b->list, &b->capacity, b->count + 1, sizeof *b->list);
    b->list[b->count] = (statement){0};
    return &b->list[b->count++];
}

static void parse_block(parser *p, block *out, piece *closer);

/* `then` at the end of a block's line. */
static void refuse_then(parser *p, const piece *line) {
    size_t then = find_then(line);
    if (then == (size_t)-1)
        return;
    diag d = {0};
    diag_error(&d, "unexpected 'then'; the block form has no then");
    diag_place(&d, piece_span(line, then, then + 4));
    diag_help(&d, "if CONDITION, the commands on lines of their own, and end");
    report(p, &d);
}

/* "end" may repeat the word of the block it closes. */
static void check_end(parser *p, const piece *end, statement_kind kind) {
    size_t i = skip_blanks(end, 3);
    const char *name = kind_names[kind];
    if (i == end->n || strcmp(end->chars + i, name) == 0)
        return;
    diag d = {0};
    diag_error(&d, "'%.60s' closes a '%s'", end->chars, name);
    diag_place(&d, piece_span(end, i, end->n));
    report(p, &d);
}

/* "else if" is read as elif, but said to be wrong. */
static bool is_else_if(parser *p, const piece *line) {
    size_t i = skip_blanks(line, 4);
    if (i == line->n)
        return false;
    diag d = {0};
    if (strncmp(line->chars + i, "if", 2) == 0)
        diag_error(&d, "'else if' opens a block of its own; write elif");
    else
        diag_error(&d, "unexpected '%.60s' after else", line->chars + i);
    diag_place(&d, piece_span(line, i, line->n));
    report(p, &d);
    return true;
}

/* Reads the body of s and, of an if, the branches that follow. */
static void parse_bodies(parser *p, statement *s) {
    statement_kind kind = s->kind;
    span opening = piece_span(&s->line, 0, strlen(kind_names[kind]));
    bool has_else = false;
    for (;;) {
        piece closer = {0};
        parse_block(p, &s->body, &closer);
        if (closer.n == 0) {
            diag d = {0};
            diag_error(&d, "this '%s' has no end", kind_names[kind]);
            diag_place(&d, opening);
            report(p, &d);
            p->open = true;
            piece_free(&closer);
            return;
        }
        if (begins(&closer, "end")) {
            check_end(p, &closer, kind);
            piece_free(&closer);
            return;
        }
        if (kind != STATEMENT_IF || has_else) {
            diag d = {0};
            diag_error(&d, "'%.4s' without an if before it", closer.chars);
            diag_place(&d, piece_span(&closer, 0, 4));
            report(p, &d);
        }
        has_else = has_else || (begins(&closer, "else") && !is_else_if(p, &closer));
        if (begins(&closer, "elif"))
            refuse_then(p, &closer);
        s->next = alloc_zeroed(1, sizeof *s->next);
        s = s->next;
        s->kind = kind;
        s->line = closer;
    }
}

static bool is_closer(const piece *line) {
    return begins(line, "end") || begins(line, "elif") || begins(line, "else");
}

/* Reads statements up to the end of the text or a line that closes the block, which goes to *closer. */
static void parse_block(parser *p, block *out, piece *closer) {
    for (;;) {
        diag d = {0};
        piece line = {0};
        line_notes notes;
        if (line_next(p->script, &p->at, &line, &notes, &d) != SARCINA_OK) {
            p->open = p->open || notes.open;
            report(p, &d);
            piece_free(&line);
            continue;
        }
        p->open = p->open || notes.cut;
        if (line.n == 0 || is_closer(&line)) {
            *closer = line;
            return;
        }
        statement_kind kind = kind_of(&line);
        if (kind == STATEMENT_IF)
            refuse_then(p, &line);
        statement *s = append(out);
        s->kind = kind;
        s->line = line;
        s->commented = notes.commented;
        if (kind != STATEMENT_COMMAND) {
            statement whole = *s; /* the list may move while the bodies are read */
            size_t row = out->count - 1;
            parse_bodies(p, &whole);
            out->list[row] = whole;
        }
    }
}

size_t block_parse(const piece *script, block *out, block_report report_to, void *self) {
    parser p = {.script = script, .report = report_to, .self = self};
    for (;;) {
        piece closer = {0};
        parse_block(&p, out, &closer);
        if (closer.n == 0) {
            piece_free(&closer);
            return p.errors;
        }
        diag d = {0};
        size_t n = skip_word(&closer, 0);
        diag_error(&d, "'%.*s' without a block", (int)n, closer.chars);
        diag_place(&d, piece_span(&closer, 0, n));
        report(&p, &d);
        piece_free(&closer);
    }
}

static void statement_free(statement *s) {
    piece_free(&s->line);
    block_free(&s->body);
    if (s->next) {
        statement_free(s->next);
        free(s->next);
    }
}

void block_free(block *b) {
    for (size_t i = 0; i < b->count; i++)
        statement_free(&b->list[i]);
    free(b->list);
    *b = (block){0};
}

bool block_is_open(const char *text) {
    source *s = source_of_text("", text);
    piece script = piece_of_source(s);
    block b = {0};
    parser p = {.script = &script};
    piece closer = {0};
    parse_block(&p, &b, &closer);
    bool open = p.open;
    piece_free(&closer);
    block_free(&b);
    piece_free(&script);
    source_free(s);
    return open;
}

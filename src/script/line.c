/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "script/line.h"

#include <ctype.h>
#include <string.h>

bool line_is_blank(char c) {
    return c == ' ' || c == '\t' || c == '\r' || c == '\n';
}

/* A quote behind one of these belongs to a word: don't, f', a"b. */
static bool is_word_end(char c) {
    return isalnum((unsigned char)c) || c == '_' || c == ')' || c == ']' || c == '}' || c == '.' || c == '"' ||
           c == '\'' || (unsigned char)c >= 0x80;
}

size_t line_quote(const char *chars, size_t start, size_t i) {
    char c = chars[i];
    if (c != '"' && c != '\'')
        return 0;
    if (i > start && is_word_end(chars[i - 1]))
        return 0;
    return c == '"' && chars[i + 1] == '"' && chars[i + 2] == '"' ? 3 : 1;
}

size_t line_quote_end(const piece *p, size_t i, size_t quote) {
    for (size_t k = i + quote; k + quote <= p->n; k++)
        if (!piece_is_replaced(p, k) && strncmp(p->chars + k, p->chars + i, quote) == 0)
            return k + quote;
    return (size_t)-1;
}

/* One physical line being read. */
typedef struct scan {
    const piece *script;
    size_t at, start; /* where the reading stands; where this physical line began */
    bool comment;     /* it had one */
} scan;

static size_t line_end(const piece *script, size_t at) {
    const char *end = memchr(script->chars + at, '\n', script->n - at);
    return end ? (size_t)(end - script->chars) : script->n;
}

/* Copies the quoted stretch at s->at; an error leaves s->at behind the line it began in. */
static int scan_quote(scan *s, size_t quote, piece *line, bool *open, diag *d) {
    size_t end = line_quote_end(s->script, s->at, quote), stop = line_end(s->script, s->at);
    if (end == (size_t)-1 || (quote == 1 && end > stop)) {
        diag_error(d, "the quote is not closed");
        diag_place(d, piece_span(s->script, s->at, s->at + quote));
        diag_help(d, quote == 3 ? "\"\"\" closes it" : "only \"\"\" ... \"\"\" goes over several lines");
        s->at = quote == 3 ? s->script->n : stop;
        *open = quote == 3;
        return SARCINA_ERROR;
    }
    piece_append(line, s->script, s->at, end);
    s->at = end;
    return SARCINA_OK;
}

/* Copies one physical line without comment and trailing blanks; s->at is then at its end. */
static int scan_physical(scan *s, piece *line, line_notes *notes, diag *d) {
    const char *chars = s->script->chars;
    s->start = s->at;
    s->comment = false;
    while (s->at < s->script->n && chars[s->at] != '\n') {
        size_t quote = line_quote(chars, s->start, s->at);
        if (quote) {
            if (scan_quote(s, quote, line, &notes->open, d) != SARCINA_OK)
                return SARCINA_ERROR;
        } else if (chars[s->at] == '#') {
            s->comment = true;
            s->at = line_end(s->script, s->at);
        } else {
            piece_append(line, s->script, s->at, s->at + 1);
            s->at++;
        }
    }
    return SARCINA_OK;
}

static void trim_end(piece *line, size_t from) {
    while (line->n > from && line_is_blank(line->chars[line->n - 1]))
        line->chars[--line->n] = '\0';
}

/* Takes a single `&` off the end of the line; && stays. Whether the next physical line belongs to this one. */
static bool take_continuation(piece *line, size_t from) {
    size_t n = line->n;
    if (n == from || line->chars[n - 1] != '&')
        return false;
    if (n < 2 || line->chars[n - 2] != '&')
        line->chars[n - 1] = ' ';
    return true;
}

/* One logical line from s->at; may come out empty. */
static int scan_logical(scan *s, piece *line, line_notes *notes, diag *d) {
    bool goes_on = false;
    do {
        size_t from = line->n;
        if (scan_physical(s, line, notes, d) != SARCINA_OK)
            return SARCINA_ERROR;
        trim_end(line, from);
        bool only_comment = line->n == from && s->comment;
        bool more = take_continuation(line, from);
        if (more && s->comment)
            notes->commented = true;
        goes_on = more || (goes_on && only_comment);
        if (s->at < s->script->n)
            s->at++; /* the line's end */
        if (goes_on && line->n)
            piece_push(line, ' ', line->marks[line->n - 1]);
    } while (goes_on && s->at < s->script->n);
    notes->cut = goes_on;
    trim_end(line, 0);
    return SARCINA_OK;
}

int line_next(const piece *script, size_t *at, piece *line, line_notes *notes, diag *d) {
    scan s = {script, *at, *at, false};
    *notes = (line_notes){0};
    line->source = script->source;
    int status = SARCINA_OK;
    while (s.at < script->n && line->n == 0 && status == SARCINA_OK)
        status = scan_logical(&s, line, notes, d);
    *at = s.at < script->n && status != SARCINA_OK ? s.at + 1 : s.at;
    size_t blanks = 0;
    while (blanks < line->n && line_is_blank(line->chars[blanks]))
        blanks++;
    if (blanks)
        piece_splice(line, 0, blanks, "", 0, (mark){0});
    return status;
}

/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "script/reader.h"

#include "base/alloc.h"
#include "script/expr.h"
#include "script/format.h"
#include "script/line.h"
#include "script/variables.h"

#include <ctype.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

void reader_open(reader *r, interp *in, const piece *line) {
    *r = (reader){.in = in, .text = piece_slice(line, 0, line->n)};
}

void reader_close(reader *r) {
    for (size_t i = 0; i < r->pooled; i++)
        free(r->pool[i]);
    free(r->pool);
    free(r->replaced);
    piece_free(&r->text);
    *r = (reader){0};
}

size_t reader_end(const reader *r) {
    return r->text.n - r->tail;
}

span reader_span(const reader *r, size_t from, size_t to) {
    return piece_span(&r->text, from, to);
}

span reader_word_span(const reader *r, const word *w) {
    return reader_span(r, w->from, w->to);
}

const char *reader_keep(reader *r, const char *text, size_t n) {
    r->pool = alloc_grow(r->pool, &r->pool_capacity, r->pooled + 1, sizeof *r->pool);
    return r->pool[r->pooled++] = alloc_copy_n(text, n);
}

static void skip_blanks(reader *r) {
    while (r->at < reader_end(r) && line_is_blank(r->text.chars[r->at]))
        r->at++;
}

bool reader_at_end(reader *r) {
    skip_blanks(r);
    return r->at >= reader_end(r);
}

/* ---- $ ---- */

/* An error about the stretch [from, to). */
static int refuse(const reader *r, size_t from, size_t to, diag *d) {
    diag_place(d, reader_span(r, from, to));
    return SARCINA_ERROR;
}

/* Puts text, owned here, in place of [from, to). */
static int put(reader *r, size_t from, size_t to, char *text, const replacement *note) {
    mark m = r->text.marks[from];
    m.length = reader_span(r, from, to).length;
    r->replaced = alloc_grow(r->replaced, &r->capacity, r->count + 1, sizeof *r->replaced);
    r->replaced[r->count++] = *note;
    m.serial = (uint32_t)r->count;
    const char *chars = note->unknown ? "?" : text;
    piece_splice(&r->text, from, to, chars, strlen(chars), m);
    free(text);
    return SARCINA_OK;
}

static int replace_name(reader *r, size_t from, size_t to, size_t name, size_t n, diag *d) {
    char *text = NULL;
    replacement note = {0};
    const char *key = reader_keep(r, r->text.chars + name, n);
    if (variables_expand(r->in, key, &text, &note, d) != SARCINA_OK)
        return refuse(r, from, to, d);
    return put(r, from, to, text, &note);
}

static bool is_name(char c) {
    return isalnum((unsigned char)c) || c == '_';
}

/* $x: one letter, and nothing behind it that would make a longer name. */
static int replace_letter(reader *r, size_t i, diag *d) {
    size_t to = i + 2;
    if (!is_name(r->text.chars[to]) || piece_is_replaced(&r->text, to))
        return replace_name(r, i, to, i + 1, 1, d);
    while (is_name(r->text.chars[to]))
        to++;
    int n = (int)(to - i - 1);
    const char *name = r->text.chars + i + 1;
    char letter[2] = {*name, 0};
    char *text = NULL;
    replacement note;
    if (variables_expand(r->in, letter, &text, &note, NULL) == SARCINA_OK)
        diag_error(d, "'$%.*s' may be two things: write ${%.*s}, or ${%s} followed by '%.*s'", n, name, n, name, letter,
                   n - 1, name + 1);
    else
        diag_error(d, "'$%.*s' would be '$%s' and '%.*s': write ${%.*s}", n, name, letter, n - 1, name + 1, n, name);
    free(text);
    return refuse(r, i, to, d);
}

static int replace_braces(reader *r, size_t i, diag *d) {
    size_t from = i + 2, to = from;
    while (to < reader_end(r) && is_name(r->text.chars[to]))
        to++;
    if (to < reader_end(r) && to > from && r->text.chars[to] == '}')
        return replace_name(r, i, to + 1, from, to - from, d);
    diag_error(d, "'${' must be followed by a name and '}'; an expression stands in $( )");
    return refuse(r, i, to, d);
}

/* Index of the ')' behind a format, or of the end. */
static size_t format_end(const reader *r, size_t i) {
    while (i < reader_end(r) && r->text.chars[i] != ')')
        i++;
    return i;
}

/* Reads ")" or ":FORMAT)" at r->at. *format: NULL without one. */
static int read_format(reader *r, const char **format, diag *d) {
    *format = NULL;
    skip_blanks(r);
    size_t end = format_end(r, r->at);
    if (r->at < reader_end(r) && r->text.chars[r->at] == ':' && end < reader_end(r)) {
        *format = reader_keep(r, r->text.chars + r->at + 1, end - r->at - 1);
        if (!format_is_valid(*format)) {
            diag_error(d, "'%s' is not one number format: %%.3f, %%d, %%e, %%g", *format);
            return refuse(r, r->at + 1, end, d);
        }
        r->at = end;
    }
    if (r->at < reader_end(r) && r->text.chars[r->at] == ')') {
        r->at++;
        return SARCINA_OK;
    }
    word w = {.from = r->at, .to = r->at};
    while (w.to < reader_end(r) && !line_is_blank(r->text.chars[w.to]) && r->text.chars[w.to] != ')')
        w.to++;
    int n = (int)(w.to - w.from);
    if (n == 0)
        diag_error(d, "expected ')' at the end of $(");
    else
        diag_error(d, "expected ')', not '%.*s'", n, r->text.chars + w.from);
    if (n >= 2 && (strncmp(r->text.chars + w.from, "and", 3) == 0 || strncmp(r->text.chars + w.from, "or", 2) == 0))
        diag_help(d, "write && for and, || for or");
    else if (n >= 2 && r->text.chars[w.from] == '.' && isalpha((unsigned char)r->text.chars[w.from + 1]))
        diag_help(d, "a number of an expression takes one unit: 2N.m is 2N*1m there");
    return refuse(r, w.from, w.to, d);
}

static int replace_expression(reader *r, size_t i, diag *d) {
    size_t at = r->at;
    r->at = i + 2;
    const char *format;
    expr *e = expr_read(r, EXPR_OPEN, d);
    int status = e ? read_format(r, &format, d) : SARCINA_ERROR;
    size_t end = r->at;
    r->at = at;
    if (status == SARCINA_OK) {
        replacement note = {0};
        char *text = expr_print(r->in, e, format, &note, d);
        status = text ? put(r, i, end, text, &note) : SARCINA_ERROR;
    }
    expr_free(e);
    return status;
}

int reader_replace(reader *r, size_t i, diag *d) {
    char c = r->text.chars[i + 1];
    if (i + 1 < reader_end(r)) {
        if (c == '$')
            return put(r, i, i + 2, alloc_copy("$"), &(replacement){0});
        if (c == '{')
            return replace_braces(r, i, d);
        if (c == '(')
            return replace_expression(r, i, d);
        if (isalpha((unsigned char)c))
            return replace_letter(r, i, d);
    }
    diag_error(d, "'$' must begin $x, ${name} or $(expression); $$ is a dollar sign");
    return refuse(r, i, i + 1, d);
}

static bool is_dollar(const reader *r, size_t i) {
    return r->text.chars[i] == '$' && !piece_is_replaced(&r->text, i);
}

/* ---- words ---- */

/* Letters outside ASCII that numbers with units may hold: µ μ · superscripts °. */
static bool is_unit_letter(const char *c) {
    static const char *const letters[] = {"\xc2\xb5", "\xce\xbc", "\xc2\xb7", "\xc2\xb2",
                                          "\xc2\xb3", "\xc2\xb9", "\xe2\x81", "\xc2\xb0"};
    for (size_t i = 0; i < sizeof letters / sizeof *letters; i++)
        if (strncmp(c, letters[i], strlen(letters[i])) == 0)
            return true;
    return false;
}

static const struct {
    unsigned long code;
    const char *ascii;
} look_alikes[] = {
    {0x2013, "-"},  {0x2014, "-"},     {0x2212, "-"}, {0x2018, "'"},   {0x2019, "'"},  {0x201c, "\""},
    {0x201d, "\""}, {0xa0, "a blank"}, {0xd7, "*"},   {0x2026, "..."}, {0x2264, "<="}, {0x2265, ">="},
};

/* Code point of the character at c and its length; length 1 for a broken sequence. */
static unsigned long decode(const char *c, size_t *length) {
    const unsigned char *u = (const void *)c;
    size_t n = *u >= 0xf0 ? 4 : *u >= 0xe0 ? 3 : *u >= 0xc0 ? 2 : 1;
    unsigned long code = n == 1 ? *u : *u & (0x7fu >> n);
    for (size_t i = 1; i < n; i++) {
        if ((u[i] & 0xc0) != 0x80) {
            *length = 1;
            return *u;
        }
        code = code << 6 | (u[i] & 0x3f);
    }
    *length = n;
    return code;
}

int reader_check_ascii(const reader *r, size_t from, size_t to, diag *d) {
    for (size_t i = from; i < to; i++) {
        const char *c = r->text.chars + i;
        size_t length = 1;
        if ((unsigned char)*c < 0x80 || piece_is_replaced(&r->text, i))
            continue;
        unsigned long code = decode(c, &length);
        if (is_unit_letter(c)) {
            i += length - 1;
            continue;
        }
        diag_error(d, "'%.*s' (U+%04lX) may stand only in quotes and comments", (int)length, c, code);
        for (size_t k = 0; k < sizeof look_alikes / sizeof *look_alikes; k++)
            if (look_alikes[k].code == code)
                diag_help(d, "the character of the language is %s", look_alikes[k].ascii);
        return refuse(r, i, i + length, d);
    }
    return SARCINA_OK;
}

static void note_unknown(const reader *r, word *w) {
    for (size_t i = w->from + w->quote; i < w->to - w->quote; i++) {
        uint32_t serial = r->text.marks[i].serial;
        if (serial && r->replaced[serial - 1].unknown)
            w->unknown = &r->replaced[serial - 1];
    }
    w->only_unknown = w->unknown && w->to - w->from == 1;
}

/* Ends the word whose stretch is set. */
static void finish(reader *r, word *w) {
    w->n = w->to - w->from - 2 * w->quote;
    w->text = reader_keep(r, r->text.chars + w->from + w->quote, w->n);
    note_unknown(r, w);
}

static int read_quoted(reader *r, word *w, bool replace, diag *d) {
    size_t i = w->from + w->quote;
    for (;; i++) {
        if (i + w->quote > reader_end(r)) {
            diag_error(d, "the quote is not closed");
            return refuse(r, w->from, w->from + w->quote, d);
        }
        while (replace && i < reader_end(r) && is_dollar(r, i))
            if (reader_replace(r, i, d) != SARCINA_OK)
                return SARCINA_ERROR;
        if (!piece_is_replaced(&r->text, i) && strncmp(r->text.chars + i, r->text.chars + w->from, w->quote) == 0)
            break;
    }
    w->to = i + w->quote;
    if (w->to < reader_end(r) && !line_is_blank(r->text.chars[w->to])) {
        diag_error(d, "a closing quote must be followed by a blank");
        return refuse(r, w->to - w->quote, w->to + 1, d);
    }
    finish(r, w);
    return SARCINA_OK;
}

static int read_bare(reader *r, word *w, bool replace, diag *d) {
    size_t i = w->from;
    while (i < reader_end(r) && !line_is_blank(r->text.chars[i])) {
        if (replace && is_dollar(r, i)) {
            if (reader_replace(r, i, d) != SARCINA_OK)
                return SARCINA_ERROR;
        } else {
            i++;
        }
    }
    w->to = i;
    finish(r, w);
    return reader_check_ascii(r, w->from, w->to, d);
}

static int peek(reader *r, word *w, bool replace, diag *d) {
    for (;;) {
        *w = (word){0};
        bool end = reader_at_end(r);
        w->from = w->to = r->at;
        if (end)
            return SARCINA_OK;
        w->quote = piece_is_replaced(&r->text, r->at) ? 0 : line_quote(r->text.chars, r->at, r->at);
        int status = w->quote ? read_quoted(r, w, replace, d) : read_bare(r, w, replace, d);
        /* a $ may have been replaced by nothing: then there was no word */
        if (status != SARCINA_OK || w->to > w->from)
            return status;
    }
}

int reader_peek(reader *r, word *w, diag *d) {
    return peek(r, w, true, d);
}

int reader_peek_raw(reader *r, word *w, diag *d) {
    return peek(r, w, false, d);
}

void reader_take(reader *r, const word *w) {
    r->at = w->to;
}

int reader_rest(reader *r, word *w, diag *d) {
    *w = (word){0};
    bool end = reader_at_end(r);
    w->from = w->to = r->at;
    if (end)
        return SARCINA_OK;
    for (size_t i = r->at; i < reader_end(r);) {
        if (!is_dollar(r, i))
            i++;
        else if (reader_replace(r, i, d) != SARCINA_OK)
            return SARCINA_ERROR;
    }
    w->to = reader_end(r);
    finish(r, w);
    return SARCINA_OK;
}

/* ---- the line as text again ---- */

/* A quote that can stand around [from, to): one that is not in it. */
static const char *choose_quote(const reader *r, size_t from, size_t to) {
    static const char *const quotes[] = {"\"", "'", "\"\"\""};
    char *inside = alloc_copy_n(r->text.chars + from, to - from);
    bool many_lines = strchr(inside, '\n') != NULL;
    const char *chosen = quotes[2];
    for (size_t k = 0; k < 2 && !many_lines; k++)
        if (!strstr(inside, quotes[k])) {
            chosen = quotes[k];
            break;
        }
    free(inside);
    return chosen;
}

/* Whether a replaced character in [from, to) would read as a quote, a comment or a continuation. */
static bool needs_quotes(const reader *r, size_t from, size_t to) {
    for (size_t i = from; i < to; i++)
        if (piece_is_replaced(&r->text, i) &&
            (strchr("\"'#", r->text.chars[i]) || (r->text.chars[i] == '&' && i + 1 == r->text.n)))
            return true;
    return false;
}

/* Copies [from, to), a replaced $ as $$; returns the new length. */
static size_t copy_stretch(const reader *r, size_t from, size_t to, char *out, size_t n) {
    for (size_t i = from; i < to; i++) {
        if (r->text.chars[i] == '$' && piece_is_replaced(&r->text, i))
            out[n++] = '$';
        out[n++] = r->text.chars[i];
    }
    return n;
}

static size_t copy_quoted(const reader *r, size_t from, size_t to, char *out, size_t n) {
    const char *quote = choose_quote(r, from, to);
    n += (size_t)sprintf(out + n, "%s", quote);
    n = copy_stretch(r, from, to, out, n);
    return n + (size_t)sprintf(out + n, "%s", quote);
}

char *reader_text(const reader *r) {
    const piece *p = &r->text;
    char *out = alloc_zeroed(8 * p->n + 16, 1); /* quotes of three around every letter at worst */
    size_t n = 0;
    for (size_t i = 0; i < p->n;) {
        size_t quote = piece_is_replaced(p, i) ? 0 : line_quote(p->chars, 0, i), end = i;
        size_t closed = quote ? line_quote_end(p, i, quote) : (size_t)-1;
        if (closed != (size_t)-1) {
            bool clash = needs_quotes(r, i + quote, closed - quote);
            n = clash ? copy_quoted(r, i + quote, closed - quote, out, n) : copy_stretch(r, i, closed, out, n);
            i = closed;
            continue;
        }
        /* a bare stretch: to the blank behind it, or to a quote that stands in it as it was written */
        while (end < p->n && (end == i || piece_is_replaced(p, end) || !line_quote(p->chars, 0, end)) &&
               !line_is_blank(p->chars[end]))
            end++;
        end += end == i;
        n = needs_quotes(r, i, end) ? copy_quoted(r, i, end, out, n) : copy_stretch(r, i, end, out, n);
        i = end;
    }
    return out;
}

/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "script/complete.h"

#include "base/alloc.h"
#include "script/complete_part.h"
#include "script/execute.h"
#include "script/line.h"

#include <stdlib.h>
#include <string.h>

void complete_free(completions *c) {
    for (size_t i = 0; i < c->n; i++)
        free(c->list[i].text);
    free(c->list);
    *c = (completions){0};
}

void complete_part_offer(completing *c, const char *candidate, bool open) {
    const char *typed = c->text + c->from;
    completions *out = c->out;
    if (strncmp(candidate, typed, strlen(typed)) != 0)
        return;
    for (size_t i = 0; i < out->n; i++)
        if (strcmp(out->list[i].text, candidate) == 0)
            return;
    out->list = alloc_grow(out->list, &out->capacity, out->n + 1, sizeof *out->list);
    out->list[out->n++] = (completion){alloc_copy(candidate), open};
}

/* ---- the text up to the cursor ----------------------------------------------------------------------------------- */

enum { OPENERS_MAX = 64 };

/* The command that the cursor is in. */
typedef struct scan {
    const char *text;
    size_t n, at, start; /* start: of the physical line */
    complete_words words;
    const char *openers[OPENERS_MAX]; /* the blocks around it: "if", "for" ... */
    size_t depth;
    size_t from;  /* where the word at the cursor begins; n: a new one */
    size_t quote; /* length of the quote that is open there; 0: none */
    bool nowhere; /* in a comment, or right behind a closing quote */
} scan;

static void drop_words(complete_words *w) {
    for (size_t i = 0; i < w->n; i++)
        free(w->list[i]);
    w->n = 0;
}

static bool is(const complete_words *w, size_t i, const char *text) {
    return i < w->n && strcmp(w->list[i], text) == 0;
}

/* Whether words of a finished line open a block; the one-line if has a word behind its then. */
static const char *opens_block(const complete_words *w) {
    static const char *const loops[] = {"for", "while", "repeat"};
    for (size_t i = 0; i < sizeof loops / sizeof *loops; i++)
        if (is(w, 0, loops[i]))
            return loops[i];
    if (!is(w, 0, "if"))
        return NULL;
    for (size_t i = 1; i + 1 < w->n; i++)
        if (is(w, i, "then"))
            return NULL;
    return "if";
}

/* The line's end is at s->at: unless & joins the next to it, a new command begins. */
static void end_line(scan *s) {
    complete_words *w = &s->words;
    bool joined = w->n && w->list[w->n - 1][strlen(w->list[w->n - 1]) - 1] == '&';
    s->at++;
    s->start = s->at;
    if (joined) {
        if (strcmp(w->list[w->n - 1], "&") == 0)
            free(w->list[--w->n]);
        return;
    }
    const char *opener = opens_block(w);
    if (opener && s->depth < OPENERS_MAX)
        s->openers[s->depth++] = opener;
    if (is(w, 0, "end") && s->depth)
        s->depth--;
    drop_words(w);
}

/* Behind the quote that opens at i; n: it is open at the cursor. */
static size_t behind_quote(const scan *s, size_t i, size_t quote) {
    for (size_t k = i + quote; k + quote <= s->n; k++)
        if (strncmp(s->text + k, s->text + i, quote) == 0)
            return k + quote;
    return s->n + 1;
}

/* Behind the bare word at i: blanks inside ( ) do not end it. */
static size_t behind_word(const scan *s, size_t i) {
    size_t depth = 0;
    while (i < s->n && s->text[i] != '\n' && (depth || !line_is_blank(s->text[i]))) {
        size_t quote = line_quote(s->text, s->start, i), end = quote ? behind_quote(s, i, quote) : i + 1;
        depth += !quote && s->text[i] == '(';
        depth -= !quote && s->text[i] == ')' && depth;
        i = end > s->n ? s->n : end;
    }
    return i;
}

/* The word at s->at: kept, or the one the cursor is in. */
static void scan_word(scan *s) {
    size_t quote = line_quote(s->text, s->start, s->at);
    size_t end = quote ? behind_quote(s, s->at, quote) : behind_word(s, s->at);
    if (end >= s->n) {
        s->from = s->at;
        s->quote = end > s->n ? quote : 0;
        s->nowhere = quote && end == s->n;
        s->at = s->n;
        return;
    }
    complete_words *w = &s->words;
    w->list = alloc_grow(w->list, &w->capacity, w->n + 1, sizeof *w->list);
    w->list[w->n++] = alloc_copy_n(s->text + s->at, end - s->at);
    s->at = end;
}

static void scan_text(scan *s) {
    s->from = s->n;
    while (s->at < s->n) {
        char c = s->text[s->at];
        if (c == '\n') {
            end_line(s);
        } else if (c == '#') {
            const char *end = strchr(s->text + s->at, '\n');
            s->nowhere = !end;
            s->at = end ? (size_t)(end - s->text) : s->n;
        } else if (line_is_blank(c)) {
            s->at++;
        } else {
            scan_word(s);
        }
    }
}

/* ---- by the first word --------------------------------------------------------------------------------------------
 */

static bool in_loop(const scan *s) {
    for (size_t i = 0; i < s->depth; i++)
        if (strcmp(s->openers[i], "if") != 0)
            return true;
    return false;
}

/* The first word: a command, a word of blocks, or, at a prompt, an expression. */
static void offer_first(completing *c, const scan *s) {
    complete_part_commands(c);
    static const char *const openers[] = {"if", "for", "while", "repeat"};
    for (size_t i = 0; i < sizeof openers / sizeof *openers; i++)
        complete_part_offer(c, openers[i], false);
    if (s->depth)
        complete_part_offer(c, "end", false);
    if (s->depth && strcmp(s->openers[s->depth - 1], "if") == 0) {
        complete_part_offer(c, "elif", false);
        complete_part_offer(c, "else", false);
    }
    if (in_loop(s)) {
        complete_part_offer(c, "break", false);
        complete_part_offer(c, "continue", false);
    }
    if (c->text[c->from] && s->depth == 0)
        complete_part_expression(c, false);
}

/* Whether the words behind the first end with an operand, so that the condition may end there. */
static bool ends_operand(const complete_words *w) {
    const char *last = w->list[w->n - 1];
    char end = last[strlen(last) - 1];
    return !strchr("+-*/%^<>=!&|(,", end);
}

/* if, while, elif: a condition, then (on one line) commands. */
static void offer_condition(completing *c, const scan *s) {
    bool then = false;
    for (size_t i = 1; i < s->words.n; i++)
        then = then || is(&s->words, i, "then") || is(&s->words, i, "else");
    if (then && s->quote) {
        complete_part_text(c);
    } else if (then) {
        complete_part_offer(c, "else", false);
        complete_part_offer(c, "elif", false);
    } else if (s->words.n == 1 || !ends_operand(&s->words)) {
        complete_part_expression(c, false);
    } else if (is(&s->words, 0, "if")) {
        complete_part_offer(c, "then", false);
    }
}

static void offer_word(completing *c, const scan *s) {
    const complete_words *w = &s->words;
    if (w->n == 0) {
        offer_first(c, s);
    } else if (is(w, 0, "if") || is(w, 0, "while") || is(w, 0, "elif")) {
        offer_condition(c, s);
    } else if (is(w, 0, "for")) {
        if (w->n == 2)
            complete_part_offer(c, "in", false);
    } else if (is(w, 0, "end")) {
        if (w->n == 1 && s->depth)
            complete_part_offer(c, s->openers[s->depth - 1], false);
    } else if (execute_is_command(c->in, w->list[0]) || is(w, 0, "?")) {
        complete_part_place(c, w);
    } else if (!ends_operand(w)) {
        complete_part_expression(c, false);
    }
}

/* text ends at the cursor. Moves c->from from the text's beginning to where the candidates go. */
void complete_part_text(completing *c) {
    scan s = {.text = c->text + c->from, .n = strlen(c->text + c->from)};
    scan_text(&s);
    c->quote = s.quote ? s.text[s.from] : '\0';
    c->from += s.from + s.quote;
    if (!s.nowhere && !complete_part_dollar(c))
        offer_word(c, &s);
    drop_words(&s.words);
    free(s.words.list);
}

void complete_line(interp *in, const char *text, size_t cursor, completions *out) {
    *out = (completions){0};
    char *before = alloc_copy_n(text, cursor);
    completing c = {.in = in, .text = before, .out = out};
    complete_part_text(&c);
    out->from = c.from;
    free(before);
}

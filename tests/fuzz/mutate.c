/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "mutate.h"

#include "base/alloc.h"

#include <ctype.h>
#include <stdlib.h>
#include <string.h>

/* What stands for a word in the wrong place: numbers at the ends of their ranges, units of other dimensions, signs of
 * the language on their own, letters that are not ASCII. */
static const char *const oddities[] = {
    "0",
    "-1",
    "1",
    "1e308",
    "-1e308",
    "1e-320",
    "nan",
    "inf",
    "99999999999999999999",
    "2147483648",
    "4294967296",
    "0.1",
    "1um",
    "-1um",
    "0um",
    "1e300um",
    "1s",
    "1h",
    "1/h",
    "5e-11N/m",
    "1kg",
    "100%",
    "-5%",
    "1e9%",
    "1kg.m2/s2",
    "\"",
    "'",
    "$",
    "${",
    "$(",
    "$(1/0)",
    "${nobody}",
    "(",
    ")",
    "((((((((",
    "[",
    "]",
    "&",
    "#",
    "*",
    ";",
    "=",
    "==",
    "<",
    "&&",
    "||",
    "!",
    "-",
    "+",
    "/",
    "^",
    "%",
    "\\",
    "\t",
    "\n",
    "\n\n",
    "end",
    "else",
    "if",
    "for",
    "while",
    "repeat",
    "quit",
    "undo",
    "clear",
    "all",
    "none",
    "NULL",
    "off",
    "on",
    "\303\251",
    "\377\376",
    "\001",
    "aaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaa",
    "1+1",
    "cells",
    "x",
    "mean(x)",
    "mean(",
    "max(overlap where cells)",
    "/dev/full",
    "..",
    "nowhere/at/all.in"};

static size_t below(gsl_rng *r, size_t n) {
    return n ? gsl_rng_uniform_int(r, n) : 0;
}

void corpus_add(corpus *c, const char *text) {
    c->scripts = alloc_grow(c->scripts, &c->script_capacity, c->nscripts + 1, sizeof *c->scripts);
    c->scripts[c->nscripts++] = alloc_copy(text);
    for (const char *at = text; *at;) {
        size_t blank = strspn(at, " \t\n"), word = strcspn(at + blank, " \t\n");
        if (word) {
            c->words = alloc_grow(c->words, &c->word_capacity, c->nwords + 1, sizeof *c->words);
            c->words[c->nwords++] = alloc_copy_n(at + blank, word);
        }
        at += blank + word;
    }
}

void corpus_free(corpus *c) {
    for (size_t i = 0; i < c->nscripts; i++)
        free(c->scripts[i]);
    for (size_t i = 0; i < c->nwords; i++)
        free(c->words[i]);
    free(c->scripts);
    free(c->words);
    *c = (corpus){0};
}

/* Text with [from, to) replaced. */
static char *splice(char *text, size_t from, size_t to, const char *by) {
    char *out = alloc_format("%.*s%s%s", (int)from, text, by, text + to);
    free(text);
    return out;
}

/* The i-th word's place; false behind the last. */
static int find_word(const char *text, size_t i, size_t *from, size_t *to) {
    const char *at = text;
    do {
        at += strspn(at, " \t\n");
        *from = (size_t)(at - text);
        at += strcspn(at, " \t\n");
        *to = (size_t)(at - text);
    } while (i-- > 0 && *at);
    return *to > *from;
}

static size_t count_words(const char *text) {
    size_t n = 0, from, to;
    while (find_word(text, n, &from, &to))
        n++;
    return n;
}

static const char *other_word(const corpus *c, gsl_rng *r) {
    return below(r, 2) ? oddities[below(r, sizeof oddities / sizeof *oddities)] : c->words[below(r, c->nwords)];
}

/* One word left out, replaced, doubled, joined with another or cut short. */
static char *mutate_word(char *text, const corpus *c, gsl_rng *r) {
    size_t from, to;
    if (!find_word(text, below(r, count_words(text)), &from, &to))
        return text;
    switch (below(r, 6)) {
    case 0:
        return splice(text, from, to, "");
    case 1:
    case 2:
        return splice(text, from, to, other_word(c, r));
    case 3:
        return splice(splice(text, to, to, other_word(c, r)), to, to, below(r, 2) ? " " : "");
    case 4:
        return splice(text, from + below(r, to - from), to, "");
    default: {
        const char letter[2] = {(char)(1 + below(r, 255)), '\0'};
        size_t at = from + below(r, to - from);
        return splice(text, at, at + below(r, 2), letter);
    }
    }
}

static void find_line(const char *text, size_t i, size_t *from, size_t *to) {
    *from = 0;
    *to = strcspn(text, "\n");
    while (i-- > 0 && text[*to]) {
        *from = *to + 1;
        *to = *from + strcspn(text + *from, "\n");
    }
}

static size_t count_lines(const char *text) {
    size_t n = 1;
    for (; *text; text++)
        n += *text == '\n';
    return n;
}

/* A line left out, done twice, or put where it was not; or one of another script; or the rest is missing. */
static char *mutate_line(char *text, const corpus *c, gsl_rng *r) {
    const char *donor = below(r, 2) ? text : c->scripts[below(r, c->nscripts)];
    size_t from, to, start, stop;
    find_line(donor, below(r, count_lines(donor)), &from, &to);
    char *line = alloc_format("%.*s\n", (int)(to - from), donor + from);
    find_line(text, below(r, count_lines(text)), &start, &stop);
    switch (below(r, 8)) {
    case 0:
        text[start] = '\0';
        break;
    case 1:
    case 2:
    case 3:
        text = splice(text, start, stop + (text[stop] == '\n'), "");
        break;
    default:
        text = splice(text, start, start, line);
    }
    free(line);
    return text;
}

/* `run 100 ...` becomes `run 2 ...`: what is looked for comes at once or not at all. */
static char *shorten_runs(char *text) {
    for (char *at = text; (at = strstr(at, "run ")); at += 4) {
        size_t digits = strspn(at + 4 + strspn(at + 4, " "), "0123456789"), blanks = strspn(at + 4, " ");
        if ((at == text || isspace((unsigned char)at[-1])) && digits > 1)
            memset(at + 4 + blanks + 1, ' ', digits - 1);
    }
    return text;
}

char *mutate_script(const corpus *c, gsl_rng *r) {
    char *text = alloc_copy(c->scripts[below(r, c->nscripts)]);
    for (size_t left = 1 + below(r, 2) * below(r, 6); left > 0; left--)
        text = below(r, 4) ? mutate_word(text, c, r) : mutate_line(text, c, r);
    return shorten_runs(text);
}

unsigned char *mutate_bytes(const unsigned char *bytes, size_t *n, gsl_rng *r) {
    unsigned char *out = alloc_zeroed(2 * *n + 1, 1);
    memcpy(out, bytes, *n);
    for (size_t left = 1 + below(r, 8); left > 0 && *n; left--) {
        size_t at = below(r, *n), length = 1 + below(r, *n - at);
        switch (below(r, 8)) {
        case 0: /* cut off */
            *n = at;
            break;
        case 1: /* a piece is missing */
            memmove(out + at, out + at + length, *n - at - length);
            *n -= length;
            break;
        case 2: /* a piece lies where another was */
            memmove(out + below(r, *n - length + 1), out + at, length);
            break;
        case 3: /* a number at the end of its range */
            memset(out + at, below(r, 2) ? 0xff : 0, length < 8 ? length : 8);
            break;
        default:
            out[at] ^= (unsigned char)(1u << below(r, 8));
        }
    }
    return out;
}

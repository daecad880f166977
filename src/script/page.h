/* SPDX-License-Identifier: GPL-3.0-or-later */
/* A text that grows, for the writers of help and manual. */
#ifndef SARCINA_SCRIPT_PAGE_H
#define SARCINA_SCRIPT_PAGE_H

#include <stddef.h>

typedef struct page {
    char *chars; /* ends in '\0'; NULL while empty. The owner of the page frees it */
    size_t n, capacity;
} page;

void page_put(page *p, const char *format, ...) __attribute__((format(printf, 2, 3)));
void page_put_n(page *p, const char *text, size_t n);

/* Puts a text in lines of at most `width` letters, each behind `indent` blanks; the first line goes on where the page
 * is. Line ends of the text stay; those that begin with a blank are left as they are. */
void page_wrap(page *p, size_t indent, size_t width, const char *text);

/* Puts a text as a sentence: capital, full stop, a blank before it where the line has begun. NULL, "": nothing. */
void page_sentence(page *p, const char *text);

/* Puts every line of a text behind `indent` blanks. */
void page_lines(page *p, size_t indent, const char *text);

#endif

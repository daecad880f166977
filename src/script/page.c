/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "script/page.h"

#include "base/alloc.h"

#include <ctype.h>
#include <stdarg.h>
#include <stdbool.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

void page_put_n(page *p, const char *text, size_t n) {
    p->chars = alloc_grow(p->chars, &p->capacity, p->n + n + 1, 1);
    memcpy(p->chars + p->n, text, n);
    p->n += n;
    p->chars[p->n] = '\0';
}

void page_put(page *p, const char *format, ...) {
    char *text = NULL;
    va_list list;
    va_start(list, format);
    int n = vasprintf(&text, format, list);
    va_end(list);
    if (n < 0)
        return;
    page_put_n(p, text, (size_t)n);
    free(text);
}

static size_t letters(const char *text, size_t n) {
    size_t count = 0;
    for (size_t i = 0; i < n; i++)
        count += ((unsigned char)text[i] & 0xc0) != 0x80;
    return count;
}

/* How far the page's last line goes. */
static size_t column(const page *p) {
    size_t at = p->n;
    while (at > 0 && p->chars[at - 1] != '\n')
        at--;
    return letters(p->chars + at, p->n - at);
}

static void wrap_line(page *p, size_t indent, size_t width, const char *text, size_t n) {
    size_t end = 0;
    while (end < n) {
        size_t from = end + strspn(text + end, " ");
        end = from + strcspn(text + from, " \n");
        if (end > n || from == end)
            break;
        size_t at = column(p);
        bool goes_on = at > 0 && p->chars[p->n - 1] != ' ';
        if (goes_on && at + 1 + letters(text + from, end - from) > width)
            page_put(p, "\n%*s", (int)indent, "");
        else if (goes_on)
            page_put(p, " ");
        page_put_n(p, text + from, end - from);
    }
}

void page_wrap(page *p, size_t indent, size_t width, const char *text) {
    for (const char *line = text; *line;) {
        size_t n = strcspn(line, "\n");
        if (line > text)
            page_put(p, "\n%*s", n ? (int)indent : 0, "");
        if (*line == ' ')
            page_put_n(p, line, n);
        else
            wrap_line(p, indent, width, line, n);
        line += n + (line[n] == '\n');
    }
    page_put(p, "\n");
}

void page_sentence(page *p, const char *text) {
    if (!text || !*text)
        return;
    bool goes_on = p->n && p->chars[p->n - 1] != '\n';
    char last = text[strlen(text) - 1];
    page_put(p, "%s%c%s%s", goes_on ? " " : "", toupper((unsigned char)*text), text + 1,
             last == '?' || last == '.' ? "" : ".");
}

void page_lines(page *p, size_t indent, const char *text) {
    while (*text) {
        size_t n = strcspn(text, "\n");
        page_put(p, "%*s%.*s\n", n ? (int)indent : 0, "", (int)n, text);
        text += n + (text[n] == '\n');
    }
}

/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "script/piece.h"

#include "base/alloc.h"

#include <stdlib.h>
#include <string.h>

static void reserve(piece *p, size_t n) {
    if (n + 1 <= p->capacity && p->chars)
        return;
    size_t capacity = p->capacity;
    p->chars = alloc_grow(p->chars, &capacity, n + 1, 1);
    p->marks = alloc_resize(p->marks, capacity, sizeof *p->marks);
    p->capacity = capacity;
}

/* The NUL behind the last character stands just after it. */
static void end_piece(piece *p) {
    p->chars[p->n] = '\0';
    mark end = {1, 1, 1, 0};
    if (p->n) {
        end = p->marks[p->n - 1];
        end.column += end.length;
        end.length = 1;
        end.serial = 0;
    }
    p->marks[p->n] = end;
}

piece piece_of_source(const source *s) {
    piece p = {.source = s};
    reserve(&p, s->length);
    uint32_t line = 1, column = 1;
    for (size_t i = 0; i < s->length; i++) {
        p.chars[i] = s->text[i];
        p.marks[i] = (mark){line, column++, 1, 0};
        if (s->text[i] == '\n')
            line++, column = 1;
    }
    p.n = s->length;
    end_piece(&p);
    return p;
}

piece piece_slice(const piece *p, size_t from, size_t to) {
    piece slice = {.source = p->source};
    reserve(&slice, to - from);
    memcpy(slice.chars, p->chars + from, to - from);
    memcpy(slice.marks, p->marks + from, (to - from) * sizeof *slice.marks);
    slice.n = to - from;
    end_piece(&slice);
    if (slice.n == 0)
        slice.marks[0] = p->marks[from];
    return slice;
}

void piece_free(piece *p) {
    free(p->chars);
    free(p->marks);
    *p = (piece){0};
}

void piece_append(piece *p, const piece *other, size_t from, size_t to) {
    reserve(p, p->n + to - from);
    p->source = other->source;
    memcpy(p->chars + p->n, other->chars + from, to - from);
    memcpy(p->marks + p->n, other->marks + from, (to - from) * sizeof *p->marks);
    p->n += to - from;
    end_piece(p);
}

void piece_push(piece *p, char c, mark m) {
    reserve(p, p->n + 1);
    p->chars[p->n] = c;
    p->marks[p->n++] = m;
    end_piece(p);
}

void piece_splice(piece *p, size_t from, size_t to, const char *chars, size_t n, mark m) {
    size_t tail = p->n - to + 1; /* with the end */
    reserve(p, p->n - (to - from) + n);
    memmove(p->chars + from + n, p->chars + to, tail);
    memmove(p->marks + from + n, p->marks + to, tail * sizeof *p->marks);
    memcpy(p->chars + from, chars, n);
    for (size_t i = 0; i < n; i++)
        p->marks[from + i] = m;
    p->n = p->n - (to - from) + n;
}

span piece_span(const piece *p, size_t from, size_t to) {
    mark first = p->marks[from < p->n ? from : p->n];
    span at = {p->source, first.line, first.column, first.length};
    if (to > from && to <= p->n) {
        mark last = p->marks[to - 1];
        if (last.line == first.line && last.column + last.length > first.column + first.length)
            at.length = last.column + last.length - first.column;
    }
    return at;
}

bool piece_is_replaced(const piece *p, size_t i) {
    return p->marks[i].serial != 0;
}

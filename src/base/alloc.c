/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "base/alloc.h"

#include <stdarg.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

static void *checked(void *p) {
    if (!p) {
        fputs("sarcina: out of memory\n", stderr);
        abort();
    }
    return p;
}

static size_t bytes(size_t n, size_t size) {
    size_t total;
    if (__builtin_mul_overflow(n, size, &total))
        checked(NULL);
    return total ? total : 1;
}

void *alloc_zeroed(size_t n, size_t size) {
    return checked(calloc(1, bytes(n, size)));
}

void *alloc_resize(void *p, size_t n, size_t size) {
    return checked(realloc(p, bytes(n, size)));
}

void *alloc_grow(void *p, size_t *capacity, size_t need, size_t size) {
    if (need <= *capacity && p)
        return p;
    size_t grown = *capacity + *capacity / 2;
    *capacity = need > grown ? need : grown;
    if (*capacity < 8)
        *capacity = 8;
    return alloc_resize(p, *capacity, size);
}

void *alloc_aligned(size_t n, size_t size, size_t alignment) {
    size_t total = bytes(n, size), rest = total % alignment;
    return checked(aligned_alloc(alignment, rest ? total + alignment - rest : total));
}

char *alloc_copy_n(const char *text, size_t n) {
    char *copy = alloc_resize(NULL, n + 1, 1);
    memcpy(copy, text, n);
    copy[n] = '\0';
    return copy;
}

char *alloc_copy(const char *text) {
    return alloc_copy_n(text, strlen(text));
}

char *alloc_format(const char *format, ...) {
    va_list list;
    va_start(list, format);
    char *text = NULL;
    int n = vasprintf(&text, format, list);
    va_end(list);
    return checked(n < 0 ? NULL : text);
}

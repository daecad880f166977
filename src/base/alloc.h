/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Memory that grows. Running out of memory ends the program with a message: no caller could do better. */
#ifndef SARCINA_BASE_ALLOC_H
#define SARCINA_BASE_ALLOC_H

#include <stddef.h>

/* n x size bytes, zeroed; never NULL (n or size may be 0). The caller frees. */
void *alloc_zeroed(size_t n, size_t size);

/* p resized to n x size bytes; never NULL. New bytes are not set. */
void *alloc_resize(void *p, size_t n, size_t size);

/* p made to hold at least need items of size bytes, growing by half; *capacity is updated. */
void *alloc_grow(void *p, size_t *capacity, size_t need, size_t size);

/* n x size bytes at a multiple of alignment (a power of two); never NULL, not set. The caller frees. */
void *alloc_aligned(size_t n, size_t size, size_t alignment);

/* A copy of text (of its first n bytes); the caller frees. */
char *alloc_copy(const char *text);
char *alloc_copy_n(const char *text, size_t n);

/* Formatted text in new memory; the caller frees. */
char *alloc_format(const char *format, ...) __attribute__((format(printf, 1, 2)));

#endif

/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Memory that grows. Running out of memory ends the program with a message: no caller could do better. */
#ifndef SARCINA_BASE_ALLOC_H
#define SARCINA_BASE_ALLOC_H

#include <stddef.h>

/* Said to compilers and checkers too: none of these gives NULL. */
#define ALLOC_NEVER_NULL __attribute__((returns_nonnull))

/* n x size bytes, zeroed; never NULL (n or size may be 0). The caller frees. */
void *alloc_zeroed(size_t n, size_t size) ALLOC_NEVER_NULL;

/* p resized to n x size bytes; never NULL. New bytes are not set. */
void *alloc_resize(void *p, size_t n, size_t size) ALLOC_NEVER_NULL;

/* p made to hold at least need items of size bytes, growing by half; *capacity is updated. */
void *alloc_grow(void *p, size_t *capacity, size_t need, size_t size) ALLOC_NEVER_NULL;

/* n x size bytes at a multiple of alignment (a power of two); never NULL, not set. The caller frees. */
void *alloc_aligned(size_t n, size_t size, size_t alignment) ALLOC_NEVER_NULL;

/* A copy of text (of its first n bytes); the caller frees. */
char *alloc_copy(const char *text) ALLOC_NEVER_NULL;
char *alloc_copy_n(const char *text, size_t n) ALLOC_NEVER_NULL;

/* Formatted text in new memory; the caller frees. */
char *alloc_format(const char *format, ...) __attribute__((format(printf, 1, 2))) ALLOC_NEVER_NULL;

#endif

/* SPDX-License-Identifier: GPL-3.0-or-later */
/* FNV-1a, 64 bits (G. Fowler, L. C. Noll, K.-P. Vo): tells texts and files apart, and proves nothing. */
#ifndef SARCINA_BASE_HASH_H
#define SARCINA_BASE_HASH_H

#include <stddef.h>
#include <stdint.h>

#define HASH_BEGIN UINT64_C(0xcbf29ce484222325)

/* Going on from h (HASH_BEGIN, or what came before) with n bytes. */
static inline uint64_t hash_bytes(uint64_t h, const void *bytes, size_t n) {
    const unsigned char *at = bytes;
    for (size_t i = 0; i < n; i++)
        h = (h ^ at[i]) * UINT64_C(0x100000001b3);
    return h;
}

#endif

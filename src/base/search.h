/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Finding a number in a sorted list. */
#ifndef SARCINA_BASE_SEARCH_H
#define SARCINA_BASE_SEARCH_H

#include <stddef.h>
#include <stdint.h>

/* Place of an id among n that rise; n: it is not there. */
static inline size_t search_id(const uint64_t *ids, size_t n, uint64_t id) {
    size_t low = 0, high = n;
    while (low < high) {
        size_t middle = low + (high - low) / 2;
        if (ids[middle] < id)
            low = middle + 1;
        else
            high = middle;
    }
    return low < n && ids[low] == id ? low : n;
}

#endif

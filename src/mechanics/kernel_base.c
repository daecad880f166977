/* SPDX-License-Identifier: GPL-3.0-or-later */
#include <math.h>
#include <sleef.h>
#include <stdbool.h>

#ifdef __SSE2__
#include <emmintrin.h>

typedef __m128d pack;
typedef __m128d pack_mask;
enum { PACK_WIDTH = 2 };

static inline pack pack_set(double x) {
    return _mm_set1_pd(x);
}
static inline pack pack_load(const double *from) {
    return _mm_loadu_pd(from);
}
static inline void pack_store(double *to, pack x) {
    _mm_storeu_pd(to, x);
}
static inline pack pack_min(pack a, pack b) {
    return _mm_min_pd(a, b);
}
static inline pack pack_max(pack a, pack b) {
    return _mm_max_pd(a, b);
}
static inline pack pack_sqrt(pack x) {
    return _mm_sqrt_pd(x);
}
static inline pack_mask pack_less(pack a, pack b) {
    return _mm_cmplt_pd(a, b);
}
static inline pack_mask pack_equal(pack a, pack b) {
    return _mm_cmpeq_pd(a, b);
}
static inline bool pack_any(pack_mask m) {
    return _mm_movemask_pd(m) != 0;
}
static inline pack pack_pick(pack_mask m, pack a, pack b) {
    return _mm_or_pd(_mm_and_pd(m, a), _mm_andnot_pd(m, b));
}

static inline void pack_records(const double *const *from, int n, pack *to) {
    for (int k = 0; k < n; k += 2) {
        const pack p = _mm_loadu_pd(from[0] + k), q = _mm_loadu_pd(from[1] + k);
        to[k] = _mm_unpacklo_pd(p, q);
        to[k + 1] = _mm_unpackhi_pd(p, q);
    }
}

#else /* any other processor: a number at a time */

typedef double pack;
typedef bool pack_mask;
enum { PACK_WIDTH = 1 };

static inline pack pack_set(double x) {
    return x;
}
static inline pack pack_load(const double *from) {
    return *from;
}
static inline void pack_store(double *to, pack x) {
    *to = x;
}
static inline pack pack_min(pack a, pack b) {
    return a < b ? a : b;
}
static inline pack pack_max(pack a, pack b) {
    return a > b ? a : b;
}
static inline pack pack_sqrt(pack x) {
    return sqrt(x);
}
static inline pack_mask pack_less(pack a, pack b) {
    return a < b;
}
static inline pack_mask pack_equal(pack a, pack b) {
    return a == b;
}
static inline bool pack_any(pack_mask m) {
    return m;
}
static inline pack pack_pick(pack_mask m, pack a, pack b) {
    return m ? a : b;
}

static inline void pack_records(const double *const *from, int n, pack *to) {
    for (int k = 0; k < n; k++)
        to[k] = from[0][k];
}
#endif

#define KERNEL_NAME base
#define KERNEL_EXP_LANES 1
#define KERNEL_EXP(x, y) (*(y) = Sleef_cinz_expd1_u10purec(*(x)))
#define KERNEL_EXPM1(x, y) (*(y) = Sleef_cinz_expm1d1_u10purec(*(x)))
#include "mechanics/kernel_batch.h"

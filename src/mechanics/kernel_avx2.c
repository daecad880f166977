/* SPDX-License-Identifier: GPL-3.0-or-later */
#include <immintrin.h>
#include <sleef.h>
#include <stdbool.h>

typedef __m256d pack;
typedef __m256d pack_mask;
enum { PACK_WIDTH = 4 };

static inline pack pack_set(double x) {
    return _mm256_set1_pd(x);
}
static inline pack pack_load(const double *from) {
    return _mm256_loadu_pd(from);
}
static inline void pack_store(double *to, pack x) {
    _mm256_storeu_pd(to, x);
}
static inline pack pack_min(pack a, pack b) {
    return _mm256_min_pd(a, b);
}
static inline pack pack_max(pack a, pack b) {
    return _mm256_max_pd(a, b);
}
static inline pack pack_sqrt(pack x) {
    return _mm256_sqrt_pd(x);
}
static inline pack_mask pack_less(pack a, pack b) {
    return _mm256_cmp_pd(a, b, _CMP_LT_OQ);
}
static inline pack_mask pack_equal(pack a, pack b) {
    return _mm256_cmp_pd(a, b, _CMP_EQ_OQ);
}
static inline bool pack_any(pack_mask m) {
    return _mm256_movemask_pd(m) != 0;
}
static inline pack pack_pick(pack_mask m, pack a, pack b) {
    return _mm256_blendv_pd(b, a, m);
}

/* Two numbers each at two addresses. */
static inline pack pair_of(const double *a, const double *b) {
    return _mm256_insertf128_pd(_mm256_castpd128_pd256(_mm_loadu_pd(a)), _mm_loadu_pd(b), 1);
}

static inline void pack_records(const double *const *from, int n, pack *to) {
    for (int k = 0; k < n; k += 2) {
        const pack p02 = pair_of(from[0] + k, from[2] + k), p13 = pair_of(from[1] + k, from[3] + k);
        to[k] = _mm256_unpacklo_pd(p02, p13);
        to[k + 1] = _mm256_unpackhi_pd(p02, p13);
    }
}

#define KERNEL_NAME avx2
#define KERNEL_EXP_LANES 4
#define KERNEL_EXP(x, y) _mm256_storeu_pd(y, Sleef_cinz_expd4_u10avx(_mm256_loadu_pd(x)))
#define KERNEL_EXPM1(x, y) _mm256_storeu_pd(y, Sleef_cinz_expm1d4_u10avx(_mm256_loadu_pd(x)))
#include "mechanics/kernel_batch.h"

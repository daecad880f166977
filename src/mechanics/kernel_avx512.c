/* SPDX-License-Identifier: GPL-3.0-or-later */
#include <immintrin.h>
#include <sleef.h>
#include <stdbool.h>

typedef __m512d pack;
typedef __mmask8 pack_mask;
enum { PACK_WIDTH = 8 };

static inline pack pack_set(double x) {
    return _mm512_set1_pd(x);
}
static inline pack pack_load(const double *from) {
    return _mm512_loadu_pd(from);
}
static inline void pack_store(double *to, pack x) {
    _mm512_storeu_pd(to, x);
}
static inline pack pack_min(pack a, pack b) {
    return _mm512_min_pd(a, b);
}
static inline pack pack_max(pack a, pack b) {
    return _mm512_max_pd(a, b);
}
static inline pack pack_sqrt(pack x) {
    return _mm512_sqrt_pd(x);
}
static inline pack_mask pack_less(pack a, pack b) {
    return _mm512_cmp_pd_mask(a, b, _CMP_LT_OQ);
}
static inline pack_mask pack_equal(pack a, pack b) {
    return _mm512_cmp_pd_mask(a, b, _CMP_EQ_OQ);
}
static inline bool pack_any(pack_mask m) {
    return m != 0;
}
static inline pack pack_pick(pack_mask m, pack a, pack b) {
    return _mm512_mask_blend_pd(m, b, a);
}

/* Four numbers each at two addresses. */
static inline pack pair_of(const double *a, const double *b) {
    return _mm512_insertf64x4(_mm512_castpd256_pd512(_mm256_loadu_pd(a)), _mm256_loadu_pd(b), 1);
}

/* Four numbers at eight addresses, from the k-th on. */
static inline void four_of(const double *const *from, int k, pack to[4]) {
    const pack p02 = pair_of(from[0] + k, from[2] + k), p13 = pair_of(from[1] + k, from[3] + k);
    const pack p46 = pair_of(from[4] + k, from[6] + k), p57 = pair_of(from[5] + k, from[7] + k);
    const pack even = _mm512_unpacklo_pd(p02, p13), odd = _mm512_unpackhi_pd(p02, p13);
    const pack even_high = _mm512_unpacklo_pd(p46, p57), odd_high = _mm512_unpackhi_pd(p46, p57);
    to[0] = _mm512_shuffle_f64x2(even, even_high, 0x88);
    to[1] = _mm512_shuffle_f64x2(odd, odd_high, 0x88);
    to[2] = _mm512_shuffle_f64x2(even, even_high, 0xdd);
    to[3] = _mm512_shuffle_f64x2(odd, odd_high, 0xdd);
}

/* Two numbers each at four addresses. */
static inline pack quartet_of(const double *a, const double *b, const double *c, const double *d) {
    const __m512d ab = _mm512_castpd128_pd512(_mm_loadu_pd(a));
    return _mm512_insertf64x2(_mm512_insertf64x2(_mm512_insertf64x2(ab, _mm_loadu_pd(b), 1), _mm_loadu_pd(c), 2),
                              _mm_loadu_pd(d), 3);
}

/* Two numbers at eight addresses, from the k-th on. */
static inline void two_of(const double *const *from, int k, pack to[2]) {
    const pack even = quartet_of(from[0] + k, from[2] + k, from[4] + k, from[6] + k);
    const pack odd = quartet_of(from[1] + k, from[3] + k, from[5] + k, from[7] + k);
    to[0] = _mm512_unpacklo_pd(even, odd);
    to[1] = _mm512_unpackhi_pd(even, odd);
}

static inline void pack_records(const double *const *from, int n, pack *to) {
    four_of(from, 0, to);
    if (n == 6)
        two_of(from, 4, to + 4);
    else
        four_of(from, 4, to + 4);
}

#define KERNEL_NAME avx512
#define KERNEL_EXP_LANES 8
#define KERNEL_EXP(x, y) _mm512_storeu_pd(y, Sleef_cinz_expd8_u10avx512fnofma(_mm512_loadu_pd(x)))
#define KERNEL_EXPM1(x, y) _mm512_storeu_pd(y, Sleef_cinz_expm1d8_u10avx512fnofma(_mm512_loadu_pd(x)))
#include "mechanics/kernel_batch.h"

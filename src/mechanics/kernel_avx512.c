/* SPDX-License-Identifier: GPL-3.0-or-later */
#include <immintrin.h>
#include <sleef.h>

#define KERNEL_NAME avx512
#define KERNEL_EXP_LANES 8
#define KERNEL_EXP(x, y) _mm512_storeu_pd(y, Sleef_cinz_expd8_u10avx512fnofma(_mm512_loadu_pd(x)))
#include "mechanics/kernel_batch.h"

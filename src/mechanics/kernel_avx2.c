/* SPDX-License-Identifier: GPL-3.0-or-later */
#include <immintrin.h>
#include <sleef.h>

#define KERNEL_NAME avx2
#define KERNEL_EXP_LANES 4
#define KERNEL_EXP(x, y) _mm256_storeu_pd(y, Sleef_cinz_expd4_u10avx(_mm256_loadu_pd(x)))
#include "mechanics/kernel_batch.h"

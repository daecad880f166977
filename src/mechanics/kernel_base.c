/* SPDX-License-Identifier: GPL-3.0-or-later */
#include <sleef.h>

#define KERNEL_NAME base
#define KERNEL_EXP_LANES 1
#define KERNEL_EXP(x, y) (*(y) = Sleef_cinz_expd1_u10purec(*(x)))
#include "mechanics/kernel_batch.h"

/* SPDX-License-Identifier: GPL-3.0-or-later */
#define KERNEL_NAME avx512
#include "mechanics/kernel_batch.h"

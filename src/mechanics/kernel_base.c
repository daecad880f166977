/* SPDX-License-Identifier: GPL-3.0-or-later */
#define KERNEL_NAME base
#include "mechanics/kernel_batch.h"

/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "mechanics/kernel.h"

#include <string.h>

extern const contact_kernel kernel_base;
#ifdef SARCINA_X86
extern const contact_kernel kernel_avx2;
extern const contact_kernel kernel_avx512;
#endif

/* Widest first. */
static const contact_kernel *const kernels[] = {
#ifdef SARCINA_X86
    &kernel_avx512, &kernel_avx2,
#endif
    &kernel_base};
enum { KERNEL_COUNT = sizeof kernels / sizeof kernels[0] };

static int is_supported(const contact_kernel *k) {
#ifdef SARCINA_X86
    if (k == &kernel_avx512)
        return __builtin_cpu_supports("avx512f") && __builtin_cpu_supports("avx512dq");
    if (k == &kernel_avx2)
        return __builtin_cpu_supports("avx2");
#endif
    return k == &kernel_base;
}

const contact_kernel *kernel_best(void) {
    for (int i = 0; i < KERNEL_COUNT; i++)
        if (is_supported(kernels[i]))
            return kernels[i];
    return &kernel_base;
}

const contact_kernel *kernel_find(const char *name) {
    for (int i = 0; i < KERNEL_COUNT; i++)
        if (strcmp(kernels[i]->name, name) == 0 && is_supported(kernels[i]))
            return kernels[i];
    return NULL;
}

/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "output/readable.h"

#include <stdio.h>

static const struct {
    const char *dimension, *name;
    double si;
} readable[] = {{"length", "um", 1e-6},      {"mass", "pg", 1e-15},      {"area", "um2", 1e-12},
                {"volume", "um3", 1e-18},    {"velocity", "um/s", 1e-6}, {"time", "h", 3600},
                {"rate", "1/h", 1 / 3600.0}, {"force", "pN", 1e-12}};

double readable_unit(dim d, char name[48]) {
    dim known;
    for (size_t i = 0; i < sizeof readable / sizeof *readable; i++)
        if (dim_by_name(readable[i].dimension, &known) && dim_equal(d, known)) {
            snprintf(name, 48, "%s", readable[i].name);
            return readable[i].si;
        }
    dim_suffix(d, name);
    return 1;
}

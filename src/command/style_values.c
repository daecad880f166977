/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "command/style_values.h"

#include <stdio.h>
#include <string.h>

void style_values_name(const param *p, char name[64]) {
    snprintf(name, 64, "%.*s", (int)strcspn(p->spec, "=:"), p->spec);
}

/* The kind of a parameter, as its specification has it behind the colon. */
static const char *kind_of(const param *p) {
    return strchr(p->spec, ':') + 1;
}

static spread value_of(const args *a, const param *p, const char *name) {
    const char *kind = kind_of(p);
    if (kind[0] == '{')
        return spread_fixed(args_choice(a, name));
    if (strncmp(kind, "flag", 4) == 0)
        return spread_fixed(args_flag(a, name));
    if (strncmp(kind, "int", 3) == 0)
        return spread_fixed((double)args_int(a, name));
    if (strchr(kind, '~'))
        return args_spread(a, name);
    return spread_fixed(args_number(a, name));
}

void style_values(const args *a, const param *params, size_t n, bool amending, spread *values) {
    for (size_t i = 0; i < n; i++) {
        char name[64];
        style_values_name(&params[i], name);
        if (!amending || args_given(a, name))
            values[i] = value_of(a, &params[i], name);
    }
}

void style_values_read(const args *a, const param *params, size_t n, bool amending, double *values) {
    spread all[PARAM_COUNT_MAX];
    for (size_t i = 0; i < n; i++)
        all[i] = spread_fixed(values[i]);
    style_values(a, params, n, amending, all);
    for (size_t i = 0; i < n; i++)
        values[i] = all[i].a;
}

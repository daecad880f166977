/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The tests that a forecast can answer are those of the clock and of the number of cells: their names are replaced by
 * their values of then, and the language does the rest. */
#include "command/forecast.h"

#include "base/alloc.h"
#include "base/number.h"
#include "base/table.h"
#include "script/expr.h"

#include <ctype.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

typedef struct clock_value {
    const char *name, *unit;
    double value;
} clock_value;

static size_t name_length(const char *c) {
    size_t n = 0;
    while (isalnum((unsigned char)c[n]) || c[n] == '_' || (n && c[n] == '.'))
        n++;
    return n;
}

/* The test with numbers for names; NULL: it names something else. The caller frees. */
static char *put_values(const char *test, const clock_value *values, size_t n) {
    size_t capacity = 0, used = 0;
    char *out = NULL;
    while (*test) {
        char number[32] = {*test, 0};
        const char *suffix = "";
        size_t taken = 1, row = n;
        if (isdigit((unsigned char)*test)) { /* with its unit */
            taken = number_length(test, strlen(test), false);
            taken += name_length(test + taken);
        } else if (isalpha((unsigned char)*test)) {
            taken = name_length(test);
            for (row = 0; row < n; row++)
                if (strlen(values[row].name) == taken && strncmp(values[row].name, test, taken) == 0)
                    break;
            if (row == n) {
                free(out);
                return NULL;
            }
            number_write(values[row].value, number);
            suffix = values[row].unit;
        }
        out = alloc_grow(out, &capacity, used + taken + sizeof number + 2, 1);
        if (row < n)
            used += (size_t)snprintf(out + used, capacity - used, "%s%s", number, suffix);
        else
            memcpy(out + used, test, taken), used += taken;
        test += taken;
    }
    if (out)
        out[used] = '\0';
    return out;
}

bool forecast_until(interp *in, const expr *test, double cells, double step, double time, double relaxed, bool *known) {
    const clock_value values[] = {
        {"cells", "", floor(cells)}, {"step", "", step}, {"time", "s", time}, {"relaxed", "s", relaxed}};
    char *text = put_values(expr_text(test), values, TABLE_COUNT(values));
    expr *e = text ? expr_of_text(in, text, NULL) : NULL;
    bool holds = false;
    *known = e && interp_truth(in, e, &holds, NULL) == SARCINA_OK;
    expr_free(e);
    free(text);
    return *known && holds;
}

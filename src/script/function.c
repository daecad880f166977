/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "script/function.h"

#include "base/table.h"

#include <math.h>

static double sign(double x) {
    return (x > 0) - (x < 0);
}

/* C's fmin and fmax drop NaN; what is undefined stays so. */
static double smaller(double a, double b) {
    return isnan(a) || isnan(b) ? (double)NAN : fmin(a, b);
}

static double larger(double a, double b) {
    return isnan(a) || isnan(b) ? (double)NAN : fmax(a, b);
}

/* Halves away from zero, as people round. */
static double round_half(double x) {
    return round(x);
}

#define ONE(id, rule_, function, summary_)                                                                             \
    {                                                                                                                  \
        .name = #id, .signature = #id "(x)", .summary = (summary_), .least = 1, .most = 1, .rule = (rule_),            \
        .one = (function)                                                                                              \
    }
#define TWO(id, rule_, function, signature_, summary_, most_)                                                          \
    {                                                                                                                  \
        .name = #id, .signature = (signature_), .summary = (summary_), .least = 2, .most = (most_), .rule = (rule_),   \
        .two = (function)                                                                                              \
    }
#define OTHER(id, rule_, signature_, summary_, n)                                                                      \
    { .name = #id, .signature = (signature_), .summary = (summary_), .least = (n), .most = (n), .rule = (rule_) }

const function_style function_styles[] = {
    ONE(abs, FUNCTION_SAME, fabs, "size of x"),
    ONE(sign, FUNCTION_SIGN, sign, "-1, 0 or 1"),
    ONE(sqrt, FUNCTION_ROOT, sqrt, "square root"),
    ONE(exp, FUNCTION_PURE, exp, "exponential function"),
    ONE(ln, FUNCTION_PURE, log, "natural logarithm"),
    ONE(log10, FUNCTION_PURE, log10, "logarithm to base 10"),
    ONE(sin, FUNCTION_PURE, sin, "sine of an angle"),
    ONE(cos, FUNCTION_PURE, cos, "cosine of an angle"),
    ONE(tan, FUNCTION_PURE, tan, "tangent of an angle"),
    ONE(asin, FUNCTION_PURE, asin, "angle with this sine"),
    ONE(acos, FUNCTION_PURE, acos, "angle with this cosine"),
    ONE(atan, FUNCTION_PURE, atan, "angle with this tangent"),
    ONE(floor, FUNCTION_PURE, floor, "whole number below"),
    ONE(ceil, FUNCTION_PURE, ceil, "whole number above"),
    ONE(round, FUNCTION_PURE, round_half, "nearest whole number"),
    TWO(atan2, FUNCTION_SIGN, atan2, "atan2(y, x)", "angle of the point (x, y)", 2),
    TWO(hypot, FUNCTION_SAME, hypot, "hypot(x, y)", "root of x^2 + y^2", 2),
    TWO(min, FUNCTION_SAME, smaller, "min(a, b, ...)", "smallest of them", 8),
    TWO(max, FUNCTION_SAME, larger, "max(a, b, ...)", "largest of them", 8),
    OTHER(ternary, FUNCTION_CHOICE, "ternary(test, yes, no)", "yes where test holds, else no", 3),
    OTHER(random, FUNCTION_RANDOM, "random(lo, hi)", "drawn anew at every look, uniform", 2),
    OTHER(normal, FUNCTION_RANDOM, "normal(mean, sd)", "drawn anew at every look, normal", 2),
    OTHER(poisson, FUNCTION_RANDOM, "poisson(mean)", "drawn anew at every look, Poisson", 1),
    OTHER(descends, FUNCTION_DESCENDS, "descends(ID)", "whether a cell is that one or descends from it", 1),
    OTHER(is_file, FUNCTION_FILE, "is_file(\"FILE\")", "whether this file can be read", 1),
    OTHER(defined, FUNCTION_DEFINED, "defined(\"NAME\")", "whether something is called so", 1),
};
const size_t function_style_count = TABLE_COUNT(function_styles);

const function_style *function_find(const char *name) {
    ptrdiff_t row = table_find(function_styles, function_style_count, sizeof *function_styles, name);
    return row < 0 ? NULL : &function_styles[row];
}

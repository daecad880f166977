/* SPDX-License-Identifier: GPL-3.0-or-later */
/* cmocka with what it wants included before it, and comparisons of doubles that say what they saw. */
#ifndef SARCINA_TESTS_CHECK_H
#define SARCINA_TESTS_CHECK_H

#include <math.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <cmocka.h>

static inline void check_near(double seen, double wanted, double tolerance, const char *what, const char *file,
                              int line) {
    if (fabs(seen - wanted) <= tolerance)
        return;
    print_error("%s is %.17g, not %.17g within %g\n", what, seen, wanted, tolerance);
    _fail(file, line);
}

/* |seen - wanted| <= tolerance; NaN fails. */
#define assert_near(seen, wanted, tolerance) check_near(seen, wanted, tolerance, #seen, __FILE__, __LINE__)

#endif

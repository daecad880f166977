/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Memory that grows keeps what it holds. */
#include "check.h"

#include "base/alloc.h"

#include <stdlib.h>
#include <string.h>

static void test_zeroed(void **state) {
    (void)state;
    unsigned char *p = alloc_zeroed(7, 3);
    for (int i = 0; i < 21; i++)
        assert_int_equal(p[i], 0);
    free(p);
    void *none = alloc_zeroed(0, 8);
    assert_non_null(none);
    free(none);
}

/* One item more at a time: contents stay, capacity covers what is asked and grows by a factor. */
static void test_grow(void **state) {
    (void)state;
    uint32_t *p = NULL;
    size_t capacity = 0, moves = 0;
    for (uint32_t n = 0; n < 100000; n++) {
        size_t before = capacity;
        p = alloc_grow(p, &capacity, n + 1, sizeof *p);
        moves += capacity != before;
        assert_true(capacity > n);
        p[n] = n * 2654435761u;
    }
    for (uint32_t n = 0; n < 100000; n++)
        assert_int_equal(p[n], n * 2654435761u);
    assert_true(moves < 30);
    free(p);
}

static void test_copy_and_format(void **state) {
    (void)state;
    char *whole = alloc_copy("colony"), *part = alloc_copy_n("colony", 3), *none = alloc_copy_n("x", 0);
    char *made = alloc_format("%s.%d", whole, 42);
    assert_string_equal(whole, "colony");
    assert_string_equal(part, "col");
    assert_string_equal(none, "");
    assert_string_equal(made, "colony.42");
    free(whole);
    free(part);
    free(none);
    free(made);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_zeroed),
        cmocka_unit_test(test_grow),
        cmocka_unit_test(test_copy_and_format),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}

/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Diagnostics: statuses, help in lines, the first place holds, and nothing is ever written past a buffer. */
#include "check.h"

#include "base/diag.h"

#include <stdlib.h>
#include <string.h>

static void test_status_and_text(void **state) {
    (void)state;
    diag d = {0};
    assert_int_equal(diag_error(&d, "no species '%s'", "ecoli"), SARCINA_ERROR);
    assert_int_equal(d.status, SARCINA_ERROR);
    assert_string_equal(d.message, "no species 'ecoli'");
    assert_int_equal(diag_fail(&d, SARCINA_NUMERICAL, "step %d", 7), SARCINA_NUMERICAL);
    assert_int_equal(d.status, SARCINA_NUMERICAL);
    assert_string_equal(d.message, "step 7");
}

static void test_null_is_allowed(void **state) {
    (void)state;
    assert_int_equal(diag_error(NULL, "x"), SARCINA_ERROR);
    assert_int_equal(diag_fail(NULL, SARCINA_EXPECT, "x"), SARCINA_EXPECT);
    assert_int_equal(diag_help(NULL, "x"), SARCINA_ERROR);
    diag_place(NULL, (span){0});
    diag_clear(NULL);
}

/* Help is added a line at a time; a new error starts without any. */
static void test_help(void **state) {
    (void)state;
    diag d = {0};
    diag_fail(&d, SARCINA_NUMERICAL, "the step is too small");
    assert_int_equal(diag_help(&d, "smaller %s", "growth step"), SARCINA_NUMERICAL);
    diag_help(&d, "or stiffer links");
    assert_string_equal(d.help, "smaller growth step\nor stiffer links");
    diag_error(&d, "another");
    assert_string_equal(d.help, "");
}

static void test_first_place_holds(void **state) {
    (void)state;
    const struct source *script = (const struct source *)&script, *other = (const struct source *)&other;
    diag d = {0};
    diag_place(&d, (span){script, 8, 34, 6});
    diag_place(&d, (span){other, 1, 1, 1});
    assert_ptr_equal(d.at.source, script);
    assert_int_equal(d.at.line, 8);
    assert_int_equal(d.at.column, 34);
    assert_int_equal(d.at.length, 6);
    diag_clear(&d);
    assert_null(d.at.source);
    diag_place(&d, (span){other, 1, 1, 1});
    assert_ptr_equal(d.at.source, other);
}

/* Texts longer than the buffers are cut, terminated, and touch nothing beside them. */
static void test_long_texts_are_cut(void **state) {
    (void)state;
    char text[4096];
    memset(text, 'a', sizeof text - 1);
    text[sizeof text - 1] = '\0';
    struct {
        diag d;
        unsigned char after[64];
    } guarded = {0};
    memset(guarded.after, 0x5a, sizeof guarded.after);
    diag_error(&guarded.d, "%s", text);
    assert_int_equal(strlen(guarded.d.message), sizeof guarded.d.message - 1);
    assert_string_equal(guarded.d.help, "");
    for (int i = 0; i < 200; i++) {
        diag_help(&guarded.d, "%.*s", i % 17, text);
        assert_true(strlen(guarded.d.help) < sizeof guarded.d.help);
    }
    assert_int_equal(strlen(guarded.d.message), sizeof guarded.d.message - 1);
    for (size_t i = 0; i < sizeof guarded.after; i++)
        assert_int_equal(guarded.after[i], 0x5a);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_status_and_text),
        cmocka_unit_test(test_null_is_allowed),
        cmocka_unit_test(test_help),
        cmocka_unit_test(test_first_place_holds),
        cmocka_unit_test(test_long_texts_are_cut),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}

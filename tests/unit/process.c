/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Programs that take what we write, that end too early, that fail, that are not there. */
#include "check.h"
#include "scratch.h"

#include "base/process.h"

#include <stdio.h>
#include <string.h>

static void test_bytes_arrive(void **state) {
    (void)state;
    char *file = alloc_format("%s/taken", folder), *to = alloc_format("of=%s", file);
    const char *const words[] = {"dd", to, "status=none", NULL};
    process *p = process_open(words, NULL);
    assert_non_null(p);
    enum { N = 300000 }; /* more than a socket holds */
    char *bytes = alloc_zeroed(N, 2), *seen = alloc_zeroed(N, 2);
    for (int i = 0; i < N; i++)
        bytes[i] = (char)(i * 7 % 251);
    assert_int_equal(process_write(p, bytes, N / 2, NULL), SARCINA_OK);
    assert_int_equal(process_write(p, bytes + N / 2, N - N / 2, NULL), SARCINA_OK);
    assert_int_equal(process_close(p, NULL), SARCINA_OK);
    FILE *f = fopen(file, "rb");
    assert_non_null(f);
    assert_int_equal(fread(seen, 1, 2 * N, f), N);
    assert_memory_equal(seen, bytes, N);
    fclose(f);
    free(bytes);
    free(seen);
    free(file);
    free(to);
}

static void test_an_early_end_is_no_signal(void **state) {
    (void)state;
    const char *const words[] = {"true", NULL};
    static char bytes[1 << 20];
    process *p = process_open(words, NULL);
    diag d = {0};
    assert_non_null(p);
    int status = SARCINA_OK;
    for (int i = 0; i < 100 && !status; i++)
        status = process_write(p, bytes, sizeof bytes, &d);
    assert_int_equal(status, SARCINA_ERROR);
    assert_string_equal(d.message, "true ended before it should");
    assert_int_equal(process_close(p, NULL), SARCINA_OK);
}

static void test_failure_is_told(void **state) {
    (void)state;
    const char *const words[] = {"false", NULL};
    diag d = {0};
    process *p = process_open(words, &d);
    assert_non_null(p);
    assert_int_equal(process_close(p, &d), SARCINA_ERROR);
    assert_string_equal(d.message, "false failed");
    assert_int_equal(process_close(NULL, NULL), SARCINA_OK);
}

static void test_what_is_not_there(void **state) {
    (void)state;
    const char *const words[] = {"no-such-program", NULL};
    diag d = {0};
    assert_int_equal(process_check("true", "coreutils", NULL), SARCINA_OK);
    assert_int_equal(process_check("no-such-program", "a-package", &d), SARCINA_ERROR);
    assert_string_equal(d.message, "the program no-such-program is needed for this and is not in PATH");
    assert_string_equal(d.help, "apt-get install a-package");
    d = (diag){0};
    assert_null(process_open(words, &d));
    assert_non_null(strstr(d.message, "cannot start no-such-program: "));
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_bytes_arrive),
        cmocka_unit_test(test_an_early_end_is_no_signal),
        cmocka_unit_test(test_failure_is_told),
        cmocka_unit_test(test_what_is_not_there),
    };
    return cmocka_run_group_tests(tests, make_folder, drop_folder);
}

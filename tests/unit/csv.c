/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Tables with commas, as RFC 4180 and our own writers make them. */
#include "check.h"
#include "scratch.h"

#include "base/csv.h"

#include <stdio.h>
#include <string.h>

static csv open_text(const char *text) {
    csv t;
    char *path = alloc_format("%s/t.csv", folder);
    FILE *f = fopen(path, "w");
    fputs(text, f);
    fclose(f);
    assert_int_equal(csv_open(&t, path, NULL), SARCINA_OK);
    free(path);
    return t;
}

static void check_row(csv *t, size_t n, const char *const *fields) {
    assert_true(csv_next(t));
    assert_int_equal(t->n, n);
    for (size_t i = 0; i < n; i++)
        assert_string_equal(t->fields[i], fields[i]);
}

static void test_rows(void **state) {
    (void)state;
    csv t = open_text("# a comment\nstep,name,value\r\n\n1,\"a, b\",2\n2,\"say \"\"no\"\"\",\n,,\n3,last,4");
    check_row(&t, 3, (const char *[]){"step", "name", "value"});
    check_row(&t, 3, (const char *[]){"1", "a, b", "2"});
    check_row(&t, 3, (const char *[]){"2", "say \"no\"", ""});
    check_row(&t, 3, (const char *[]){"", "", ""});
    check_row(&t, 3, (const char *[]){"3", "last", "4"});
    assert_false(csv_next(&t));
    csv_close(&t);
}

static void test_wide(void **state) {
    (void)state;
    char text[2002];
    memset(text, ',', 2000);
    memcpy(text + 2000, "\n", 2);
    csv t = open_text(text);
    assert_true(csv_next(&t));
    assert_int_equal(t.n, 2001);
    csv_close(&t);
}

/* What a crash may leave must not read beyond its end. */
static void test_broken_quotes(void **state) {
    (void)state;
    csv t = open_text("a,\"never closed, b\n\"\n\"x\"y,z\n");
    check_row(&t, 2, (const char *[]){"a", "never closed, b"});
    check_row(&t, 1, (const char *[]){""});
    check_row(&t, 2, (const char *[]){"x", "z"});
    csv_close(&t);
}

static void test_missing(void **state) {
    (void)state;
    csv t;
    diag d = {0};
    assert_int_equal(csv_open(&t, "no/such.csv", &d), SARCINA_ERROR);
    assert_non_null(strstr(d.message, "no/such.csv"));
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_rows),
        cmocka_unit_test(test_wide),
        cmocka_unit_test(test_broken_quotes),
        cmocka_unit_test(test_missing),
    };
    return cmocka_run_group_tests(tests, make_folder, drop_folder);
}

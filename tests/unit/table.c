/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Look-up by name, and the name that was meant. */
#include "check.h"

#include "base/table.h"

#include <stdlib.h>
#include <string.h>

typedef struct record {
    const char *name;
    int payload[5]; /* a stride that is not the name's */
} record;

static const record records[] = {
    {"create_cells", {0}}, {"diameter", {0}}, {"growth", {0}}, {"division", {0}}, {"k", {0}}, {"x", {0}},
    {"link", {0}},         {"relax", {0}},    {"ecoli", {0}},
};

static const char *nearest(const char *typed) {
    return table_nearest(records, TABLE_COUNT(records), sizeof records[0], typed);
}

static void test_find(void **state) {
    (void)state;
    for (size_t i = 0; i < TABLE_COUNT(records); i++)
        assert_int_equal(table_find(records, TABLE_COUNT(records), sizeof records[0], records[i].name), i);
    assert_int_equal(table_find(records, TABLE_COUNT(records), sizeof records[0], "Growth"), -1);
    assert_int_equal(table_find(records, TABLE_COUNT(records), sizeof records[0], "grow"), -1);
    assert_int_equal(table_find(records, TABLE_COUNT(records), sizeof records[0], ""), -1);
    assert_int_equal(table_find(records, 0, sizeof records[0], "growth"), -1);
}

static void test_nearest(void **state) {
    (void)state;
    assert_string_equal(nearest("creat_cells"), "create_cells");
    assert_string_equal(nearest("create_cell"), "create_cells");
    assert_string_equal(nearest("diamter"), "diameter");
    assert_string_equal(nearest("diameetr"), "diameter");
    assert_string_equal(nearest("GROWTH"), "growth");
    assert_string_equal(nearest("rleax"), "relax");
    assert_string_equal(nearest("Ecoli"), "ecoli");
    assert_string_equal(nearest("K"), "k");
}

/* What resembles nothing gets no suggestion; least of all a word of one or two letters. */
static void test_nothing_near(void **state) {
    (void)state;
    assert_null(nearest("substratum"));
    assert_null(nearest("z"));
    assert_null(nearest("y"));
    assert_null(nearest("zz"));
    assert_null(nearest(""));
    assert_null(table_nearest(records, 0, sizeof records[0], "growth"));
}

static void test_distance(void **state) {
    (void)state;
    assert_near(table_distance("relax", "relax"), 0, 0);
    assert_near(table_distance("", "relax"), 5, 0);
    assert_near(table_distance("relax", ""), 5, 0);
    assert_near(table_distance("rlax", "relax"), 1, 0);   /* insertion */
    assert_near(table_distance("rellax", "relax"), 1, 0); /* deletion */
    assert_near(table_distance("rexax", "relax"), 1, 0);  /* substitution */
    assert_near(table_distance("realx", "relax"), 1, 0);  /* swap */
    assert_near(table_distance("erlax", "relax"), 1, 0);  /* swap of the first two */
    assert_near(table_distance("kitten", "sitting"), 3, 0);
    assert_near(table_distance("ca", "abc"), 3, 0); /* optimal string alignment, not full Damerau (2) */
    assert_true(table_distance("Relax", "relax") < 0.5);
}

/* The metric's symmetry, and no reading past names of any length. */
static void test_distance_is_symmetric(void **state) {
    (void)state;
    char a[100], b[100];
    unsigned s = 12345;
    for (int trial = 0; trial < 3000; trial++) {
        size_t n = (s = s * 1103515245u + 12345u) / 65536 % 90, m = (s = s * 1103515245u + 12345u) / 65536 % 90;
        for (size_t i = 0; i < n; i++)
            a[i] = "abcABC_"[(s = s * 1103515245u + 12345u) / 65536 % 7];
        for (size_t i = 0; i < m; i++)
            b[i] = "abcABC_"[(s = s * 1103515245u + 12345u) / 65536 % 7];
        a[n] = b[m] = '\0';
        double there = table_distance(a, b), back = table_distance(b, a);
        assert_near(there, back, 1e-9);
        assert_true((there == 0) == (strcmp(a, b) == 0));
        if (n < 64 && m < 64)
            assert_true(there >= (n > m ? (double)(n - m) : (double)(m - n)) && there <= (double)(n > m ? n : m));
    }
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_find),
        cmocka_unit_test(test_nearest),
        cmocka_unit_test(test_nothing_near),
        cmocka_unit_test(test_distance),
        cmocka_unit_test(test_distance_is_symmetric),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}

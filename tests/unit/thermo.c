/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The thermo table as it looks on the screen and as its file reads back. */
#include "check.h"
#include "scratch.h"

#include "base/alloc.h"
#include "base/path.h"
#include "output/stream.h"
#include "output/thermo.h"

#include <inttypes.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

/* A column that gives what a number of the test holds. */
static int give(void *self, uint32_t row, double *si, diag *d) {
    (void)row, (void)d;
    *si = *(const double *)self;
    return SARCINA_OK;
}

static int give_text(void *self, uint32_t row, char out[64], diag *d) {
    (void)row, (void)d;
    snprintf(out, 64, "%s", (const char *)self);
    return SARCINA_OK;
}

static output_column column(const char *name, dim d, double *number) {
    return (output_column){.name = alloc_copy(name), .d = d, .self = number, .number = give};
}

static void collect(void *self, const char *line) {
    char **text = self, *longer = alloc_format("%s%s\n", *text, line);
    free(*text);
    *text = longer;
}

static char *read_file(const char *path) {
    FILE *f = fopen(path, "r");
    assert_non_null(f);
    char *text = alloc_zeroed(1, 1 << 16);
    fread(text, 1, (1 << 16) - 1, f);
    fclose(f);
    return text;
}

static void check_file(const char *path, const char *wanted) {
    char *text = read_file(path);
    assert_string_equal(text, wanted);
    free(text);
}

static char *path_of(const char *name) {
    return alloc_format("%s/%s", folder, name);
}

static void test_screen_has_columns_below_their_headings(void **state) {
    (void)state;
    double step = 5, height = 0.75e-6, ratio = 1.0 / 3, undefined = NAN, many = 1234567890;
    const output_column columns[] = {column("step", DIM_NONE, &step), column("thickness", DIM_LENGTH, &height),
                                     column("max(overlap)/1nm", DIM_NONE, &ratio), column("C", DIM_NONE, &undefined),
                                     column("particles", DIM_NONE, &many)};
    thermo *t = thermo_create();
    thermo_set_columns(t, columns, 5);
    char *text = alloc_copy("");
    thermo_header(t, collect, &text);
    assert_int_equal(thermo_row(t, 5, collect, &text, NULL), SARCINA_OK);
    assert_string_equal(text, "        Step    Thickness max(overlap)/1nm            C    Particles\n"
                              "           5      7.5e-07       0.33333333          nan   1234567890\n");
    assert_near(thermo_last(t, 1), 0.75e-6, 0);
    free(text);
    thermo_free(t);
}

static void test_formats_and_units_change_the_screen_only(void **state) {
    (void)state;
    double height = 0.75e-6, count = 1.9999999999;
    const output_column columns[] = {column("thickness", DIM_LENGTH, &height), column("n", DIM_NONE, &count)};
    char *path = path_of("units.csv"), *text = alloc_copy("");
    thermo *t = thermo_create();
    diag d = {0};
    thermo_set_columns(t, columns, 2);
    thermo_set_unit(t, 0, 1e-6);
    thermo_set_suffix(t, 0, "um");
    assert_int_equal(thermo_set_format(t, "thickness", "%.2f", &d), SARCINA_OK);
    assert_int_equal(thermo_set_format(t, "n", "%04d", &d), SARCINA_OK);
    const char *const wrong[] = {"", "%", "%s", "%n", "%.3f%s", "x%f", "%lf", "%*d", "%.100f", "%1000d", "%ff", "%p"};
    for (size_t i = 0; i < sizeof wrong / sizeof *wrong; i++)
        assert_int_equal(thermo_set_format(t, "n", wrong[i], &d), SARCINA_ERROR);
    assert_int_equal(thermo_set_format(t, "thicknes", "%g", &d), SARCINA_ERROR);
    thermo_set_file(t, path);
    thermo_header(t, collect, &text);
    assert_int_equal(thermo_row(t, 3, collect, &text, &d), SARCINA_OK);
    assert_string_equal(text, "Thickness[um]            N\n"
                              "         0.75         0002\n");
    check_file(path, "step,thickness[um],n\n3,7.5e-07,1.9999999999\n");
    thermo_free(t);
    free(text);
    free(path);
}

/* Awkward doubles read back to the bit; a text with a comma is one field. */
static void test_file_reads_back_to_the_bit(void **state) {
    (void)state;
    const double numbers[] = {0.1, 1.0 / 3, 1e-300, 5e-324, 1.7976931348623157e308, -0.1 - 1e-16, 123456789012345678.0};
    double x, step;
    const output_column columns[] = {column("a,\"b\"", DIM_LENGTH, &x),
                                     column("step", DIM_NONE, &step),
                                     {.name = alloc_copy("word"), .is_text = true, .self = "p,q", .text = give_text}};
    char *path = path_of("bits.csv"), *ignored = alloc_copy("");
    thermo *t = thermo_create();
    thermo_set_columns(t, columns, 3);
    thermo_set_file(t, path);
    for (size_t i = 0; i < sizeof numbers / sizeof *numbers; i++) {
        x = numbers[i];
        step = (double)i;
        assert_int_equal(thermo_row(t, i, collect, &ignored, NULL), SARCINA_OK);
    }
    FILE *f = fopen(path, "r");
    char line[256];
    assert_non_null(fgets(line, sizeof line, f));
    assert_string_equal(line, "\"a,\"\"b\"\"\",step,word\n");
    for (size_t i = 0; i < sizeof numbers / sizeof *numbers; i++) {
        char *end;
        assert_non_null(fgets(line, sizeof line, f));
        double seen = strtod(line, &end);
        assert_memory_equal(&seen, &numbers[i], sizeof seen);
        assert_int_equal(strtol(end + 1, &end, 10), i);
        assert_string_equal(end, ",\"p,q\"\n");
    }
    assert_null(fgets(line, sizeof line, f));
    fclose(f);
    free(ignored);
    free(path);
    thermo_free(t);
}

static thermo *open_table(const char *path, double *step, double *x, bool resumes, uint64_t at) {
    const output_column columns[] = {column("x", DIM_NONE, x), column("step", DIM_NONE, step)};
    thermo *t = thermo_create();
    thermo_set_columns(t, columns, 2);
    thermo_set_file(t, path);
    if (resumes)
        assert_int_equal(thermo_rewind(t, at, NULL), SARCINA_OK);
    assert_int_equal(thermo_open(t, NULL), SARCINA_OK);
    return t;
}

/* Prints the steps from..to of the function 0.5 step. */
static void print_rows(thermo *t, double *step, double *x, int from, int to) {
    char *ignored = alloc_copy("");
    for (int i = from; i <= to; i++) {
        *step = i;
        *x = 0.5 * i;
        assert_int_equal(thermo_row(t, (uint64_t)i, collect, &ignored, NULL), SARCINA_OK);
    }
    free(ignored);
}

static void test_a_step_is_written_once(void **state) {
    (void)state;
    double step, x;
    char *path = path_of("once.csv");
    thermo *t = open_table(path, &step, &x, false, 0);
    print_rows(t, &step, &x, 0, 2);
    print_rows(t, &step, &x, 2, 3); /* the next run prints the row it begins with again */
    check_file(path, "x,step\n0,0\n0.5,1\n1,2\n1.5,3\n");
    thermo_free(t);
    free(path);
}

static void test_going_on_from_a_restart(void **state) {
    (void)state;
    double step, x;
    char *path = path_of("resume.csv");
    thermo *t = open_table(path, &step, &x, false, 0);
    print_rows(t, &step, &x, 0, 12);
    thermo_free(t);
    /* another session goes on from step 9: 10 to 12 are lost, 9 is not written twice */
    t = open_table(path, &step, &x, true, 9);
    print_rows(t, &step, &x, 9, 10);
    check_file(path, "x,step\n0,0\n0.5,1\n1,2\n1.5,3\n2,4\n2.5,5\n3,6\n3.5,7\n4,8\n4.5,9\n5,10\n");
    /* the same session goes back to step 1 */
    assert_int_equal(thermo_rewind(t, 1, NULL), SARCINA_OK);
    print_rows(t, &step, &x, 1, 2);
    check_file(path, "x,step\n0,0\n0.5,1\n1,2\n");
    thermo_free(t);
    /* a line cut short by a crash goes */
    FILE *f = fopen(path, "a");
    fputs("1.5,3", f);
    fclose(f);
    t = open_table(path, &step, &x, true, 5);
    check_file(path, "x,step\n0,0\n0.5,1\n1,2\n");
    thermo_free(t);
    /* without a restart the file begins anew */
    t = open_table(path, &step, &x, false, 0);
    check_file(path, "x,step\n");
    thermo_free(t);
    free(path);
}

static void test_files_that_cannot_be_written(void **state) {
    (void)state;
    diag d = {0};
    assert_int_equal(path_check("no/such/folder/x.csv", &d), SARCINA_OK); /* folders are made */
    assert_int_equal(path_check("/dev/null/x.csv", &d), SARCINA_ERROR);
    assert_string_equal(d.message, "cannot write '/dev/null/x.csv': Not a directory");
    assert_int_equal(path_check(folder, &d), SARCINA_ERROR);
    assert_non_null(strstr(d.message, "Is a directory"));
    char *path = path_of("untouched.csv");
    assert_int_equal(path_check(path, &d), SARCINA_OK);
    thermo *t = thermo_create();
    thermo_set_file(t, path);
    assert_int_equal(access(path, F_OK), -1); /* nothing is touched before the table opens */
    thermo_set_file(t, "/dev/null/x.csv");
    assert_int_equal(thermo_open(t, &d), SARCINA_ERROR);
    free(path);
    thermo_free(t);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_screen_has_columns_below_their_headings),
        cmocka_unit_test(test_formats_and_units_change_the_screen_only),
        cmocka_unit_test(test_file_reads_back_to_the_bit),
        cmocka_unit_test(test_a_step_is_written_once),
        cmocka_unit_test(test_going_on_from_a_restart),
        cmocka_unit_test(test_files_that_cannot_be_written),
    };
    return cmocka_run_group_tests(tests, make_folder, drop_folder);
}

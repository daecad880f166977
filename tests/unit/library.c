/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The public API: what it runs gives the program's own bits, a failed call says why and leaves the scene as it was. */
#include "sarcina/sarcina.h"

#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>

#include <cmocka.h>

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

static const char colony[] = "species ball coccus\n"
                             "growth ball exponential rate 1/h sd 10%\n"
                             "division ball random mass 6e-16kg\n"
                             "force collision\n"
                             "force damping\n"
                             "create_cells ball single 0 0 0\n"
                             "run 60 grow 4min relax 1s\n";

static int open_scene(void **state) {
    *state = sarcina_create(NULL);
    return *state ? 0 : -1;
}

static int close_scene(void **state) {
    sarcina_free(*state);
    return 0;
}

static double value_of(sarcina *s, const char *expression) {
    double value = NAN;
    if (sarcina_value(s, expression, &value) != SARCINA_OK)
        fail_msg("%s", sarcina_error(s));
    return value;
}

static void runs(sarcina *s, const char *text) {
    if (sarcina_run(s, text) != SARCINA_OK)
        fail_msg("%s", sarcina_error(s));
    assert_string_equal(sarcina_error(s), "");
}

static void test_values(void **state) {
    sarcina *s = *state;
    runs(s, colony);
    size_t n = sarcina_cells(s);
    assert_int_equal(n, 32);
    assert_true(value_of(s, "cells") == 32);
    assert_true(value_of(s, "time/1h") == 4);
    double *x = malloc(n * sizeof *x), *id = malloc(n * sizeof *id), sum = 0, least = 0;
    assert_int_equal(sarcina_cell_values(s, "x/1um", x), SARCINA_OK);
    assert_int_equal(sarcina_cell_values(s, "id", id), SARCINA_OK);
    for (size_t i = 0; i < n; i++) {
        assert_true(id[i] > least); /* in the order of ids */
        least = id[i];
        sum += x[i];
    }
    assert_true(fabs(sum / (double)n - value_of(s, "mean(x)/1um")) < 1e-12);
    assert_true(fabs(value_of(s, "max(x)") / value_of(s, "max(x)/1um") - 1e-6) < 1e-18); /* SI without a unit */
    free(x);
    free(id);
}

/* Rows are put in order of space now and then; values stay with their cells. */
static void test_order(void **state) {
    sarcina *s = *state;
    runs(s, "species ball coccus\n"
            "for i in 1 2 3 4 5\n"
            "    create_cells ball single ${i}mm 0 0 mass 6e-16kg\n"
            "end\n"
            "delete_cells all where \"id == 2\"\n");
    double x[4];
    assert_int_equal(sarcina_cell_values(s, "x/1mm", x), SARCINA_OK);
    const double wanted[4] = {1, 3, 4, 5};
    for (size_t i = 0; i < 4; i++)
        assert_true(fabs(x[i] - wanted[i]) < 1e-12);
}

static void test_same_bits(void **state) {
    sarcina *a = *state, *b = sarcina_create(NULL);
    runs(a, colony);
    char line[128];
    for (const char *c = colony; *c; c += strcspn(c, "\n") + 1) { /* line by line, with another scene beside it */
        snprintf(line, sizeof line, "%.*s", (int)strcspn(c, "\n"), c);
        runs(b, line);
    }
    assert_true(value_of(a, "gyration") == value_of(b, "gyration"));
    sarcina_free(b);
}

static void test_errors(void **state) {
    sarcina *s = *state;
    double value = 7;
    runs(s, "species ball coccus\ncreate_cells ball single 0 0 0 mass 6e-16kg\n");
    assert_int_equal(sarcina_run(s, "print \"so far\"\nforce colision\n"), SARCINA_ERROR);
    assert_non_null(strstr(sarcina_error(s), "text:2:7: error: "));
    assert_non_null(strstr(sarcina_error(s), "collision"));
    assert_int_equal(sarcina_value(s, "cels", &value), SARCINA_ERROR);
    assert_non_null(strstr(sarcina_error(s), "text:1:1: error: "));
    assert_int_equal(sarcina_value(s, "cells 5", &value), SARCINA_ERROR);
    assert_non_null(strstr(sarcina_error(s), "'cells 5' is not one expression"));
    assert_int_equal(sarcina_value(s, "x", &value), SARCINA_ERROR); /* of which cell? */
    assert_int_equal(sarcina_value(s, "", &value), SARCINA_ERROR);
    assert_int_equal(sarcina_run_file(s, "/nowhere/a.in"), SARCINA_ERROR);
    assert_non_null(strstr(sarcina_error(s), "/nowhere/a.in"));
    assert_int_equal(sarcina_run(s, "shell true\n"), SARCINA_ERROR);
    assert_int_equal(sarcina_set_variable(s, "1st", "x"), SARCINA_ERROR);
    assert_true(value == 7);
    assert_true(value_of(s, "cells") == 1);
    assert_string_equal(sarcina_error(s), "");
}

static void test_check(void **state) {
    sarcina *s = *state;
    char name[] = "/tmp/sarcina-api-XXXXXX";
    int file = mkstemp(name);
    static const char text[] = "variable d default 1um\nspecies ball coccus diameter $d\nfrce collision\nruns 5\n";
    assert_int_equal(write(file, text, sizeof text - 1), sizeof text - 1);
    close(file);
    assert_int_equal(sarcina_check_file(s, name), SARCINA_ERROR);
    assert_non_null(strstr(sarcina_error(s), ":3:1: error: "));
    assert_non_null(strstr(sarcina_error(s), ":4:1: error: "));
    assert_int_equal(sarcina_cells(s), 0);
    assert_int_equal(sarcina_run(s, "print \"$d\"\n"), SARCINA_ERROR); /* nothing of it stands */
    unlink(name);
}

typedef struct listener {
    char screen[4096], warnings[4096];
    sarcina *stops; /* at the first line, NULL: goes on */
} listener;

static void hear(void *self, const char *text) {
    listener *l = self;
    strncat(l->screen, text, sizeof l->screen - strlen(l->screen) - 1);
    if (l->stops)
        sarcina_interrupt(l->stops);
}

static void be_warned(void *self, const char *text) {
    listener *l = self;
    strncat(l->warnings, text, sizeof l->warnings - strlen(l->warnings) - 1);
}

static void test_output(void **state) {
    (void)state;
    listener l = {0};
    const sarcina_output out = {.self = &l, .screen = hear, .warnings = be_warned};
    sarcina *s = sarcina_create(&out);
    assert_int_equal(sarcina_set_variable(s, "who", "reader"), SARCINA_OK);
    runs(s, "variable who default nobody\nprint \"dear ${who}\"\n");
    assert_string_equal(l.screen, "dear reader\n");
    runs(s, "species ball coccus\ncreate_cells ball single 0 0 0 mass 6e-16kg\ngroup far where \"x > 1um\"\n");
    assert_non_null(strstr(l.warnings, "text:3: warning: group far is empty"));
    assert_string_equal(l.screen, "dear reader\ncreated 1 cell of ball: 1 in all\ngroup far: 0 of 1 cell\n");
    sarcina_free(s);
}

/* The run stops at a whole cycle, and goes on from there as if nothing had been. */
static void test_interrupt(void **state) {
    listener l = {0};
    const sarcina_output out = {.self = &l, .screen = hear};
    sarcina *s = sarcina_create(&out), *whole = *state;
    char *end = strstr(colony, "run 60"), before[512];
    snprintf(before, sizeof before, "%.*sthermo 10\n", (int)(end - colony), colony);
    runs(s, before);
    l.stops = s;
    assert_int_equal(sarcina_run(s, "run 60 grow 4min relax 1s\n"), SARCINA_INTERRUPTED);
    assert_non_null(strstr(sarcina_error(s), "interrupted"));
    double done = value_of(s, "step");
    assert_true(done < 60);
    l.stops = NULL;
    char rest[64];
    snprintf(rest, sizeof rest, "run %d grow 4min relax 1s\n", 60 - (int)done);
    runs(s, rest);
    runs(whole, colony);
    assert_true(value_of(s, "gyration") == value_of(whole, "gyration"));
    sarcina_free(s);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test_setup_teardown(test_values, open_scene, close_scene),
        cmocka_unit_test_setup_teardown(test_order, open_scene, close_scene),
        cmocka_unit_test_setup_teardown(test_same_bits, open_scene, close_scene),
        cmocka_unit_test_setup_teardown(test_errors, open_scene, close_scene),
        cmocka_unit_test_setup_teardown(test_check, open_scene, close_scene),
        cmocka_unit_test(test_output),
        cmocka_unit_test_setup_teardown(test_interrupt, open_scene, close_scene),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}

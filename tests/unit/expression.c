/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Expressions: what each prints, and the error of each that is wrong, under both systems of units. */
#include "script_host.h"

#include "script/expr.h"

#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>

#include <cmocka.h>

/* Runs a script; what it printed, or the error it ended with. */
static const char *run(script_host *h, const char *text) {
    interp *in = interp_create(&h->host);
    script_host_clear(h);
    int status = interp_run_source(in, "test", text);
    interp_free(in);
    h->printed[strcspn(h->printed, "\n")] = '\0';
    return status ? h->errors : h->printed;
}

static void test_values(void **state) {
    static const struct {
        const char *expr, *printed;
    } cases[] = {
        {"1+2*3", "7"},
        {"(1+2)*3", "9"},
        {"2^3^2", "512"},
        {"-2^2", "-4"},
        {"(-2)^2", "4"},
        {"2^-1", "0.5"},
        {"2*-3", "-6"},
        {"1--1", "2"},
        {"7%3", "1"},
        {"-7%3", "-1"},
        {"!0 + !3", "1"},
        {"1 < 2 && 2 < 1 || 1", "1"},
        {"0 && 1/0", "0"},
        {"1 || 1/0", "1"},
        {"ternary(1, 2, 1/0)", "2"},
        {"1um + 2", "2.000001m"},
        {"2*0.4um", "8e-07m"},
        {"1um*2um", "2e-12m2"},
        {"1um/1s", "1e-06m/s"},
        {"1kg*1m/1s^2", "1N"},
        {"1/1h", "0.00027777777777777778/s"},
        {"sqrt(4um2)", "2e-06m"},
        {"(8um3)^(1/3) > 1.99um", "1"},
        {"abs(-3um)", "3e-06m"},
        {"max(1, 3, 2) + min(4, 2)", "5"},
        {"hypot(3, 4)", "5"},
        {"atan2(1um, 1um)/1degree", "45"},
        {"sin(90degree)", "1"},
        {"ln(exp(2))", "2"},
        {"log10(1000)", "3"},
        {"floor(-1.5) + ceil(1.2) + round(2.5)", "3"},
        {"sign(-3um)", "-1"},
        {"'a' == 'a'", "1"},
        {"\"ab\" != 'ab'", "0"},
        {"cells", "0"},
        {"count(z > 1um)", "0"},
        {"sum(z)", "0m"},
        {"mean(z)", "nan"},
        {"mean(z) > 1um", "0"},
        {"thickness > 0.75", "0"},
        {"pi", "3.1415926535897931"},
        {"defined('cells') + defined('nothing')", "1"},
        {"1e3um/1mm", "1"},
        {"5e-11N/1m", "5e-11N/m"},
        {"ternary(cells > 0, 'many', 'none')", "none"},
    };
    script_host h;
    script_host_open(&h);
    (void)state;
    for (size_t i = 0; i < sizeof cases / sizeof *cases; i++) {
        char *text = alloc_format("print \"\"\"$(%s)\"\"\"\n", cases[i].expr);
        const char *got = run(&h, text);
        if (strcmp(got, cases[i].printed) != 0)
            fail_msg("%s: '%s', not '%s'", cases[i].expr, got, cases[i].printed);
        free(text);
    }
    script_host_close(&h);
}

static void reads_back(script_host *h, const char *value) {
    char *text = alloc_format("variable q equal %s\nprint \"$($(q) == q && ${q} == q && -${q}^2 == -q^2) $(2*${q}/q) "
                              "$(abs(${q}-q) == 0*q)\"\n",
                              value);
    const char *got = run(h, text);
    if (strcmp(got, "1 2 1") != 0)
        fail_msg("%s: '%s'", value, got);
    free(text);
}

/* What $( ) prints of a value is that value where an expression reads it, to the bit, whatever its dimension and
 * whatever stands around it; so is that of a formula by its name. */
static void test_read_back(void **state) {
    static const char *const odd[] = {"(2J)^(1/3)", "1/sqrt(3s)", "7J/1s",    "3/(1m*1s)",
                                      "-3m/7s",     "1e-30m/3s",  "2Pa*1s/3m"};
    script_host h;
    script_host_open(&h);
    (void)state;
    dim d;
    for (size_t i = 0; dim_listed(i, &d); i++) {
        char *third =
            alloc_format("(1m^(%d/12))*(1kg^(%d/12))*(1s^(%d/12))/3", (int)d.length, (int)d.mass, (int)d.time);
        reads_back(&h, third);
        free(third);
    }
    for (size_t i = 0; i < sizeof odd / sizeof *odd; i++)
        reads_back(&h, odd[i]);
    assert_string_equal(run(&h, "print '$($(2)um/1um)'\n"), "2"); /* a pure number takes a unit */
    script_host_close(&h);
}

static void test_errors(void **state) {
    static const struct {
        const char *expr, *message;
    } cases[] = {
        {"1 +", "expected a value"},
        {"", "expected a value"},
        {"((1", "this '(' is not closed"},
        {"max((1 2", "this '(' is not closed"},
        {"max(1 2", "expected ',' or ')'"},
        {"z[1", "this '[' is not closed"},
        {"max(1,)", "expected a value, not ')'"},
        {"2kg.m2/s2", "a number of an expression takes one unit: 2N.m is 2N*1m there"},
        {"1 & 2", "write '&&'"},
        {"1 | 2", "write '||'"},
        {"1 = 2", "write '=='"},
        {"1 / 0", "division by zero"},
        {"5 % 0", "division by zero"},
        {"1e300*1e300", "the result of '*' is not finite"},
        {"sqrt(-1)", "sqrt(-1) is not finite"},
        {"ln(0)", "is not finite"},
        {"exp(1um)", "exp takes a pure number, not a length"},
        {"1um + 1s", "'+' between length and time"},
        {"1um && 1", "'&&' between length and pure number"},
        {"!1um", "'!' takes a truth, not a length"},
        {"-'a'", "'-' of a text"},
        {"'a' < 'b'", "only == and != compare texts"},
        {"'a' == 1", "between a text and a number"},
        {"2^1um", "an exponent is a pure number"},
        {"(1um)^cells", "needs a constant exponent"},
        {"(1um)^0.3", "needs a constant exponent"},
        {"mean(1)", "takes a value per cell or a list"},
        {"mean(species)", "takes numbers, not a text"},
        {"count(z)", "takes a truth per cell, not a length"},
        {"mean(z where 'a')", "where takes a truth per cell"},
        {"quantile(2, z)", "number from 0 to 1"},
        {"quantile(z)", "takes other arguments: quantile(p, x"},
        {"sqrt(1, 2)", "takes other arguments: sqrt(x)"},
        {"sqrt('a')", "sqrt takes numbers, not a text"},
        {"nothing(1)", "no function 'nothing'"},
        {"cells(1)", "'cells' is a value, not a function"},
        {"mean", "'mean' is a function"},
        {"cells.all", "cells has no 'all'"},
        {"links.stik", "did you mean 'stick'"},
        {"cells[1]", "cells is one value: it takes no [ ]"},
        {"z[1.5]", "whole number from 1"},
        {"z[1um]", "one pure number"},
        {"z[1]", "there is no cell 1"},
        {"z", "'z' has a value per cell"},
        {"is_file(3)", "takes a text in quotes"},
        {"PI", "the constant is pi"},
        {"'a", "the quote is not closed"},
        {"1 2", "expected ')', not '2'"},
        {"max(1,2,3,4,5,6,7,8,9)", "has too many arguments"},
        {"hypot(1um, 1s)", "hypot between length and time"},
        {"ternary(1, 1um, 1s)", "ternary between length and time"},
        {"not cells", "write !"},
        {"@", "expected a value, not '@'"},
    };
    script_host h;
    script_host_open(&h);
    (void)state;
    for (size_t i = 0; i < sizeof cases / sizeof *cases; i++) {
        char *text = alloc_format("print $(%s)\n", cases[i].expr);
        const char *got = run(&h, text);
        if (!strstr(got, cases[i].message))
            fail_msg("%s: '%s', not '%s'", cases[i].expr, got, cases[i].message);
        free(text);
    }
    script_host_close(&h);
}

/* Bare numbers are in the script's units; what carries a unit means the same. */
static void test_bio(void **state) {
    (void)state;
    script_host h;
    script_host_open(&h);
    assert_string_equal(run(&h, "units bio\nprint \"$(1um + 2) $(1um:%g) $(1pg:%g) $(thickness > 0.75)\"\n"),
                        "3e-06m 1 1 0");
    assert_string_equal(run(&h, "print \"$(1um:%g)\"\n"), "1e-06");
    script_host_close(&h);
}

static void test_variables(void **state) {
    static const struct {
        const char *script, *due;
    } cases[] = {
        {"variable a default 1\nvariable a default 2\nprint $a", "1"},
        {"variable a string 1\nvariable a string 2\nprint $a", "2"},
        {"variable a equal b*2\nvariable b equal 3um\nprint ${a}", "6e-06m"},
        {"variable a equal a+1\nprint ${a}", "depends on itself"},
        {"variable a default -2\nprint $($a^2)", "4"},
        {"variable a default -2\nprint $(1-$a)", "3"},
        {"variable a default -2\nprint $(1 $a)", "expected ')'"},
        {"variable a default 3um\nprint $(a/1um)", "3"},
        {"variable a list 1um 2um 6um\nprint \"$(mean(a)/1um) $(a[2]) $(count(a)) ${a}\"", "3 2e-06m 3 1um 2um 6um"},
        {"variable a list 1um 2s\nprint $(mean(a))", "holds a length and a time"},
        {"variable a list\nvariable a append cells+1\nvariable a append 3\nprint $(sd(a)/sqrt(2))", "1"},
        {"variable a default 1\nvariable a append 2", "is no list"},
        {"variable a list x y\nprint $(a[2])", "y"},
        {"variable a list 1\nprint $(a[2])", "a has 1 element"},
        {"variable a list 1\nprint $(a)", "'a' is a list"},
        {"variable a getenv HOME\nprint $a", "somewhere"},
        {"variable a default 1\nvariable a off\nprint $a", "no variable 'a'"},
        {"variable a equal 2 * (3 + 1)\nprint $(a:%d)", "8"},
        {"variable a equal \"2 * 3\"\nprint $(a:%d)", "6"},
        {"print $(1/3:%.2f)", "0.33"},
        {"print $(2um/1nm:%d)", "2000"},
        {"print $(2.5:%d)", "takes a whole number"},
        {"print $('a':%d)", "a format prints a number"},
        {"variable a equal 1 +", "expected a value"},
        {"variable a equal 1 2", "unexpected '2' behind the expression"},
        {"variable 1a default 2", "use a1a"},
        {"variable a-b default 2", "a name is letters, digits and _"},
        {"variable every default 2", "word of the language"},
        {"print ${a", "must be followed by a name and '}'"},
        {"print $", "'$' must begin"},
        {"for i in 3..1\nprint x\nend\nprint y", "y"},
        {"for i in 3..1..-2\nvariable t string $i\nend\nprint $t", "1"},
        {"variable n string 0\nwhile n < 3\nvariable n string $($n+1)\nend\nprint $n", "3"},
        {"variable n string 0\nrepeat 4\nvariable n string $($n+1)\nif n == 2\nbreak\nend\nend\nprint $n", "2"},
        {"if 0\nprint a\nelif 1\nprint b\nelse\nprint c\nend", "b"},
        {"if 0 then 'print a' elif 0 'print b' else 'print c'", "c"},
        {"if 1 then 'print a' else 'print c'", "a"},
        {"break", "'break' outside a loop"},
        {"repeat 1.5\nend", "whole number of passes"},
        {"while 1 2\nend", "unexpected '2' behind the condition"},
        {"quit 3\nprint a", ""},
        {"print a\\b", "a\\b"},
        {"print \"a\" b", "no keyword 'b'"},
    };
    script_host h;
    script_host_open(&h);
    (void)state;
    for (size_t i = 0; i < sizeof cases / sizeof *cases; i++) {
        const char *got = run(&h, cases[i].script);
        if (strcmp(got, cases[i].due) != 0 && !(*h.errors && strstr(h.errors, cases[i].due)))
            fail_msg("%s: '%s', not '%s'", cases[i].script, got, cases[i].due);
    }
    script_host_close(&h);
}

/* random() is a function of the seed and of how many were drawn: the same script, the same numbers. */
static void test_random(void **state) {
    (void)state;
    script_host h;
    script_host_open(&h);
    static const char script[] = "print \"$(random(0,1)) $(normal(0,1)) $(poisson(5))\"\n";
    char *first = alloc_copy(run(&h, script));
    assert_string_equal(first, run(&h, script));
    char *with_seed = alloc_format("seed 2\n%s", script);
    assert_string_not_equal(first, run(&h, with_seed));
    assert_true(strtod(first, NULL) > 0 && strtod(first, NULL) < 1);
    free(first);
    free(with_seed);
    script_host_close(&h);
}

/* Variables survive a save and a load, blanks and all; the command line's stay. */
static void test_save(void **state) {
    (void)state;
    script_host h;
    script_host_open(&h);
    interp *in = interp_create(&h.host), *other = interp_create(&h.host);
    assert_int_equal(interp_run_source(in, "test",
                                       "variable a string \"x % y\"\nvariable b equal cells + 1\n"
                                       "variable c list 1um 2um\nvariable e string ''\nvariable d string 1\n"),
                     SARCINA_OK);
    char *text = interp_variables_save(in);
    assert_int_equal(interp_set_variable(other, "d", "7", NULL), SARCINA_OK);
    assert_int_equal(interp_variables_load(other, text, NULL), SARCINA_OK);
    free(text);
    script_host_clear(&h);
    interp_run_source(other, "test", "print \"$a|$b|$(c[2])|$e|$d\"\n");
    assert_string_equal(h.printed, "x % y|1|2e-06m||7\n");
    interp_free(in);
    interp_free(other);
    script_host_close(&h);
}

/* Columns give the values of the moment, row by row, and know when the scene has changed between two rows. */
static void test_columns(void **state) {
    (void)state;
    script_host h;
    script_host_open(&h);
    interp *in = interp_create(&h.host);
    assert_int_equal(interp_run_source(in, "test",
                                       "species cf coccus\ncreate_cells cf single 0 0 1um mass 5e-16kg\n"
                                       "create_cells cf single 5um 0 2um mass 5e-16kg\nvariable v string word\n"),
                     SARCINA_OK);
    expr *e = expr_of_text(in, "z-min(z)", NULL), *name = expr_of_text(in, "v", NULL);
    output_column z, v;
    double si;
    char text[64];
    assert_int_equal(interp_column(in, e, true, &z, NULL), SARCINA_OK);
    assert_string_equal(z.name, "z-min(z)");
    assert_true(dim_equal(z.d, DIM_LENGTH) && !z.is_text);
    assert_int_equal(z.number(z.self, 0, &si, NULL), SARCINA_OK);
    assert_true(si == 0);
    assert_int_equal(interp_execute(in, "set cf z 3*z where z > 1.5um", NULL), SARCINA_OK);
    assert_int_equal(z.number(z.self, 1, &si, NULL), SARCINA_OK);
    assert_true(si > 4.99e-6 && si < 5.01e-6);

    /* a variable may turn from a text into a number while its column stands */
    diag d = {0};
    assert_int_equal(interp_column(in, name, false, &v, NULL), SARCINA_OK);
    assert_true(v.is_text);
    assert_int_equal(v.text(v.self, 0, text, NULL), SARCINA_OK);
    assert_string_equal(text, "word");
    assert_int_equal(interp_execute(in, "variable v string 3", NULL), SARCINA_OK);
    assert_int_equal(v.text(v.self, 0, text, &d), SARCINA_ERROR);
    assert_string_equal(d.message, "'v' is a number now, no text");
    z.release(z.self);
    v.release(v.self);
    free(z.name);
    free(v.name);
    expr_free(e);
    expr_free(name);
    interp_free(in);
    script_host_close(&h);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_values), cmocka_unit_test(test_read_back), cmocka_unit_test(test_errors),
        cmocka_unit_test(test_bio),    cmocka_unit_test(test_variables), cmocka_unit_test(test_random),
        cmocka_unit_test(test_save),   cmocka_unit_test(test_columns),
    };
    return cmocka_run_group_tests_name("expression", tests, NULL, NULL);
}

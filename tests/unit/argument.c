/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Arguments of every kind: what a command is given, and the error of each that is wrong; blocks and their errors. */
#include "script_host.h"

#include "base/table.h"
#include "script/signature.h"

#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>

#include <cmocka.h>

#include <math.h>
#include <signal.h>
#include <stdio.h>

/* What the probe commands were given last. */
typedef struct probe {
    int runs;
    double length, number;
    spread mass;
    bool percent, flag, given, off, is_time;
    long long whole;
    int choice;
    char text[64];
    orient_kind orient;
    double axis[3], size[2], lo, time, force, cycle_time;
    uint64_t cycles;
    size_t words, every, commands;
} probe;

static probe seen;

static int run_probe(interp *in, const args *a, diag *d) {
    (void)in, (void)d;
    seen.runs++;
    seen.length = args_number(a, "L");
    seen.number = args_number(a, "number");
    seen.mass = args_spread(a, "mass");
    seen.percent = args_percent(a, "mass");
    seen.flag = args_flag(a, "flag");
    seen.given = args_given(a, "number");
    seen.whole = args_int(a, "whole");
    seen.choice = args_choice(a, "choice");
    seen.text[0] = '\0';
    if (args_text(a, "text"))
        snprintf(seen.text, sizeof seen.text, "%s", args_text(a, "text"));
    seen.orient = args_orient(a, "orient", seen.axis);
    args_vector(a, "size", seen.size, 2);
    seen.lo = args_number(a, "LO");
    args_relaxation(a, "relax", &seen.time, &seen.force);
    args_cycles_value c = args_cycles(a, "cycles");
    seen.is_time = c.is_time;
    seen.cycles = c.cycles;
    seen.cycle_time = c.time;
    seen.words = args_count(a, "words");
    seen.every = args_every_count(a, "every");
    seen.commands = 0;
    for (size_t i = 0; i < seen.every; i++) {
        command_text *const *texts;
        size_t n;
        args_every(a, "every", i, &texts, &n);
        seen.commands += n;
    }
    return SARCINA_OK;
}

static int run_switch(interp *in, const args *a, diag *d) {
    (void)in, (void)d;
    seen.runs++;
    seen.off = args_off(a);
    return SARCINA_OK;
}

static const param probe_params[] = {
    {"number=3:number", ""},      {"mass=50%:mass%~(0,1e-9kg)", ""},
    {"flag=no:flag", ""},         {"whole=7:int[0,10]", ""},
    {"choice=b:{a|b|c}", ""},     {"text:text", ""},
    {"orient=random:orient", ""}, {"size=800,600:size", ""},
    {"relax:relaxation", ""},     {"cycles:cycles[1,)", ""},
    {"words:words", ""},          {"every:everycmd", ""},
    {"view=top:view", ""},        {"color=auto:color", ""},
    {"any:quantity", ""},
};
static const param switch_params[] = {{"k=1:number", ""}};
static const param group_params[] = {{"a:number!1", ""}, {"b:number!1", ""}, {"c:length!", ""}};

static const command_form forms[] = {
    {"probe L:length LO:bound", probe_params, TABLE_COUNT(probe_params), "", NULL, NULL, 0, run_probe, NULL, 0},
    {"switch @off", switch_params, TABLE_COUNT(switch_params), "", NULL, NULL, 0, run_switch, NULL, 0},
    {"needs", group_params, TABLE_COUNT(group_params), "", NULL, NULL, 0, run_switch, NULL, 0},
    {"danger", NULL, 0, "", NULL, NULL, COMMAND_UNSAFE, run_switch, NULL, 0},
};

static script_host host;

static int open_host(void **state) {
    (void)state;
    script_host_open(&host);
    command_add(host.commands, forms, TABLE_COUNT(forms));
    return 0;
}

static int close_host(void **state) {
    (void)state;
    script_host_close(&host);
    return 0;
}

/* Runs a script; the errors it told. */
static const char *run(const char *text) {
    interp *in = interp_create(&host.host);
    script_host_clear(&host);
    seen = (probe){0};
    interp_run_source(in, "test", text);
    interp_free(in);
    return host.errors;
}

static void run_well(const char *text) {
    const char *errors = run(text);
    if (*errors)
        fail_msg("%s: %s", text, errors);
    assert_int_equal(seen.runs, 1);
}

static void test_values(void **state) {
    (void)state;
    run_well("probe 1.5um -INF mass 1pg sd 10% flag yes whole 1e1 choice c text 'a b' orient 1 1 0 size 5 6\n");
    assert_true(seen.length == 1.5 && isinf(seen.lo) && seen.lo < 0 && seen.number == 3 && !seen.given);
    assert_true(seen.mass.law == SPREAD_NORMAL && seen.mass.a == 1 && seen.mass.b == 0.1 && !seen.percent);
    assert_true(seen.flag && seen.whole == 10 && seen.choice == 2);
    assert_string_equal(seen.text, "a b");
    assert_true(seen.orient == ORIENT_VECTOR && seen.axis[1] == 1 && seen.size[1] == 6);

    run_well("probe 1e-6 INF relax to 1e-16N within 60s cycles 3h words a 'b c' number 4\n");
    assert_true(seen.length == 1 && seen.force == 1e5 && seen.time == 60 && seen.is_time && seen.cycle_time == 10800);
    assert_true(seen.words == 2 && seen.number == 4 && seen.given);
    assert_true(seen.percent && seen.mass.a == 0.5 && seen.choice == 1 && seen.whole == 7 && seen.size[0] == 800);
    assert_true(seen.orient == ORIENT_RANDOM);

    run_well("probe 1um 0 mass uniform 50% 100% relax 1s cycles 5 every 2 'print a' \"print b\" every 1h 'print c'\n");
    assert_true(seen.mass.law == SPREAD_UNIFORM && seen.mass.b == 1 && seen.percent && seen.time == 1);
    assert_true(!seen.is_time && seen.cycles == 5 && seen.every == 2 && seen.commands == 3);

    run_well("units bio\nprobe 1 2 mass lognormal 1.5 1.2\n");
    assert_true(seen.length == 1 && seen.lo == 2 && seen.mass.law == SPREAD_LOGNORMAL && seen.mass.b == 1.2);
    run_well("probe 1um 0 mass normal 1pg 0.1pg\n");
    assert_true(seen.mass.law == SPREAD_NORMAL && fabs(seen.mass.b - 0.1) < 1e-15);
    run_well("switch\n");
    assert_false(seen.off);
    run_well("switch off\n");
    assert_true(seen.off);
}

/* Replaced text may be several words; what a $ puts in keeps the place of the $. */
static void test_replaced(void **state) {
    (void)state;
    run_well("variable m default 'uniform 50% 100%'\nvariable key default number\nprobe 1um 0 mass ${m} ${key} 4\n");
    assert_true(seen.mass.law == SPREAD_UNIFORM && seen.number == 4);
    run_well("variable nothing string ''\nprobe 1um ${nothing} 0\n");
    const char *errors = run("variable m default 3s\nprobe 1um 0 mass ${m} number 4\n");
    assert_non_null(strstr(errors, "test:2:18: error: mass takes a mass, not '3s' (time)"));
    assert_non_null(strstr(errors, "                 ^~~~\n"));
    assert_non_null(strstr(errors, "expanded: probe 1um 0 mass 3s number 4"));
}

static const struct {
    const char *script, *error;
} wrong[] = {
    {"probe", "probe needs L"},
    {"probe 1um", "probe needs LO"},
    {"probe 1s 0", "L takes a length, not '1s' (time)"},
    {"probe 5% 0", "L takes a length, not '5%' (percent)"},
    {"probe big 0", "L: expected a length, not 'big'"},
    {"probe 1um 0 number", "number: expected a number"},
    {"probe 1um 0 number 1 number 2", "number is given twice"},
    {"probe 1um 0 nmber 1", "did you mean 'number'?"},
    {"probe 1um 0 whole 1.5", "whole takes a whole number, not '1.5'"},
    {"probe 1um 0 whole x", "whole: expected a whole number, not 'x'"},
    {"probe 1um 0 whole 11", "whole must be at most 10, not '11'"},
    {"probe 1um 0 flag maybe", "flag: expected yes or no, not 'maybe'"},
    {"probe 1um 0 choice d", "choice: expected a | b | c, not 'd'"},
    {"probe 1um 0 orient up", "expected x, y, z, xy, random or three numbers, not 'up'"},
    {"probe 1um 0 orient 0 0 0", "orient 0 0 0 is no direction"},
    {"probe 1um 0 view below", "view: expected top, side, front, iso or two angles, not 'below'"},
    {"probe 1um 0 color mauvish", "color: expected a color, not 'mauvish'"},
    {"probe 1um 0 any much", "any: expected a number, not 'much'"},
    {"probe 1um 0 cycles 0", "cycles must be at least 1, not '0'"},
    {"probe 1um 0 cycles -1s", "cycles must be a time above 0, not '-1s'"},
    {"probe 1um 0 cycles often", "cycles: expected a number of cycles or a time, not 'often'"},
    {"probe 1um 0 every -2 'print a'", "every must be at least 0, not '-2'"},
    {"probe 1um 0 mass 50% sd 0.1pg", "sd of a percent is a percent"},
    {"probe 1um 0 mass uniform 50% 1pg", "uniform takes two percents or two of mass, not one of each"},
    {"probe 1um 0 mass uniform 2pg 1pg", "uniform takes its lower end first"},
    {"probe 1um 0 mass 1pg sd -1pg", "sd must be at least 0, not '-1pg'"},
    {"probe 1um 0 mass lognormal 1pg 0.5", "mass must be at least 1, not '0.5'"},
    {"probe 1um 0 mass 0pg", "mass must be more than 0, not '0pg'"},
    {"switch off k", "off ends the command; unexpected 'k'"},
    {"needs c 1um", "needs needs a or b"},
    {"needs a 1", "needs needs c"},
    {"danger", "danger is refused under -safe"},
    {"thermo_style custom step)", "unexpected ')' behind 'step'"},
    {"species ff coccus\nanalyze ff all orientation", "'ff' is already a species"},
    {"variable v default 1\nspecies v coccus", "'v' is already a variable"},
    {"species a1234567890123456789012345678901234567890123456789012345678901 coccus", "1 to 60 characters"},
    {"if\nend", "if needs a condition"},
    {"while\nend", "while needs a condition"},
    {"for\nend", "for needs a name"},
    {"for i of 1..3\nend", "for: expected in, not 'of'"},
    {"for i in 1..3 4\nend", "for takes one range, or words"},
    {"else\nend", "'else' without a block"},
    {"for i in 1..2\nelse\nend", "'else' without an if before it"},
    {"if 1\nelse 2\nend", "unexpected '2' after else"},
    {"for i in 1\nbreak now\nend", "break takes no argument"},
    {"if 1 then 'print a' else", "a branch of the one-line if needs a command in quotes"},
    {"if 1 2 then 'print a'", "unexpected '2' behind the condition"},
    {"if 1 then 'for i in 1'", "this 'for' has no end"},
    {"print $(1", "expected ')' at the end of $("},
    {"print $(== 1)", "'=' does not compare; write '=='"},
    {"print $(1:%x)", "is not one number format"},
    {"variable a default 1\nvariable b equal \"1 2\"", "unexpected '2' behind the expression"},
    {"variable t list 1 2\nvariable u list 1 2 3\nprint $(mean(t+u))", "'+' between lists of different length"},
    {"variable t list 1 2\nprint $(mean(t where z))", "where"},
    {"variable t list 1 2\nprint $(mean(t where 1))", "where chooses cells; a list has none"},
    {"print $(mean(ternary(z > 0, 'a', 'b')))", "ternary of texts takes one truth, not one per cell"},
    {"variable s string a\nexpect s", "'s' is a text, not a number"},
    {"expect 1um approx 1s", "expect compares a length with a time"},
    {"expect 1um approx 2um abs 1s", "expect compares a length with a time"},
    {"expect 1um approx 2um", "expected 1um approx 2um"},
    {"expect 1 > 2", "its sides are 1 and 2"},
    {"expect_error 'nothing' 'probe'", "expected the error 'nothing', not 'probe needs L'"},
    {"expect_error 'nothing' 'print a'", "expected the error 'nothing', but there was none"},
    {"help nothing", "no help about 'nothing'"},
    {"shell true", "there is no shell here"},
    {"variable a getenv NOTHING", "the environment has no variable 'NOTHING'"},
    {"include " SARCINA_TEST_DATA, "is a folder, not a script"},
    {"include " SARCINA_TEST_DATA "/script/self.in", "nested too deeply"},
    {"variable \xc2\xb5 default 1", "a name is letters, digits and _"},
    {"print a\xe2\x88\x92", "(U+2212) may stand only in quotes and comments"},
    {"print 'a\nprint b", "the quote is not closed"},
    {"print \"\"\"a\nprint b", "the quote is not closed"},
    {"end", "'end' without a block"},
};

static void test_errors(void **state) {
    (void)state;
    host.environment = NULL;
    for (size_t i = 0; i < sizeof wrong / sizeof *wrong; i++) {
        host.host.safe = strcmp(wrong[i].script, "danger") == 0;
        const char *errors = run(wrong[i].script);
        if (!strstr(errors, wrong[i].error))
            fail_msg("%s: '%s', not '%s'", wrong[i].script, errors, wrong[i].error);
    }
    host.environment = "somewhere";
}

/* Expressions and commands nested beyond reason are refused, not run into the stack's end. */
static void test_depth(void **state) {
    (void)state;
    char *text = alloc_zeroed(100000, 1);
    strcpy(text, "print $(");
    memset(text + 8, '(', 50000);
    assert_non_null(strstr(run(text), "the expression is nested too deeply"));
    memset(text + 8, '-', 50000);
    assert_non_null(strstr(run(text), "the expression is nested too deeply"));
    free(text);
}

/* In a check what is not known stands for anything that may fit, and what it hides is not reported. */
static void test_check(void **state) {
    (void)state;
    static const struct {
        const char *script, *error; /* NULL: none */
    } cases[] = {
        {"probe $(thickness) 0", NULL},
        {"probe $(time) 0", "L takes a length, not a time"},
        {"probe $(thickness)um 0", NULL},
        {"probe $(thickness:%g) 0", NULL},
        {"probe 1um 0 whole $(cells) text $(ternary(cells > 1, 'a', 'b')) nothing", NULL},
        {"species s$(cells) coccus\ngrowth s1 exponential rate 1/h", "no species 's1'"},
        {"species s rod diameter 1s\ngrowth s exponential rate 1/h", "diameter takes a length"},
        {"speces s coccus\ngrowth s exponential rate 1/h", "unknown command 'speces'"},
        {"if cells > 3\nregion r sphere 0 0 0 1um\nelse\nregion r sphere 0 0 0 2um\nend", NULL},
        {"region r sphere 0 0 0 1um\nregion r sphere 0 0 0 2um", "'r' is already a region"},
        {"if 0\nprint $(nothing)\nend", "no value 'nothing'"},
        {"for i in 3..1\nprint $(nothing)\nend", "no value 'nothing'"},
        {"while 0\nprint $(nothing)\nend", "no value 'nothing'"},
        {"if 0 then 'print $(nothing)'", "no value 'nothing'"},
        {"probe 1um 0 every 5 'print $(nothing)'", "no value 'nothing'"},
        {"expect_error 'no value' 'print $(nothing)'", NULL},
        {"variable t list\nvariable t append time\nprint $(mean(t) + 1um)", NULL},
        {"variable a string $(cells)\nprobe 1um 0 whole $a number ${a}um", NULL},
        {"while cells < 3\nrun 1 grow 4min\nend", NULL},
    };
    for (size_t i = 0; i < sizeof cases / sizeof *cases; i++) {
        interp *in = interp_create(&host.host);
        script_host_clear(&host);
        size_t errors = interp_check_text(in, "test", cases[i].script);
        bool right = cases[i].error ? errors == 1 && strstr(host.errors, cases[i].error) : errors == 0;
        if (!right)
            fail_msg("%s: %zu errors: '%s', not '%s'", cases[i].script, errors, host.errors,
                     cases[i].error ? cases[i].error : "");
        interp_free(in);
    }
}

/* -var that nothing reads; a damaged save; an interrupt in a loop. */
static void test_interp(void **state) {
    (void)state;
    interp *in = interp_create(&host.host);
    script_host_clear(&host);
    interp_set_variable(in, "unread", "1", NULL);
    interp_set_variable(in, "used", "1", NULL);
    assert_int_equal(interp_check_text(in, "test", "print ${used}\n"), 1);
    assert_non_null(strstr(host.errors, "-var unread: nothing in the script reads 'unread'"));
    diag d = {0};
    assert_int_equal(interp_variables_load(in, "nothing of ours\n", &d), SARCINA_ERROR);
    assert_non_null(strstr(d.message, "damaged"));
    assert_int_equal(interp_variables_load(in, "text \n", &d), SARCINA_ERROR);
    interp_free(in);

    static volatile sig_atomic_t interrupt = 1;
    host.host.interrupt = &interrupt;
    in = interp_create(&host.host);
    assert_int_equal(interp_run_source(in, "test", "while 1\nend\n"), SARCINA_INTERRUPTED);
    interp_free(in);
    host.host.interrupt = NULL;
}

/* Warnings: told, limited, dropped, or errors; for numbers that are hardly meant. */
static void test_warnings(void **state) {
    (void)state;
    static const char odd[] = "species s rod diameter 1m\n";
    assert_non_null(strstr(run(odd), "test:1: warning: diameter 1m is unusual (0.1um to 100um)"));
    assert_non_null(strstr(run("species s coccus\ngrowth s exponential rate 0.005\n"), "; meant 0.005/h"));
    assert_string_equal(run("warn off\nspecies s rod diameter 1m\n"), "");
    assert_non_null(strstr(run("warn error\nspecies s rod diameter 1m\n"), "error: diameter 1m is unusual"));
    const char *told = run("for i in 1..30\nspecies s rod diameter 1m\nend\n");
    size_t n = 0;
    for (const char *at = told; (at = strstr(at, "unusual")); at++)
        n++;
    assert_int_equal(n, 5); /* of a kind; the program tells at its end how many more there were */
    assert_non_null(strstr(run("print a & # goes on\n screen no\n"), "a comment behind &"));
}

/* Records whose notation is wrong are refused. */
static void test_records(void **state) {
    (void)state;
    static const param no_kind[] = {{"k", ""}}, bad_end[] = {{"k:number!x", ""}},
                       bad_range[] = {{"k:number[1zz,2]", ""}};
    const param *const params[] = {no_kind, bad_end, bad_range};
    for (size_t i = 0; i < 3; i++) {
        command_form form = {.head = "bad", .params = params[i], .nparams = 1};
        signature s;
        diag d = {0};
        if (signature_parse(&form, host.units, &s, &d) != SARCINA_ERROR)
            fail_msg("%s is taken", params[i]->spec);
        signature_free(&s);
    }
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_values),  cmocka_unit_test(test_replaced), cmocka_unit_test(test_errors),
        cmocka_unit_test(test_depth),   cmocka_unit_test(test_check),    cmocka_unit_test(test_interp),
        cmocka_unit_test(test_records), cmocka_unit_test(test_warnings),
    };
    return cmocka_run_group_tests_name("argument", tests, open_host, close_host);
}

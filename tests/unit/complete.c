/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Completion: by place and kind for chosen lines; every word of every form of every command; and random text, which
 * must do no harm. */
#include "script_host.h"

#include "base/table.h"
#include "script/complete.h"
#include "script/signature.h"

#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>

#include <cmocka.h>

#include <stdbool.h>
#include <stdio.h>
#include <sys/stat.h>
#include <unistd.h>

static script_host host;
static interp *in;

static const char scene_text[] = "species ball coccus\n"
                                 "species stick rod diameter 0.5um\n"
                                 "region box block -5um 5um -5um 5um 0 5um\n"
                                 "variable seed default 7\n"
                                 "variable steep equal thickness > 1um\n"
                                 "analyze E all ellipse\n"
                                 "dump d all csv 10 d.csv id z\n";

static int open_host(void **state) {
    (void)state;
    char folder[] = "/tmp/sarcina-complete-XXXXXX";
    assert_non_null(mkdtemp(folder));
    assert_int_equal(chdir(folder), 0);
    script_host_open(&host);
    in = interp_create(&host.host);
    assert_int_equal(interp_run_source(in, "scene", scene_text), SARCINA_OK);
    assert_int_equal(mkdir("cases", 0700), 0);
    const char *const files[] = {"first.in", "figure.png", "two words.in", ".hidden.in", "cases/a.in"};
    for (size_t i = 0; i < TABLE_COUNT(files); i++) {
        FILE *f = fopen(files[i], "w");
        assert_non_null(f);
        fclose(f);
    }
    return 0;
}

static int close_host(void **state) {
    (void)state;
    interp_free(in);
    script_host_close(&host);
    return 0;
}

/* The candidates of a line, cursor at its end, in the order of the alphabet with blanks between; the caller frees. */
static int by_text(const void *a, const void *b) {
    return strcmp(((const completion *)a)->text, ((const completion *)b)->text);
}

static char *candidates(const char *line) {
    completions c;
    complete_line(in, line, strlen(line), &c);
    if (c.n)
        qsort(c.list, c.n, sizeof *c.list, by_text);
    char *all = alloc_copy("");
    for (size_t i = 0; i < c.n; i++) {
        assert_true(strncmp(c.list[i].text, line + c.from, strlen(line) - c.from) == 0);
        char *longer = alloc_format("%s%s%s", all, i ? " " : "", c.list[i].text);
        free(all);
        all = longer;
    }
    complete_free(&c);
    return all;
}

static bool offers(const char *line, const char *wanted) {
    completions c;
    bool found = false;
    complete_line(in, line, strlen(line), &c);
    for (size_t i = 0; i < c.n; i++)
        found = found || strcmp(c.list[i].text, wanted) == 0;
    complete_free(&c);
    return found;
}

/* ---- chosen lines ------------------------------------------------------------------------------------------------ */

static const struct {
    const char *line, *all;
} cases[] = {
    /* commands; values only where nothing else begins so */
    {"spe", "species"},
    {"whi", "while"},
    {"thick", "thickness"},
    /* forms, names, keywords, units: the dialogue of the tutorial */
    {"species ball co", "coccus"},
    {"species ball coccus den", "density"},
    {"species ball coccus density 1010", "1010g/l 1010kg/m3 1010mg/l 1010pg/um3"},
    {"species ball coccus density 1010k", "1010kg/m3"},
    {"species ball coccus density ", "1010kg/m3"},
    {"species ball coccus density 1010kg/m3 ", "color"},
    {"growth st", "stick"},
    {"growth stick exponential rate 1/", "1/h 1/min 1/s"},
    {"growth stick exponential rate 1/h ", "draw sd"},
    {"growth stick exponential rate uniform 1/h 2/h ", "draw"},
    {"growth stick exponential draw ", "birth step"},
    {"create_cells b", "ball"},
    {"create_cells ball random 3 ", "box"},
    {"create_cells ball single 0 0 0 orient ra", "random"},
    {"create_cells ball single 0 0 0 orient 0 0 1 ga", "gap"},
    {"create_cells ball single 0 0 0 mass 50", "50% 50fg 50g 50kg 50pg"},
    {"create_cells ball single 0 0 0 overlap ", "no yes"},
    {"region r block -I", "-INF"},
    {"run 10 grow 4", "4day 4h 4min 4ms 4s"},
    {"run 10 relax t", "to"},
    {"run 10 relax to 1p", "1pN"},
    {"run 10 relax to 1pN wi", "within"},
    {"run 10 until thickn", "thickness"},
    {"run 10 until thickness > 1um gr", "grow"},
    {"run 10 until thickness > thickn", "thickness"},
    {"run 10 grow 1min every 5 \"print ", ""},
    {"run 10 grow 1min every 5 \"spe", "species"},
    {"run 10 grow 1min every 5 \"delete_cells b", "ball box"},
    {"run 10 grow 1min every 5 \"print a\" rel", "relax"},
    {"force dlvo o", "off"},
    {"dump d o", "off"},
    {"dump_modify d ", "axes background color every legend map pad range scalebar size springs view zoom"},
    {"thermo_style custom step tim", "time"},
    {"thermo_style custom mean(le", "length"},
    {"thermo_style custom ellipse.ma", "ellipse.major"},
    {"thermo_style custom E.mi", "E.minor"},
    {"thermo_style custom spee", ""},
    {"dump e all csv 10 f.csv spee", "speed"},
    {"write_dump all csv f.csv id vq", ""},
    {"include fir", "first.in"},
    {"include cas", "cases/"},
    {"include cases/", "cases/a.in"},
    {"include two", ""},
    {"include \"two", "two words.in\""},
    {"include .hid", ".hidden.in"},
    {"log o", "off"},
    /* expressions and texts */
    {"print \"$(max(over", "overlap"},
    {"print \"it is ${se", "${seed}"},
    {"print $(mean(length wh", "where"},
    {"print $(4mi", "4min"},
    {"print \"$(cells) and ", ""},
    {"max(over", "overlap"},
    {"max(overlap) + thickn", "thickness"},
    {"max(overlap) ", ""},
    {"if defined(\"se", "seed"},
    {"if is_file(\"fir", "first.in\""},
    {"if cells > 1 th", "then"},
    {"if cells > 1 then \"spe", "species"},
    {"if cells > 1 then \"print a\" el", "elif else"},
    {"set all z z+1u", "1um 1um2 1um3"},
    {"variable steep equal thickn", "thickness"},
    {"variable se", "seed"},
    {"variable seed ", "append default equal getenv list off string"},
    /* blocks and continued lines */
    {"for i in 1..3\n  spe", "species"},
    {"for i in 1..3\n  en", "end"},
    {"for i in 1..3\n  bre", "break"},
    {"for i in 1..3\n  run 1\nend ", "for"},
    {"for i ", "in"},
    {"if cells > 1\n  run 1\nel", "elif else"},
    {"if cells > 1\nend\nel", "ellipse"},
    {"bre", ""},
    {"species ball coccus &\n  den", "density"},
    {"print a # spe", ""},
    {"print a\nspe", "species"},
    {"help thermo_m", "thermo_modify"},
    {"help dump im", "image"},
    {"? thermo_m", "thermo_modify"},
    /* what is wrong has none */
    {"nonsense ", ""},
    {"species ball coccus dnsity 1 de", "density"},
    {"print \"a\"", ""},
};

static void test_lines(void **state) {
    (void)state;
    size_t bad = 0;
    for (size_t i = 0; i < TABLE_COUNT(cases); i++) {
        char *all = candidates(cases[i].line);
        if (strcmp(all, cases[i].all) != 0) {
            print_message("'%s': '%s', due '%s'\n", cases[i].line, all, cases[i].all);
            bad++;
        }
        free(all);
    }
    assert_int_equal(bad, 0);
}

/* What stands behind the cursor does not count. */
static void test_middle(void **state) {
    (void)state;
    completions c;
    complete_line(in, "species ball coccus den 5", 23, &c);
    assert_int_equal(c.n, 1);
    assert_int_equal(c.from, 20);
    assert_string_equal(c.list[0].text, "density");
    assert_false(c.list[0].open);
    complete_free(&c);
    complete_line(in, "print $(mea", 11, &c);
    assert_int_equal(c.n, 1);
    assert_true(c.list[0].open);
    complete_free(&c);
}

/* ---- every form -------------------------------------------------------------------------------------------------- */

/* A text that an argument of this kind could be. */
static const char *sample(const slot *s) {
    static const struct {
        slot_kind kind;
        const char *text;
    } samples[] = {
        {SLOT_NOTHING, ""},       {SLOT_FLAG, "yes"},
        {SLOT_EXPR, "cells > 1"}, {SLOT_CELLEXPR, "z > 1um"},
        {SLOT_VALUE, "cells"},    {SLOT_CELL, "z"},
        {SLOT_FORMULA, "cells"},  {SLOT_COMMAND, "\"print a\""},
        {SLOT_NEW, "fresh"},      {SLOT_EVERY, "2 \"clear\""},
        {SLOT_RELAXATION, "1s"},  {SLOT_ORIENT, "xy"},
        {SLOT_LENGTH3, "1 2 3"},  {SLOT_SIZE, "1 2"},
        {SLOT_VIEW, "top"},       {SLOT_RANGE2, "1 2"},
        {SLOT_COLOR, "red"},      {SLOT_CELLCOLOR, "red"},
        {SLOT_NAME, "some"},      {SLOT_COLUMNFORMAT, "step %d"},
        {SLOT_ANALYSIS, "hull"},  {SLOT_FILE, "f"},
        {SLOT_FILEOFF, "f"},      {SLOT_TEXT, "t"},
        {SLOT_WORD, "w"},         {SLOT_WORDS, "w"},
        {SLOT_REST, "r"},
    };
    for (size_t i = 0; i < TABLE_COUNT(samples); i++)
        if (samples[i].kind == s->kind)
            return samples[i].text;
    return s->kind == SLOT_CHOICE ? s->choices[0] : "1";
}

static char *append(char *line, const char *word) {
    char *longer = alloc_format("%s%s%s", line, *line && *word ? " " : "", word);
    free(line);
    return longer;
}

static void require(const char *line, const char *wanted) {
    char *open = alloc_format("%s ", line);
    if (!offers(open, wanted))
        fail_msg("'%s' is not completed by '%s'", open, wanted);
    /* half typed it is offered too */
    char *half = alloc_format("%s%.*s", open, (int)(strlen(wanted) + 1) / 2, wanted);
    if (!offers(half, wanted))
        fail_msg("'%s' is not completed to '%s'", half, wanted);
    free(half);
    free(open);
}

static void require_units(const char *line, dim d) {
    const char *names[64];
    size_t n = units_usual(d, names, 64);
    for (size_t i = 0; i < n && !dim_is_none(d); i++) {
        char *typed = alloc_format("%s 12.5", line), *wanted = alloc_format("12.5%s", names[i]);
        if (!offers(typed, wanted))
            fail_msg("'%s' is not completed to '%s'", typed, wanted);
        free(typed);
        free(wanted);
    }
}

/* What must be offered in the place of an argument. */
static void require_argument(const char *line, const slot *s) {
    for (size_t i = 0; i < s->nchoices; i++)
        require(line, s->choices[i]);
    if (s->kind == SLOT_NUMBER)
        require_units(line, s->d);
    static const struct {
        slot_kind kind;
        const char *words[4];
    } due[] = {
        {SLOT_CYCLES, {NULL}},
        {SLOT_FLAG, {"yes", "no"}},
        {SLOT_BOUND, {"INF", "-INF"}},
        {SLOT_FILE, {"first.in", "cases/"}},
        {SLOT_FILEOFF, {"first.in", "off"}},
        {SLOT_EXPR, {"thickness", "mean(", "steep"}},
        {SLOT_VALUE, {"thickness", "mean(", "E"}},
        {SLOT_CELLEXPR, {"z", "mean(", "ball"}},
        {SLOT_CELL, {"z", "sqrt(", "box"}},
        {SLOT_FORMULA, {"z", "cells"}},
        {SLOT_ANALYSIS, {"thickness", "hull"}},
        {SLOT_ORIENT, {"x", "xy", "random"}},
        {SLOT_VIEW, {"top", "iso"}},
        {SLOT_COLOR, {"red", "teal"}},
        {SLOT_CELLCOLOR, {"generation", "ball"}},
        {SLOT_RELAXATION, {"to"}},
    };
    for (size_t i = 0; i < TABLE_COUNT(due); i++)
        for (size_t k = 0; due[i].kind == s->kind && k < 4 && due[i].words[k]; k++)
            require(line, due[i].words[k]);
    if (s->kind == SLOT_NAME && strcmp(s->kind_name, "variable") == 0)
        require(line, "seed");
    if (s->kind == SLOT_NAME && strcmp(s->kind_name, "species") == 0)
        require(line, "stick");
    if (s->kind == SLOT_NAME && strcmp(s->kind_name, "group") == 0)
        require(line, "all");
    if (s->spread)
        require(line, "uniform");
}

/* A keyword given is not offered again, the others are. */
static void require_keywords(const char *line, const signature *f) {
    for (size_t i = 0; i < f->nkey; i++) {
        require(line, f->key[i].name);
        char *named = append(alloc_copy(line), f->key[i].name);
        if (f->key[i].kind != SLOT_NOTHING)
            require_argument(named, &f->key[i]);
        named = append(named, sample(&f->key[i]));
        for (size_t k = 0; k < f->nkey; k++)
            if (k != i)
                require(named, f->key[k].name);
        named = append(named, " ");
        if (f->key[i].kind != SLOT_EVERY && offers(named, f->key[i].name))
            fail_msg("'%s' is completed by a second '%s'", named, f->key[i].name);
        free(named);
    }
}

static void test_forms(void **state) {
    (void)state;
    for (size_t i = 0; i < host.commands->count; i++) {
        const signature *f = &host.commands->list[i];
        char *line = alloc_copy("");
        bool rest = false;
        for (size_t k = 0; k < f->nhead; k++) {
            const slot *s = &f->head[k];
            if (f->off_at == k && k)
                require(line, "off");
            if (k && s->kind == SLOT_LITERAL)
                require(line, s->name);
            else if (k)
                require_argument(line, s);
            rest = rest || s->kind == SLOT_REST;
            line = append(line, s->kind == SLOT_LITERAL ? s->name : sample(s));
        }
        if (f->off_at == f->nhead)
            require(line, "off");
        if (!rest)
            require_keywords(line, f);
        free(line);
    }
}

/* ---- random text ------------------------------------------------------------------------------------------------- */

static uint64_t draw(uint64_t *s) {
    *s = *s * 6364136223846793005u + 1442695040888963407u;
    return *s >> 33;
}

/* Stretches of examples and heads, and characters that mean something, in any order. */
static void test_random(void **state) {
    (void)state;
    static const char special[] = "  \n\t\"'()${}[]#&:%.,*^<=>!|?/~\\0123456789abcdefghzumN\xc2\xb5";
    uint64_t seed = 1;
    char text[400];
    for (int round = 0; round < 20000; round++) {
        size_t n = 0, parts = draw(&seed) % 6 + 1;
        for (size_t p = 0; p < parts; p++) {
            const command_form *f = &host.commands->list[draw(&seed) % host.commands->count].form;
            const char *from = draw(&seed) % 2 && f->example ? f->example : f->head;
            size_t skip = draw(&seed) % 3 ? 0 : draw(&seed) % (strlen(from) + 1), length = draw(&seed) % 60;
            for (; length && from[skip] && n < 300; length--)
                text[n++] = from[skip++];
            for (size_t k = draw(&seed) % 5; k > 0 && n < 320; k--)
                text[n++] = special[draw(&seed) % (sizeof special - 1)];
        }
        text[n] = '\0';
        size_t cursor = draw(&seed) % (n + 1);
        completions c;
        complete_line(in, text, cursor, &c);
        assert_true(c.from <= cursor);
        for (size_t i = 0; i < c.n; i++)
            assert_true(strncmp(c.list[i].text, text + c.from, cursor - c.from) == 0);
        complete_free(&c);
    }
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_lines),
        cmocka_unit_test(test_middle),
        cmocka_unit_test(test_forms),
        cmocka_unit_test(test_random),
    };
    return cmocka_run_group_tests(tests, open_host, close_host);
}

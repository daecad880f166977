/* SPDX-License-Identifier: GPL-3.0-or-later */
/* What the tables of commands promise: every form has its example, and every example runs, typed line by line after
 * the prelude, in a scene and a folder of its own. */
#include "script_host.h"

#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>

#include <cmocka.h>

#include "example_host.h"
#include "script/control.h"
#include "analysis/value.h"
#include "script/foreign.h"
#include "script/function.h"
#include "script/help.h"
#include "script/reduction.h"
#include "script/topic.h"

#include <stdio.h>

static script_host host;

static int open_host(void **state) {
    (void)state;
    return example_host_open(&host);
}

static int close_host(void **state) {
    (void)state;
    return example_host_close(&host);
}

/* Runs an example after the prelude; what went wrong is shown. */
static bool runs(const char *what, const char *example) {
    interp *in = example_host_scene(&host);
    assert_non_null(in);
    int status = example_host_type(in, example, false);
    if (status)
        printf("%s: its example fails (%d)\n%s\n%s\n", what, status, example, host.errors);
    interp_free(in);
    return status == SARCINA_OK;
}

static void test_examples(void **state) {
    (void)state;
    const command_table *t = host.commands;
    size_t wrong = 0, lacking = 0, ran = 0;
    for (size_t i = 0; i < t->count; i++) {
        const signature *s = &t->list[i];
        char *usage = signature_usage(s);
        if (!s->form.example)
            printf("%s: has no example\n", usage), lacking++;
        else
            wrong += !runs(usage, s->form.example), ran++;
        free(usage);
    }
    for (size_t i = 0; i < control_word_count; i++)
        wrong += !runs(control_words[i].name, control_words[i].example), ran++;
    printf("%zu examples, %zu fail, %zu are missing\n", ran, wrong, lacking);
    assert_int_equal(wrong, 0);
}

/* Examples of topics run too, and print what the topic says they print. */
static void test_topics(void **state) {
    (void)state;
    size_t wrong = 0, ran = 0, compared = 0;
    for (size_t i = 0; i < topic_count; i++)
        for (size_t k = 0; k < topic_list[i].nparts; k++) {
            const topic_part *part = &topic_list[i].parts[k];
            if (!part->example)
                continue;
            bool right = runs(topic_list[i].name, part->example);
            ran++;
            if (right && part->prints) {
                char *due = alloc_format("%s\n", part->prints);
                right = strcmp(due, host.printed) == 0;
                compared++;
                if (!right)
                    printf("%s:\n%s\ndue: %sseen: %s\n", topic_list[i].name, part->example, due, host.printed);
                free(due);
            }
            wrong += !right;
        }
    printf("%zu examples of topics, %zu with what they print, %zu wrong\n", ran, compared, wrong);
    assert_int_equal(wrong, 0);
}

/* One @example ... @prints ... @end of a page; false at the end of the file. The caller frees both. */
static bool next_example(FILE *f, char **example, char **prints) {
    char line[512];
    char **to = NULL;
    *example = alloc_copy("");
    *prints = NULL;
    while (fgets(line, sizeof line, f)) {
        if (strcmp(line, "@example\n") == 0)
            to = example;
        else if (to && strcmp(line, "@prints\n") == 0)
            *(to = prints) = alloc_copy("");
        else if (to && strcmp(line, "@end\n") == 0)
            return true;
        else if (to)
            script_host_append(to, line);
    }
    free(*example);
    return false;
}

/* Examples in the pages written by hand run too. */
static void test_pages(void **state) {
    (void)state;
    static const char *const pages[] = {"sarcina-script.7", "sarcina-lammps.7"};
    size_t wrong = 0, ran = 0;
    for (size_t i = 0; i < sizeof pages / sizeof *pages; i++) {
        char *path = alloc_format("%s/../../man/src/%s", SARCINA_TEST_DATA, pages[i]), *example, *prints;
        FILE *f = fopen(path, "r");
        assert_non_null(f);
        while (next_example(f, &example, &prints)) {
            bool right = runs(pages[i], example) && (!prints || strcmp(prints, host.printed) == 0);
            if (!right && prints)
                printf("%s:\n%sdue: %sseen: %s\n", pages[i], example, prints, host.printed);
            wrong += !right;
            ran++;
            free(example);
            free(prints);
        }
        fclose(f);
        free(path);
    }
    printf("%zu examples of pages, %zu wrong\n", ran, wrong);
    assert_int_equal(wrong, 0);
    assert_true(ran >= 5);
}

/* Whether a word stands in a text, between blanks, quotes or line ends. */
static bool has_word(const char *text, const char *word) {
    size_t n = strlen(word);
    for (const char *at = text; (at = strstr(at, word)); at++)
        if ((at == text || strchr(" \n\"'", at[-1])) && strchr(" \n\"'", at[n]))
            return true;
    return false;
}

/* Commands that both have, by their names there. */
static const char *const shared[] = {
    "clear",      "dump",          "dump_modify",   "echo",     "group",        "if",
    "include",    "info",          "log",           "neighbor", "print",        "quit",
    "read_data",  "read_restart",  "region",        "restart",  "run",          "set",
    "shell",      "thermo",        "thermo_modify", "undump",   "thermo_style", "write_data",
    "write_dump", "write_restart", "units",         "variable", "dimension",
};

static bool is_command(const char *name) {
    const signature *first;
    return signature_forms(host.commands, name, &first, 1) > 0 || control_find(name);
}

/* The page for users of LAMMPS: what it calls a command of both is one here, none is left out, and what is answered as
 * LAMMPS's is none here. */
static void test_lammps(void **state) {
    (void)state;
    char *path = alloc_format("%s/../../man/src/sarcina-lammps.7", SARCINA_TEST_DATA), line[512], *save;
    char *listed = alloc_copy(" ");
    FILE *f = fopen(path, "r");
    bool both = false;
    assert_non_null(f);
    while (fgets(line, sizeof line, f)) {
        if (strncmp(line, ".Sh ", 4) == 0)
            both = strcmp(line, ".Sh COMMANDS OF BOTH\n") == 0;
        if (!both || strncmp(line, ".It Ic ", 7) != 0)
            continue;
        for (char *w = strtok_r(line + 7, " ,\n", &save); w; w = strtok_r(NULL, " ,\n", &save)) {
            if (!is_command(w))
                fail_msg("%s is no command here", w);
            script_host_append(&listed, w);
            script_host_append(&listed, " ");
        }
    }
    fclose(f);
    for (size_t i = 0; i < sizeof shared / sizeof *shared; i++)
        if (is_command(shared[i]) && !has_word(listed, shared[i]))
            fail_msg("%s is not in the list of commands of both", shared[i]);
    foreign_word w;
    for (size_t i = 0; foreign_list(i, &w); i++)
        if (is_command(w.name))
            fail_msg("%s is a command here and cannot be answered as LAMMPS's", w.name);
    free(listed);
    free(path);
}

static void count_named(const signature *s, const char *word, size_t *named, size_t *wrong) {
    bool there = has_word(s->form.example, word);
    if (!there)
        printf("'%s' is not in the example of %s: %s\n", word, s->form.head, s->form.example);
    *named += there;
    *wrong += !there;
}

/* The example of a form names the words of its head, the choices in it, and each of its keywords. */
static void test_named(void **state) {
    (void)state;
    const command_table *t = host.commands;
    size_t named = 0, wrong = 0;
    for (size_t i = 0; i < t->count; i++) {
        const signature *s = &t->list[i];
        for (size_t k = 0; k < s->nhead + s->nkey && s->form.example; k++) {
            const slot *one = k < s->nhead ? &s->head[k] : &s->key[k - s->nhead];
            bool stands = k >= s->nhead || one->kind == SLOT_LITERAL; /* for itself */
            if (stands)
                count_named(s, one->name, &named, &wrong);
            for (size_t c = 0; c < one->nchoices && k < s->nhead; c++)
                count_named(s, one->choices[c], &named, &wrong);
        }
    }
    printf("%zu words and keywords of forms stand in examples, %zu do not\n", named, wrong);
    assert_int_equal(wrong, 0);
}

/* Every value, function and reduction: its example runs, a misspelt name or field is answered. */
static void test_values(void **state) {
    (void)state;
    size_t ran = 0, wrong = 0, fields = 0;
    page p = {0};
    for (size_t i = 0; i < value_style_count + function_style_count + reduction_style_count; i++) {
        size_t f = i - value_style_count, r = f - function_style_count;
        p.n = 0;
        if (i < value_style_count)
            topic_example_value(&p, &value_styles[i]);
        else if (f < function_style_count)
            topic_example_function(&p, &function_styles[f]);
        else
            topic_example_reduction(&p, &reduction_styles[r]);
        wrong += !runs("values", p.chars);
        ran++;
    }
    free(p.chars);
    interp *in = example_host_scene(&host);
    for (size_t i = 0; i < value_style_count; i++) {
        const char *name = value_styles[i].name;
        char *line = alloc_format("print \"$(%s.nosuchfield)\"", name);
        script_host_clear(&host);
        bool refused = interp_run_line(in, line) != SARCINA_OK;
        wrong += !refused || !(strstr(host.errors, "nosuchfield") || strstr(host.errors, "no fields"));
        fields++;
        free(line);
        if (strlen(name) < 3) /* too short for a slip to be told from another word */
            continue;
        line = alloc_format("print \"$(%s%c)\"", name, name[strlen(name) - 1]);
        char *hint = alloc_format("did you mean '%s'?", name);
        script_host_clear(&host);
        wrong += interp_run_line(in, line) == SARCINA_OK || !strstr(host.errors, hint);
        free(hint);
        free(line);
    }
    interp_free(in);
    printf("%zu examples of values and functions, %zu values with wrong fields and slips refused, %zu wrong\n", ran,
           fields, wrong);
    assert_int_equal(wrong, 0);
}

/* Help on a thing; fails when there is none, or it does not hold the text. */
static size_t helps(interp *in, const char *about, const char *text) {
    diag d = {0};
    char *help = help_text(in, about, &d);
    bool right = help && strstr(help, text);
    if (!right)
        printf("help %s: %s\n", about, help ? "does not say all" : d.message);
    free(help);
    return !right;
}

static char *read_file(const char *path) {
    FILE *f = fopen(path, "r");
    char *text = alloc_copy(""), line[4096];
    while (f && fgets(line, sizeof line, f))
        script_host_append(&text, line);
    if (f)
        fclose(f);
    return text;
}

/* Every command has its page in the overview and in man/, which names its words, choices and keywords. */
static size_t check_page(const command_table *t, const char *name, size_t *words) {
    const signature *list[HELP_FORMS_MAX];
    size_t n = signature_forms(t, name, list, HELP_FORMS_MAX), wrong = 0;
    char *path = alloc_format("%s/../../man/sarcina-%s.7", SARCINA_TEST_DATA, name), *text = read_file(path);
    for (size_t i = 0; i < n; i++)
        for (size_t k = 0; k < list[i]->nhead + list[i]->nkey; k++) {
            const slot *s = k < list[i]->nhead ? &list[i]->head[k] : &list[i]->key[k - list[i]->nhead];
            bool there = strstr(text, s->name);
            for (size_t c = 0; c < s->nchoices; c++)
                there = there && strstr(text, s->choices[c]);
            if (!there)
                printf("%s does not name %s: run scripts/manual\n", path, s->name);
            *words += 1 + s->nchoices;
            wrong += !there;
        }
    if (!signature_page(t, name))
        printf("%s has no row in src/command/pages.c\n", name), wrong++;
    free(text);
    free(path);
    return wrong;
}

static void test_help(void **state) {
    (void)state;
    const command_table *t = host.commands;
    interp *in = example_host_scene(&host);
    const char *name;
    size_t wrong = 0, commands = 0, styles = 0, words = 0, others = 0;
    for (; (name = signature_command(t, commands)); commands++) {
        wrong += helps(in, name, name);
        wrong += helps(in, "", name);
        wrong += check_page(t, name, &words);
    }
    for (size_t i = 0; i < t->count; i++) {
        const char *style = signature_style(&t->list[i]);
        char *about = alloc_format("%s%s%s", t->list[i].head[0].name, *style ? " " : "", style);
        char *line = alloc_copy_n(t->list[i].form.example, strcspn(t->list[i].form.example, "\n"));
        wrong += helps(in, about, line);
        free(line);
        styles++;
        free(about);
    }
    for (size_t i = 0; i < value_style_count; i++, others++)
        wrong += helps(in, value_styles[i].name, value_styles[i].dimension);
    for (size_t i = 0; i < function_style_count; i++, others++)
        wrong += helps(in, function_styles[i].name, function_styles[i].signature);
    for (size_t i = 0; i < reduction_style_count; i++, others++)
        wrong += helps(in, reduction_styles[i].name, reduction_styles[i].signature);
    for (size_t i = 0; i < control_word_count; i++, others++)
        wrong += helps(in, control_words[i].name, control_words[i].summary);
    for (size_t i = 0; i < topic_count; i++, others++)
        wrong += helps(in, topic_list[i].name, topic_list[i].title);
    for (size_t i = 0; i < t->npages; i++)
        if (!is_command(t->pages[i].name))
            printf("src/command/pages.c: there is no command %s\n", t->pages[i].name), wrong++;
    for (size_t i = 0; i < t->npages; i++)
        for (size_t k = 0; k < i; k++) {
            bool split = strcmp(t->pages[i].topic, t->pages[k].topic) == 0 &&
                         strcmp(t->pages[i].topic, t->pages[i - 1].topic) != 0;
            if (split || strcmp(t->pages[i].name, t->pages[k].name) == 0)
                printf("src/command/pages.c: %s stands twice, or its topic does\n", t->pages[i].name), wrong++;
        }
    printf("help and pages: %zu commands, %zu forms, %zu words in man/, %zu values, functions, blocks and topics; %zu "
           "wrong\n",
           commands, styles, words, others, wrong);
    interp_free(in);
    assert_int_equal(wrong, 0);
}

/* apropos and help find what there is, and answer what there is not. */
static void test_search(void **state) {
    (void)state;
    static const struct {
        const char *word, *finds;
    } finds[] = {{"overlap", "force collision"}, {"OVERLAP", "create_cells"}, {"percent", "numbers"},
                 {"Debye", "force dlvo"},        {"handover", "link"},        {"jump", "blocks"}};
    interp *in = example_host_scene(&host);
    diag d = {0};
    for (size_t i = 0; i < sizeof finds / sizeof *finds; i++) {
        char *text = help_search(in, finds[i].word, &d);
        if (!text || !strstr(text, finds[i].finds))
            fail_msg("apropos %s does not find %s", finds[i].word, finds[i].finds);
        free(text);
    }
    assert_null(help_search(in, "qqqq", &d));
    assert_string_equal(d.message, "nothing has to do with 'qqqq'");
    diag_clear(&d);
    assert_null(help_text(in, "thicknes", &d));
    assert_string_equal(d.message, "no help about 'thicknes'");
    assert_non_null(strstr(d.help, "did you mean 'thickness'?"));
    diag_clear(&d);
    assert_null(help_text(in, "dump nosuchstyle", &d));
    assert_null(help_text(in, "nosuchcommand image", &d));
    assert_int_equal(helps(in, "sphere", "region"), 0);
    assert_int_equal(helps(in, "gap", "create_cells"), 0);
    assert_int_equal(helps(in, "colours", "#"), 0);
    interp_free(in);
}

int main(void) {
    const struct CMUnitTest tests[] = {cmocka_unit_test(test_examples), cmocka_unit_test(test_named),
                                       cmocka_unit_test(test_topics),   cmocka_unit_test(test_pages),
                                       cmocka_unit_test(test_lammps),   cmocka_unit_test(test_values),
                                       cmocka_unit_test(test_help),     cmocka_unit_test(test_search)};
    return cmocka_run_group_tests_name("records", tests, open_host, close_host);
}

/* SPDX-License-Identifier: GPL-3.0-or-later */
/* What the tables of commands promise: every form has its example, and every example runs, typed line by line after
 * the prelude, in a scene and a folder of its own. */
#include "script_host.h"

#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>

#include <cmocka.h>

#include "script/block.h"
#include "script/control.h"
#include "script/foreign.h"
#include "script/signature.h"
#include "script/topic.h"

#include <stdio.h>
#include <unistd.h>

static script_host host;
static char folder[] = "/tmp/sarcina-records-XXXXXX";

static int run_shell(void *self, const char *command, diag *d) {
    (void)self;
    return system(command) == 0 ? SARCINA_OK : diag_error(d, "the shell says no");
}

static int open_host(void **state) {
    (void)state;
    script_host_open(&host);
    host.host.shell = run_shell;
    return mkdtemp(folder) && chdir(folder) == 0 ? 0 : -1;
}

static int close_host(void **state) {
    (void)state;
    script_host_close(&host);
    return system("rm -rf \"$PWD\"") == 0 ? 0 : -1;
}

static void write_files(void) {
    const command_table *t = host.commands;
    if (system("rm -rf ./*") != 0)
        fail();
    for (size_t i = 0; i < t->nfiles; i++) {
        FILE *f = fopen(t->files[i].name, "w");
        assert_non_null(f);
        fputs(t->files[i].text, f);
        fclose(f);
    }
}

/* Runs commands and blocks one after the other, as typed at the prompt. Returns the first status that is not 0. */
static int type(interp *in, const char *script) {
    char *text = alloc_copy("");
    int status = SARCINA_OK;
    while (*script && !status) {
        size_t n = strcspn(script, "\n");
        char *longer = alloc_format("%s%.*s\n", text, (int)n, script);
        free(text);
        text = longer;
        script += n + (script[n] == '\n');
        if (block_is_open(text) && *script)
            continue;
        status = interp_run_line(in, text);
        *text = '\0';
    }
    free(text);
    return status;
}

/* Runs an example after the prelude; what went wrong is shown. */
static bool runs(const char *what, const char *example) {
    write_files();
    interp *in = interp_create(&host.host);
    int status = type(in, host.commands->prelude);
    assert_int_equal(status, SARCINA_OK);
    script_host_clear(&host);
    status = type(in, example);
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

/* The example of a form names the words of its head and each of its keywords. */
static void test_named(void **state) {
    (void)state;
    const command_table *t = host.commands;
    size_t named = 0, wrong = 0;
    for (size_t i = 0; i < t->count; i++) {
        const signature *s = &t->list[i];
        for (size_t k = 0; k < s->nhead + s->nkey && s->form.example; k++) {
            const slot *one = k < s->nhead ? &s->head[k] : &s->key[k - s->nhead];
            if (k < s->nhead && one->kind != SLOT_LITERAL)
                continue;
            bool there = has_word(s->form.example, one->name);
            if (!there)
                printf("'%s' is not in the example of %s: %s\n", one->name, s->form.head, s->form.example);
            named += there;
            wrong += !there;
        }
    }
    printf("%zu words and keywords of forms stand in examples, %zu do not\n", named, wrong);
    assert_int_equal(wrong, 0);
}

int main(void) {
    const struct CMUnitTest tests[] = {cmocka_unit_test(test_examples), cmocka_unit_test(test_named),
                                       cmocka_unit_test(test_topics), cmocka_unit_test(test_pages),
                                       cmocka_unit_test(test_lammps)};
    return cmocka_run_group_tests_name("records", tests, open_host, close_host);
}

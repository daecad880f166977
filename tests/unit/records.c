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

/* Whether a word stands in a text, between blanks, quotes or line ends. */
static bool has_word(const char *text, const char *word) {
    size_t n = strlen(word);
    for (const char *at = text; (at = strstr(at, word)); at++)
        if ((at == text || strchr(" \n\"'", at[-1])) && strchr(" \n\"'", at[n]))
            return true;
    return false;
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
                                       cmocka_unit_test(test_topics)};
    return cmocka_run_group_tests_name("records", tests, open_host, close_host);
}

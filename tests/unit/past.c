/* SPDX-License-Identifier: GPL-3.0-or-later */
/* undo: whatever the commands of a session change is to the bit what it was, for every example of every command; how
 * far back it goes; and what a session writes down. */
#include "example_host.h"

#include "base/table.h"
#include "command/past.h"
#include "command/session.h"
#include "engine/archive.h"
#include "script/block.h"
#include "script/signature.h"

#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>

#include <cmocka.h>

#include <stdio.h>
#include <unistd.h>

static script_host host;
static char folder[] = "/tmp/sarcina-past-XXXXXX";

static int open_host(void **state) {
    (void)state;
    script_host_open(&host);
    host.host.shell = NULL;
    return mkdtemp(folder) && chdir(folder) == 0 ? 0 : -1;
}

static int close_host(void **state) {
    (void)state;
    script_host_close(&host);
    return system("rm -rf \"$PWD\"") == 0 ? 0 : -1;
}

static archive *state_of(interp *in) {
    archive *a = session_pack(in);
    char *settings = interp_settings_save(in);
    archive_put(a, "settings", settings, strlen(settings));
    free(settings);
    return a;
}

static void write_files(void) {
    const command_table *t = host.commands;
    for (size_t i = 0; i < t->nfiles; i++) {
        FILE *f = fopen(t->files[i].name, "w");
        assert_non_null(f);
        fputs(t->files[i].text, f);
        fclose(f);
    }
}

/* Every example of the manual, taken back line by line. */
static void test_examples(void **state) {
    (void)state;
    const command_table *t = host.commands;
    size_t wrong = 0, changed = 0;
    for (size_t i = 0; i < t->count; i++) {
        const command_form *form = &t->list[i].form;
        if (!form->example || (form->flags & COMMAND_PROMPT) || strstr(form->example, "quit"))
            continue;
        write_files();
        interp *in = interp_create(&host.host);
        example_host_type(in, t->prelude, true);
        archive *before = state_of(in);
        example_host_type(in, form->example, true);
        archive *between = state_of(in);
        bool same = archive_share(between, before);
        changed += !same;
        /* as many steps back as there are, down to the prelude's own */
        for (int k = 0; !same && k < 20; k++) {
            script_host_clear(&host);
            example_host_type(in, "undo", true);
            archive *now = state_of(in);
            same = archive_share(now, before);
            archive_free(now);
        }
        if (!same)
            printf("undo does not take back: %s\n%s\n", form->example, host.errors);
        wrong += !same;
        archive_free(between);
        archive_free(before);
        interp_free(in);
    }
    printf("%zu examples that change the state\n", changed);
    assert_true(changed > 30);
    assert_int_equal(wrong, 0);
}

static void test_room(void **state) {
    (void)state;
    host.host.undo_bytes = 1;
    interp *in = interp_create(&host.host);
    script_host_clear(&host);
    example_host_type(in, "variable a string 1\nvariable a string 2\nvariable a string 3", true);
    assert_non_null(strstr(host.printed, "from here on undo goes back 1 command: older states are dropped"));
    example_host_type(in, "undo 2", true);
    assert_non_null(strstr(host.errors, "undo goes back no further than 1 command: older states have been dropped"));
    script_host_clear(&host);
    example_host_type(in, "undo\nprint $a", true);
    assert_string_equal(host.printed, "undone: variable a string 3\n2\n");
    interp_free(in);
    host.host.undo_bytes = 0;
}

/* Three cells of 1000 in a row, one state: what does not change is kept once. */
static void test_sharing(void **state) {
    (void)state;
    archive *a = archive_create(), *b = archive_create();
    char bytes[1000] = "x";
    archive_put(a, "big", bytes, sizeof bytes);
    archive_put(b, "big", bytes, sizeof bytes);
    size_t alone = archive_bytes(a);
    assert_true(archive_share(b, a));
    assert_true(archive_bytes(a) + archive_bytes(b) < 2 * alone - 900);
    archive_free(a);
    assert_memory_equal(archive_get(b, "big", NULL), bytes, sizeof bytes);
    archive_free(b);
    a = archive_create();
    b = archive_create();
    archive_put(a, "big", "1", 1);
    archive_put(b, "big", "2", 1);
    assert_false(archive_share(b, a));
    archive_free(a);
    archive_free(b);
}

static char *read_file(const char *path) {
    char *text = alloc_zeroed(4096, 1);
    FILE *f = fopen(path, "r");
    assert_non_null(f);
    assert_true(fread(text, 1, 4095, f) > 0);
    fclose(f);
    return text;
}

/* What came before the prompt, a value drawn, quotes of all kinds. */
static void test_script(void **state) {
    (void)state;
    interp *in = interp_create(&host.host);
    past_begin(in);
    past_given_variable(in, "a", "it's $5");
    past_given_variable(in, "b", "say \"x\"");
    assert_int_equal(interp_set_variable(in, "a", "it's $5", NULL), SARCINA_OK);
    interp_run_source(in, "-e", "seed 5");
    past_given(in, "seed 5", SARCINA_OK);
    example_host_type(in, "random(0,1)\nprint 'no change'\nspecies ball coccus\nnonsense\nsave saved.in", true);
    char *text = read_file("saved.in");
    assert_string_equal(text, "# saved by sarcina " SARCINA_VERSION " on ; replays this session's scene\n"
                              "variable a default \"it's $$5\"\n"
                              "variable b default 'say \"x\"'\n"
                              "seed 5\n"
                              "print $(random(0,1))\n"
                              "species ball coccus\n");
    free(text);
    script_host_clear(&host);
    example_host_type(in, "save saved.in\nsave no/such/folder/is/made.in", true);
    assert_non_null(strstr(host.errors, "'saved.in' is there already"));
    assert_non_null(strstr(host.printed, "no/such/folder/is/made.in: 5 commands"));
    interp_free(in);
}

static void test_no_editor(void **state) {
    (void)state;
    host.host.edit = NULL;
    interp *in = interp_create(&host.host);
    script_host_clear(&host);
    example_host_type(in, "edit", true);
    assert_non_null(strstr(host.errors, "there is no editor here"));
    interp_free(in);
    host.host.edit = script_host_edit;
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_examples), cmocka_unit_test(test_room),      cmocka_unit_test(test_sharing),
        cmocka_unit_test(test_script),   cmocka_unit_test(test_no_editor),
    };
    return cmocka_run_group_tests(tests, open_host, close_host);
}

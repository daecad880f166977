/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The scripts and traps of the design (tests/language): each trap is a line, or several parted by '⏎', and the answer
 * due: "ok" (a check finds no error), "= text" (what it prints last), or a part of the error. What later.txt lists
 * must still fail. */
#include "script_host.h"

#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>

#include <cmocka.h>

#include <ctype.h>
#include <stdio.h>
#include <unistd.h>

#define LANGUAGE SARCINA_TEST_DATA "/../language"

static const char setup[] = "species ff rod diameter 0.75um\n"
                            "species cf coccus\n"
                            "region inner block -1um 1um -1um 1um -1um 1um\n"
                            "variable h0 equal 2um\n";

typedef struct lines {
    char **list;
    size_t n, capacity;
} lines;

/* The lines of a file that are neither empty nor comments ("##"). */
static lines read_lines(const char *path) {
    lines l = {0};
    FILE *f = fopen(path, "r");
    char *line = NULL;
    size_t room = 0;
    assert_non_null(f);
    while (getline(&line, &room, f) > 0) {
        line[strcspn(line, "\n")] = '\0';
        if (!*line || strncmp(line, "##", 2) == 0)
            continue;
        l.list = alloc_grow(l.list, &l.capacity, l.n + 1, sizeof *l.list);
        l.list[l.n++] = alloc_copy(line);
    }
    free(line);
    fclose(f);
    return l;
}

static void free_lines(lines *l) {
    for (size_t i = 0; i < l->n; i++)
        free(l->list[i]);
    free(l->list);
}

static bool has_line(const lines *l, const char *line) {
    for (size_t i = 0; i < l->n; i++)
        if (strcmp(l->list[i], line) == 0)
            return true;
    return false;
}

/* The set-up and the trap's line, its ⏎ as line ends; the caller frees. */
static char *script_of(const char *line) {
    static const char mark[] = "\xe2\x8f\x8e";
    char *text = alloc_format("%s%s\n", setup, line), *at;
    while ((at = strstr(text, mark))) {
        *at = '\n';
        memmove(at + 1, at + 3, strlen(at + 3) + 1);
    }
    return text;
}

/* The last line printed, without its end. */
static const char *last_line(char *printed) {
    size_t n = strlen(printed);
    if (n && printed[n - 1] == '\n')
        printed[n - 1] = '\0';
    const char *end = strrchr(printed, '\n');
    return end ? end + 1 : printed;
}

/* Whether the program gives the answer due; what it gave instead goes to *got (the caller frees). */
static bool answers(script_host *h, const char *line, const char *due, char **got) {
    interp *in = interp_create(&h->host);
    char *text = script_of(line);
    script_host_clear(h);
    size_t errors = interp_check_text(in, "trap", text);
    bool right;
    if (strcmp(due, "ok") == 0) {
        right = errors == 0;
        *got = alloc_copy(h->errors);
    } else if (strncmp(due, "= ", 2) == 0) {
        right = errors == 0 && interp_run_source(in, "trap", text) == SARCINA_OK;
        right = right && strcmp(last_line(h->printed), due + 2) == 0;
        *got = alloc_format("%s%s", h->printed, h->errors);
    } else {
        right = errors > 0 && strstr(h->errors, due);
        *got = alloc_format("%s", *h->errors ? h->errors : "no error\n");
    }
    free(text);
    interp_free(in);
    return right;
}

static void test_traps(void **state) {
    (void)state;
    script_host h;
    script_host_open(&h);
    lines traps = read_lines(LANGUAGE "/traps.txt"), later = read_lines(LANGUAGE "/later.txt");
    size_t wrong = 0, passed = 0, waiting = 0;
    for (size_t i = 0; i < traps.n; i++) {
        char *line = traps.list[i], *arrow = strstr(line, " ==> "), *got;
        assert_non_null(arrow);
        bool is_later = has_line(&later, line);
        *arrow = '\0';
        bool right = answers(&h, line, arrow + 5, &got);
        if (right != !is_later) {
            printf("%s\n  due: %s%s\n  got: %s\n", line, arrow + 5, is_later ? " (listed as later)" : "", got);
            wrong++;
        }
        passed += right;
        waiting += is_later;
        free(got);
    }
    printf("%zu traps: %zu answered, %zu later, %zu wrong\n", traps.n, passed, waiting, wrong);
    free_lines(&traps);
    free_lines(&later);
    script_host_close(&h);
    assert_int_equal(wrong, 0);
}

/* Every script is checked whole; those listed must have an error. */
static void test_scripts(void **state) {
    (void)state;
    static const char *const scripts[] = {
        "sample.in",
        "ecoli/default.in",
        "ecoli/filial.in",
        "ecoli/anchored.in",
        "ecoli/anchored_2x.in",
        "ecoli/anchored_half.in",
        "ecoli/gliding.in",
        "floc/branching.in",
        "floc/flexible.in",
        "floc/high_oxygen.in",
        "floc/spherical.in",
        "floc/standard.in",
        "floc/stiff.in",
        "floc/strong_sticking.in",
        "floc/weak_sticking.in",
        "tests/two_balls.test.in",
        "tutorial/01_two_cells.in",
        "tutorial/02_filament_bends.in",
        "tutorial/03_streptococcus.in",
        "tutorial/04_sarcina.in",
        "tutorial/05_helix.in",
        "tutorial/06_gliding.in",
        "tutorial/07_sweep.in",
        "tutorial/10a_write.in",
        "tutorial/10b_continue.in",
        "tutorial/10c_resume.in",
        "tutorial/11_custom_analysis.in",
        "tutorial/12_antibiotic.in",
        "tutorial/13_attachment.in",
        "tutorial/14_checkpoint.in",
        "tutorial/15_one_species.in",
        "tutorial/16_thermo.in",
        "tutorial/17_tradeoff.in",
        "tutorial/18_control.in",
    };
    script_host h;
    script_host_open(&h);
    lines later = read_lines(LANGUAGE "/later.txt");
    size_t wrong = 0;
    for (size_t i = 0; i < sizeof scripts / sizeof *scripts; i++) {
        char *path = alloc_format("%s/%s", LANGUAGE, scripts[i]);
        interp *in = interp_create(&h.host);
        script_host_clear(&h);
        size_t errors = interp_check_file(in, path);
        if ((errors == 0) == has_line(&later, scripts[i])) {
            printf("%s: %zu errors\n%s\n", scripts[i], errors, h.errors);
            wrong++;
        }
        interp_free(in);
        free(path);
    }
    free_lines(&later);
    script_host_close(&h);
    assert_int_equal(wrong, 0);
}

int main(void) {
    const struct CMUnitTest tests[] = {cmocka_unit_test(test_traps), cmocka_unit_test(test_scripts)};
    return cmocka_run_group_tests_name("language", tests, NULL, NULL);
}

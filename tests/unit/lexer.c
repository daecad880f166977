/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Logical lines and blocks: what is joined, what is left out, and that every character keeps its place. */
#include "base/alloc.h"
#include "script/block.h"
#include "script/line.h"
#include "script/piece.h"

#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>

#include <cmocka.h>

#include <stdlib.h>
#include <string.h>

/* Runs of blanks as one: how many a continuation leaves does not matter. */
static void collapse_blanks(char *text) {
    char *to = text;
    for (const char *c = text; *c; c++)
        if (*c != ' ' || to == text || to[-1] != ' ')
            *to++ = *c;
    *to = '\0';
}

/* All logical lines of a text with '|' between; an error as "!message". The caller frees. */
static char *lines_of(const char *text) {
    source *s = source_of_text("test", text);
    piece script = piece_of_source(s);
    char *all = alloc_copy("");
    for (size_t at = 0;;) {
        piece line = {0};
        line_notes notes;
        diag d = {0};
        int status = line_next(&script, &at, &line, &notes, &d);
        bool end = status == SARCINA_OK && line.n == 0;
        char *longer = alloc_format("%s%s%s%s", all, *all && !end ? "|" : "", status ? "!" : "",
                                    status   ? d.message
                                    : line.n ? line.chars
                                             : "");
        free(all);
        all = longer;
        piece_free(&line);
        if (end)
            break;
    }
    collapse_blanks(all);
    piece_free(&script);
    source_free(s);
    return all;
}

static void test_lines(void **state) {
    (void)state;
    static const struct {
        const char *text, *lines;
    } cases[] = {
        {"", ""},
        {"\n\n  \n# only\n", ""},
        {"a b\nc", "a b|c"},
        {"a b\r\nc\r\n", "a b|c"},
        {"\ta\tb \n", "a\tb"},
        {"a # comment\nb", "a|b"},
        {"a &\nb", "a b"},
        {"a &   \n  b", "a b"},
        {"a & # c\nb", "a b"},
        {"a &\n # c\n b", "a b"},
        {"a && \nb", "a && b"},
        {"a &", "a"},
        {"'a # b' # c", "'a # b'"},
        {"'it & '\nb", "'it & '|b"},
        {"don't # c\nb", "don't|b"},
        {"f('a#b') # c", "f('a#b')"},
        {"\"\"\"a\n# b\n\"c\" \"\"\" d", "\"\"\"a\n# b\n\"c\" \"\"\" d"},
        {"'a\nb", "!the quote is not closed|b"},
        {"\"\"\"a\nb", "!the quote is not closed"},
        {"\xe2\x80\x9c"
         "a # b",
         "\xe2\x80\x9c"
         "a"},
    };
    for (size_t i = 0; i < sizeof cases / sizeof *cases; i++) {
        char *lines = lines_of(cases[i].text);
        if (strcmp(lines, cases[i].lines) != 0)
            fail_msg("'%s' gives '%s', not '%s'", cases[i].text, lines, cases[i].lines);
        free(lines);
    }
}

/* Characters behind a continuation know their own line; replaced ones carry the place of the $. */
static void test_places(void **state) {
    (void)state;
    source *s = source_of_text("test", "ab &\n  cd $x ef\n");
    piece script = piece_of_source(s), line = {0};
    size_t at = 0;
    line_notes notes;
    assert_int_equal(line_next(&script, &at, &line, &notes, NULL), SARCINA_OK);
    size_t c = (size_t)(strchr(line.chars, 'c') - line.chars), x = (size_t)(strchr(line.chars, '$') - line.chars);
    span cd = piece_span(&line, c, c + 2);
    assert_true(cd.line == 2 && cd.column == 3 && cd.length == 2);
    mark m = line.marks[x];
    m.length = 2;
    m.serial = 1;
    piece_splice(&line, x, x + 2, "long text", 9, m);
    span word = piece_span(&line, x + 5, x + 9), behind = piece_span(&line, x + 10, x + 12);
    assert_true(word.column == 6 && word.length == 2 && piece_is_replaced(&line, x));
    assert_true(behind.column == 9 && behind.length == 2 && !piece_is_replaced(&line, x + 10));
    size_t length;
    const char *text = source_line(s, 2, &length);
    assert_true(length == 10 && strncmp(text, "  cd $x ef", 10) == 0);
    assert_null(source_line(s, 9, &length));
    piece_free(&line);
    piece_free(&script);
    source_free(s);
}

static void count_errors(void *self, const diag *d) {
    (void)d;
    ++*(size_t *)self;
}

static void test_blocks(void **state) {
    (void)state;
    static const struct {
        const char *text;
        size_t statements, errors;
    } cases[] = {
        {"a\nb\n", 2, 0},
        {"if x\na\nelif y\nb\nelse\nc\nend\nd", 2, 0},
        {"for i in 1..3\nif x\na\nend if\nend for\n", 1, 0},
        {"if x then 'a'\nb", 2, 0},
        {"if x then 'a' else 'b'\nend\n", 1, 1},
        {"if x then\na\nend", 1, 1},
        {"if 'a then b'\na\nend", 1, 0},
        {"while x\na", 1, 1},
        {"repeat 3\na\nend while", 1, 1},
        {"if x\na\nelse if y\nb\nend", 1, 1},
        {"if x\na\nelse\nb\nelse\nc\nend", 1, 1},
        {"end\nend\na", 1, 2},
        {"for i in 1 2\n'a\nend", 1, 1},
    };
    for (size_t i = 0; i < sizeof cases / sizeof *cases; i++) {
        source *s = source_of_text("test", cases[i].text);
        piece script = piece_of_source(s);
        block b = {0};
        size_t told = 0, errors = block_parse(&script, &b, count_errors, &told);
        if (b.count != cases[i].statements || errors != cases[i].errors || told != errors)
            fail_msg("'%s': %zu statements and %zu errors, not %zu and %zu", cases[i].text, b.count, errors,
                     cases[i].statements, cases[i].errors);
        block_free(&b);
        piece_free(&script);
        source_free(s);
    }
}

/* What a prompt must ask to go on. */
static void test_open(void **state) {
    (void)state;
    static const char *const open[] = {"if x", "for i in 1..3\nif y\nend", "a &", "\"\"\"a", "\"\"\"a\nb"};
    static const char *const whole[] = {"a", "", "if x\nend", "if x then 'a'", "end", "a # b &", "'a"};
    for (size_t i = 0; i < sizeof open / sizeof *open; i++)
        if (!block_is_open(open[i]))
            fail_msg("'%s' is open", open[i]);
    for (size_t i = 0; i < sizeof whole / sizeof *whole; i++)
        if (block_is_open(whole[i]))
            fail_msg("'%s' is whole", whole[i]);
}

int main(void) {
    const struct CMUnitTest tests[] = {cmocka_unit_test(test_lines), cmocka_unit_test(test_places),
                                       cmocka_unit_test(test_blocks), cmocka_unit_test(test_open)};
    return cmocka_run_group_tests_name("lexer", tests, NULL, NULL);
}

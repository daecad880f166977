/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Pictures of text: what is in front, how it is written in each style, that it fits. */
#include "output/blocks.h"

#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>

#include <cmocka.h>

#include <stdlib.h>
#include <string.h>

static const rgb red = {1, 0, 0}, green = {0, 1, 0};

static char *draw(const capsule *list, size_t n, blocks_style style, int columns, int rows, double *scale) {
    const blocks_options o = {.style = style, .columns = columns, .rows = rows};
    return blocks_draw(list, n, &o, scale);
}

static void test_nothing(void **state) {
    (void)state;
    double scale = 1;
    char *text = draw(NULL, 0, BLOCKS_RGB, 80, 24, &scale);
    assert_string_equal(text, "");
    assert_true(scale == 0);
    free(text);
}

/* A ball of radius 4 pixels, by hand: within 0.85 of it lie rows of 0, 4, 6, 6, 6, 6, 4, 0 pixels. */
static void test_ball(void **state) {
    (void)state;
    const capsule ball = {.r = 1, .color = {1, 1, 1}};
    double scale;
    char *text = draw(&ball, 1, BLOCKS_ASCII, 8, 4, &scale);
    assert_true(scale == 4);
    assert_string_equal(text, "  ....\n"
                              " ######\n"
                              " ######\n"
                              "  ''''\n");
    free(text);
    text = draw(&ball, 1, BLOCKS_PLAIN, 8, 4, &scale);
    assert_string_equal(text, "  ▄▄▄▄\n ██████\n ██████\n  ▀▀▀▀\n");
    free(text);
    /* a lone cell does not fill the screen */
    text = draw(&ball, 1, BLOCKS_PLAIN, 200, 100, &scale);
    assert_true(scale == 12);
    free(text);
}

/* The same picture whichever comes first: the upper one is seen; from the side both are. */
static void test_depth(void **state) {
    (void)state;
    const capsule both[] = {{.a = {0, 0, 5}, .b = {0, 0, 5}, .r = 1, .color = red}, {.r = 1, .color = green}};
    const capsule turned[] = {both[1], both[0]};
    double scale;
    char *text = draw(both, 2, BLOCKS_RGB, 8, 4, &scale), *again = draw(turned, 2, BLOCKS_RGB, 8, 4, &scale);
    assert_string_equal(text, again);
    assert_null(strstr(text, ";2;0;"));
    assert_non_null(strstr(text, "\033[38;2;"));
    free(text);
    free(again);
    const blocks_options side = {.style = BLOCKS_256, .columns = 20, .rows = 10, .theta = 1.5707963267948966, .phi = 0};
    text = blocks_draw(both, 2, &side, &scale);
    assert_non_null(strstr(text, "\033[38;5;196m"));
    assert_non_null(strstr(text, "\033[38;5;46m"));
    free(text);
}

/* Characters of a line as the terminal counts them. */
static size_t width_of(const char *line, size_t n) {
    size_t width = 0;
    for (size_t i = 0; i < n; i++) {
        if (line[i] == '\033')
            i += strcspn(line + i, "m");
        else
            width += (line[i] & 0xc0) != 0x80;
    }
    return width;
}

static void test_fits(void **state) {
    (void)state;
    capsule list[500];
    uint64_t seed = 7;
    double scale;
    for (size_t i = 0; i < 500; i++) {
        double x[6];
        for (int k = 0; k < 6; k++) {
            seed = seed * 6364136223846793005u + 1442695040888963407u;
            x[k] = (double)(seed >> 40) * 1e-6;
        }
        list[i] = (capsule){.a = {x[0], x[1], x[2]}, .b = {x[0] + 1, x[1], x[2]}, .r = 0.1 + 0.05 * x[3], .color = red};
    }
    for (int columns = 1; columns < 60; columns += 7)
        for (int rows = 1; rows < 20; rows += 3)
            for (int style = BLOCKS_ASCII; style <= BLOCKS_RGB; style++) {
                char *text = draw(list, 500, (blocks_style)style, columns, rows, &scale);
                int lines = 0;
                for (const char *line = text; *line; lines++) {
                    size_t n = strcspn(line, "\n");
                    assert_true(width_of(line, n) <= (size_t)columns);
                    line += n + 1;
                }
                assert_in_range(lines, 1, rows);
                assert_true(scale > 0);
                free(text);
            }
}

static void test_captions(void **state) {
    (void)state;
    char mark[48];
    blocks_mark(BLOCKS_256, (rgb){1, 1, 1}, mark);
    assert_string_equal(mark, "\033[38;5;231m■\033[0m");
    blocks_mark(BLOCKS_RGB, red, mark);
    assert_string_equal(mark, "\033[38;2;255;0;0m■\033[0m");
    blocks_mark(BLOCKS_PLAIN, red, mark);
    assert_string_equal(mark, "■");
    blocks_mark(BLOCKS_ASCII, red, mark);
    assert_string_equal(mark, "#");
    static const struct {
        double scale;
        int most;
        const char *bar;
    } bars[] = {
        {2, 10, "|--------| 5 um"}, {3, 10, "|----| 2 um"}, {4, 7, "|--| 1 um"}, {0.1, 12, "|--------| 100 um"}};
    for (size_t i = 0; i < sizeof bars / sizeof *bars; i++) {
        char *bar = blocks_scale_bar(BLOCKS_ASCII, bars[i].scale, bars[i].most);
        assert_string_equal(bar, bars[i].bar);
        free(bar);
    }
}

int main(void) {
    const struct CMUnitTest tests[] = {cmocka_unit_test(test_nothing), cmocka_unit_test(test_ball),
                                       cmocka_unit_test(test_depth), cmocka_unit_test(test_fits),
                                       cmocka_unit_test(test_captions)};
    return cmocka_run_group_tests(tests, NULL, NULL);
}

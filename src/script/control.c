/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "script/control.h"

#include "base/table.h"

const control_word control_words[] = {
    {"if",
     "if EXPR\n"
     "    LINES\n"
     "[elif EXPR\n"
     "    LINES ...]\n"
     "[else\n"
     "    LINES]\n"
     "end [if]\n"
     "if EXPR then \"COMMAND\" ... [elif EXPR \"COMMAND\" ...] [else \"COMMAND\" ...]",
     "Runs commands where a condition holds",
     "The block form has no then; with something behind then it is LAMMPS's form of one line, whose commands are "
     "quoted "
     "and replaced when they run.",
     "if cells > 100\n"
     "    print \"a colony\"\n"
     "elif cells > 1\n"
     "    print \"a few cells\"\n"
     "else\n"
     "    print \"one cell\"\n"
     "end\n"
     "if cells > 1 then \"print 'more than one'\" else \"print 'one'\""},
    {"elif", "elif EXPR", "Begins another branch of an if", "Judged where no condition before it held.",
     "if cells > 100\n"
     "    print \"many\"\n"
     "elif cells > 1\n"
     "    print \"some\"\n"
     "end"},
    {"else", "else", "Begins the last branch of an if", "Taken where no condition before it held.",
     "if cells > 100\n"
     "    print \"many\"\n"
     "else\n"
     "    print \"few\"\n"
     "end"},
    {"for",
     "for NAME in A..B[..STEP]\n"
     "    LINES\n"
     "end [for]\n"
     "for NAME in WORD ...\n"
     "    LINES\n"
     "end [for]",
     "Runs commands for each number of a range, or for each word",
     "Ranges are of whole numbers and hold both ends; they run upwards unless a STEP says down, so 1..0 runs zero "
     "times. "
     "NAME is an ordinary variable, set anew for each pass; it keeps its last value.",
     "for i in 1..3\n"
     "    print \"$i squared is $(i^2)\"\n"
     "end\n"
     "for name in ecoli cf\n"
     "    print \"$(count(${name})) of ${name}\"\n"
     "end for"},
    {"while", "while EXPR\n    LINES\nend [while]", "Runs commands as long as a condition holds",
     "Condition and body are replaced anew at every pass.",
     "while time < 20min\n"
     "    grow 4min\n"
     "    relax 0.1s\n"
     "end"},
    {"repeat", "repeat N\n    LINES\nend [repeat]", "Runs commands N times", NULL,
     "repeat 2\n"
     "    grow 4min\n"
     "end"},
    {"break", "break", "Ends the innermost loop", NULL,
     "for i in 1..10\n"
     "    if $i > 3 then break\n"
     "    print $i\n"
     "end"},
    {"continue", "continue", "Goes on with the next pass of the innermost loop", NULL,
     "for i in 1..3\n"
     "    if $i == 2 then continue\n"
     "    print $i\n"
     "end"},
    {"end", "end [if|for|while|repeat]", "Closes a block",
     "The word of the block may be repeated, and is checked then. A block ends in the file that began it.",
     "repeat 2\n"
     "    grow 4min\n"
     "end repeat"},
};
const size_t control_word_count = TABLE_COUNT(control_words);

const control_word *control_find(const char *name) {
    ptrdiff_t row = table_find(control_words, control_word_count, sizeof *control_words, name);
    return row < 0 ? NULL : &control_words[row];
}

/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "app/repl_line.h"

#include "app/program.h"
#include "base/alloc.h"
#include "script/complete.h"

#include <errno.h>
#include <signal.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/select.h>
#include <unistd.h>

#include <readline/readline.h>

/* readline's callbacks take no argument of ours: what they look at. */
static struct {
    interp *in;
    const char *before; /* lines of the open command */
    char *line;
    bool done;
    completions found;
    size_t next, skip; /* the next candidate to give; characters that readline's word has before each */
    int cut;           /* characters of each that stand before readline's word */
} state;

/* ---- completion -------------------------------------------------------------------------------------------------- */

/* Candidates one by one, as what takes the place of readline's word. */
static char *next_candidate(const char *word, int again) {
    if (!again)
        state.next = 0;
    while (state.next < state.found.n) {
        const char *text = state.found.list[state.next++].text;
        if (strlen(text) >= (size_t)state.cut)
            return alloc_format("%.*s%s", (int)state.skip, word, text + state.cut);
    }
    return NULL;
}

static char **complete(const char *word, int start, int end) {
    const char *before = state.before ? state.before : "";
    char *text = alloc_format("%s%s%s", before, *before ? "\n" : "", rl_line_buffer);
    size_t offset = strlen(before) + (*before != '\0');
    complete_line(state.in, text, offset + (size_t)end, &state.found);
    free(text);
    rl_attempted_completion_over = 1; /* no file names of readline's own */
    size_t at = offset + (size_t)start;
    state.skip = state.found.from > at ? state.found.from - at : 0;
    state.cut = state.found.from < at ? (int)(at - state.found.from) : 0;
    rl_completion_append_character = state.found.n == 1 && state.found.list[0].open ? '\0' : ' ';
    char **matches = state.found.n ? rl_completion_matches(word, next_candidate) : NULL;
    complete_free(&state.found);
    return matches;
}

/* The list without what stands before the part that is completed: 1010kg/m3, but time of mean(x)/ti. */
static void display(char **matches, int n, int longest) {
    char **tails = alloc_zeroed((size_t)n + 2, sizeof *tails);
    for (int i = 0; i <= n; i++)
        tails[i] = strlen(matches[i]) >= state.skip ? matches[i] + state.skip : matches[i];
    rl_display_match_list(tails, n, longest - (int)state.skip);
    free(tails);
    rl_forced_update_display();
}

void repl_line_open(interp *in) {
    state.in = in;
    rl_readline_name = "sarcina";
    if (!isatty(STDOUT_FILENO))
        rl_outstream = stderr;
    rl_attempted_completion_function = complete;
    rl_completion_display_matches_hook = display;
    rl_completer_word_break_characters = " \t\n";
    rl_completer_quote_characters = NULL;
    rl_basic_quote_characters = "";
}

/* ---- a line ------------------------------------------------------------------------------------------------------ */

static void take_line(char *line) {
    state.line = line;
    state.done = true;
    rl_callback_handler_remove();
}

/* Waits for a key or a signal; signals come in only while it waits, so that none is missed. */
static bool wait_for_key(void) {
    sigset_t watched, before;
    fd_set keys;
    sigemptyset(&watched);
    const int signals[] = {SIGINT, SIGTSTP, SIGWINCH, SIGTERM, SIGHUP};
    for (size_t i = 0; i < sizeof signals / sizeof *signals; i++)
        sigaddset(&watched, signals[i]);
    sigprocmask(SIG_BLOCK, &watched, &before);
    FD_ZERO(&keys);
    FD_SET(STDIN_FILENO, &keys);
    bool pending = rl_pending_signal() != 0 || program_is_interrupted();
    int n = pending ? -1 : pselect(STDIN_FILENO + 1, &keys, NULL, NULL, NULL, &before);
    sigprocmask(SIG_SETMASK, &before, NULL);
    if (n < 0)
        rl_check_signals(); /* Ctrl-C, Ctrl-Z, a new size of the terminal */
    return n > 0;
}

static void discard(void) {
    rl_callback_sigcleanup();
    rl_free_line_state();
    rl_replace_line("", 1);
    rl_callback_handler_remove();
    fputc('\n', rl_outstream ? rl_outstream : stdout);
    fflush(rl_outstream ? rl_outstream : stdout);
    program_clear_interrupt();
}

repl_line_status repl_line_edit(const char *before, char **line) {
    state.before = before;
    state.done = false;
    state.line = NULL;
    rl_callback_handler_install(before ? "     ...> " : "sarcina> ", take_line);
    while (!state.done) {
        if (wait_for_key() && !program_is_interrupted()) /* it came in after the key: the key is of the next line */
            rl_callback_read_char();
        if (program_is_interrupted() && !state.done) {
            discard();
            return REPL_LINE_INTERRUPTED;
        }
    }
    *line = state.line;
    return state.line ? REPL_LINE : REPL_LINE_END;
}

repl_line_status repl_line_read(char **line) {
    size_t room = 0;
    *line = NULL;
    program_end_reads(true);
    ssize_t n = getline(line, &room, stdin);
    program_end_reads(false);
    if (n < 0) {
        free(*line);
        *line = NULL;
        return program_is_interrupted() ? REPL_LINE_INTERRUPTED : REPL_LINE_END;
    }
    if (n && (*line)[n - 1] == '\n')
        (*line)[n - 1] = '\0';
    return REPL_LINE;
}

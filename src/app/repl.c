/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "app/repl.h"

#include "app/program.h"
#include "app/repl_history.h"
#include "app/repl_line.h"
#include "base/alloc.h"
#include "base/number.h"
#include "command/past.h"
#include "script/block.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

typedef struct repl {
    interp *in;
    bool terminal;
    char *history; /* its file; NULL: none, or it cannot be written */
    char *waiting; /* lines that came with the one before; NULL: none */
} repl;

/* ---- reading ----------------------------------------------------------------------------------------------------- */

/* The next line; of several that came at once (pasted, or a block from the history) one after the other. */
static repl_line_status next_line(repl *r, const char *before, char **line) {
    repl_line_status got = REPL_LINE;
    char *all = r->waiting;
    r->waiting = NULL;
    if (!all)
        got = r->terminal ? repl_line_edit(before, &all) : repl_line_read(&all);
    if (got != REPL_LINE)
        return got;
    size_t n = strcspn(all, "\n");
    if (all[n])
        r->waiting = alloc_copy(all + n + 1);
    all[n] = '\0';
    *line = all;
    return REPL_LINE;
}

/* One command or block, over as many lines as it takes; NULL at the end of the input. The caller frees. */
static char *read_entry(repl *r, bool *interrupted) {
    char *text = NULL;
    *interrupted = false;
    for (;;) {
        char *line = NULL;
        repl_line_status got = next_line(r, text, &line);
        if (got == REPL_LINE_END)
            return text;
        if (got == REPL_LINE_INTERRUPTED) {
            free(text);
            text = NULL;
            *interrupted = true;
            if (!r->terminal)
                return NULL;
            continue;
        }
        char *longer = text ? alloc_format("%s\n%s", text, line) : alloc_copy(line);
        free(text);
        free(line);
        text = longer;
        if (!block_is_open(text))
            return text;
    }
}

static void keep(repl *r, const char *text) {
    int error = r->terminal ? repl_history_add(r->history, text) : 0;
    if (!error)
        return;
    fprintf(stderr, "what is typed cannot be kept in '%s': %s\n", r->history, strerror(error));
    free(r->history);
    r->history = NULL;
}

/* ---- init.in ----------------------------------------------------------------------------------------------------- */

/* The user's own first commands; the caller frees. */
static char *init_path(void) {
    const char *config = getenv("XDG_CONFIG_HOME"), *home = getenv("HOME");
    if (config && *config == '/')
        return alloc_format("%s/sarcina/init.in", config);
    return home && *home ? alloc_format("%s/.config/sarcina/init.in", home) : NULL;
}

static void run_init(const repl *r, const options *o) {
    char *path = r->terminal && !o->safe && !o->noinit ? init_path() : NULL;
    if (path && access(path, R_OK) == 0) {
        interp_print(r->in, "reading %s", path);
        int status = interp_check_file(r->in, path) ? SARCINA_ERROR : interp_run_file(r->in, path);
        past_given_file(r->in, path, status);
    }
    free(path);
}

/* ---- the prompt -------------------------------------------------------------------------------------------------- */

static void greet(const repl *r) {
    int threads = interp_scene(r->in)->threads;
    interp_screen(r->in, "sarcina %s (%d %s)  'help' lists commands, 'help COMMAND' explains one, Tab completes",
                  SARCINA_VERSION, threads, number_noun((uint64_t)threads, "thread", "threads"));
}

static bool is_blank(const char *text) {
    return text[strspn(text, " \t\r\n")] == '\0';
}

static void run_entry(repl *r, const char *text) {
    if (is_blank(text))
        return;
    keep(r, text);
    program_clear_interrupt();
    interp_run_line(r->in, text);
    /* Ctrl-C has ended all that came with this line */
    if (program_is_interrupted()) {
        free(r->waiting);
        r->waiting = NULL;
    }
    program_clear_interrupt();
}

static void show_lines(const repl *r, const char *text) {
    const char *prompt = "sarcina> ";
    for (size_t n; *text; text += n + (text[n] == '\n')) {
        n = strcspn(text, "\n");
        interp_screen(r->in, "%s%.*s", prompt, (int)n, text);
        prompt = "     ...> ";
    }
}

/* What a command wants to be run next is shown as if it had been typed. */
static void run_edited(repl *r) {
    char *text;
    int code;
    while (!interp_has_quit(r->in, &code) && (text = past_take_next(r->in))) {
        if (r->terminal)
            show_lines(r, text);
        run_entry(r, text);
        free(text);
    }
}

static void open_terminal(repl *r) {
    r->history = repl_history_path();
    if (r->history)
        repl_history_load(r->history);
    repl_line_open(r->in);
    greet(r);
}

bool repl_is_wanted(const options *o) {
    return o->interactive || (!o->file && !o->ncommands && isatty(STDIN_FILENO));
}

int repl_run(const options *o, interp *in) {
    repl r = {.in = in, .terminal = isatty(STDIN_FILENO)};
    int code = 0;
    char *text = NULL;
    bool interrupted = false;
    program_be_patient();
    program_clear_interrupt();
    if (r.terminal)
        open_terminal(&r);
    run_init(&r, o);
    while (!interp_has_quit(in, &code) && (text = read_entry(&r, &interrupted))) {
        run_entry(&r, text);
        free(text);
        run_edited(&r);
    }
    if (r.terminal && !interp_has_quit(in, &code))
        putchar('\n'); /* behind the prompt that Ctrl-D has answered */
    free(r.history);
    free(r.waiting);
    return interrupted && !r.terminal ? SARCINA_INTERRUPTED : code;
}

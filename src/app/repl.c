/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "app/repl.h"

#include "app/repl_history.h"
#include "app/repl_line.h"
#include "base/alloc.h"
#include "script/block.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

typedef struct repl {
    program *program;
    interp *in;
    bool terminal;
    char *history; /* its file; NULL: none, or it cannot be written */
} repl;

/* ---- reading ----------------------------------------------------------------------------------------------------- */

/* One command or block, over as many lines as it takes; NULL at the end of the input. The caller frees. */
static char *read_entry(const repl *r, bool *interrupted) {
    char *text = NULL, *line;
    *interrupted = false;
    for (;;) {
        repl_line_status got = r->terminal ? repl_line_edit(text, &line) : repl_line_read(&line);
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
        if (interp_check_file(r->in, path) == 0)
            interp_run_file(r->in, path);
    }
    free(path);
}

/* ---- the prompt -------------------------------------------------------------------------------------------------- */

static void greet(const repl *r) {
    int threads = interp_scene(r->in)->threads;
    interp_screen(r->in, "sarcina %s (%d thread%s)  'help' lists commands, 'help COMMAND' explains one, Tab completes",
                  SARCINA_VERSION, threads, threads == 1 ? "" : "s");
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
    program_clear_interrupt();
}

static void open_terminal(repl *r) {
    r->history = repl_history_path();
    if (r->history)
        repl_history_load(r->history);
    repl_line_open(r->in);
    greet(r);
}

int repl_run(program *p, const options *o, interp *in) {
    repl r = {.program = p, .in = in, .terminal = isatty(STDIN_FILENO)};
    int code = 0;
    char *text = NULL;
    bool interrupted = false;
    program_be_patient();
    if (r.terminal)
        open_terminal(&r);
    run_init(&r, o);
    while (!interp_has_quit(in, &code) && (text = read_entry(&r, &interrupted))) {
        run_entry(&r, text);
        free(text);
    }
    if (r.terminal && !interp_has_quit(in, &code))
        putchar('\n'); /* behind the prompt that Ctrl-D has answered */
    free(r.history);
    return interrupted && !r.terminal ? SARCINA_INTERRUPTED : code;
}

/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "app/program.h"

#include "app/plan.h"

#include "app/editor.h"
#include "app/terminal.h"
#include "base/alloc.h"
#include "base/number.h"
#include "command/commands.h"
#include "script/source.h"

#include <errno.h>
#include <gsl/gsl_errno.h>
#include <inttypes.h>
#include <poll.h>
#include <signal.h>
#include <stdio_ext.h>
#include <stdlib.h>
#include <string.h>
#include <time.h>
#include <unistd.h>

static volatile sig_atomic_t interrupted, patient, ending;

/* Whether a process has sent the same a moment ago: timeout(1) and others signal a process and then its whole group,
 * which is one wish. Of a terminal each is one (a code > 0: from the kernel; readline passes it on itself). */
static bool is_echo(int signal_number, const siginfo_t *from) {
    static struct timespec last;
    static int last_number;
    struct timespec now;
    clock_gettime(CLOCK_MONOTONIC, &now);
    double since = (double)(now.tv_sec - last.tv_sec) + 1e-9 * (double)(now.tv_nsec - last.tv_nsec);
    bool echo = signal_number == last_number && since < 0.1 && from->si_code <= 0 && from->si_pid != getpid();
    last = now;
    last_number = signal_number;
    return echo;
}

static void interrupt(int signal_number) {
    static const char warning[] = "\nthe command has not come to an end yet; Ctrl-C once more ends sarcina\n";
    if (interrupted > patient) { /* it is not being looked at */
        signal(signal_number, SIG_DFL);
        raise(signal_number);
        return;
    }
    if (interrupted) {
        poll(NULL, 0, 50); /* the terminal drops output that comes as it answers Ctrl-C */
        if (write(STDERR_FILENO, warning, sizeof warning - 1) < 0)
            signal(signal_number, SIG_DFL);
    }
    interrupted++;
}

static void on_interrupt(int signal_number, siginfo_t *from, void *context) {
    (void)context;
    if (!is_echo(signal_number, from))
        interrupt(signal_number);
}

static bool is_ignored(int signal_number) {
    struct sigaction action;
    return sigaction(signal_number, NULL, &action) == 0 && action.sa_handler == SIG_IGN;
}

/* A write that a signal comes upon goes on behind it: what it had not written would be lost. */
void program_catch_interrupts(bool prompt) {
    struct sigaction action = {.sa_sigaction = on_interrupt, .sa_flags = SA_SIGINFO | SA_RESTART};
    sigemptyset(&action.sa_mask);
    if (prompt || !is_ignored(SIGINT))
        sigaction(SIGINT, &action, NULL);
}

void program_end_reads(bool yes) {
    struct sigaction action;
    if (sigaction(SIGINT, NULL, &action))
        return;
    action.sa_flags = yes ? action.sa_flags & ~SA_RESTART : action.sa_flags | SA_RESTART;
    sigaction(SIGINT, &action, NULL);
}

static void on_ending(int signal_number, siginfo_t *from, void *context) {
    (void)context;
    if (is_echo(signal_number, from))
        return;
    if (signal_number == SIGINT)
        interrupt(signal_number);
    if (signal_number != SIGINT && ending) {
        signal(signal_number, SIG_DFL);
        raise(signal_number);
    }
    if (signal_number != SIGINT || from->si_code <= 0) /* > 0: from the kernel, that is its terminal */
        ending = signal_number;
}

void program_catch_ending(void) {
    static const int signals[] = {SIGTERM, SIGHUP, SIGINT};
    struct sigaction action = {.sa_sigaction = on_ending, .sa_flags = SA_SIGINFO | SA_RESTART};
    sigemptyset(&action.sa_mask);
    for (size_t i = 0; i < sizeof signals / sizeof *signals; i++)
        if (!is_ignored(signals[i]))
            sigaction(signals[i], &action, NULL);
}

int program_ending(void) {
    return ending;
}

void program_be_patient(void) {
    patient = 1;
}

bool program_is_interrupted(void) {
    return interrupted;
}

void program_clear_interrupt(void) {
    interrupted = 0;
}

void program_complain(const diag *d) {
    fprintf(stderr, "sarcina: error: %s\n", d->message);
    for (const char *h = d->help; *h;) {
        size_t n = strcspn(h, "\n");
        fprintf(stderr, "help: %.*s\n", (int)n, h);
        h += n + (h[n] == '\n');
    }
}

/* ---- callbacks ---- */

/* Takes the progress away, so that what is printed next stands alone. */
static void erase_progress(program *p) {
    if (p->shown)
        fputs("\r\033[K", stderr);
    for (int i = 1; i < p->shown; i++)
        fputs("\033[A\033[K", stderr);
    p->shown = 0;
}

/* None from the background of a terminal. The last line is the progress itself, cut where it would wrap and stay; a
 * picture above it is as wide as there is room. */
static void show_progress(void *self, const char *text) {
    program *p = self;
    erase_progress(p);
    if (!text || tcgetpgrp(STDERR_FILENO) != getpgrp())
        return;
    const char *last = strrchr(text, '\n');
    last = last ? last + 1 : text;
    p->shown = 1;
    for (const char *c = text; c < last; c++)
        p->shown += *c == '\n';
    fprintf(stderr, "%.*s%.*s", (int)(last - text), text, terminal_of(stderr).columns - 1, last);
}

static void print_screen(void *self, const char *text) {
    program *p = self;
    if (!p->screen)
        return;
    erase_progress(p);
    fputs(text, p->screen);
    fflush(p->screen);
}

static void print_log(void *self, const char *text) {
    logfile_put(&((program *)self)->log, text);
}

static bool start_log(void *self) {
    return logfile_start(&((program *)self)->log);
}

static void print_error(void *self, const char *text) {
    program *p = self;
    if (p->screen)
        fflush(p->screen);
    erase_progress(p);
    fputs(text, stderr);
    logfile_put(&p->log, text);
}

static int open_log(void *self, const char *path, bool append, diag *d) {
    return logfile_open(&((program *)self)->log, path, append, d);
}

static int run_shell(void *self, const char *command, diag *d) {
    program *p = self;
    if (p->screen)
        fflush(p->screen);
    erase_progress(p);
    int code = system(command);
    return code == 0 ? SARCINA_OK : diag_error(d, "the command ended with %d: %s", code, command);
}

static int run_editor(void *self, char **text, diag *d) {
    program *p = self;
    if (p->screen)
        fflush(p->screen);
    return editor_run(text, d);
}

static interp_terminal describe_terminal(void *self) {
    return terminal_of(((program *)self)->screen);
}

static const char *date_of_today(void *self) {
    program *p = self;
    time_t now = time(NULL);
    struct tm day;
    strftime(p->date, sizeof p->date, "%Y-%m-%d", localtime_r(&now, &day));
    return p->date;
}

static const char *look_up_environment(void *self, const char *name) {
    (void)self;
    return getenv(name);
}

/* ---- life ---- */

static char *find_library(void) {
    char path[4096];
    ssize_t n = readlink("/proc/self/exe", path, sizeof path - 1);
    if (n <= 0)
        return NULL;
    path[n] = '\0';
    return source_library(path);
}

static int open_outputs(program *p, const options *o, diag *d) {
    bool none = o->screen && strcmp(o->screen, "none") == 0;
    p->screen = none ? NULL : o->screen ? fopen(o->screen, "w") : stdout;
    if (!none && !p->screen)
        return diag_fail(d, SARCINA_USAGE, "cannot write '%s': %s", o->screen, strerror(errno));
    logfile_create(&p->log, !o->log && !o->test && !o->check, o->argc, o->argv);
    return o->log && strcmp(o->log, "none") != 0 ? open_log(p, o->log, false, d) : SARCINA_OK;
}

/* Lines that replace each other are for somebody who looks on. */
static bool has_terminal(const program *p) {
    const char *kind = getenv("TERM");
    return p->screen == stdout && isatty(STDOUT_FILENO) && isatty(STDERR_FILENO) && kind && strcmp(kind, "dumb") != 0;
}

/* Of an ensemble all that the command line names. */
static int count_runs(const options *o, size_t *runs, diag *d) {
    plan all;
    *runs = o->check;
    if (!o->check || (!o->replicates && !o->nsweeps))
        return SARCINA_OK;
    int status = plan_create(&all, o, d);
    if (status)
        return status;
    *runs = all.nruns;
    plan_free(&all);
    return SARCINA_OK;
}

int program_create(program *p, const options *o, diag *d) {
    *p = (program){0};
    gsl_set_error_handler_off();
    size_t runs;
    int status = count_runs(o, &runs, d);
    if (!status)
        status = open_outputs(p, o, d);
    p->units = status ? NULL : units_create(d);
    if (!p->units) {
        program_free(p);
        return status ? status : SARCINA_ERROR;
    }
    p->commands = commands_create(p->units);
    p->library = find_library();
    p->host = (interp_host){.commands = p->commands,
                            .forecast = runs,
                            .units = p->units,
                            .self = p,
                            .screen = print_screen,
                            .log = print_log,
                            .start_log = start_log,
                            .progress = has_terminal(p) ? show_progress : NULL,
                            .error = print_error,
                            .open_log = open_log,
                            .shell = run_shell,
                            .environment = look_up_environment,
                            .terminal = describe_terminal,
                            .date = date_of_today,
                            .edit = run_editor,
                            .interrupt = &interrupted,
                            .library = p->library,
                            .safe = o->safe,
                            .skip_runs = o->skiprun,
                            .test = o->test,
                            .results = o->results};
    return SARCINA_OK;
}

bool program_close_screen(FILE *screen) {
    bool lost = ferror(screen) != 0, pending = __fpending(screen) > 0;
    bool closed = fclose(screen) == 0 || (!pending && errno == EBADF); /* >&- is no loss to who prints nothing */
    if (closed && !lost)
        return true;
    fputs("sarcina: error: not all that was printed could be written\n", stderr);
    return false;
}

int program_free(program *p) {
    bool whole = true;
    command_table_free(p->commands);
    units_free(p->units);
    free(p->library);
    logfile_end(&p->log, 0);
    if (p->screen && p->screen != stdout)
        whole = program_close_screen(p->screen);
    *p = (program){0};
    return whole ? SARCINA_OK : SARCINA_ERROR;
}

void program_end(program *p, interp *in) {
    interp_tell_warnings(in);
    uint64_t n = interp_warnings(in);
    if (n)
        fprintf(stderr, "%" PRIu64 " %s\n", n, number_noun(n, "warning", "warnings"));
    logfile_end(&p->log, n);
}

interp *program_interp(program *p, const options *o, diag *d) {
    interp *in = interp_create(&p->host);
    int status = SARCINA_OK;
    for (size_t i = 0; i < o->nvars && !status; i++)
        status = interp_set_variable(in, o->names[i], o->texts[i], d);
    if (!status && o->echo) {
        char *command = alloc_format("echo %s", o->echo);
        status = interp_execute(in, command, d);
        free(command);
    }
    if (o->threads)
        interp_scene(in)->threads = o->threads;
    if (!status)
        return in;
    if (d)
        d->status = SARCINA_USAGE;
    interp_free(in);
    return NULL;
}

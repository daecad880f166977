/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "script/interp.h"

#include "base/alloc.h"
#include "base/hash.h"
#include "base/number.h"
#include "script/execute.h"
#include "script/names.h"
#include "script/state.h"

#include <stdarg.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

enum { WARNINGS_SHOWN = 5 }; /* of a kind */

/* Warnings of one kind have one format. */
typedef struct warning_kind {
    const char *format;
    char *first; /* its first message */
    uint64_t count;
} warning_kind;

/* ---- life ---- */

interp *interp_create(const interp_host *host) {
    interp *in = alloc_zeroed(1, sizeof *in);
    in->host = host;
    in->echo = ECHO_LOG;
    in->scene = scene_create();
    in->scene->interrupt = host->interrupt;
    if (host->commands->client_create)
        in->client = host->commands->client_create(in);
    return in;
}

void interp_free(interp *in) {
    if (!in)
        return;
    if (in->host->commands->client_free)
        in->host->commands->client_free(in->client);
    scene_free(in->scene);
    variables_free(&in->variables);
    interp_journal_clear(in);
    free(in->journal);
    for (size_t i = 0; i < in->check.ndoubtful; i++)
        free(in->check.doubtful[i]);
    free(in->check.doubtful);
    for (size_t i = 0; i < in->nsources; i++)
        source_free(in->sources[i]);
    free(in->sources);
    for (size_t i = 0; i < in->nkinds; i++)
        free(in->kinds[i].first);
    free(in->kinds);
    free(in->expanded);
    free(in->trace);
    free(in);
}

source *interp_keep_source(interp *in, source *s) {
    in->sources = alloc_grow(in->sources, &in->source_capacity, in->nsources + 1, sizeof *in->sources);
    return in->sources[in->nsources++] = s;
}

/* ---- what stands ---- */

scene *interp_scene(interp *in) {
    return in->scene;
}

void *interp_client(interp *in) {
    return in->client;
}

size_t interp_forecast_runs(const interp *in) {
    return in->host->forecast;
}

double interp_check_passes(const interp *in) {
    return in->check.passes;
}

bool interp_checking(const interp *in) {
    return in->check.on;
}

void interp_set_units(interp *in, unit_system u) {
    in->units = u;
}

double interp_unit(const interp *in, dim d) {
    return in->units == UNITS_SI ? 1 : dim_from_engine(1, d);
}

units *interp_units(const interp *in) {
    return in->host->units;
}

void interp_restart_random(interp *in) {
    in->draws = 0;
}

void interp_open_world(interp *in) {
    in->check.open_world = true;
}

bool interp_has_open_world(const interp *in) {
    return in->check.open_world;
}

bool interp_in_loop(const interp *in) {
    for (int i = 0; i < in->depth; i++)
        if (strcmp(in->stack[i].kind, "for") == 0 || strcmp(in->stack[i].kind, "while") == 0 ||
            strcmp(in->stack[i].kind, "repeat") == 0)
            return true;
    return false;
}

const char *interp_here(const interp *in) {
    for (int i = in->depth - 1; i >= 0; i--)
        if (in->stack[i].running)
            return in->stack[i].running->folder;
    return "";
}

void interp_set_warn(interp *in, warn_mode mode) {
    in->warn = mode;
}

echo_mode interp_set_echo(interp *in, echo_mode mode) {
    echo_mode before = in->echo;
    in->echo = mode;
    return before;
}

void interp_quit(interp *in, int code) {
    in->quit = true;
    in->quit_code = code;
}

bool interp_has_quit(const interp *in, int *code) {
    *code = in->quit_code;
    return in->quit;
}

void interp_expects(const interp *in, uint64_t *passed, uint64_t *failed) {
    *passed = in->expects_passed;
    *failed = in->expects_failed;
}

uint64_t interp_warnings(const interp *in) {
    return in->warnings;
}

/* ---- printing ---- */

/* One line to the screen, the log or both. */
static void print_line(interp *in, bool screen, bool log, const char *format, va_list list) {
    char *text = NULL;
    if (in->check.on || in->replaying || vasprintf(&text, format, list) < 0)
        return;
    char *line = alloc_format("%s\n", text);
    if (screen && in->host->screen)
        in->host->screen(in->host->self, line);
    if (log && in->host->log)
        in->host->log(in->host->self, line);
    free(line);
    free(text);
}

void interp_print(interp *in, const char *format, ...) {
    va_list list;
    va_start(list, format);
    print_line(in, true, true, format, list);
    va_end(list);
}

void interp_screen(interp *in, const char *format, ...) {
    va_list list;
    va_start(list, format);
    print_line(in, true, false, format, list);
    va_end(list);
}

void interp_log(interp *in, const char *format, ...) {
    va_list list;
    va_start(list, format);
    print_line(in, false, true, format, list);
    va_end(list);
}

bool interp_start_log(interp *in) {
    return !in->check.on && in->host->log && (!in->host->start_log || in->host->start_log(in->host->self));
}

bool interp_has_progress(const interp *in) {
    return in->host->progress && !in->check.on;
}

void interp_progress(interp *in, const char *line) {
    if (interp_has_progress(in))
        in->host->progress(in->host->self, line);
}

static void tell_host(interp *in, const char *warning) {
    void (*tell)(void *, const char *) = in->host->warning ? in->host->warning : in->host->error;
    if (tell)
        tell(in->host->self, warning);
}

static void tell_warning(interp *in, const char *message) {
    const source *s = in->at.source;
    char *line = s && *s->name ? alloc_format("%s:%u: warning: %s\n", s->name, in->at.line, message)
                               : alloc_format("warning: %s\n", message);
    tell_host(in, line);
    free(line);
}

/* Counts a warning among those of its kind; returns how many there have been. */
static uint64_t count_warning(interp *in, const char *format, const char *message) {
    for (size_t i = 0; i < in->nkinds; i++)
        if (in->kinds[i].format == format)
            return ++in->kinds[i].count;
    in->kinds = alloc_grow(in->kinds, &in->kind_capacity, in->nkinds + 1, sizeof *in->kinds);
    in->kinds[in->nkinds++] = (warning_kind){format, alloc_copy(message), 1};
    return 1;
}

void interp_warn(interp *in, const char *format, ...) {
    if (in->warn == WARN_OFF || in->replaying) /* what is replayed has been warned of */
        return;
    char message[512];
    va_list list;
    va_start(list, format);
    vsnprintf(message, sizeof message, format, list);
    va_end(list);
    in->warnings++;
    if (in->warn == WARN_ERROR && !*in->warned)
        snprintf(in->warned, sizeof in->warned, "%.250s", message);
    else if (in->warn == WARN_ON && count_warning(in, format, message) <= WARNINGS_SHOWN)
        tell_warning(in, message);
}

void interp_tell_warnings(interp *in) {
    for (size_t i = 0; i < in->nkinds; i++) {
        warning_kind *k = &in->kinds[i];
        uint64_t more = k->count > WARNINGS_SHOWN ? k->count - WARNINGS_SHOWN : 0;
        char *line = alloc_format("%llu more %s of this kind: %s\n", (unsigned long long)more,
                                  number_noun(more, "warning", "warnings"), k->first);
        if (more)
            tell_host(in, line);
        free(line);
        free(k->first);
    }
    in->nkinds = 0;
}

/* ---- host services ---- */

int interp_open_log(interp *in, const char *path, bool append, diag *d) {
    return in->host->open_log ? in->host->open_log(in->host->self, path, append, d) : SARCINA_OK;
}

int interp_shell(interp *in, const char *command, diag *d) {
    return in->host->shell ? in->host->shell(in->host->self, command, d) : diag_error(d, "there is no shell here");
}

const char *interp_environment(interp *in, const char *name) {
    return in->host->environment ? in->host->environment(in->host->self, name) : NULL;
}

/* ---- variables ---- */

int interp_set_variable(interp *in, const char *name, const char *text, diag *d) {
    if (names_check_new(in, NULL, name, d) != SARCINA_OK)
        return SARCINA_ERROR;
    variables_set_text(&in->variables, name, text);
    variables_find(&in->variables, name)->command_line = true;
    return SARCINA_OK;
}

const char *interp_formula(const interp *in, size_t i) {
    for (size_t k = 0; k < in->variables.count; k++)
        if (in->variables.list[k].kind == VARIABLE_FORMULA && i-- == 0)
            return in->variables.list[k].name;
    return NULL;
}

bool interp_results(const interp *in) {
    return in->host->results && !in->check.on;
}

/* ---- running ---- */

/* Tells the host about a failure that nothing above will handle. */
int interp_tell(interp *in, const diag *d) {
    if (d->status && in->host->error) {
        char *text = interp_explain(in, d);
        in->host->error(in->host->self, text);
        free(text);
    }
    return (int)d->status;
}

int interp_execute(interp *in, const char *text, diag *d) {
    return execute_source(in, interp_keep_source(in, source_of_text("", text)), "text", d);
}

int interp_run_file(interp *in, const char *path) {
    diag d = {0};
    source *s = source_read(path, &d);
    if (s && execute_source(in, interp_keep_source(in, s), "script", &d) == SARCINA_OK)
        return SARCINA_OK;
    return interp_tell(in, &d);
}

int interp_run_source(interp *in, const char *name, const char *text) {
    diag d = {0};
    int status = execute_source(in, interp_keep_source(in, source_of_text(name, text)), "script", &d);
    return status ? interp_tell(in, &d) : SARCINA_OK;
}

/* The path of an include: beside the running script, in the working folder, in the library. */
static char *find_include(const interp *in, const char *path) {
    const char *folders[] = {interp_here(in), "", in->host->library};
    for (size_t i = 0; i < 3 && *path != '/'; i++) {
        if (!folders[i])
            continue;
        char *full = alloc_format("%s%s%s", folders[i], *folders[i] ? "/" : "", path);
        if (access(full, R_OK) == 0)
            return full;
        free(full);
    }
    return alloc_copy(path);
}

int interp_include(interp *in, const char *path, diag *d) {
    char *full = find_include(in, path);
    source *s = source_read(full, d);
    free(full);
    return s ? execute_source(in, interp_keep_source(in, s), "include", d) : SARCINA_ERROR;
}

int interp_expect(interp *in, bool holds, diag *failure) {
    if (holds) {
        in->expects_passed++;
        return SARCINA_OK;
    }
    in->expects_failed++;
    if (!in->host->test)
        return (int)failure->status;
    diag_place(failure, in->at);
    execute_note(in, NULL, failure);
    interp_tell(in, failure);
    in->noted = false;
    return SARCINA_OK;
}

/* ---- checking ---- */

/* A -var that nothing reads is a slip. */
static void check_unread(interp *shadow) {
    for (size_t i = 0; i < shadow->variables.count; i++) {
        const variable *v = &shadow->variables.list[i];
        if (!v->command_line || v->read)
            continue;
        diag d = {0};
        diag_error(&d, "-var %s: nothing in the script reads '%s'", v->name, v->name);
        execute_report(shadow, &d);
    }
}

/* Of the files' texts, in the order in which they were read. */
static uint64_t hash_sources(const interp *in) {
    uint64_t h = HASH_BEGIN;
    for (size_t i = 0; i < in->nsources; i++)
        if (*in->sources[i]->name)
            h = hash_bytes(h, in->sources[i]->text, in->sources[i]->length);
    return h;
}

uint64_t interp_fingerprint(const interp *in) {
    return in->fingerprint;
}

static void check_source(interp *shadow, const interp_script *script) {
    diag d = {0};
    source *s = script->name ? source_of_text(script->name, script->text) : source_read(script->text, &d);
    if (!s || execute_source(shadow, interp_keep_source(shadow, s), "script", &d) != SARCINA_OK)
        execute_report(shadow, &d);
}

size_t interp_check(interp *in, const interp_script *list, size_t n, bool whole) {
    interp *shadow = interp_create(in->host);
    shadow->check.on = true;
    shadow->check.passes = 1;
    shadow->units = in->units;
    variables_copy(&shadow->variables, &in->variables);
    for (size_t i = 0; i < n; i++)
        check_source(shadow, &list[i]);
    if (whole)
        check_unread(shadow);
    size_t errors = shadow->check.errors;
    if (!errors && in->host->forecast && in->host->commands->client_checked) {
        shadow->check.on = false; /* what it says is to be seen */
        in->host->commands->client_checked(shadow);
    }
    in->fingerprint = hash_sources(shadow);
    interp_free(shadow);
    return errors;
}

size_t interp_check_file(interp *in, const char *path) {
    return interp_check(in, &(interp_script){NULL, path}, 1, true);
}

size_t interp_check_text(interp *in, const char *name, const char *text) {
    return interp_check(in, &(interp_script){name, text}, 1, true);
}

/* ---- the journal ---- */

size_t interp_journal_count(const interp *in) {
    return in->njournal;
}

const char *interp_journal(const interp *in, size_t i) {
    return in->journal[i];
}

void interp_journal_add(interp *in, const char *text) {
    if (in->check.on)
        return;
    in->journal = alloc_grow(in->journal, &in->journal_capacity, in->njournal + 1, sizeof *in->journal);
    in->journal[in->njournal++] = alloc_copy(text);
}

void interp_journal_clear(interp *in) {
    for (size_t i = 0; i < in->njournal; i++)
        free(in->journal[i]);
    in->njournal = 0;
}

int interp_journal_replay(interp *in, const char *const *texts, size_t n, diag *d) {
    echo_mode echo = in->echo;
    int status = SARCINA_OK;
    in->echo = ECHO_NONE;
    in->replaying = true;
    for (size_t i = 0; i < n && !status; i++)
        status = interp_execute(in, texts[i], d);
    in->replaying = false;
    in->echo = echo;
    return status;
}

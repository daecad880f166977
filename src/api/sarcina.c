/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The public API over the interpreter: a host that keeps texts in place of a terminal. */
#include "sarcina/sarcina.h"

#include "base/alloc.h"
#include "command/commands.h"
#include "script/interp.h"
#include "script/source.h"

#include <dlfcn.h>
#include <gsl/gsl_errno.h>
#include <signal.h>
#include <stdlib.h>
#include <string.h>

struct sarcina {
    sarcina_output out;
    interp_host host;
    units *units;
    command_table *commands;
    char *library; /* folder of what scripts include; NULL */
    interp *interp;
    char *error;                       /* of the last call */
    volatile sig_atomic_t interrupted; /* read by the scene between steps */
};

const char *sarcina_version(void) {
    return SARCINA_VERSION;
}

static void on_screen(void *self, const char *text) {
    const sarcina *s = self;
    if (s->out.screen)
        s->out.screen(s->out.self, text);
}

static void on_warning(void *self, const char *text) {
    const sarcina *s = self;
    if (s->out.warnings)
        s->out.warnings(s->out.self, text);
}

static void on_error(void *self, const char *text) {
    sarcina *s = self;
    char *longer = alloc_format("%s%s", s->error, text);
    free(s->error);
    s->error = longer;
}

/* What a failed call leaves: its error as text. */
static int tell(sarcina *s, const diag *d) {
    char *text = interp_explain(s->interp, d);
    on_error(s, text);
    free(text);
    return (int)d->status;
}

/* Every call that may fail begins here. */
static void begin(sarcina *s) {
    free(s->error);
    s->error = alloc_copy("");
    s->interrupted = 0;
}

/* From where this library, or the program it is linked into, lies. */
static char *find_library(void) {
    static const char here = 0;
    Dl_info file;
    char *path = dladdr(&here, &file) && file.dli_fname ? realpath(file.dli_fname, NULL) : NULL;
    char *library = path ? source_library(path) : NULL;
    free(path);
    return library;
}

sarcina *sarcina_create(const sarcina_output *out) {
    gsl_set_error_handler_off();
    units *known = units_create(NULL);
    if (!known)
        return NULL;
    sarcina *s = alloc_zeroed(1, sizeof *s);
    if (out)
        s->out = *out;
    s->units = known;
    s->commands = commands_create(known);
    s->library = find_library();
    s->host = (interp_host){.commands = s->commands,
                            .units = known,
                            .self = s,
                            .screen = on_screen,
                            .error = on_error,
                            .warning = on_warning,
                            .interrupt = &s->interrupted,
                            .library = s->library};
    s->interp = interp_create(&s->host);
    begin(s);
    return s;
}

void sarcina_free(sarcina *s) {
    if (!s)
        return;
    interp_free(s->interp);
    command_table_free(s->commands);
    units_free(s->units);
    free(s->library);
    free(s->error);
    free(s);
}

int sarcina_set_variable(sarcina *s, const char *name, const char *text) {
    diag d = {0};
    begin(s);
    return interp_set_variable(s->interp, name, text, &d) ? tell(s, &d) : SARCINA_OK;
}

int sarcina_check_file(sarcina *s, const char *path) {
    begin(s);
    return interp_check_file(s->interp, path) ? SARCINA_ERROR : SARCINA_OK;
}

int sarcina_run_file(sarcina *s, const char *path) {
    begin(s);
    return interp_run_file(s->interp, path);
}

int sarcina_run(sarcina *s, const char *text) {
    begin(s);
    return interp_run_source(s->interp, "text", text);
}

const char *sarcina_error(const sarcina *s) {
    return s->error;
}

int sarcina_value(sarcina *s, const char *expression, double *value) {
    begin(s);
    return interp_run_expression(s->interp, "text", expression, false, value);
}

size_t sarcina_cells(const sarcina *s) {
    return interp_scene(s->interp)->colony->cell.count;
}

int sarcina_cell_values(sarcina *s, const char *expression, double *values) {
    size_t n = sarcina_cells(s);
    begin(s);
    double *by_row = alloc_zeroed(n, sizeof *by_row);
    int status = interp_run_expression(s->interp, "text", expression, true, by_row);
    const uint32_t *rows = colony_by_id(interp_scene(s->interp)->colony);
    for (size_t i = 0; i < n && !status; i++)
        values[i] = by_row[rows[i]];
    free(by_row);
    return status;
}

void sarcina_interrupt(sarcina *s) {
    s->interrupted = 1;
}

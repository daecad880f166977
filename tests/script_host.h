/* SPDX-License-Identifier: GPL-3.0-or-later */
/* An interpreter for tests: what it prints and the errors it tells are kept as text. */
#ifndef SARCINA_TESTS_SCRIPT_HOST_H
#define SARCINA_TESTS_SCRIPT_HOST_H

#include "base/alloc.h"
#include "command/commands.h"
#include "script/interp.h"

#include <gsl/gsl_errno.h>
#include <stdlib.h>
#include <string.h>

typedef struct script_host {
    interp_host host;
    units *units;
    command_table *commands;
    char *printed, *errors;
    const char *environment; /* value of every variable; NULL: not set */
} script_host;

static inline void script_host_append(char **to, const char *text) {
    char *longer = alloc_format("%s%s", *to, text);
    free(*to);
    *to = longer;
}

static inline void script_host_print(void *self, const char *text) {
    script_host_append(&((script_host *)self)->printed, text);
}

static inline void script_host_error(void *self, const char *text) {
    script_host_append(&((script_host *)self)->errors, text);
}

static inline const char *script_host_environment(void *self, const char *name) {
    (void)name;
    return ((script_host *)self)->environment;
}

/* An editor that leaves the text as it is. */
static inline int script_host_edit(void *self, char **text, diag *d) {
    (void)self, (void)text, (void)d;
    return SARCINA_OK;
}

static inline void script_host_clear(script_host *h) {
    free(h->printed);
    free(h->errors);
    h->printed = alloc_copy("");
    h->errors = alloc_copy("");
}

static inline void script_host_open(script_host *h) {
    *h = (script_host){0};
    gsl_set_error_handler_off();
    h->units = units_create(NULL);
    h->commands = commands_create(h->units);
    h->environment = "somewhere";
    h->host = (interp_host){.commands = h->commands,
                            .units = h->units,
                            .self = h,
                            .screen = script_host_print,
                            .error = script_host_error,
                            .environment = script_host_environment,
                            .edit = script_host_edit};
    script_host_clear(h);
}

static inline void script_host_close(script_host *h) {
    command_table_free(h->commands);
    units_free(h->units);
    free(h->printed);
    free(h->errors);
}

/* The same as cmocka's set-up and tear-down of a group whose tests share one host, a global of theirs. */
#define SCRIPT_HOST_OF_GROUP(host)                                                                                     \
    static int open_host(void **state) {                                                                               \
        (void)state;                                                                                                   \
        script_host_open(&(host));                                                                                     \
        return 0;                                                                                                      \
    }                                                                                                                  \
    static int close_host(void **state) {                                                                              \
        (void)state;                                                                                                   \
        script_host_close(&(host));                                                                                    \
        return 0;                                                                                                      \
    }

#endif

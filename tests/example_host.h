/* SPDX-License-Identifier: GPL-3.0-or-later */
/* A place to run examples in: a scratch folder with the files of the prelude, and scenes after the prelude. */
#ifndef SARCINA_TESTS_EXAMPLE_HOST_H
#define SARCINA_TESTS_EXAMPLE_HOST_H

#include "script_host.h"

#include "script/block.h"
#include "script/signature.h"

#include <stdio.h>
#include <unistd.h>

static inline int example_host_shell(void *self, const char *command, diag *d) {
    (void)self;
    return system(command) == 0 ? SARCINA_OK : diag_error(d, "the shell says no");
}

static inline int example_host_open(script_host *h) {
    char folder[] = "/tmp/sarcina-examples-XXXXXX";
    script_host_open(h);
    h->host.shell = example_host_shell;
    return mkdtemp(folder) && chdir(folder) == 0 ? 0 : -1;
}

static inline int example_host_close(script_host *h) {
    script_host_close(h);
    return system("rm -rf \"$PWD\"") == 0 ? 0 : -1;
}

/* The files of the prelude, and no others. */
static inline void example_host_files(script_host *h) {
    const command_table *t = h->commands;
    int gone = system("rm -rf ./*");
    for (size_t i = 0; gone == 0 && i < t->nfiles; i++) {
        FILE *f = fopen(t->files[i].name, "w");
        if (!f)
            return;
        fputs(t->files[i].text, f);
        fclose(f);
    }
}

/* Runs commands and blocks one after the other, as typed at the prompt. Returns the first status that is not 0; there
 * it stops, unless it is to go on, as people do. */
static inline int example_host_type(interp *in, const char *script, bool go_on) {
    char *text = alloc_copy("");
    int status = SARCINA_OK;
    while (*script && (go_on || !status)) {
        size_t n = strcspn(script, "\n");
        char *longer = alloc_format("%s%.*s\n", text, (int)n, script);
        free(text);
        text = longer;
        script += n + (script[n] == '\n');
        if (block_is_open(text) && *script)
            continue;
        text[strlen(text) - 1] = '\0';
        int line = interp_run_line(in, text);
        status = status ? status : line;
        *text = '\0';
    }
    free(text);
    return status;
}

/* A scene after the prelude, NULL if that fails; nothing of it is left in what the host keeps of prints and errors. */
static inline interp *example_host_scene(script_host *h) {
    example_host_files(h);
    interp *in = interp_create(&h->host);
    int status = example_host_type(in, h->commands->prelude, false);
    script_host_clear(h);
    if (status == SARCINA_OK)
        return in;
    interp_free(in);
    return NULL;
}

#endif

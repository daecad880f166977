/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The program: sarcina [OPTION...] [FILE]. */
#include "app/ensemble.h"
#include "app/options.h"
#include "app/program.h"
#include "app/records.h"
#include "app/repl.h"
#include "app/test_run.h"
#include "base/alloc.h"
#include "command/commands.h"
#include "command/results.h"
#include "script/interp.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

/* All of standard input; the caller frees. */
static char *read_standard_input(void) {
    char *text = NULL;
    size_t n = 0, capacity = 0, got;
    do {
        text = alloc_grow(text, &capacity, n + 65537, 1);
        got = fread(text + n, 1, 65536, stdin);
        n += got;
    } while (got);
    text[n] = '\0';
    return text;
}

/* A script by whichever way it came: name NULL: a file called text. */
static size_t check(interp *in, const char *name, const char *text) {
    return name ? interp_check_text(in, name, text) : interp_check_file(in, text);
}

static int run(interp *in, const options *o, const char *name, const char *text) {
    size_t errors = check(in, name, text);
    if (o->check)
        printf("%zu error%s\n", errors, errors == 1 ? "" : "s");
    if (errors || o->check)
        return errors ? SARCINA_ERROR : SARCINA_OK;
    return name ? interp_run_source(in, name, text) : interp_run_file(in, text);
}

static int run_commands(interp *in, const options *o) {
    int status = SARCINA_OK, code;
    for (size_t i = 0; i < o->ncommands && !status && !interp_has_quit(in, &code); i++)
        status = run(in, o, "-e", o->commands[i]);
    return status;
}

static int run_pipe(interp *in, const options *o) {
    char *text = read_standard_input();
    int status = run(in, o, "<stdin>", text);
    free(text);
    return status;
}

static int leave_scalars(interp *in) {
    diag d = {0};
    int status = results_scalars(in, &d);
    if (status)
        program_complain(&d);
    return status;
}

static int run_all(program *p, interp *in, const options *o) {
    bool nothing = !o->file && !o->ncommands, terminal = isatty(STDIN_FILENO);
    int status = SARCINA_OK, code = 0;
    if (o->file)
        status = run(in, o, NULL, o->file);
    if (!status)
        status = run_commands(in, o);
    if (!status)
        status = leave_scalars(in);
    if (nothing && !terminal && !o->interactive)
        status = run_pipe(in, o);
    if ((nothing && terminal) || o->interactive)
        status = repl_run(p, o, in);
    return interp_has_quit(in, &code) && !status ? code : status;
}

/* -help-json: needs the tables, but no scene. */
static int print_records(void) {
    diag d = {0};
    units *u = units_create(&d);
    if (!u) {
        program_complain(&d);
        return SARCINA_ERROR;
    }
    command_table *t = command_table_create(u);
    commands_add(t);
    char *text = records_json(t);
    fputs(text, stdout);
    free(text);
    command_table_free(t);
    units_free(u);
    return SARCINA_OK;
}

static void print_help(void) {
    char *text = options_help();
    fputs(text, stdout);
    free(text);
}

static int run_program(const options *o) {
    program p;
    diag d = {0};
    int status = program_create(&p, o, &d);
    if (status) {
        program_complain(&d);
        return status;
    }
    program_catch_interrupts(&p);
    if (o->test) {
        status = test_run_all(&p, o);
    } else if ((o->replicates || o->nsweeps) && !o->check) {
        status = ensemble_main(&p, o);
    } else {
        interp *in = program_interp(&p, o, &d);
        status = in ? run_all(&p, in, o) : (int)d.status;
        if (in)
            program_end(&p, in);
        else
            program_complain(&d);
        interp_free(in);
    }
    program_free(&p);
    return status;
}

int main(int argc, char **argv) {
    options o;
    diag d = {0};
    int status = options_read(&o, argc, argv, &d);
    if (status) {
        program_complain(&d);
        fputs("'sarcina -help' lists the options\n", stderr);
    } else if (o.version) {
        printf("sarcina %s\n", SARCINA_VERSION);
    } else if (o.help) {
        print_help();
    } else if (o.json) {
        status = print_records();
    } else {
        status = run_program(&o);
    }
    options_free(&o);
    return status;
}

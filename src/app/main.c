/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The program: sarcina [OPTION...] [FILE]. */
#include "app/ensemble.h"
#include "app/options.h"
#include "app/program.h"
#include "app/records.h"
#include "app/repl.h"
#include "app/test_run.h"
#include "app/version.h"
#include "base/alloc.h"
#include "base/number.h"
#include "base/path.h"
#include "command/commands.h"
#include "command/past.h"
#include "command/results.h"
#include "script/interp.h"

#include <gsl/gsl_version.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

/* All of standard input, which the caller frees; NULL: interrupted, and half a script is none. */
static char *read_pipe(void) {
    program_end_reads(true);
    char *text = path_read_all(stdin, NULL);
    program_end_reads(false);
    if (!program_is_interrupted())
        return text;
    free(text);
    return NULL;
}

/* The file, then the commands of -e; without either what comes through the pipe. *n of them; the caller frees. */
static interp_script *list_scripts(const options *o, const char *piped, size_t *n) {
    interp_script *list = alloc_zeroed(o->ncommands + 2, sizeof *list);
    *n = 0;
    if (o->file)
        list[(*n)++] = (interp_script){NULL, o->file};
    for (size_t i = 0; i < o->ncommands; i++)
        list[(*n)++] = (interp_script){"-e", o->commands[i]};
    if (piped)
        list[(*n)++] = (interp_script){"<stdin>", piped};
    return list;
}

/* Runs one, noted for a prompt behind it. */
static int run(interp *in, const options *o, const interp_script *s) {
    int status = s->name ? interp_run_source(in, s->name, s->text) : interp_run_file(in, s->text);
    if (repl_is_wanted(o) && s->name)
        past_given(in, s->text, status);
    else if (repl_is_wanted(o))
        past_given_file(in, s->text, status);
    return status;
}

/* Nothing runs before all of it has been checked. */
static int run_scripts(interp *in, const options *o, const char *piped) {
    size_t n;
    interp_script *list = list_scripts(o, piped, &n);
    size_t errors = n ? interp_check(in, list, n, !repl_is_wanted(o)) : 0;
    int status = errors ? SARCINA_ERROR : SARCINA_OK, code;
    if (o->check && n)
        printf("%zu %s\n", errors, number_noun(errors, "error", "errors"));
    for (size_t i = 0; i < n && !o->check && !status && !interp_has_quit(in, &code); i++)
        status = run(in, o, &list[i]);
    free(list);
    return status;
}

static int leave_scalars(interp *in) {
    diag d = {0};
    int status = results_scalars(in, &d);
    if (status)
        program_complain(&d);
    return status;
}

static void begin_past(interp *in, const options *o) {
    past_begin(in);
    for (size_t i = 0; i < o->nvars; i++)
        past_given_variable(in, o->names[i], o->texts[i]);
}

static int run_all(interp *in, const options *o) {
    int code = 0;
    bool pipe = !o->file && !o->ncommands && !repl_is_wanted(o);
    if (repl_is_wanted(o))
        begin_past(in, o);
    char *piped = pipe ? read_pipe() : NULL;
    int status = pipe && !piped ? SARCINA_INTERRUPTED : run_scripts(in, o, piped);
    free(piped);
    if (!status)
        status = leave_scalars(in);
    if (repl_is_wanted(o))
        status = repl_run(o, in);
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
    command_table *t = commands_create(u);
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
    program_catch_interrupts(repl_is_wanted(o));
    if (o->test) {
        status = test_run_all(&p, o);
    } else if ((o->replicates || o->nsweeps) && !o->check) {
        status = ensemble_main(&p, o);
    } else {
        interp *in = program_interp(&p, o, &d);
        status = in ? run_all(in, o) : (int)d.status;
        if (in)
            program_end(&p, in);
        else
            program_complain(&d);
        interp_free(in);
    }
    int closed = program_free(&p);
    return status ? status : closed;
}

/* Whoever reports a fault or checks a result needs all of it. */
static void print_version(void) {
    char *version = version_text();
    printf("sarcina %s\nbuilt by gcc %s with GSL %s, %s pictures, %s MPI\n", version, __VERSION__, gsl_version,
           SARCINA_HAVE_IMAGE ? "with" : "without", SARCINA_HAVE_MPI ? "with" : "without");
    free(version);
}

int main(int argc, char **argv) {
    options o;
    diag d = {0};
    int status = options_read(&o, argc, argv, &d);
    if (status) {
        program_complain(&d);
        fputs("'sarcina -help' lists the options\n", stderr);
    } else if (o.version) {
        print_version();
    } else if (o.help) {
        print_help();
    } else if (o.json) {
        status = print_records();
    } else {
        status = run_program(&o);
    }
    options_free(&o);
    bool whole = program_close_screen(stdout);
    return whole || status ? status : SARCINA_ERROR;
}

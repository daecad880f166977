/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "app/options.h"

#include "base/alloc.h"
#include "base/number.h"
#include "base/table.h"
#include "script/page.h"

#include <stdlib.h>
#include <string.h>

typedef struct option {
    const char *name;
    int words; /* that follow it */
    int (*take)(options *o, char **words, diag *d);
    const char *takes, *summary; /* as in options.h */
} option;

static int take_in(options *o, char **words, diag *d) {
    if (o->file)
        return diag_fail(d, SARCINA_USAGE, "two scripts: '%s' and '%s'", o->file, words[0]);
    o->file = words[0];
    return SARCINA_OK;
}

static int take_var(options *o, char **words, diag *d) {
    (void)d;
    o->names = alloc_resize(o->names, o->nvars + 1, sizeof *o->names);
    o->texts = alloc_resize(o->texts, o->nvars + 1, sizeof *o->texts);
    o->names[o->nvars] = words[0];
    o->texts[o->nvars++] = words[1];
    return SARCINA_OK;
}

static int take_command(options *o, char **words, diag *d) {
    (void)d;
    o->commands = alloc_resize(o->commands, o->ncommands + 1, sizeof *o->commands);
    o->commands[o->ncommands++] = words[0];
    return SARCINA_OK;
}

#define WORD(id)                                                                                                       \
    static int take_##id(options *o, char **words, diag *d) {                                                          \
        (void)d;                                                                                                       \
        o->id = words[0];                                                                                              \
        return SARCINA_OK;                                                                                             \
    }
WORD(log)
WORD(screen)
WORD(echo)
WORD(replicates)

static int read_count(const char *name, const char *word, int *out, diag *d) {
    char *end;
    long n = strtol(word, &end, 10);
    if (*end || n < 1 || n > 1024)
        return diag_fail(d, SARCINA_USAGE, "-%s takes a number from 1 to 1024, not '%s'", name, word);
    *out = (int)n;
    return SARCINA_OK;
}

static int take_threads(options *o, char **words, diag *d) {
    return read_count("threads", words[0], &o->threads, d);
}

static int take_workers(options *o, char **words, diag *d) {
    return read_count("workers", words[0], &o->workers, d);
}

static int take_sweep(options *o, char **words, diag *d) {
    (void)d;
    o->sweeps = alloc_resize(o->sweeps, o->nsweeps + 1, sizeof *o->sweeps);
    o->sweeps[o->nsweeps++] = (option_pair){words[0], words[1]};
    return SARCINA_OK;
}

#define SWITCH(id)                                                                                                     \
    static int take_##id(options *o, char **words, diag *d) {                                                          \
        (void)words, (void)d;                                                                                          \
        o->id = true;                                                                                                  \
        return SARCINA_OK;                                                                                             \
    }
SWITCH(check)
SWITCH(test)
SWITCH(interactive)
SWITCH(noinit)
SWITCH(skiprun)
SWITCH(safe)
SWITCH(version)
SWITCH(help)
SWITCH(results)
SWITCH(json)

static const option table[] = {
    {"in", 1, take_in, "FILE",
     "run this script; FILE alone is the same. Without one: a prompt, or the commands that come through a pipe"},
    {"var", 2, take_var, "NAME TEXT", "set a variable before the script, whose own 'variable NAME default' yields"},
    {"e", 1, take_command, "COMMAND", "run this command, after FILE when there is one"},
    {"i", 0, take_interactive, "", "stay at the prompt afterwards"},
    {"noinit", 0, take_noinit, "", "at a prompt, do not read $XDG_CONFIG_HOME/sarcina/init.in (~/.config without it)"},
    {"check", 0, take_check, "",
     "read and check the whole script, report every error and what it will take, run nothing"},
    {"skiprun", 0, take_skiprun, "",
     "grow and relax nothing: everything else of the script runs, to find its mistakes"},
    {"test", 0, take_test, "PATH...", "run the scripts *.test.in of these files and folders; print N passed, N failed"},
    {"log", 1, take_log, "FILE|none",
     "write the log to FILE or nowhere; otherwise, once cells move, to log.sarcina (an earlier one becomes "
     "log.sarcina.1, .2 ...)"},
    {"screen", 1, take_screen, "FILE|none", "print to this file, or nowhere"},
    {"echo", 1, take_echo, "none|screen|log|both", "where commands are shown as they run"},
    {"threads", 1, take_threads, "N", "processor cores to compute on; the results are the same for any number"},
    {"replicates", 1, take_replicates, "N|A..B",
     "run FILE with the variable seed = 1 to N, each in a folder below NAME.runs, and merge their tables: "
     "NAME.ensemble.csv, NAME.scalars.csv, NAME.summary.csv"},
    {"sweep", 2, take_sweep, "NAME A,B,...",
     "run FILE with each of these texts of a variable; crosses with -replicates and other -sweep"},
    {"workers", 1, take_workers, "N", "runs of an ensemble at a time; else as many as cores, or the ranks of mpirun"},
    {"results", 0, take_results, "", "leave results.csv and scalars.csv, as each run of an ensemble does"},
    {"safe", 0, take_safe, "", "refuse commands that reach outside, such as shell; read no init.in"},
    {"version", 0, take_version, "", "print the version"},
    {"help", 0, take_help, "", "print this; 'sarcina -e help' lists the commands"},
    {"help-json", 0, take_json, "", "print the records of all commands, values, functions and options as JSON"},
    {"h", 0, take_help, NULL, "help"},
    {"v", 2, take_var, NULL, "var"},
};

const option_text *options_list(size_t i, option_text *out) {
    if (i >= TABLE_COUNT(table))
        return NULL;
    *out = (option_text){table[i].name, table[i].takes, table[i].summary};
    return out;
}

char *options_help(void) {
    page p = {0};
    option_text o;
    page_put(&p, "usage: sarcina [OPTION...] [FILE]\n");
    for (size_t i = 0; options_list(i, &o); i++) {
        if (!o.takes)
            continue;
        size_t from = p.n;
        page_put(&p, "  -%s%s%s", o.name, *o.takes ? " " : "", o.takes);
        page_put(&p, "%*s", p.n - from < 26 ? (int)(26 - (p.n - from)) : 1, "");
        page_wrap(&p, 26, 110, o.summary);
    }
    page_put(
        &p, "--NAME is the same as -NAME; -h is -help, -v is -var. Exit codes: 0 done, 1 error in the script, 2 wrong\n"
            "command line, 3 numerical failure, 4 failed expect, 130 interrupted,\n143 ended by SIGTERM.\n");
    return p.chars;
}

static int take_word(options *o, char *text, diag *d) {
    if (!o->test)
        return take_in(o, &text, d);
    o->tests = alloc_resize(o->tests, o->ntests + 1, sizeof *o->tests);
    o->tests[o->ntests++] = text;
    return SARCINA_OK;
}

static int take_option(options *o, const char *name, char **words, int left, int *used, diag *d) {
    ptrdiff_t row = table_find(table, TABLE_COUNT(table), sizeof *table, name);
    if (row < 0) {
        const char *near = table_nearest(table, TABLE_COUNT(table), sizeof *table, name);
        diag_fail(d, SARCINA_USAGE, "unknown option '-%s'", name);
        return near ? diag_help(d, "did you mean '-%s'?", near) : SARCINA_USAGE;
    }
    if (left < table[row].words)
        return diag_fail(d, SARCINA_USAGE, "-%s needs %d %s behind it", name, table[row].words,
                         number_noun((uint64_t)table[row].words, "word", "words"));
    *used = table[row].words;
    return table[row].take(o, words, d);
}

int options_read(options *o, int argc, char **argv, diag *d) {
    *o = (options){.argc = argc, .argv = argv};
    int status = SARCINA_OK;
    for (int i = 1; i < argc && !status; i++) {
        char *word = argv[i];
        int used = 0;
        if (word[0] != '-' || word[1] == '\0')
            status = take_word(o, word, d);
        else
            status = take_option(o, word + 1 + (word[1] == '-'), argv + i + 1, argc - i - 1, &used, d);
        i += used;
    }
    if (!status && o->test && o->ntests == 0)
        status = diag_fail(d, SARCINA_USAGE, "-test needs the files or folders to test");
    return status;
}

void options_free(options *o) {
    free(o->names);
    free(o->texts);
    free(o->commands);
    free(o->tests);
    free(o->sweeps);
}

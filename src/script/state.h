/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The interpreter's state, for the files of src/script only; interp.h is what others include. */
#ifndef SARCINA_SCRIPT_STATE_H
#define SARCINA_SCRIPT_STATE_H

#include "base/units.h"
#include "script/block.h"
#include "script/expr.h"
#include "script/interp.h"
#include "script/signature.h"
#include "script/variables.h"

/* Where the interpreter is: a loop, an include, a text run later. Shown below an error, innermost first. */
typedef struct frame {
    const char *kind; /* "include", "for", "while", "repeat", "script" */
    span at;
    char detail[80]; /* "i = 2" */
    const source *running;
} frame;

enum { FRAME_MAX = 64 };

/* What the check of a script keeps, beside its errors. */
typedef struct checking {
    bool on;
    bool open_world; /* names are unknown from here on */
    int branch;      /* > 0: in a branch that may not be taken, or may be taken beside another */
    char **doubtful; /* names whose definition failed: not reported again as missing */
    size_t ndoubtful, doubtful_capacity;
    size_t errors;
    double passes; /* how often the present command would run; 0: not at all, as far as can be known */
} checking;

typedef enum { LOOP_NONE, LOOP_BREAK, LOOP_CONTINUE } loop_request;

struct interp {
    const interp_host *host;
    scene *scene;
    void *client;
    variables variables;
    unit_system units;
    frame stack[FRAME_MAX];
    int depth;
    source **sources; /* kept to the end: spans point into them */
    size_t nsources, source_capacity;
    char **journal;
    size_t njournal, journal_capacity;
    bool replaying; /* the journal: nothing is said */
    checking check;
    uint64_t fingerprint; /* of the texts that the last check read */
    loop_request loop;
    bool quit;
    int quit_code;
    uint64_t draws; /* random() calls of the script so far */
    uint64_t epoch; /* commands executed: caches of column values compare it */
    warn_mode warn;
    uint64_t warnings;
    struct warning_kind *kinds; /* of warnings, each by its format */
    size_t nkinds, kind_capacity;
    char warned[256]; /* under warn error: the first warning of the running command */
    uint64_t expects_passed, expects_failed;
    echo_mode echo;
    /* of the last error: what the reader saw where variables had been replaced, and the stack */
    bool noted;
    char *expanded;
    char *trace;
    span at;      /* of the running command */
    bool prompt;  /* a line of the prompt is running */
    int commands; /* running inside one another */
};

/* Tells the host about a failure that nothing above will handle; returns its status. */
int interp_tell(interp *in, const diag *d);

/* Keeps a source to the end of the interpreter; returns it. */
source *interp_keep_source(interp *in, source *s);

#endif

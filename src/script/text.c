/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "script/text.h"

#include "base/alloc.h"
#include "script/execute.h"
#include "script/state.h"

#include <stdlib.h>

/* The first fault of the structure is kept, to be told when the text runs. */
struct command_text {
    int references;
    block body;
    bool faulty;
    diag fault;
};

static void keep_fault(void *self, const diag *d) {
    command_text *t = self;
    if (!t->faulty)
        t->fault = *d;
    t->faulty = true;
}

command_text *text_create(piece *text) {
    command_text *t = alloc_zeroed(1, sizeof *t);
    t->references = 1;
    block_parse(text, &t->body, keep_fault, t);
    piece_free(text);
    return t;
}

command_text *interp_keep_text(command_text *t) {
    t->references++;
    return t;
}

void interp_free_text(command_text *t) {
    if (!t || --t->references > 0)
        return;
    block_free(&t->body);
    free(t);
}

int text_check(interp *in, command_text *t, diag *d) {
    if (t->faulty) {
        *d = t->fault;
        return SARCINA_ERROR;
    }
    in->check.branch++;
    int status = execute_block(in, &t->body, d);
    in->check.branch--;
    return status;
}

int interp_run_text(interp *in, command_text *t, diag *d) {
    if (t->faulty) {
        if (d)
            *d = t->fault;
        return t->fault.status;
    }
    interp_keep_text(t); /* it may take itself away: dump off within every */
    int status = execute_block(in, &t->body, d);
    interp_free_text(t);
    return status;
}

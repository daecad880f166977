/* SPDX-License-Identifier: GPL-3.0-or-later */
/* clear: back to an empty scene. */
#include "command/commands.h"
#include "command/session.h"

static int run_clear(interp *in, const args *a, diag *d) {
    (void)a;
    (void)d;
    session_clear(in);
    return SARCINA_OK;
}

static const command_form form = {
    "clear",
    NULL,
    0,
    "Takes out the scene and its outputs",
    "Keeps variables, log, threads and warn. The clock and the seed are as at the beginning.",
    "clear",
    COMMAND_SHADOW,
    run_clear,
    NULL,
    0};

void command_clear(command_table *t) {
    command_add(t, &form, 1);
}

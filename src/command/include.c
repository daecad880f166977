/* SPDX-License-Identifier: GPL-3.0-or-later */
/* include FILE. */
#include "command/commands.h"

#include "base/table.h"

static int run_include(interp *in, const args *a, diag *d) {
    int status = interp_include(in, args_text(a, "FILE"), d);
    if (status)
        diag_place(d, args_span(a, "FILE"));
    return status;
}

static const param params[] = {{"FILE:file", "a script"}};

static const command_form forms[] = {
    {"include FILE:file", params, TABLE_COUNT(params), "Runs a script at this place",
     "Looked for beside the running script, then in the working folder. A block ends in the file that began it.",
     "include scene.in", COMMAND_SHADOW, run_include, NULL, 0},
};

void command_include(command_table *t) {
    command_add(t, forms, TABLE_COUNT(forms));
}

/* SPDX-License-Identifier: GPL-3.0-or-later */
/* undo, save, edit: commands of the prompt. */
#include "command/commands.h"
#include "command/past.h"

#include "base/alloc.h"
#include "base/number.h"
#include "base/table.h"

#include <stdlib.h>
#include <string.h>
#include <unistd.h>

static int run_undo(interp *in, const args *a, diag *d) {
    size_t n = args_given(a, "N") ? (size_t)args_int(a, "N") : 1;
    return past_undo(in, n, d);
}

static int run_save(interp *in, const args *a, diag *d) {
    const char *file = args_text(a, "FILE");
    size_t lines;
    if (access(file, F_OK) == 0 && !args_given(a, "overwrite")) {
        diag_error(d, "'%s' is there already", file);
        diag_place(d, args_span(a, "FILE"));
        return diag_help(d, "save %s overwrite", file);
    }
    int status = past_save(in, file, &lines, d);
    if (!status)
        interp_screen(in, "%s: %zu %s", file, lines, number_noun(lines, "command", "commands"));
    return status;
}

static int run_edit(interp *in, const args *a, diag *d) {
    (void)a;
    const char *last = past_last(in);
    char *text = alloc_copy(last ? last : "");
    int status = interp_edit(in, &text, d);
    if (!status && text[strspn(text, " \t\n")] == '\0')
        interp_screen(in, "nothing to run");
    else if (!status)
        past_set_next(in, text);
    free(text);
    return status;
}

static const param undo_params[] = {{"N:int[1,)?", "how many commands; 1"}};
static const param save_params[] = {{"FILE:file", "a script, .in by custom"},
                                    {"overwrite:nothing", "even if the file is there already"}};

static const command_form forms[] = {
    {"undo N:int[1,)?", undo_params, TABLE_COUNT(undo_params), "Takes back the last command",
     "The scene, groups, outputs, variables and settings are to the bit what they were before the last command that "
     "changed any of them; a block is taken back whole. Files stay as they are: tables go on behind the step that the "
     "scene has gone back to, at the next run. States of up to 256 MB are kept, the last one always. At a prompt only.",
     "grow 4min\nundo\ngrow 4min\ngrow 4min\nundo 2", COMMAND_ALONE, run_undo, NULL, 0},
    {"save FILE:file", save_params, TABLE_COUNT(save_params), "Writes the session as a script",
     "The commands that changed the scene, outputs, variables or settings, as typed and in their order, without those "
     "taken back by undo: the script leads to the same bits. First come the variables and the script that the program "
     "was started with. A run that was interrupted is written with the cycles it did; where a block was broken off, a "
     "file FILE.rst beside the script holds the state behind it. At a prompt only.",
     "save session.in\nsave session.in overwrite", COMMAND_ALONE, run_save, NULL, 0},
    {"edit", NULL, 0, "Opens the last command in an editor and runs it",
     "The editor is $VISUAL, else $EDITOR, else vi. What it leaves is run as if it had been typed; an empty file runs "
     "nothing. Refused under -safe. At a prompt only.",
     "edit", COMMAND_ALONE | COMMAND_UNSAFE, run_edit, NULL, 0},
};

void command_prompt(command_table *t) {
    command_add(t, forms, TABLE_COUNT(forms));
}

/* SPDX-License-Identifier: GPL-3.0-or-later */
/* print TEXT [file F | append F] [screen yes|no]. */
#include "command/commands.h"

#include "base/path.h"
#include "base/table.h"

#include <stdio.h>

static int write_file(const args *a, const char *key, const char *mode, const char *text, diag *d) {
    if (!args_given(a, key))
        return SARCINA_OK;
    const char *path = args_text(a, key);
    FILE *f = path_open(path, mode, d);
    if (f)
        fprintf(f, "%s\n", text);
    if (f && path_close(f, path, d) == SARCINA_OK)
        return SARCINA_OK;
    diag_place(d, args_span(a, key));
    return SARCINA_ERROR;
}

static int run_print(interp *in, const args *a, diag *d) {
    const char *text = args_text(a, "TEXT");
    text += *text == '\n'; /* text over several lines begins behind its opening quotes */
    int status = write_file(a, "file", "w", text, d);
    if (!status)
        status = write_file(a, "append", "a", text, d);
    if (status)
        return status;
    if (args_flag(a, "screen"))
        interp_print(in, "%s", text);
    else
        interp_log(in, "%s", text);
    return SARCINA_OK;
}

static const param params[] = {
    {"TEXT:text", "one word or one quoted text"},
    {"file:file", "written there too, anew"},
    {"append:file", "added to that file too"},
    {"screen=yes:flag", "no: only to the log and files"},
};

static const command_form forms[] = {
    {"print TEXT:text", params, TABLE_COUNT(params), "Prints a text",
     "$(expr:%.3f) puts in a value: print \"$(time/1h:%.2f) h\".",
     "print \"$(cells) cells at $(time/1h:%.2f) h\"\nprint \"step,cells\" file growth.csv screen no\nprint "
     "\"$(step),$(cells)\" append growth.csv screen no",
     0, run_print, NULL, 0},
};

void command_print(command_table *t) {
    command_add(t, forms, TABLE_COUNT(forms));
}

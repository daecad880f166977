/* SPDX-License-Identifier: GPL-3.0-or-later */
/* help [TOPIC ...]: made from the tables, see script/help.h. */
#include "command/commands.h"

#include "base/table.h"
#include "script/help.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

static int run_help(interp *in, const args *a, diag *d) {
    char topic[256] = "";
    size_t used = 0;
    for (size_t i = 0; i < args_count(a, "TOPIC") && used + 70 < sizeof topic; i++)
        used +=
            (size_t)snprintf(topic + used, sizeof topic - used, "%s%.60s", i ? " " : "", args_text_at(a, "TOPIC", i));
    char *text = help_text(in, topic, d);
    if (!text) {
        diag_place(d, args_span(a, "TOPIC"));
        return SARCINA_ERROR;
    }
    interp_screen(in, "%s", text);
    free(text);
    return SARCINA_OK;
}

static const param params[] = {{"TOPIC:words?", "a command and its style, a value, a function, expressions"}};

static const command_form forms[] = {
    {"help TOPIC:words?", params, TABLE_COUNT(params), "Explains a command, value or function", NULL, "help print", 0,
     run_help, NULL, 0},
};

void command_help(command_table *t) {
    command_add(t, forms, TABLE_COUNT(forms));
}

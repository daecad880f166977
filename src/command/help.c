/* SPDX-License-Identifier: GPL-3.0-or-later */
/* help [TOPIC ...] and apropos WORD: made from the tables, see script/help.h. */
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

static int run_apropos(interp *in, const args *a, diag *d) {
    char *text = help_search(in, args_text(a, "WORD"), d);
    if (!text) {
        diag_place(d, args_span(a, "WORD"));
        return SARCINA_ERROR;
    }
    interp_screen(in, "%s", text);
    free(text);
    return SARCINA_OK;
}

static const param params[] = {
    {"TOPIC:words?", "a command and its style, a value, a function, a topic such as expressions"}};

static const param search_params[] = {{"WORD:text", "a word, a part of one, or several in quotes"}};

static const command_form forms[] = {
    {"help TOPIC:words?", params, TABLE_COUNT(params), "Explains commands, values, functions and the language",
     "Without a topic it lists them all. A command of many forms is listed form by form: 'help dump image' explains "
     "one. "
     "A style or keyword alone shows the forms that have it.",
     "help\nhelp print\nhelp dump image\nhelp thickness\nhelp expressions", 0, run_help, NULL, 0},
    {"apropos WORD:text", search_params, TABLE_COUNT(search_params), "Finds what has to do with a word",
     "Searches names, summaries, details and arguments of commands, topics, values and functions.", "apropos overlap",
     0, run_apropos, NULL, 0},
};

void command_help(command_table *t) {
    command_add(t, forms, TABLE_COUNT(forms));
}

/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "app/repl.h"

#include "app/program.h"
#include "base/alloc.h"
#include "script/block.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include <readline/history.h>
#include <readline/readline.h>

/* One command or block, over as many lines as it takes; NULL at the end of the input. The caller frees. */
static char *read_command(void) {
    char *text = readline("sarcina> ");
    while (text && block_is_open(text)) {
        char *more = readline("     ...> ");
        if (!more)
            break;
        char *longer = alloc_format("%s\n%s", text, more);
        free(text);
        free(more);
        text = longer;
    }
    return text;
}

int repl_run(interp *in) {
    int code = 0;
    char *text;
    printf("sarcina %s  'help' lists commands, 'help COMMAND' explains one\n", SARCINA_VERSION);
    while (!interp_has_quit(in, &code) && (text = read_command())) {
        program_clear_interrupt();
        if (*text)
            add_history(text);
        interp_run_line(in, text);
        free(text);
    }
    return code;
}

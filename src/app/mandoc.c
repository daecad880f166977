/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Writes what is generated from the tables: the manual pages in man/, and the syntax files of editors.
 * mandoc SOURCE_FOLDER TARGET_FOLDER; scripts/manual runs it. */
#include "app/mandoc.h"

#include "command/commands.h"

#include <stdio.h>

int main(int argc, char **argv) {
    if (argc != 3) {
        fputs("usage: mandoc SOURCE_FOLDER TARGET_FOLDER\n", stderr);
        return 2;
    }
    diag d = {0};
    units *u = units_create(&d);
    if (!u) {
        fprintf(stderr, "%s\n", d.message);
        return 1;
    }
    command_table *t = commands_create(u);
    mandoc m = {.commands = t, .source = argv[1], .target = argv[2]};
    mandoc_commands(&m);
    mandoc_sources(&m);
    mandoc_editors(&m);
    mandoc_shells(&m);
    command_table_free(t);
    units_free(u);
    return m.failed;
}

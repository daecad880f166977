/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The list of command files: each adds its forms by one function, command_NAME. To add a command: its file, and one
 * name here. */
#ifndef SARCINA_COMMAND_COMMANDS_H
#define SARCINA_COMMAND_COMMANDS_H

#include "script/command.h"

#define COMMAND_FILES(X)                                                                                               \
    X(variable)                                                                                                        \
    X(print)                                                                                                           \
    X(include)                                                                                                         \
    X(expect)                                                                                                          \
    X(program)                                                                                                         \
    X(show)                                                                                                            \
    X(prompt)                                                                                                          \
    X(help)                                                                                                            \
    X(settings)                                                                                                        \
    X(dimension)                                                                                                       \
    X(accuracy)                                                                                                        \
    X(species)                                                                                                         \
    X(growth)                                                                                                          \
    X(division)                                                                                                        \
    X(force)                                                                                                           \
    X(link)                                                                                                            \
    X(link_between)                                                                                                    \
    X(region)                                                                                                          \
    X(group)                                                                                                           \
    X(create_cells)                                                                                                    \
    X(attach)                                                                                                          \
    X(delete_cells)                                                                                                    \
    X(data)                                                                                                            \
    X(set)                                                                                                             \
    X(grow)                                                                                                            \
    X(thermo)                                                                                                          \
    X(dump)                                                                                                            \
    X(analyze)                                                                                                         \
    X(plot)                                                                                                            \
    X(tradeoff)                                                                                                        \
    X(run)                                                                                                             \
    X(restart)                                                                                                         \
    X(clear)                                                                                                           \
    X(info)

/* What is said of each command as a whole, and the prelude of all examples: pages.c. */
void command_pages(command_table *t);

#define COMMAND_DECLARE(name) void command_##name(command_table *t);
COMMAND_FILES(COMMAND_DECLARE)
#undef COMMAND_DECLARE

/* The table of every command, name class and the session; command_table_free takes it, before the units. */
command_table *commands_create(units *u);

#endif

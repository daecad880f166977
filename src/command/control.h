/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The list of control commands: they belong to the language, not to the scene. Each file adds its forms by one
 * function, command_NAME. */
#ifndef SARCINA_COMMAND_CONTROL_H
#define SARCINA_COMMAND_CONTROL_H

#include "script/command.h"

#define CONTROL_FILES(X)                                                                                               \
    X(variable)                                                                                                        \
    X(print)                                                                                                           \
    X(include)                                                                                                         \
    X(expect)                                                                                                          \
    X(program)                                                                                                         \
    X(help)

#define CONTROL_DECLARE(name) void command_##name(command_table *t);
CONTROL_FILES(CONTROL_DECLARE)
#undef CONTROL_DECLARE

void control_add(command_table *t);

#endif

/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "command/control.h"

void control_add(command_table *t) {
#define CONTROL_ADD(name) command_##name(t);
    CONTROL_FILES(CONTROL_ADD)
#undef CONTROL_ADD
}

/* SPDX-License-Identifier: GPL-3.0-or-later */
/* What `info` says of the things a script declares by name: one list a topic. */
#ifndef SARCINA_COMMAND_INFO_LISTS_H
#define SARCINA_COMMAND_INFO_LISTS_H

#include "script/command.h"

/* Prints the list of a topic; false: it is none of these. */
bool info_lists_show(interp *in, const char *topic);

/* Their names, for errors: "groups, regions, ..." */
const char *info_lists_topics(void);

#endif

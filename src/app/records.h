/* SPDX-License-Identifier: GPL-3.0-or-later */
/* -help-json: the records of the program and of its command line. */
#ifndef SARCINA_APP_RECORDS_H
#define SARCINA_APP_RECORDS_H

#include "script/command.h"

/* One JSON object and a line end; the caller frees. */
char *records_json(const command_table *t);

#endif

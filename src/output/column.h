/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The column of a table or dump. It stands in the engine's layer because the script layer makes columns and the output
 * layer writes them, and these two do not know each other. */
#ifndef SARCINA_OUTPUT_COLUMN_H
#define SARCINA_OUTPUT_COLUMN_H

#include "engine/column.h"

#endif

/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Colours as scripts write them: a name, "#rrggbb" or "#rgb". */
#ifndef SARCINA_BASE_COLOR_CODE_H
#define SARCINA_BASE_COLOR_CODE_H

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

/* 0xrrggbb; false when text is no colour. */
bool color_code_read(const char *text, uint32_t *code);

/* The i-th name; NULL behind the last. */
const char *color_code_name(size_t i);

#endif

/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "base/color_code.h"

#include "base/table.h"

#include <stdio.h>
#include <string.h>

static const struct {
    const char *name;
    uint32_t code;
} names[] = {
    {"white", 0xffffff}, {"black", 0x000000},  {"gray", 0x808080},  {"grey", 0x808080},   {"silver", 0xc0c0c0},
    {"red", 0xe41a1c},   {"green", 0x4daf4a},  {"blue", 0x377eb8},  {"yellow", 0xffd92f}, {"magenta", 0xd33682},
    {"cyan", 0x17becf},  {"orange", 0xff7f00}, {"brown", 0xa65628}, {"purple", 0x984ea3}, {"pink", 0xf781bf},
    {"olive", 0x8a9a2b}, {"maroon", 0x800000}, {"navy", 0x1f3b73},  {"teal", 0x1b9e77},   {"lime", 0x7fd34e},
};

const char *color_code_name(size_t i) {
    return i < TABLE_COUNT(names) ? names[i].name : NULL;
}

bool color_code_read(const char *text, uint32_t *code) {
    ptrdiff_t row = table_find(names, TABLE_COUNT(names), sizeof names[0], text);
    if (row >= 0) {
        *code = names[row].code;
        return true;
    }
    size_t n = strlen(text);
    if (text[0] != '#' || (n != 7 && n != 4) || strspn(text + 1, "0123456789abcdefABCDEF") != n - 1)
        return false;
    unsigned read;
    sscanf(text + 1, "%x", &read);
    if (n == 4) /* each digit stands for two */
        read = 0x110000 * (read >> 8) + 0x1100 * (read >> 4 & 15) + 0x11 * (read & 15);
    *code = read;
    return true;
}

/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "model/group.h"

#include <string.h>

int group_find(const group_table *t, const char *name) {
    for (int i = 0; i < GROUP_MAX; i++)
        if (*name && strcmp(t->name[i], name) == 0)
            return i;
    return -1;
}

int group_add(group_table *t, const char *name) {
    for (int i = 0; i < GROUP_MAX; i++)
        if (!*t->name[i]) {
            strncpy(t->name[i], name, sizeof t->name[i] - 1);
            return i;
        }
    return -1;
}

void group_remove(group_table *t, int bit, colony *c) {
    memset(t->name[bit], 0, sizeof t->name[bit]);
    for (size_t i = 0; i < c->cell.count; i++)
        c->cell.groups[i] &= ~(UINT64_C(1) << bit);
}

void group_assign(int bit, colony *c, const bool *flags) {
    uint64_t mask = UINT64_C(1) << bit;
    for (size_t i = 0; i < c->cell.count; i++)
        c->cell.groups[i] = flags[i] ? c->cell.groups[i] | mask : c->cell.groups[i] & ~mask;
}

bool group_has(const colony *c, uint32_t row, int bit) {
    return c->cell.groups[row] >> bit & 1;
}

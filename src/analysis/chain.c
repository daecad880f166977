/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "analysis/chain.h"

#include "base/alloc.h"
#include "base/vec3.h"

#include <math.h>
#include <stdlib.h>

/* What a cell is linked to; of a cell with more links the first two only, but its degree says so. */
typedef struct joint {
    uint32_t degree, next[2];
} joint;

static joint *find_joints(colony *c, const bool *members) {
    joint *list = alloc_zeroed(c->cell.count, sizeof *list);
    for (uint32_t link = 0; link < c->link.count; link++) {
        if (c->link.kind[link] != LINK_FILIAL)
            continue;
        uint32_t ends[2] = {colony_row(c, c->link.cell_a[link]), colony_row(c, c->link.cell_b[link])};
        if (members && !(members[ends[0]] && members[ends[1]]))
            continue;
        for (int i = 0; i < 2; i++) {
            joint *j = &list[ends[i]];
            if (j->degree < 2)
                j->next[j->degree] = ends[1 - i];
            j->degree++;
        }
    }
    return list;
}

static vec3 centre_of(const colony *c, uint32_t row) {
    double x[3];
    colony_centre(c, row, x);
    return vec3_load(x);
}

/* Walks from an end to the other one, in the direction of the lower id; false at a branch, and from the other end. */
static bool walk(const colony *c, const joint *list, uint32_t start, uint32_t *end, double *length, size_t *cells) {
    uint32_t before = start, here = list[start].next[0];
    *length = vec3_norm(vec3_sub(centre_of(c, here), centre_of(c, before)));
    *cells = 2;
    while (list[here].degree == 2) {
        uint32_t next = list[here].next[0] == before ? list[here].next[1] : list[here].next[0];
        *length += vec3_norm(vec3_sub(centre_of(c, next), centre_of(c, here)));
        before = here;
        here = next;
        (*cells)++;
    }
    *end = here;
    return list[here].degree == 1 && c->cell.id[start] < c->cell.id[here];
}

void chain_shape(const view *v, const bool *members, double *length, double *straightness) {
    colony *c = v->colony;
    const uint32_t *order = colony_by_id(c);
    joint *list = find_joints(c, members);
    double n = 0, sum = 0, bent = 0, ratio = 0;
    for (size_t i = 0; i < c->cell.count; i++) {
        uint32_t start = order[i], end;
        double along;
        size_t cells;
        if (list[start].degree != 1 || !walk(c, list, start, &end, &along, &cells))
            continue;
        n += 1;
        sum += along;
        if (cells < 3 || !(along > 0))
            continue;
        bent += 1;
        ratio += vec3_norm(vec3_sub(centre_of(c, end), centre_of(c, start))) / along;
    }
    *length = n > 0 ? sum / n : (double)NAN;
    *straightness = bent > 0 ? ratio / bent : (double)NAN;
    free(list);
}

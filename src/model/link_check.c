/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "model/link_check.h"

#include "base/alloc.h"

#include <math.h>
#include <stdlib.h>

/* What a link joins, the lower id first; 0: the substratum. */
typedef struct joint {
    uint64_t low, high, link;
} joint;

static bool is_in(const colony *c, uint32_t row, uint32_t particle) {
    return particle - c->cell.first[row] < c->cell.nparticles[row];
}

static uint32_t smaller(uint32_t a, uint32_t b) {
    return a < b ? a : b;
}

/* Springs that a link of its kind has between two cells. */
static uint32_t wanted_springs(const colony *c, uint32_t link, uint32_t a, uint32_t b) {
    uint32_t na = c->cell.nparticles[a], nb = c->cell.nparticles[b];
    switch ((link_kind)c->link.kind[link]) {
    case LINK_FILIAL:
        return na == 1 && nb == 1 ? 1 : 2;
    case LINK_STICK:
        return smaller(na, 2) * smaller(nb, 2);
    case LINK_ANCHOR:
        return na;
    case LINK_SPRING:
        break;
    }
    return c->link.nsprings[link];
}

static const char *check_spring(const colony *c, uint32_t link, uint32_t spring, uint32_t a, uint32_t b) {
    bool anchored = c->link.cell_b[link] == 0;
    if (!is_in(c, a, c->spring.a[spring]))
        return "a spring begins at a particle that is not its first cell's";
    if (anchored != (c->spring.b[spring] == SPRING_ANCHOR))
        return "a spring ends at the substratum and its link does not, or the other way about";
    if (!anchored && !is_in(c, b, c->spring.b[spring]))
        return "a spring ends at a particle that is not its second cell's";
    if (c->link.kind[link] != LINK_SPRING && !(c->spring.k[spring] > 0 && isfinite(c->spring.k[spring])))
        return "a spring has no stiffness";
    if (c->link.kind[link] != LINK_SPRING && !(c->spring.rest[spring] > 0 && isfinite(c->spring.rest[spring])))
        return "a spring has no rest length";
    return NULL;
}

static const char *check_link(colony *c, uint32_t link, uint32_t first, uint64_t least_id) {
    uint32_t a = colony_row(c, c->link.cell_a[link]);
    uint32_t b = c->link.cell_b[link] ? colony_row(c, c->link.cell_b[link]) : a;
    if (c->link.id[link] < least_id || c->link.id[link] >= c->next_link_id)
        return "ids of links do not ascend";
    if (a == COLONY_NO_ROW || b == COLONY_NO_ROW)
        return "a cell that is not there is linked";
    if (c->link.cell_a[link] == c->link.cell_b[link])
        return "a cell is linked to itself";
    if (c->link.kind[link] != LINK_SPRING && (c->link.kind[link] == LINK_ANCHOR) != (c->link.cell_b[link] == 0))
        return "an anchoring link, and no other, ends at the substratum";
    if (c->link.first[link] != first)
        return "springs do not follow one another";
    if (c->link.nsprings[link] != wanted_springs(c, link, a, b) || first + c->link.nsprings[link] > c->spring.count)
        return "a link has not the springs of its kind";
    const char *what = NULL;
    for (uint32_t i = 0; i < c->link.nsprings[link] && !what; i++)
        what = check_spring(c, link, first + i, a, b);
    return what;
}

static int compare_joints(const void *a, const void *b) {
    const joint *p = a, *q = b;
    if (p->low != q->low)
        return p->low < q->low ? -1 : 1;
    return (p->high > q->high) - (p->high < q->high);
}

/* Two links between the same cells. */
static link_fault find_double(const colony *c) {
    joint *joints = alloc_zeroed(c->link.count, sizeof *joints);
    size_t n = 0;
    link_fault fault = {0};
    for (uint32_t link = 0; link < c->link.count; link++) {
        uint64_t a = c->link.cell_a[link], b = c->link.cell_b[link];
        if (c->link.kind[link] != LINK_SPRING)
            joints[n++] = (joint){a < b ? a : b, a < b ? b : a, c->link.id[link]};
    }
    qsort(joints, n, sizeof *joints, compare_joints);
    for (size_t i = 1; i < n && !fault.what; i++)
        if (compare_joints(&joints[i - 1], &joints[i]) == 0)
            fault = (link_fault){"two cells, or a cell and the substratum, are linked twice", joints[i].link};
    free(joints);
    return fault;
}

link_fault link_check(colony *c) {
    uint32_t first = 0;
    uint64_t least_id = 1;
    for (uint32_t link = 0; link < c->link.count; link++) {
        const char *what = check_link(c, link, first, least_id);
        if (what)
            return (link_fault){what, c->link.id[link]};
        first += c->link.nsprings[link];
        least_id = c->link.id[link] + 1;
    }
    if (first != c->spring.count)
        return (link_fault){"there are springs of no link", 0};
    return find_double(c);
}

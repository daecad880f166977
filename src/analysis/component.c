/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Union-find over cell rows, always hanging the component of higher lowest id below the other, so that the root does
 * not depend on the order of links. */
#include "analysis/component.h"

#include "analysis/chain.h"
#include "base/alloc.h"

#include <math.h>
#include <stdlib.h>

static uint32_t find(uint32_t *root, uint32_t row) {
    while (root[row] != row) {
        root[row] = root[root[row]];
        row = root[row];
    }
    return row;
}

void component_join(const colony *c, uint32_t *root, uint32_t a, uint32_t b) {
    a = find(root, a);
    b = find(root, b);
    if (c->cell.id[a] < c->cell.id[b])
        root[b] = a;
    else
        root[a] = b;
}

/* The rows a link joins, when it is of this kind and between members. */
static bool joined_rows(colony *c, uint32_t link, int kind, const bool *members, uint32_t *a, uint32_t *b) {
    if (kind != COMPONENT_ANY_LINK && c->link.kind[link] != kind)
        return false;
    *a = colony_row(c, c->link.cell_a[link]);
    *b = colony_row(c, c->link.cell_b[link]);
    if (*a == COLONY_NO_ROW || *b == COLONY_NO_ROW)
        return false;
    return !members || (members[*a] && members[*b]);
}

void component_roots(colony *c, int kind, const bool *members, uint32_t *root) {
    uint32_t a, b;
    for (uint32_t row = 0; row < c->cell.count; row++)
        root[row] = row;
    for (uint32_t link = 0; link < c->link.count; link++)
        if (joined_rows(c, link, kind, members, &a, &b))
            component_join(c, root, a, b);
    for (uint32_t row = 0; row < c->cell.count; row++)
        root[row] = find(root, row);
}

void component_sizes(const colony *c, uint32_t *root, const bool *members, uint32_t least, double out[3]) {
    uint32_t *size = alloc_zeroed(c->cell.count, sizeof *size);
    double cells = 0;
    out[0] = out[1] = 0;
    for (uint32_t row = 0; row < c->cell.count; row++)
        if (!members || members[row])
            size[find(root, row)]++;
    for (uint32_t row = 0; row < c->cell.count; row++) {
        if (size[row] < least)
            continue;
        out[0] += 1;
        cells += size[row];
        out[1] = size[row] > out[1] ? size[row] : out[1];
    }
    out[2] = out[0] > 0 ? cells / out[0] : (double)NAN;
    free(size);
}

static void measure_components(const view *v, const bool *members, int kind, uint32_t least, double *out) {
    uint32_t *root = alloc_zeroed(v->colony->cell.count, sizeof *root);
    component_roots(v->colony, kind, members, root);
    component_sizes(v->colony, root, members, least, out);
    free(root);
}

int component_clusters(const view *v, const bool *members, double *out, diag *d) {
    (void)d;
    measure_components(v, members, COMPONENT_ANY_LINK, 1, out);
    return SARCINA_OK;
}

static double count_ends(const view *v, const bool *members) {
    colony *c = v->colony;
    uint32_t *degree = alloc_zeroed(c->cell.count, sizeof *degree);
    uint32_t a, b;
    for (uint32_t link = 0; link < c->link.count; link++)
        if (joined_rows(c, link, LINK_FILIAL, members, &a, &b)) {
            degree[a]++;
            degree[b]++;
        }
    double ends = 0;
    for (uint32_t row = 0; row < c->cell.count; row++)
        ends += degree[row] == 1;
    free(degree);
    return ends;
}

int component_filaments(const view *v, const bool *members, double *out, diag *d) {
    (void)d;
    measure_components(v, members, LINK_FILIAL, 2, out);
    out[3] = count_ends(v, members);
    chain_shape(v, members, &out[4], &out[5]);
    return SARCINA_OK;
}

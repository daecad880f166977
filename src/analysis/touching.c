/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "analysis/touching.h"

#include "analysis/component.h"
#include "analysis/neighborhood.h"
#include "base/alloc.h"

#include <math.h>
#include <stdlib.h>

typedef struct count {
    double pairs;
    uint32_t *contacts; /* by cell row */
} count;

static void count_pair(void *self, uint32_t a, uint32_t b, double distance) {
    count *k = self;
    (void)distance;
    k->pairs += 1;
    k->contacts[a]++;
    k->contacts[b]++;
}

int touching_coordination(const view *v, const bool *members, double *out, diag *d) {
    (void)d;
    size_t cells = v->colony->cell.count;
    count k = {.contacts = alloc_zeroed(cells, sizeof *k.contacts)};
    double n = 0, alone = 0;
    neighborhood_contacts(v, members, count_pair, &k);
    for (size_t row = 0; row < cells; row++) {
        bool counts = !members || members[row];
        n += counts;
        alone += counts && k.contacts[row] == 0;
    }
    out[0] = n > 0 ? 2 * k.pairs / n : (double)NAN;
    out[1] = k.pairs;
    out[2] = n > 0 ? alone / n : (double)NAN;
    free(k.contacts);
    return SARCINA_OK;
}

typedef struct joining {
    const colony *c;
    uint32_t *root;
} joining;

static void join_pair(void *self, uint32_t a, uint32_t b, double distance) {
    const joining *j = self;
    (void)distance;
    component_join(j->c, j->root, a, b);
}

int touching_clusters(const view *v, const bool *members, double *out, diag *d) {
    (void)d;
    size_t cells = v->colony->cell.count;
    joining j = {v->colony, alloc_zeroed(cells, sizeof *j.root)};
    for (uint32_t row = 0; row < cells; row++)
        j.root[row] = row;
    neighborhood_contacts(v, members, join_pair, &j);
    component_sizes(v->colony, j.root, members, 1, out);
    free(j.root);
    return SARCINA_OK;
}

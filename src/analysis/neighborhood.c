/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Sweep and prune: centres sorted along x; only those within the radius along x are looked at. */
#include "analysis/neighborhood.h"

#include "base/alloc.h"
#include "base/vec3.h"
#include "model/axis.h"

#include <math.h>
#include <stdlib.h>

typedef struct place {
    double x[3];
    uint64_t id;
    uint32_t row;
} place;

static int compare_places(const void *a, const void *b) {
    const place *p = a, *q = b;
    if (p->x[0] != q->x[0])
        return p->x[0] < q->x[0] ? -1 : 1;
    return p->id < q->id ? -1 : p->id > q->id;
}

static place *sort_places(const view *v, const bool *members, size_t *n) {
    const colony *c = v->colony;
    place *list = alloc_zeroed(c->cell.count, sizeof *list);
    *n = 0;
    for (uint32_t row = 0; row < c->cell.count; row++) {
        if (members && !members[row])
            continue;
        place *p = &list[(*n)++];
        colony_centre(c, row, p->x);
        p->id = c->cell.id[row];
        p->row = row;
    }
    qsort(list, *n, sizeof *list, compare_places);
    return list;
}

void neighborhood_pairs(const view *v, const bool *members, double radius, neighborhood_visit *visit, void *self) {
    size_t n;
    place *list = sort_places(v, members, &n);
    for (size_t i = 0; i < n; i++)
        for (size_t j = i + 1; j < n && list[j].x[0] - list[i].x[0] <= radius; j++) {
            double distance = vec3_norm(vec3_sub(vec3_load(list[j].x), vec3_load(list[i].x)));
            if (distance <= radius)
                visit(self, list[i].row, list[j].row, distance);
        }
    free(list);
}

/* ---- contacts --------------------------------------------------------------------------------------------------- */

typedef struct touching {
    const colony *c;
    double touch;
    neighborhood_visit *visit;
    void *self;
} touching;

static void visit_near(void *self, uint32_t a, uint32_t b, double distance) {
    const touching *t = self;
    double reach = t->touch * 0.5 * (t->c->cell.diameter[a] + t->c->cell.diameter[b]);
    distance = axis_cell_distance(t->c, a, b);
    if (distance < reach)
        t->visit(t->self, a, b, distance);
}

/* How far a cell's axis reaches from its centre. */
static double half_extent(const colony *c, uint32_t row) {
    double centre[3], most = 0;
    const double *x = c->particle.x + 3 * (size_t)c->cell.first[row];
    colony_centre(c, row, centre);
    for (uint32_t p = 0; p < c->cell.nparticles[row]; p++)
        most = fmax(most, vec3_norm(vec3_sub(vec3_load(x + 3 * p), vec3_load(centre))));
    return most;
}

void neighborhood_contacts(const view *v, const bool *members, neighborhood_visit *visit, void *self) {
    const colony *c = v->colony;
    touching t = {c, v->mechanics ? mechanics_touch(v->mechanics) : 1, visit, self};
    double half = 0, diameter = 0;
    for (uint32_t row = 0; row < c->cell.count; row++) {
        half = fmax(half, half_extent(c, row));
        diameter = fmax(diameter, c->cell.diameter[row]);
    }
    neighborhood_pairs(v, members, 2 * half + t.touch * diameter, visit_near, &t);
}

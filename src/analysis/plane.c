/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Convex hull by Andrew's monotone chain (Inform. Process. Lett. 9:216, 1979). */
#include "analysis/plane.h"

#include "base/alloc.h"

#include <math.h>
#include <stdlib.h>

static int compare_points(const void *a, const void *b) {
    const point2 *p = a, *q = b;
    if (p->x != q->x)
        return p->x < q->x ? -1 : 1;
    return (p->y > q->y) - (p->y < q->y);
}

point2 *plane_points(const view *v, const bool *members, size_t *n) {
    const colony *c = v->colony;
    point2 *points = alloc_zeroed(c->particle.count, sizeof *points);
    *n = 0;
    for (size_t row = 0; row < c->cell.count; row++) {
        if (members && !members[row])
            continue;
        const double *x = c->particle.x + 3 * (size_t)c->cell.first[row];
        for (uint32_t p = 0; p < c->cell.nparticles[row]; p++)
            points[(*n)++] = (point2){x[3 * (size_t)p], x[3 * (size_t)p + 1]};
    }
    qsort(points, *n, sizeof *points, compare_points);
    return points;
}

/* Twice the signed area of the triangle o, a, b. */
static double turn(point2 o, point2 a, point2 b) {
    return (a.x - o.x) * (b.y - o.y) - (a.y - o.y) * (b.x - o.x);
}

size_t plane_hull(const point2 *points, size_t n, point2 *hull) {
    size_t k = 0;
    for (size_t i = 0; i < n; i++) { /* lower side */
        while (k >= 2 && turn(hull[k - 2], hull[k - 1], points[i]) <= 0)
            k--;
        hull[k++] = points[i];
    }
    size_t lower = k + 1;
    for (size_t i = n; i-- > 1;) { /* upper side, back from the last point */
        while (k >= lower && turn(hull[k - 2], hull[k - 1], points[i - 1]) <= 0)
            k--;
        hull[k++] = points[i - 1];
    }
    if (k > 1)
        k--; /* the first point came again */
    if (k == 2 && hull[0].x == hull[1].x && hull[0].y == hull[1].y)
        k = 1;
    return k;
}

double plane_area(const point2 *polygon, size_t n) {
    double twice = 0;
    for (size_t i = 2; i < n; i++)
        twice += turn(polygon[0], polygon[i - 1], polygon[i]);
    return 0.5 * fabs(twice);
}

int plane_hull_measure(const view *v, const bool *members, double *out, diag *d) {
    (void)d;
    size_t n;
    point2 *points = plane_points(v, members, &n);
    point2 *hull = alloc_zeroed(n + 1, sizeof *hull);
    out[0] = n ? plane_area(hull, plane_hull(points, n, hull)) : (double)NAN;
    free(points);
    free(hull);
    return SARCINA_OK;
}

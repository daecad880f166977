/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The hull is Qhull's (Barber, Dobkin & Huhdanpaa 1996, ACM Trans. Math. Softw. 22:469). A convex body K grown by r has
 * the volume V + S r + M r^2 + 4/3 pi r^3 (Steiner 1840), so balls of one radius need no faceting: the hull of one
 * coccus is exactly the coccus, that of one rod exactly the rod. */
#include "analysis/solid.h"

#include "analysis/plane.h"
#include "base/alloc.h"
#include "base/vec3.h"

#include <gsl/gsl_eigen.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include <libqhull_r/qhull_ra.h>

/* ---- flat hulls ---- */

/* The points' centroid and principal axes, the widest first; returns in how many dimensions they spread. */
static int principal_axes(const double *points, size_t n, vec3 *centre, vec3 axis[3]) {
    double moments[9] = {0}, widest = 0;
    *centre = vec3_of(0, 0, 0);
    for (size_t i = 0; i < n; i++)
        *centre = vec3_axpy(*centre, 1 / (double)n, vec3_load(points + 3 * i));
    for (size_t i = 0; i < n; i++) {
        double r[3];
        vec3_store(r, vec3_sub(vec3_load(points + 3 * i), *centre));
        for (int k = 0; k < 9; k++)
            moments[k] += r[k / 3] * r[k % 3];
    }
    double values[3], vectors[9];
    gsl_matrix_view m = gsl_matrix_view_array(moments, 3, 3), v = gsl_matrix_view_array(vectors, 3, 3);
    gsl_vector_view e = gsl_vector_view_array(values, 3);
    gsl_eigen_symmv_workspace *w = gsl_eigen_symmv_alloc(3);
    gsl_eigen_symmv(&m.matrix, &e.vector, &v.matrix, w);
    gsl_eigen_symmv_free(w);
    gsl_eigen_symmv_sort(&e.vector, &v.matrix, GSL_EIGEN_SORT_ABS_DESC);
    for (int a = 0; a < 3; a++)
        axis[a] = vec3_of(vectors[a], vectors[3 + a], vectors[6 + a]);
    /* spread: farther than rounding of the coordinates, in any point */
    int dimensions = 0;
    for (int a = 0; a < 3; a++) {
        double far = 0;
        for (size_t i = 0; i < n; i++)
            far = fmax(far, fabs(vec3_dot(vec3_sub(vec3_load(points + 3 * i), *centre), axis[a])));
        widest = fmax(widest, far);
        dimensions += far > 1e-7 * widest && far > 0;
    }
    return dimensions;
}

static int compare_points(const void *a, const void *b) {
    const point2 *p = a, *q = b;
    if (p->x != q->x)
        return p->x < q->x ? -1 : 1;
    return (p->y > q->y) - (p->y < q->y);
}

/* A polygon counts twice as a surface; along its rim the normal turns by pi. A segment is a polygon of two corners. */
static solid_body flat_hull(const double *points, size_t n, vec3 centre, const vec3 axis[3]) {
    point2 *flat = alloc_zeroed(n, sizeof *flat), *hull = alloc_zeroed(n + 1, sizeof *hull);
    for (size_t i = 0; i < n; i++) {
        vec3 r = vec3_sub(vec3_load(points + 3 * i), centre);
        flat[i] = (point2){vec3_dot(r, axis[0]), vec3_dot(r, axis[1])};
    }
    qsort(flat, n, sizeof *flat, compare_points);
    size_t corners = plane_hull(flat, n, hull);
    double rim = 0;
    for (size_t i = 0; i < corners; i++) {
        const point2 *p = &hull[i], *q = &hull[(i + 1) % corners];
        rim += hypot(q->x - p->x, q->y - p->y);
    }
    solid_body body = {0, 2 * plane_area(hull, corners), 0.5 * M_PI * rim};
    free(flat);
    free(hull);
    return body;
}

/* ---- solid hulls ---- */

/* Of the edge between two triangles: length times the angle between their normals, halved. */
static double edge_curvature(const facetT *f, const facetT *g, const vertexT *opposite) {
    vec3 ends[2] = {{0}};
    int n = 0;
    for (int i = 0; i < 3; i++) {
        const vertexT *corner = SETelemt_(f->vertices, i, vertexT);
        if (corner != opposite && n < 2)
            ends[n++] = vec3_load(corner->point);
    }
    vec3 a = vec3_load(f->normal), b = vec3_load(g->normal);
    double angle = atan2(vec3_norm(vec3_cross(a, b)), vec3_dot(a, b));
    return 0.5 * vec3_norm(vec3_sub(ends[1], ends[0])) * angle;
}

static solid_body measure_hull(qhT *qh) {
    solid_body body = {0};
    facetT *f;
    qh_getarea(qh, qh->facet_list);
    body.volume = qh->totvol;
    body.surface = qh->totarea;
    for (f = qh->facet_list; f && f->next; f = f->next)
        for (int i = 0; i < 3; i++) {
            const facetT *g = SETelemt_(f->neighbors, i, facetT);
            if (g->id > f->id) /* the i-th neighbour lies opposite to the i-th corner */
                body.curvature += edge_curvature(f, g, SETelemt_(f->vertices, i, vertexT));
        }
    return body;
}

solid_body solid_hull(const double *points, size_t n) {
    vec3 centre, axis[3];
    solid_body body = {0};
    if (n == 0)
        return body;
    if (principal_axes(points, n, &centre, axis) < 3)
        return flat_hull(points, n, centre, axis);
    qhT qh;
    char command[] = "qhull Qt Pp";
    FILE *nowhere = fopen("/dev/null", "w");
    double *copy = alloc_resize(NULL, 3 * n, sizeof *copy);
    memcpy(copy, points, 3 * n * sizeof *copy);
    qh_zero(&qh, nowhere);
    int failed = qh_new_qhull(&qh, 3, (int)n, copy, 0, command, nowhere, nowhere);
    body = failed ? flat_hull(points, n, centre, axis) : measure_hull(&qh);
    int held, pieces;
    qh_freeqhull(&qh, !qh_ALL);
    qh_memfreeshort(&qh, &held, &pieces);
    if (nowhere)
        fclose(nowhere);
    free(copy);
    return body;
}

double solid_grown_volume(const solid_body *b, double r) {
    return b->volume + r * (b->surface + r * (b->curvature + r * 4 * M_PI / 3));
}

/* ---- the measure ---- */

int solid_compactness(const view *v, const bool *members, double *out, diag *d) {
    (void)d;
    const colony *c = v->colony;
    const uint32_t *order = colony_by_id(v->colony);
    double *points = alloc_resize(NULL, 3 * c->particle.count, sizeof *points), filled = 0, radius = 0;
    size_t n = 0, cells = 0;
    for (size_t i = 0; i < c->cell.count; i++) {
        uint32_t row = order[i];
        if (members && !members[row])
            continue;
        size_t count = c->cell.nparticles[row];
        memcpy(points + 3 * n, c->particle.x + 3 * (size_t)c->cell.first[row], 3 * count * sizeof *points);
        n += count;
        cells++;
        radius += 0.5 * c->cell.diameter[row];
        filled += c->cell.mass[row] / v->species->list[c->cell.species[row]].density;
    }
    solid_body hull = solid_hull(points, n);
    free(points);
    out[1] = cells ? solid_grown_volume(&hull, radius / (double)cells) : (double)NAN;
    out[0] = filled / out[1];
    return SARCINA_OK;
}

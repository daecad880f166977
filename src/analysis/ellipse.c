/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Minimum-area enclosing ellipse by Khachiyan's barycentric coordinate descent with the away steps of Wolfe, Atwood,
 * Todd and Yildirim (Todd & Yildirim, Discrete Appl. Math. 155:1731, 2007, algorithm 3.2).
 *
 * The dual problem: weights u >= 0 of sum 1 that maximise det sum u_i q_i q_i', q_i = (x_i, y_i, 1). At a point i
 *     w_i = q_i' (sum u q q')^-1 q_i.
 * At the optimum w_i <= 3, with equality where u_i > 0. For any u the ellipse of the weighted mean and covariance,
 * scaled to pass through its farthest point, encloses all of them, and its area is at most (max w - 1) / 2 of the
 * smallest: the stopping rule. The points are first brought to zero mean and unit covariance, so that a long thin
 * colony is as easy as a round one. */
#include "analysis/ellipse.h"

#include "base/alloc.h"

#include <math.h>
#include <stdlib.h>

#define ELLIPSE_TOLERANCE 3e-10 /* of max w / 3 - 1 */
enum { ELLIPSE_STEPS = 1000000 };

/* Symmetric 2x2: xx, xy, yy. */
typedef struct sym2 {
    double xx, xy, yy;
} sym2;

static double sym2_det(sym2 m) {
    return m.xx * m.yy - m.xy * m.xy;
}

static sym2 sym2_inverse(sym2 m) {
    double det = sym2_det(m);
    return (sym2){m.yy / det, -m.xy / det, m.xx / det};
}

static double sym2_form(sym2 m, double x, double y) {
    return m.xx * x * x + 2 * m.xy * x * y + m.yy * y * y;
}

static point2 weighted_mean(const point2 *p, const double *u, size_t n) {
    point2 mean = {0, 0};
    for (size_t i = 0; i < n; i++) {
        mean.x += u[i] * p[i].x;
        mean.y += u[i] * p[i].y;
    }
    return mean;
}

static sym2 weighted_covariance(const point2 *p, const double *u, size_t n, point2 mean) {
    sym2 s = {0, 0, 0};
    for (size_t i = 0; i < n; i++) {
        double x = p[i].x - mean.x, y = p[i].y - mean.y;
        s.xx += u[i] * x * x;
        s.xy += u[i] * x * y;
        s.yy += u[i] * y * y;
    }
    return s;
}

/* The point to lean towards (largest w) or away from (smallest w with weight), whichever is farther from w = 3. */
typedef struct extreme {
    size_t row;
    double w, largest;
} extreme;

static extreme find_extreme(const point2 *p, const double *u, size_t n) {
    point2 mean = weighted_mean(p, u, n);
    sym2 inverse = sym2_inverse(weighted_covariance(p, u, n, mean));
    size_t high = 0, low = 0;
    double w_high = -1, w_low = INFINITY;
    for (size_t i = 0; i < n; i++) {
        double w = 1 + sym2_form(inverse, p[i].x - mean.x, p[i].y - mean.y);
        if (w > w_high) {
            w_high = w;
            high = i;
        }
        if (u[i] > 0 && w < w_low) {
            w_low = w;
            low = i;
        }
    }
    if (w_high - 3 >= 3 - w_low)
        return (extreme){high, w_high, w_high};
    return (extreme){low, w_low, w_high};
}

/* The weights of the smallest ellipse, from equal ones. */
static void find_weights(const point2 *p, double *u, size_t n) {
    for (size_t i = 0; i < n; i++)
        u[i] = 1.0 / (double)n;
    for (int step = 0; step < ELLIPSE_STEPS; step++) {
        extreme e = find_extreme(p, u, n);
        if (e.largest <= 3 * (1 + ELLIPSE_TOLERANCE) && fabs(e.w - 3) <= 3 * ELLIPSE_TOLERANCE)
            return;
        /* exact line search; an away step stops where the weight would become negative */
        double beta = (e.w - 3) / (3 * (e.w - 1));
        double least = -u[e.row] / (1 - u[e.row]);
        bool drops = beta <= least;
        if (drops)
            beta = least;
        for (size_t i = 0; i < n; i++)
            u[i] *= 1 - beta;
        u[e.row] = drops ? 0 : u[e.row] + beta;
    }
}

/* Centre and matrix of the ellipse (x - c)' M^-1 (x - c) <= 1 of the weights, grown to enclose every point. */
static sym2 enclose(const point2 *p, const double *u, size_t n, point2 *centre) {
    *centre = weighted_mean(p, u, n);
    sym2 s = weighted_covariance(p, u, n, *centre), inverse = sym2_inverse(s);
    double largest = 0;
    for (size_t i = 0; i < n; i++) {
        double w = sym2_form(inverse, p[i].x - centre->x, p[i].y - centre->y);
        largest = w > largest ? w : largest;
    }
    return (sym2){largest * s.xx, largest * s.xy, largest * s.yy};
}

static ellipse from_matrix(sym2 m, point2 centre) {
    double middle = 0.5 * (m.xx + m.yy), radius = hypot(0.5 * (m.xx - m.yy), m.xy);
    double least = sym2_det(m) / (middle + radius);
    ellipse e = {centre, M_PI * sqrt(sym2_det(m)), 2 * sqrt(middle + radius), 2 * sqrt(least), 0};
    e.angle = 0.5 * atan2(2 * m.xy, m.xx - m.yy);
    return e;
}

/* Points on a line: the segment between the two farthest apart along it. */
static ellipse segment_ellipse(const point2 *p, size_t n) {
    ellipse e = {p[0], 0, 0, 0, NAN};
    for (size_t i = 0; i < n; i++)
        for (size_t j = i + 1; j < n; j++) {
            double length = hypot(p[j].x - p[i].x, p[j].y - p[i].y);
            if (length <= e.major)
                continue;
            e.major = length;
            e.centre = (point2){0.5 * (p[i].x + p[j].x), 0.5 * (p[i].y + p[j].y)};
            e.angle = atan((p[j].y - p[i].y) / (p[j].x - p[i].x));
        }
    return e;
}

/* Brings the points to zero mean and unit covariance, x = mean + L y with L lower triangular. */
static void whiten(const point2 *p, point2 *y, double *u, size_t n, point2 *mean, sym2 *lower) {
    for (size_t i = 0; i < n; i++)
        u[i] = 1.0 / (double)n;
    *mean = weighted_mean(p, u, n);
    sym2 s = weighted_covariance(p, u, n, *mean);
    lower->xx = sqrt(s.xx);
    lower->xy = s.xy / lower->xx;
    lower->yy = sqrt(s.yy - lower->xy * lower->xy);
    for (size_t i = 0; i < n; i++) {
        y[i].x = (p[i].x - mean->x) / lower->xx;
        y[i].y = (p[i].y - mean->y - lower->xy * y[i].x) / lower->yy;
    }
}

ellipse ellipse_around(const point2 *points, size_t n) {
    if (n == 0)
        return (ellipse){{NAN, NAN}, NAN, NAN, NAN, NAN};
    if (n < 3)
        return segment_ellipse(points, n);
    double *u = alloc_zeroed(n, sizeof *u);
    point2 *y = alloc_zeroed(n, sizeof *y), mean, centre;
    sym2 l;
    whiten(points, y, u, n, &mean, &l);
    ellipse e;
    if (!(l.yy > 1e-12 * (fabs(l.xx) + fabs(l.xy)))) { /* flat to rounding */
        e = segment_ellipse(points, n);
    } else {
        find_weights(y, u, n);
        sym2 m = enclose(y, u, n, &centre);
        sym2 back = {l.xx * l.xx * m.xx, l.xx * (l.xy * m.xx + l.yy * m.xy),
                     l.xy * l.xy * m.xx + 2 * l.xy * l.yy * m.xy + l.yy * l.yy * m.yy};
        centre = (point2){mean.x + l.xx * centre.x, mean.y + l.xy * centre.x + l.yy * centre.y};
        e = from_matrix(back, centre);
        e.area = M_PI * l.xx * l.yy * sqrt(sym2_det(m)); /* without the cancellation in a thin ellipse */
        e.minor = 4 * e.area / (M_PI * e.major);
    }
    free(u);
    free(y);
    return e;
}

int ellipse_measure(const view *v, const bool *members, double *out, diag *d) {
    (void)d;
    size_t n;
    point2 *points = plane_points(v, members, &n);
    point2 *hull = alloc_zeroed(n + 1, sizeof *hull);
    ellipse e = ellipse_around(hull, n ? plane_hull(points, n, hull) : 0);
    out[0] = out[1] = e.area;
    out[2] = e.major;
    out[3] = e.minor;
    out[4] = e.angle;
    free(points);
    free(hull);
    return SARCINA_OK;
}

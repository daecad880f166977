/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Of the light that a diffuse surface gets from an even sky, a ball of radius r at distance l, seen under the angle
 * theta to the normal, hides (r/l)^2 cos(theta), and an endless cylinder (r/l) cos(theta): the configuration factors
 * from a surface element. A rod is between: the cylinder's times the part of its length that is there, seen from the
 * place, but never less than its nearest ball. What several hide is added: smooth, without the noise of sampled rays,
 * and a crevice between two rods on the floor is dark, as it is. */
#include "output/capsule.h"

#include "base/alloc.h"

#include <math.h>
#include <stdlib.h>

struct capsule_shade {
    const capsule *list;
    vec3 low;
    double size, reach;
    int bins[3];
    uint32_t *first;   /* bins + 1: where a bin's entries begin */
    uint32_t *entries; /* rows of list, by bin */
};

vec3 capsule_nearest(const capsule *c, vec3 p) {
    vec3 axis = vec3_sub(c->b, c->a);
    double length2 = vec3_dot(axis, axis);
    if (length2 <= 0)
        return c->a;
    double t = vec3_dot(vec3_sub(p, c->a), axis) / length2;
    return vec3_axpy(c->a, t < 0 ? 0 : t > 1 ? 1 : t, axis);
}

static vec3 box_low(const capsule *c, double margin) {
    return vec3_of(fmin(c->a.x, c->b.x) - margin, fmin(c->a.y, c->b.y) - margin, fmin(c->a.z, c->b.z) - margin);
}

static vec3 box_high(const capsule *c, double margin) {
    return vec3_of(fmax(c->a.x, c->b.x) + margin, fmax(c->a.y, c->b.y) + margin, fmax(c->a.z, c->b.z) + margin);
}

static int bin_of(double x, double low, double size, int bins) {
    double i = floor((x - low) / size);
    return i < 0 ? 0 : i >= bins ? bins - 1 : (int)i;
}

/* Is any of a bin nearer to the capsule than its reach? Its middle, to within half its diagonal. */
static bool touches_bin(const capsule_shade *s, const capsule *c, int x, int y, int z) {
    vec3 middle = vec3_axpy(s->low, s->size, vec3_of(x + 0.5, y + 0.5, z + 0.5));
    vec3 d = vec3_sub(capsule_nearest(c, middle), middle);
    double most = c->r + s->reach + 0.87 * s->size;
    return vec3_dot(d, d) <= most * most;
}

/* Visits the bins that a capsule's surroundings touch: counts them, or with entries fills its row in. */
static void visit_bins(capsule_shade *s, uint32_t row, uint32_t *count, uint32_t *entries) {
    const capsule *c = &s->list[row];
    vec3 low = box_low(c, c->r + s->reach), high = box_high(c, c->r + s->reach);
    int from[3] = {bin_of(low.x, s->low.x, s->size, s->bins[0]), bin_of(low.y, s->low.y, s->size, s->bins[1]),
                   bin_of(low.z, s->low.z, s->size, s->bins[2])};
    int to[3] = {bin_of(high.x, s->low.x, s->size, s->bins[0]), bin_of(high.y, s->low.y, s->size, s->bins[1]),
                 bin_of(high.z, s->low.z, s->size, s->bins[2])};
    for (int z = from[2]; z <= to[2]; z++)
        for (int y = from[1]; y <= to[1]; y++)
            for (int x = from[0]; x <= to[0]; x++) {
                if (!touches_bin(s, c, x, y, z))
                    continue;
                int bin = (z * s->bins[1] + y) * s->bins[0] + x;
                if (entries)
                    entries[count[bin]] = row;
                count[bin]++;
            }
}

/* Bins about a capsule's diameter wide, but never more than a few million. */
static void lay_bins(capsule_shade *s, size_t n) {
    vec3 low = vec3_of(INFINITY, INFINITY, INFINITY), high = vec3_of(-INFINITY, -INFINITY, -INFINITY);
    double widest = 0;
    for (size_t i = 0; i < n; i++) {
        vec3 a = box_low(&s->list[i], s->list[i].r + s->reach), b = box_high(&s->list[i], s->list[i].r + s->reach);
        low = vec3_of(fmin(low.x, a.x), fmin(low.y, a.y), fmin(low.z, a.z));
        high = vec3_of(fmax(high.x, b.x), fmax(high.y, b.y), fmax(high.z, b.z));
        widest = fmax(widest, 2 * s->list[i].r);
    }
    s->low = low;
    vec3 extent = vec3_sub(high, low);
    s->size = fmax(widest, cbrt(extent.x * extent.y * extent.z / 4e6));
    s->bins[0] = (int)(extent.x / s->size) + 1;
    s->bins[1] = (int)(extent.y / s->size) + 1;
    s->bins[2] = (int)(extent.z / s->size) + 1;
}

capsule_shade *capsule_shade_create(const capsule *list, size_t n, double reach) {
    capsule_shade *s = alloc_zeroed(1, sizeof *s);
    s->list = list;
    s->reach = reach;
    if (!n)
        return s;
    lay_bins(s, n);
    size_t bins = (size_t)s->bins[0] * (size_t)s->bins[1] * (size_t)s->bins[2];
    uint32_t *count = alloc_zeroed(bins, sizeof *count);
    for (uint32_t i = 0; i < n; i++)
        visit_bins(s, i, count, NULL);
    s->first = alloc_zeroed(bins + 1, sizeof *s->first);
    for (size_t i = 0; i < bins; i++) {
        s->first[i + 1] = s->first[i] + count[i];
        count[i] = s->first[i];
    }
    s->entries = alloc_zeroed(s->first[bins], sizeof *s->entries);
    for (uint32_t i = 0; i < n; i++)
        visit_bins(s, i, count, s->entries);
    free(count);
    return s;
}

void capsule_shade_free(capsule_shade *s) {
    if (!s)
        return;
    free(s->first);
    free(s->entries);
    free(s);
}

/* Part of an endless rod that is there, as seen from p: half the sum of the sines of the angles to its ends. */
static double present_part(const capsule *c, vec3 p) {
    vec3 axis = vec3_sub(c->b, c->a), from_a = vec3_sub(p, c->a);
    double length = vec3_norm(axis);
    if (length <= 0)
        return 0;
    double along = vec3_dot(from_a, axis) / length, across2 = vec3_dot(from_a, from_a) - along * along;
    double behind = along, ahead = length - along;
    return 0.5 * (ahead / sqrt(ahead * ahead + across2) + behind / sqrt(behind * behind + across2));
}

/* What one capsule hides of the sky; fades to nothing at the reach. */
static double hidden_by(const capsule *c, vec3 p, vec3 n, double reach) {
    vec3 d = vec3_sub(capsule_nearest(c, p), p);
    double above = vec3_dot(d, n), l2 = vec3_dot(d, d), most = c->r + reach;
    if (above <= 0 || l2 >= most * most)
        return 0;
    double l = sqrt(l2), gap = (l - c->r) / reach;
    double fade = gap > 0 ? 1 - gap * gap * gap : 1, near = fmin(1, c->r / l);
    return fade * near * fmax(near, present_part(c, p)) * above / l;
}

double capsule_shade_open(const capsule_shade *s, vec3 p, vec3 n, uint32_t owner) {
    if (!s->first)
        return 1;
    double i = floor((p.x - s->low.x) / s->size), j = floor((p.y - s->low.y) / s->size),
           k = floor((p.z - s->low.z) / s->size);
    if (i < 0 || j < 0 || k < 0 || i >= s->bins[0] || j >= s->bins[1] || k >= s->bins[2])
        return 1;
    size_t bin = ((size_t)k * (size_t)s->bins[1] + (size_t)j) * (size_t)s->bins[0] + (size_t)i;
    double hidden = 0;
    for (uint32_t e = s->first[bin]; e < s->first[bin + 1]; e++) {
        const capsule *c = &s->list[s->entries[e]];
        if (c->owner != owner)
            hidden += hidden_by(c, p, n, s->reach);
    }
    return fmax(0, 1 - hidden);
}

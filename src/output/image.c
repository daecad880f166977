/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "output/image.h"

#include "base/alloc.h"
#include "output/image_overlay.h"
#include "output/image_scene.h"

#include <math.h>
#include <stdlib.h>

image_options image_defaults(void) {
    const camera_view *top = &camera_views[0];
    return (image_options){.width = 800,
                           .height = 600,
                           .theta = top->theta,
                           .phi = top->phi,
                           .zoom = 1,
                           .scalebar = -1,
                           .low = NAN,
                           .high = NAN,
                           .legend = true,
                           .fps = 24,
                           .background = {1, 1, 1}};
}

/* ---- shapes ----------------------------------------------------------------------------------------------------- */

/* A capsule for each segment of each cell; the caller frees. */
static capsule *build_capsules(const colony *c, const uint32_t *rows, const rgb *colors, size_t n, size_t *count) {
    size_t segments = 0;
    for (size_t i = 0; i < n; i++)
        segments += c->cell.nparticles[rows[i]] > 1 ? c->cell.nparticles[rows[i]] - 1 : 1;
    capsule *list = alloc_zeroed(segments, sizeof *list);
    *count = 0;
    for (size_t i = 0; i < n; i++) {
        const double *x = c->particle.x + 3 * (size_t)c->cell.first[rows[i]];
        size_t last = c->cell.nparticles[rows[i]] - 1;
        for (size_t p = 0; p == 0 || p < last; p++)
            list[(*count)++] = (capsule){.a = vec3_load(x + 3 * p),
                                         .b = vec3_load(x + 3 * (last ? p + 1 : p)),
                                         .r = 0.5 * c->cell.diameter[rows[i]],
                                         .color = color_to_linear(colors[i]),
                                         .owner = (uint32_t)i};
    }
    return list;
}

static vec3 least(vec3 a, vec3 b) {
    return vec3_of(fmin(a.x, b.x), fmin(a.y, b.y), fmin(a.z, b.z));
}

static vec3 largest(vec3 a, vec3 b) {
    return vec3_of(fmax(a.x, b.x), fmax(a.y, b.y), fmax(a.z, b.z));
}

/* The box of all balls, along the axes of the picture. A picture of nothing shows 10 um. */
static void find_bounds(const capsule *list, size_t n, const camera *eye, vec3 *low, vec3 *high) {
    *low = vec3_of(INFINITY, INFINITY, INFINITY);
    *high = vec3_scale(-1, *low);
    if (n == 0) {
        *low = vec3_of(-5, -5, -5);
        *high = vec3_of(5, 5, 5);
    }
    for (size_t i = 0; i < n; i++)
        for (int end = 0; end < 2; end++) {
            vec3 p = camera_project(eye, end ? list[i].b : list[i].a), r = vec3_of(list[i].r, list[i].r, list[i].r);
            *low = least(*low, vec3_sub(p, r));
            *high = largest(*high, vec3_add(p, r));
        }
}

/* Leaves `right` pixels of the picture free at its right side. */
static stage set_stage(const capsule *list, size_t n, const image_options *o, double right) {
    stage s = {.list = list, .count = n, .background = color_to_linear(o->background)};
    vec3 low, high;
    s.eye = camera_look(o->theta, o->phi, o->width, o->height);
    find_bounds(list, n, &s.eye, &low, &high);
    s.eye.width -= (int)right;
    camera_fit(&s.eye, low, high, 0.92, o->zoom);
    s.eye.width = o->width;
    s.middle = s.eye.centre;
    s.eye.centre = vec3_axpy(s.eye.centre, 0.5 * (int)right / s.eye.scale, s.eye.right);
    s.radius = 0.5 * vec3_norm(vec3_sub(high, low));
    s.has_floor = o->has_floor;
    s.floor_z = o->floor_z;
    return s;
}

int image_set(const dump_frame *f, const image_options *o, image_scene *out, diag *d) {
    size_t n;
    uint32_t *rows = dump_rows(f, &n);
    rgb *colors = alloc_zeroed(n, sizeof *colors);
    *out = (image_scene){.list = NULL};
    int status = image_color_cells(f, o, rows, n, colors, &out->key, d);
    if (!status) {
        size_t count;
        out->list = build_capsules(f->view->colony, rows, colors, n, &count);
        out->stage = set_stage(out->list, count, o, image_overlay_margin(f, o, &out->key));
    }
    free(rows);
    free(colors);
    return status;
}

void image_release(image_scene *s) {
    free(s->list);
}

int image_draw(const dump_frame *f, const image_options *o, canvas **out, diag *d) {
    image_scene s;
    *out = NULL;
    int status = image_set(f, o, &s, d);
    if (!status) {
        *out = canvas_create(o->width, o->height, o->background);
        status = render_stage(&s.stage, *out, f->threads, d);
        if (!status)
            image_overlay_draw(*out, f, &s.stage.eye, o, &s.key);
    }
    image_release(&s);
    if (status) {
        canvas_free(*out);
        *out = NULL;
    }
    return status;
}

/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "output/image.h"

#include "base/alloc.h"
#include "output/render.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

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
                           .background = {1, 1, 1}};
}

/* ---- colours ---------------------------------------------------------------------------------------------------- */

/* Values that tell cells apart but have no amount. */
static bool is_label(const char *name) {
    static const char *const labels[] = {"generation", "founder", "parent", "id", "cluster"};
    for (size_t i = 0; i < sizeof labels / sizeof *labels; i++)
        if (strcmp(name, labels[i]) == 0)
            return true;
    return false;
}

static rgb species_color(const dump_frame *f, uint32_t row) {
    int32_t kind = f->view->colony->cell.species[row];
    rgb c;
    if (!color_parse(f->view->species->list[kind].color, &c))
        c = color_palette((uint64_t)kind);
    return c;
}

/* Texts take the palette's colours in the order of the alphabet. */
static int color_by_text(const dump_frame *f, const uint32_t *rows, size_t n, rgb *out, diag *d) {
    char(*texts)[64] = alloc_zeroed(n, sizeof *texts), (*distinct)[64] = alloc_zeroed(n, sizeof *distinct);
    size_t count = 0;
    int status = SARCINA_OK;
    for (size_t i = 0; i < n && !status; i++) {
        status = f->columns[0].text(f->columns[0].self, rows[i], texts[i], d);
        size_t at = 0;
        while (at < count && strcmp(distinct[at], texts[i]) < 0)
            at++;
        if (at < count && strcmp(distinct[at], texts[i]) == 0)
            continue;
        memmove(distinct[at + 1], distinct[at], (count++ - at) * sizeof *distinct);
        memcpy(distinct[at], texts[i], sizeof *distinct);
    }
    for (size_t i = 0; i < n && !status; i++) {
        size_t at = 0;
        while (strcmp(distinct[at], texts[i]) != 0)
            at++;
        out[i] = color_palette(at);
    }
    free(texts);
    free(distinct);
    return status;
}

static int color_by_number(const dump_frame *f, const image_options *o, const uint32_t *rows, size_t n, rgb *out,
                           diag *d) {
    const output_column *column = &f->columns[0];
    double *x = alloc_zeroed(n, sizeof *x), low = INFINITY, high = -INFINITY;
    int status = SARCINA_OK;
    for (size_t i = 0; i < n && !status; i++) {
        status = column->number(column->self, rows[i], &x[i], d);
        low = fmin(low, x[i]);
        high = fmax(high, x[i]);
    }
    bool labels = is_label(column->name) && isnan(o->low);
    low = isnan(o->low) ? low : o->low;
    high = isnan(o->high) ? high : o->high;
    for (size_t i = 0; i < n && !status; i++) {
        double t = high > low ? (x[i] - low) / (high - low) : isnan(x[i]) ? (double)NAN : 0.5;
        out[i] = labels && x[i] >= 0 ? color_palette((uint64_t)x[i]) : color_of(&color_maps[o->map], t);
    }
    free(x);
    return status;
}

static int color_cells(const dump_frame *f, const image_options *o, const uint32_t *rows, size_t n, rgb *out, diag *d) {
    bool by_species = !o->has_color && f->columns[0].is_text && strcmp(f->columns[0].name, "species") == 0;
    if (!o->has_color && !by_species)
        return f->columns[0].is_text ? color_by_text(f, rows, n, out, d) : color_by_number(f, o, rows, n, out, d);
    for (size_t i = 0; i < n; i++)
        out[i] = by_species ? species_color(f, rows[i]) : o->color;
    return SARCINA_OK;
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

static stage set_stage(const capsule *list, size_t n, const image_options *o) {
    stage s = {.list = list, .count = n, .background = color_to_linear(o->background)};
    vec3 low, high;
    s.eye = camera_look(o->theta, o->phi, o->width, o->height);
    find_bounds(list, n, &s.eye, &low, &high);
    camera_fit(&s.eye, low, high, 0.92, o->zoom);
    s.middle = s.eye.centre;
    s.radius = 0.5 * vec3_norm(vec3_sub(high, low));
    s.has_floor = o->has_floor;
    s.floor_z = o->floor_z;
    return s;
}

/* ---- what is drawn flat over the picture ------------------------------------------------------------------------ */

static rgb ink(const image_options *o) {
    return color_luminance(color_to_linear(o->background)) > 0.2f ? (rgb){0.1f, 0.1f, 0.1f}
                                                                  : (rgb){0.95f, 0.95f, 0.95f};
}

/* 1, 2 or 5 times a power of ten: the longest bar that is not over a fifth of the picture. */
static double round_length(double most) {
    double power = pow(10, floor(log10(most))), digit = most / power;
    return power * (digit >= 5 ? 5 : digit >= 2 ? 2 : 1);
}

static void draw_scalebar(canvas *c, const camera *eye, const image_options *o) {
    double length = o->scalebar > 0 ? o->scalebar : round_length(0.2 * eye->width / eye->scale);
    double size = fmax(10, eye->height / 40.0), margin = 1.4 * size, bar = length * eye->scale, thick = 0.28 * size;
    char label[40];
    snprintf(label, sizeof label,
             length < 0.1    ? "%g nm"
             : length < 1000 ? "%g um"
                             : "%g mm",
             length < 0.1    ? length * 1e3
             : length < 1000 ? length
                             : length / 1e3);
    double text = canvas_text_width(label, size), width = fmax(bar, text), base = c->height - margin;
    canvas_box(c, margin - 0.5 * size, base - thick - 2.1 * size, margin + width + 0.5 * size, base + 0.5 * size,
               o->background, 0.8);
    canvas_box(c, margin + 0.5 * (width - bar), base - thick, margin + 0.5 * (width + bar), base, ink(o), 1);
    canvas_text(c, margin + 0.5 * (width - text), base - thick - 0.6 * size, size, label, ink(o));
}

static void draw_arrow(canvas *c, const camera *eye, vec3 axis, const char *name, double x, double y, double size,
                       rgb color) {
    vec3 a = camera_project(eye, axis);
    double length = 2.6 * size, dx = length * a.x, dy = -length * a.y, flat = hypot(dx, dy);
    if (flat < 0.15 * length) /* towards the eye */
        return;
    double ux = dx / flat, uy = dy / flat, head = 0.5 * size;
    canvas_line(c, x, y, x + dx, y + dy, 0.16 * size, color, 1);
    for (int side = -1; side <= 1; side += 2)
        canvas_line(c, x + dx, y + dy, x + dx - head * (ux - 0.5 * side * uy), y + dy - head * (uy + 0.5 * side * ux),
                    0.16 * size, color, 1);
    canvas_text(c, x + dx + 0.7 * size * ux - 0.4 * size, y + dy + 0.7 * size * uy + 0.35 * size, size, name, color);
}

static void draw_axes(canvas *c, const camera *eye, const image_options *o) {
    double size = fmax(10, eye->height / 40.0), x = c->width - 5 * size, y = c->height - 4 * size;
    draw_arrow(c, eye, vec3_of(1, 0, 0), "x", x, y, size, (rgb){0.80f, 0.15f, 0.15f});
    draw_arrow(c, eye, vec3_of(0, 1, 0), "y", x, y, size, (rgb){0.13f, 0.55f, 0.13f});
    draw_arrow(c, eye, vec3_of(0, 0, 1), "z", x, y, size, (rgb){0.15f, 0.30f, 0.80f});
    (void)o;
}

static void draw_springs(canvas *c, const dump_frame *f, const camera *eye) {
    static const rgb colors[] = {[LINK_FILIAL] = {0.10f, 0.10f, 0.10f},
                                 [LINK_STICK] = {0.10f, 0.35f, 0.75f},
                                 [LINK_ANCHOR] = {0.70f, 0.20f, 0.10f},
                                 [LINK_SPRING] = {0.30f, 0.30f, 0.30f}};
    colony *k = f->view->colony;
    for (size_t l = 0; l < k->link.count; l++) {
        uint32_t a = colony_row(k, k->link.cell_a[l]), b = k->link.cell_b[l] ? colony_row(k, k->link.cell_b[l]) : a;
        if (f->members && !(f->members[a] && f->members[b]))
            continue;
        for (uint32_t s = k->link.first[l]; s < k->link.first[l] + k->link.nsprings[l]; s++) {
            const double *to = k->spring.b[s] == SPRING_ANCHOR ? k->spring.anchor + 3 * (size_t)s
                                                               : k->particle.x + 3 * (size_t)k->spring.b[s];
            vec3 p = camera_to_pixel(eye, vec3_load(k->particle.x + 3 * (size_t)k->spring.a[s]));
            vec3 q = camera_to_pixel(eye, vec3_load(to));
            canvas_line(c, p.x, p.y, q.x, q.y, fmax(1.2, 0.06 * eye->scale), colors[k->link.kind[l]], 0.9);
        }
    }
}

static void draw_overlay(canvas *c, const dump_frame *f, const camera *eye, const image_options *o) {
    if (o->springs)
        draw_springs(c, f, eye);
    if (o->scalebar != 0)
        draw_scalebar(c, eye, o);
    if (o->axes)
        draw_axes(c, eye, o);
}

int image_draw(const dump_frame *f, const image_options *o, canvas **out, diag *d) {
    size_t n, count = 0;
    uint32_t *rows = dump_rows(f, &n);
    rgb *colors = alloc_zeroed(n, sizeof *colors);
    *out = NULL;
    int status = color_cells(f, o, rows, n, colors, d);
    if (!status) {
        capsule *list = build_capsules(f->view->colony, rows, colors, n, &count);
        stage s = set_stage(list, count, o);
        *out = canvas_create(o->width, o->height, o->background);
        status = render_stage(&s, *out, f->threads, d);
        if (!status)
            draw_overlay(*out, f, &s.eye, o);
        free(list);
    }
    if (status) {
        canvas_free(*out);
        *out = NULL;
    }
    free(rows);
    free(colors);
    return status;
}

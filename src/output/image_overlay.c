/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "output/image_overlay.h"

#include "output/readable.h"
#include "output/spring_list.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

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

/* ---- springs ----------------------------------------------------------------------------------------------------- */

/* The map of strain: red is stretched, blue pressed together, as far from the middle either way. */
static int strain_map(void) {
    return color_map_find("coolwarm");
}

/* The largest strain either way of the springs of links. */
static double largest_strain(const spring_item *list, size_t n) {
    double most = 0;
    for (size_t i = 0; i < n; i++)
        if (list[i].kind != SPRING_INTERNAL && fabs(list[i].strain) > most)
            most = fabs(list[i].strain);
    return most;
}

static rgb spring_color(const spring_item *s, const image_options *o, double most) {
    static const rgb colors[] = {[LINK_FILIAL] = {0.10f, 0.10f, 0.10f},
                                 [LINK_STICK] = {0.10f, 0.35f, 0.75f},
                                 [LINK_ANCHOR] = {0.70f, 0.20f, 0.10f},
                                 [LINK_SPRING] = {0.30f, 0.30f, 0.30f}};
    if (o->springs == IMAGE_SPRINGS_KIND)
        return colors[s->kind];
    return color_of(&color_maps[strain_map()], most > 0 ? 0.5 + 0.5 * s->strain / most : 0.5);
}

/* Of links only: those inside cells lie in their axes. Returns the largest strain shown. */
static double draw_springs(canvas *c, const dump_frame *f, const camera *eye, const image_options *o) {
    size_t n;
    spring_item *list = spring_list_make(f, &n);
    double most = largest_strain(list, n), thick = fmax(1.2, 0.06 * eye->scale);
    for (size_t i = 0; i < n; i++) {
        if (list[i].kind == SPRING_INTERNAL)
            continue;
        vec3 p = camera_to_pixel(eye, list[i].from), q = camera_to_pixel(eye, list[i].to);
        if (o->springs == IMAGE_SPRINGS_STRAIN) /* an edge, so that the middle of the map is seen on any cell */
            canvas_line(c, p.x, p.y, q.x, q.y, 2 * thick + 1.5, (rgb){0.1f, 0.1f, 0.1f}, 0.9);
        canvas_line(c, p.x, p.y, q.x, q.y, o->springs == IMAGE_SPRINGS_STRAIN ? 2 * thick : thick,
                    spring_color(&list[i], o, most), o->springs == IMAGE_SPRINGS_STRAIN ? 1 : 0.9);
    }
    free(list);
    return most;
}

/* ---- what the colours mean --------------------------------------------------------------------------------------- */

/* A bar of the map with the numbers at its ends and in its middle. */
typedef struct bar {
    char label[160], number[3][32];
    double size, wide; /* height of a letter; of all, px */
} bar;

static bar lay_out_bar(const char *title, const image_key *key, const image_options *o) {
    bar b = {.size = fmax(9, o->height / 46.0)};
    char suffix[48];
    double text = 0, unit = readable_unit(key->d, suffix);
    snprintf(b.label, sizeof b.label, suffix[0] ? "%.60s (%s)" : "%.60s", title, suffix);
    for (int i = 0; i < 3; i++) {
        snprintf(b.number[i], sizeof b.number[i], "%.3g", (key->low + 0.5 * i * (key->high - key->low)) / unit);
        text = fmax(text, canvas_text_width(b.number[i], b.size));
    }
    b.wide = fmax(1.7 * b.size + text, canvas_text_width(b.label, b.size));
    return b;
}

/* Left of `right`, from y down. Returns its height. */
static double draw_bar(canvas *c, const bar *b, const image_key *key, double right, double y, const image_options *o) {
    double size = b->size, width = 1.1 * size, height = 9 * size, left = right - b->wide;
    canvas_box(c, left - 0.5 * size, y - 0.5 * size, right + 0.5 * size, y + height + 3.8 * size, o->background, 0.8);
    canvas_text(c, left, y + size, size, b->label, ink(o));
    double top = rint(y + 2.6 * size); /* whole pixels: the rows of the bar are to meet */
    int steps = (int)height;
    for (int i = 0; i < steps; i++)
        canvas_box(c, left, top + i, left + width, top + i + 1, color_of(&color_maps[key->map], 1 - (i + 0.5) / steps),
                   1);
    for (int i = 0; i < 3; i++) {
        double at = top + steps * (1 - 0.5 * i);
        canvas_line(c, left + width, at, left + width + 0.3 * size, at, 0.1 * size, ink(o), 1);
        canvas_text(c, left + width + 0.6 * size, at + 0.4 * size, size, b->number[i], ink(o));
    }
    return height + 5 * size;
}

static double names_width(const image_key *key, double size) {
    double wide = 0;
    for (size_t i = 0; i < key->names; i++)
        wide = fmax(wide, canvas_text_width(key->name[i], size));
    return wide + 1.8 * size;
}

static void draw_names(canvas *c, const image_key *key, double right, double y, const image_options *o) {
    double size = fmax(9, c->height / 46.0), left = right - names_width(key, size);
    canvas_box(c, left - 0.5 * size, y - 0.5 * size, right + 0.5 * size, y + 1.8 * size * (double)key->names,
               o->background, 0.8);
    for (size_t i = 0; i < key->names; i++, y += 1.8 * size) {
        canvas_line(c, left + 0.5 * size, y + 0.5 * size, left + 0.5 * size, y + 0.5 * size, size, key->color[i], 1);
        canvas_text(c, left + 1.8 * size, y + size, size, key->name[i], ink(o));
    }
}

static const char links_title[] = "strain of links";

static image_key key_of_springs(double strain) {
    return (image_key){.kind = strain > 0 ? KEY_MAP : KEY_NONE, .low = -strain, .high = strain, .map = strain_map()};
}

static double strain_shown(const dump_frame *f, const image_options *o) {
    size_t n;
    if (o->springs != IMAGE_SPRINGS_STRAIN)
        return 0;
    spring_item *list = spring_list_make(f, &n);
    double most = largest_strain(list, n);
    free(list);
    return most;
}

double image_overlay_margin(const dump_frame *f, const image_options *o, const image_key *key) {
    double size = fmax(9, o->height / 46.0), wide = 0;
    const image_key springs = key_of_springs(strain_shown(f, o));
    if (!o->legend)
        return 0;
    if (key->kind == KEY_MAP && key->high > key->low)
        wide = lay_out_bar(key->title, key, o).wide;
    if (key->kind == KEY_NAMES && key->names > 1)
        wide = names_width(key, size);
    if (springs.kind == KEY_MAP)
        wide = fmax(wide, lay_out_bar(links_title, &springs, o).wide);
    return wide > 0 ? fmin(wide + 2.4 * size, o->width / 3.0) : 0;
}

/* In the upper right corner: the cells' colours, and below them those of the springs. */
static void draw_legend(canvas *c, const image_options *o, const image_key *key, double strain) {
    double size = fmax(9, c->height / 46.0), right = c->width - 1.2 * size, y = 1.2 * size;
    const image_key springs = key_of_springs(strain);
    if (key->kind == KEY_MAP && key->high > key->low) {
        bar b = lay_out_bar(key->title, key, o);
        y += draw_bar(c, &b, key, right, y, o);
    } else if (key->kind == KEY_NAMES && key->names > 1) {
        draw_names(c, key, right, y, o);
        y += 1.8 * size * (double)key->names + size;
    }
    if (springs.kind == KEY_MAP) {
        bar b = lay_out_bar(links_title, &springs, o);
        draw_bar(c, &b, &springs, right, y, o);
    }
}

void image_overlay_draw(canvas *c, const dump_frame *f, const camera *eye, const image_options *o,
                        const image_key *key) {
    double strain = o->springs == IMAGE_SPRINGS_NONE ? 0 : draw_springs(c, f, eye, o);
    if (o->scalebar != 0)
        draw_scalebar(c, eye, o);
    if (o->axes)
        draw_axes(c, eye, o);
    if (o->legend)
        draw_legend(c, o, key, strain);
}

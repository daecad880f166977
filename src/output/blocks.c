/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "output/blocks.h"

#include "base/alloc.h"
#include "output/camera.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

/* Pixels a um at most: cells of 1 um are then 12 characters wide. */
static const double scale_most = 12;

/* What is nearest to the eye. */
typedef struct pixel {
    bool on;
    double depth; /* um towards the eye */
    rgb color;    /* linear light, shaded */
} pixel;

typedef struct raster {
    int width, height; /* pixels; height is even */
    camera eye;
    bool gaps;
    pixel *pixels;
} raster;

/* ---- the picture's size ------------------------------------------------------------------------------------------ */

static void find_bounds(const capsule *list, size_t n, const camera *eye, vec3 *low, vec3 *high) {
    *low = vec3_of(INFINITY, INFINITY, INFINITY);
    *high = vec3_of(-INFINITY, -INFINITY, -INFINITY);
    for (size_t i = 0; i < n; i++)
        for (int end = 0; end < 2; end++) {
            vec3 p = camera_project(eye, end ? list[i].b : list[i].a);
            *low = vec3_of(fmin(low->x, p.x - list[i].r), fmin(low->y, p.y - list[i].r), fmin(low->z, p.z));
            *high = vec3_of(fmax(high->x, p.x + list[i].r), fmax(high->y, p.y + list[i].r), fmax(high->z, p.z));
        }
}

static raster set_raster(const capsule *list, size_t n, const blocks_options *o) {
    vec3 low, high;
    raster r = {.eye = camera_look(o->theta, o->phi, o->columns, 2 * o->rows), .gaps = o->style <= BLOCKS_PLAIN};
    find_bounds(list, n, &r.eye, &low, &high);
    camera_fit(&r.eye, low, high, 1, 1);
    r.eye.scale = fmin(r.eye.scale, scale_most);
    /* no more lines than are needed; the middle stays in the middle */
    r.width = (int)fmin(o->columns, fmax(1, ceil((high.x - low.x) * r.eye.scale)));
    r.height = (int)fmin(2 * o->rows, fmax(2, 2 * ceil(0.5 * (high.y - low.y) * r.eye.scale)));
    r.eye.width = r.width;
    r.eye.height = r.height;
    r.pixels = alloc_zeroed((size_t)r.width * (size_t)r.height, sizeof *r.pixels);
    return r;
}

/* ---- pixels ------------------------------------------------------------------------------------------------------ */

/* A pixel whose centre is at distance d (in radii) from the axis seen from the eye, at this depth of the axis. */
static void put(raster *r, int x, int y, const capsule *c, double d, double depth) {
    pixel *p = &r->pixels[(size_t)y * (size_t)r->width + (size_t)x];
    double lift = sqrt(fmax(0, 1 - d * d));
    if (p->on && p->depth >= depth + c->r * lift)
        return;
    float light = (float)(0.35 + 0.65 * lift);
    /* the rim of a cell hides what is behind it and shows nothing itself: so neighbours stay apart */
    bool rim = r->gaps && d > 0.85 && c->r * r->eye.scale > 2;
    p->on = !rim;
    p->depth = depth + c->r * lift;
    p->color = (rgb){light * c->color.r, light * c->color.g, light * c->color.b};
}

static void draw_capsule(raster *r, const capsule *c) {
    vec3 a = camera_to_pixel(&r->eye, c->a), b = camera_to_pixel(&r->eye, c->b);
    double reach = fmax(c->r * r->eye.scale, 0.75), dx = b.x - a.x, dy = b.y - a.y, length2 = dx * dx + dy * dy;
    int x0 = (int)fmax(0, floor(fmin(a.x, b.x) - reach)), x1 = (int)fmin(r->width, ceil(fmax(a.x, b.x) + reach));
    int y0 = (int)fmax(0, floor(fmin(a.y, b.y) - reach)), y1 = (int)fmin(r->height, ceil(fmax(a.y, b.y) + reach));
    for (int y = y0; y < y1; y++)
        for (int x = x0; x < x1; x++) {
            double px = x + 0.5 - a.x, py = y + 0.5 - a.y;
            double t = length2 > 0 ? fmin(1, fmax(0, (px * dx + py * dy) / length2)) : 0;
            double d = hypot(px - t * dx, py - t * dy) / reach;
            if (d <= 1)
                put(r, x, y, c, d, a.z + t * (b.z - a.z));
        }
}

/* ---- text -------------------------------------------------------------------------------------------------------- */

static int byte_of(float x) {
    return (int)lrintf(255 * fminf(fmaxf(x, 0), 1));
}

/* Index in xterm's cube of 6 x 6 x 6, whose levels are 0, 95, 135, 175, 215, 255. */
static int cube_of(rgb c) {
    const float parts[3] = {c.r, c.g, c.b};
    int index = 16;
    for (int i = 0, weight = 36; i < 3; i++, weight /= 6) {
        int x = byte_of(parts[i]);
        index += weight * (x < 48 ? 0 : x < 115 ? 1 : (x - 35) / 40);
    }
    return index;
}

/* The sequence that sets the colour of what is drawn (ground false) or behind it. */
static int put_color(char *out, size_t room, blocks_style style, rgb linear, bool ground) {
    rgb c = color_to_srgb(linear);
    int which = ground ? 48 : 38;
    if (style == BLOCKS_256)
        return snprintf(out, room, "\033[%d;5;%dm", which, cube_of(c));
    return snprintf(out, room, "\033[%d;2;%d;%d;%dm", which, byte_of(c.r), byte_of(c.g), byte_of(c.b));
}

static void put_plain(FILE *f, blocks_style style, bool upper, bool lower) {
    static const char *const glyphs[2][4] = {{" ", "'", ".", "#"}, {" ", "▀", "▄", "█"}};
    fputs(glyphs[style == BLOCKS_PLAIN][upper + 2 * lower], f);
}

static void put_colored(FILE *f, blocks_style style, const pixel *upper, const pixel *lower) {
    char drawn[32], ground[32] = "";
    if (!upper->on && !lower->on) {
        fputc(' ', f);
        return;
    }
    put_color(drawn, sizeof drawn, style, upper->on ? upper->color : lower->color, false);
    if (upper->on && lower->on)
        put_color(ground, sizeof ground, style, lower->color, true);
    fprintf(f, "%s%s%s\033[0m", drawn, ground, upper->on ? "▀" : "▄");
}

/* Columns of a line up to the last that shows anything. */
static int visible(const raster *r, int y) {
    int n = r->width;
    const pixel *upper = r->pixels + (size_t)y * (size_t)r->width, *lower = upper + r->width;
    while (n > 0 && !upper[n - 1].on && !lower[n - 1].on)
        n--;
    return n;
}

static char *put_lines(const raster *r, blocks_style style) {
    char *text = NULL;
    size_t size;
    FILE *f = open_memstream(&text, &size);
    for (int y = 0; y < r->height; y += 2) {
        const pixel *upper = r->pixels + (size_t)y * (size_t)r->width, *lower = upper + r->width;
        int n = visible(r, y);
        for (int x = 0; x < n; x++)
            if (style >= BLOCKS_256)
                put_colored(f, style, &upper[x], &lower[x]);
            else
                put_plain(f, style, upper[x].on, lower[x].on);
        fputc('\n', f);
    }
    fclose(f);
    return text;
}

char *blocks_draw(const capsule *list, size_t n, const blocks_options *o, double *scale) {
    *scale = 0;
    if (n == 0)
        return alloc_copy("");
    raster r = set_raster(list, n, o);
    for (size_t i = 0; i < n; i++)
        draw_capsule(&r, &list[i]);
    char *text = put_lines(&r, o->style);
    free(r.pixels);
    *scale = r.eye.scale;
    return text;
}

void blocks_mark(blocks_style style, rgb color, char out[48]) {
    int n = style >= BLOCKS_256 ? put_color(out, 40, style, color_to_linear(color), false) : 0;
    snprintf(out + n, 48 - (size_t)n, "%s%s", style == BLOCKS_ASCII ? "#" : "■", style >= BLOCKS_256 ? "\033[0m" : "");
}

char *blocks_scale_bar(blocks_style style, double scale, int most) {
    double length = pow(10, floor(log10(most / scale)));
    length *= 5 * length * scale <= most ? 5 : 2 * length * scale <= most ? 2 : 1;
    int n = (int)fmax(2, rint(length * scale));
    char *bar = alloc_copy(style == BLOCKS_ASCII ? "|" : "├");
    for (int i = 0; i < n - 2; i++) {
        char *longer = alloc_format("%s%s", bar, style == BLOCKS_ASCII ? "-" : "─");
        free(bar);
        bar = longer;
    }
    char *whole = alloc_format("%s%s %g um", bar, style == BLOCKS_ASCII ? "|" : "┤", length);
    free(bar);
    return whole;
}

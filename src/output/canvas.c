/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Letters are those of A. V. Hershey's Simplex Roman strokes (U.S. National Bureau of Standards, 1967; free for any
 * use), drawn as lines with round ends. */
#include "output/canvas.h"

#include "base/alloc.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#if SARCINA_HAVE_IMAGE
#include <png.h>
#endif

canvas *canvas_create(int width, int height, rgb background) {
    canvas *c = alloc_zeroed(1, sizeof *c);
    c->width = width;
    c->height = height;
    c->pixels = alloc_zeroed((size_t)width * (size_t)height, sizeof *c->pixels);
    for (size_t i = 0; i < (size_t)width * (size_t)height; i++)
        c->pixels[i] = background;
    return c;
}

void canvas_free(canvas *c) {
    if (!c)
        return;
    free(c->pixels);
    free(c);
}

static void blend(canvas *c, int x, int y, rgb color, double opacity) {
    rgb *p = &c->pixels[(size_t)y * (size_t)c->width + (size_t)x];
    *p = color_mix(*p, color, (float)opacity);
}

static double clamp01(double x) {
    return x < 0 ? 0 : x > 1 ? 1 : x;
}

static int clamp_to(double x, int most) {
    return x < 0 ? 0 : x > most ? most : (int)x;
}

void canvas_line(canvas *c, double x0, double y0, double x1, double y1, double thickness, rgb color, double opacity) {
    double r = 0.5 * thickness, dx = x1 - x0, dy = y1 - y0, length2 = dx * dx + dy * dy;
    int left = clamp_to(fmin(x0, x1) - r - 1, c->width), right = clamp_to(fmax(x0, x1) + r + 2, c->width);
    int top = clamp_to(fmin(y0, y1) - r - 1, c->height), bottom = clamp_to(fmax(y0, y1) + r + 2, c->height);
    for (int y = top; y < bottom; y++)
        for (int x = left; x < right; x++) {
            double px = x + 0.5 - x0, py = y + 0.5 - y0;
            double t = length2 > 0 ? clamp01((px * dx + py * dy) / length2) : 0;
            double cover = clamp01(r + 0.5 - hypot(px - t * dx, py - t * dy));
            if (cover > 0)
                blend(c, x, y, color, cover * opacity);
        }
}

/* How much of the pixel i lies between a and b. */
static double cover_1d(int i, double a, double b) {
    return clamp01(fmin(b, i + 1.0) - fmax(a, i));
}

void canvas_box(canvas *c, double x0, double y0, double x1, double y1, rgb color, double opacity) {
    int left = clamp_to(floor(x0), c->width), right = clamp_to(ceil(x1), c->width);
    int top = clamp_to(floor(y0), c->height), bottom = clamp_to(ceil(y1), c->height);
    for (int y = top; y < bottom; y++)
        for (int x = left; x < right; x++)
            blend(c, x, y, color, cover_1d(x, x0, x1) * cover_1d(y, y0, y1) * opacity);
}

enum { UP = -99, GLYPH_HEIGHT = 21, GLYPH_POINTS = 64 };

/* Strokes as x, y pairs on a grid where digits are 21 high; UP, UP lifts the pen. */
typedef struct glyph {
    char letter;
    signed char width, points, xy[2 * GLYPH_POINTS];
} glyph;

static const glyph glyphs[] = {
    {'0', 20, 17, {9, 21, 6, 20, 4, 17, 3, 12, 3,  9,  4,  4,  6,  1,  9,  0, 11,
                   0, 14, 1, 16, 4, 17, 9, 17, 12, 16, 17, 14, 20, 11, 21, 9, 21}},
    {'1', 20, 4, {6, 17, 8, 18, 11, 21, 11, 0}},
    {'2', 20, 14, {4,  16, 4,  17, 5,  19, 6,  20, 8,  21, 12, 21, 14, 20,
                   15, 19, 16, 17, 16, 15, 15, 13, 13, 10, 3,  0,  17, 0}},
    {'3', 20, 15, {5, 21, 16, 21, 10, 13, 13, 13, 15, 12, 16, 11, 17, 8, 17,
                   6, 16, 3,  14, 1,  11, 0,  8,  0,  5,  1,  4,  2,  3, 4}},
    {'4', 20, 6, {13, 21, 3, 7, 18, 7, UP, UP, 13, 21, 13, 0}},
    {'5', 20, 17, {15, 21, 5, 21, 4, 12, 5, 13, 8, 14, 11, 14, 14, 13, 16, 11, 17,
                   8,  17, 6, 16, 3, 14, 1, 11, 0, 8,  0,  5,  1,  4,  2,  3,  4}},
    {'6', 20, 23, {16, 18, 15, 20, 12, 21, 10, 21, 7, 20, 5,  17, 4,  12, 4,  7,  5,  3, 7,  1, 10, 0, 11,
                   0,  14, 1,  16, 3,  17, 6,  17, 7, 16, 10, 14, 12, 11, 13, 10, 13, 7, 12, 5, 10, 4, 7}},
    {'7', 20, 5, {17, 21, 7, 0, UP, UP, 3, 21, 17, 21}},
    {'8', 20, 29, {8,  21, 5,  20, 4,  18, 4,  16, 5,  14, 7,  13, 11, 12, 14, 11, 16, 9, 17, 7,
                   17, 4,  16, 2,  15, 1,  12, 0,  8,  0,  5,  1,  4,  2,  3,  4,  3,  7, 4,  9,
                   6,  11, 9,  12, 13, 13, 15, 14, 16, 16, 16, 18, 15, 20, 12, 21, 8,  21}},
    {'9', 20, 23, {16, 14, 15, 11, 13, 9,  10, 8,  9,  8,  6, 9,  4, 11, 3, 14, 3, 15, 4, 18, 6, 20, 9,
                   21, 10, 21, 13, 20, 15, 18, 16, 14, 16, 9, 15, 4, 13, 1, 10, 0, 8,  0, 5,  1, 4,  3}},
    {'.', 10, 5, {5, 2, 4, 1, 5, 0, 6, 1, 5, 2}},
    {'-', 26, 2, {4, 9, 22, 9}},
    {' ', 12, 0, {0}},
    {'e', 18, 17, {3,  8, 15, 8, 15, 10, 14, 12, 13, 13, 11, 14, 8, 14, 6, 13, 4,
                   11, 3, 8,  3, 6,  4,  3,  6,  1,  8,  0,  11, 0, 13, 1, 15, 3}},
    {'k', 17, 8, {4, 21, 4, 0, UP, UP, 14, 14, 4, 4, UP, UP, 8, 8, 15, 0}},
    {'m', 30, 18, {4,  14, 4,  0,  UP, UP, 4,  10, 7,  13, 9,  14, 12, 14, 14, 13, 15, 10,
                   15, 0,  UP, UP, 15, 10, 18, 13, 20, 14, 23, 14, 25, 13, 26, 10, 26, 0}},
    {'n', 19, 10, {4, 14, 4, 0, UP, UP, 4, 10, 7, 13, 9, 14, 12, 14, 14, 13, 15, 10, 15, 0}},
    {'u', 19, 10, {4, 14, 4, -7, UP, UP, 4, 4, 5, 1, 7, 0, 10, 0, 12, 1, 15, 4, 15, 14}},
    {'x', 17, 5, {3, 14, 14, 0, UP, UP, 14, 14, 3, 0}},
    {'y', 16, 9, {2, 14, 8, 0, UP, UP, 14, 14, 8, 0, 6, -4, 4, -6, 2, -7, 1, -7}},
    {'z', 17, 8, {14, 14, 3, 0, UP, UP, 3, 14, 14, 14, UP, UP, 3, 0, 14, 0}},
};

static const glyph *find_glyph(char letter) {
    for (size_t i = 0; i < sizeof glyphs / sizeof *glyphs; i++)
        if (glyphs[i].letter == letter)
            return &glyphs[i];
    return find_glyph(' ');
}

static void draw_glyph(canvas *c, const glyph *g, double x, double y, double scale, rgb color) {
    for (int i = 0; i + 1 < g->points; i++) {
        const signed char *p = g->xy + 2 * i;
        if (p[0] != UP && p[2] != UP)
            canvas_line(c, x + scale * p[0], y - scale * p[1], x + scale * p[2], y - scale * p[3], 2.4 * scale, color,
                        1);
    }
}

void canvas_text(canvas *c, double x, double y, double height, const char *text, rgb color) {
    double scale = height / GLYPH_HEIGHT;
    for (; *text; text++) {
        const glyph *g = find_glyph(*text);
        draw_glyph(c, g, x, y, scale, color);
        x += scale * g->width;
    }
}

double canvas_text_width(const char *text, double height) {
    double width = 0;
    for (; *text; text++)
        width += find_glyph(*text)->width;
    return width * height / GLYPH_HEIGHT;
}

#if SARCINA_HAVE_IMAGE

static png_byte to_byte(float x) {
    return (png_byte)lrintf(255 * fminf(fmaxf(x, 0), 1));
}

int canvas_write_png(const canvas *c, const char *path, diag *d) {
    size_t n = (size_t)c->width * (size_t)c->height;
    png_byte *bytes = alloc_zeroed(3 * n, 1);
    for (size_t i = 0; i < n; i++) {
        bytes[3 * i] = to_byte(c->pixels[i].r);
        bytes[3 * i + 1] = to_byte(c->pixels[i].g);
        bytes[3 * i + 2] = to_byte(c->pixels[i].b);
    }
    png_image image = {.version = PNG_IMAGE_VERSION,
                       .width = (png_uint_32)c->width,
                       .height = (png_uint_32)c->height,
                       .format = PNG_FORMAT_RGB};
    int good = png_image_write_to_file(&image, path, 0, bytes, 0, NULL);
    free(bytes);
    return good ? SARCINA_OK : diag_error(d, "cannot write '%s': %s", path, image.message);
}

#else

int canvas_write_png(const canvas *c, const char *path, diag *d) {
    (void)c, (void)path;
    return diag_error(d, "this build has no pictures: install libpng-dev and libembree-dev and build again");
}

#endif

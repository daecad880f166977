/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "output/canvas.h"

#include "base/alloc.h"
#include "output/glyph.h"

#include <math.h>
#include <stdlib.h>

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

static void draw_glyph(canvas *c, const glyph *g, double x, double y, double scale, rgb color) {
    for (int i = 0; i + 1 < g->points; i++) {
        const signed char *p = g->xy + 2 * i;
        if (p[0] != GLYPH_UP && p[2] != GLYPH_UP)
            canvas_line(c, x + scale * p[0], y - scale * p[1], x + scale * p[2], y - scale * p[3], 2.4 * scale, color,
                        1);
    }
}

void canvas_text(canvas *c, double x, double y, double height, const char *text, rgb color) {
    double scale = height / GLYPH_HEIGHT;
    for (const char *at = text; *at; at++) {
        const glyph *g = glyph_find(text, at);
        draw_glyph(c, g, x, y, scale, color);
        x += scale * g->width;
    }
}

double canvas_text_width(const char *text, double height) {
    double width = 0;
    for (const char *at = text; *at; at++)
        width += glyph_find(text, at)->width;
    return width * height / GLYPH_HEIGHT;
}

static unsigned char to_byte(float x) {
    return (unsigned char)lrintf(255 * fminf(fmaxf(x, 0), 1));
}

unsigned char *canvas_bytes(const canvas *c, size_t *n) {
    size_t pixels = (size_t)c->width * (size_t)c->height;
    unsigned char *bytes = alloc_zeroed(pixels, 3);
    for (size_t i = 0; i < pixels; i++) {
        bytes[3 * i] = to_byte(c->pixels[i].r);
        bytes[3 * i + 1] = to_byte(c->pixels[i].g);
        bytes[3 * i + 2] = to_byte(c->pixels[i].b);
    }
    *n = 3 * pixels;
    return bytes;
}

#if SARCINA_HAVE_IMAGE

int canvas_write_png(const canvas *c, const char *path, diag *d) {
    size_t n;
    unsigned char *bytes = canvas_bytes(c, &n);
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

/* SPDX-License-Identifier: GPL-3.0-or-later */
/* A picture in memory, and what is drawn flat upon it: lines, boxes, text. Places are in pixels from the upper left
 * corner; edges are smoothed by how much of a pixel they cover. */
#ifndef SARCINA_OUTPUT_CANVAS_H
#define SARCINA_OUTPUT_CANVAS_H

#include "base/diag.h"
#include "output/color.h"

typedef struct canvas {
    int width, height;
    rgb *pixels; /* sRGB (height x width), from the upper left corner */
} canvas;

canvas *canvas_create(int width, int height, rgb background);
void canvas_free(canvas *c); /* NULL is allowed */

/* A line with round ends. */
void canvas_line(canvas *c, double x0, double y0, double x1, double y1, double thickness, rgb color, double opacity);

void canvas_box(canvas *c, double x0, double y0, double x1, double y1, rgb color, double opacity);

/* Text in the letters of glyph.h; height is that of a digit, (x, y) the left end of the base line. canvas_text_width:
 * how far it reaches. */
void canvas_text(canvas *c, double x, double y, double height, const char *text, rgb color);
double canvas_text_width(const char *text, double height);

/* Red, green, blue of each pixel, row by row, 8 bits each; *n: how many bytes. The caller frees. */
unsigned char *canvas_bytes(const canvas *c, size_t *n);

/* 8 bits a colour. Fails where the build has no libpng. */
int canvas_write_png(const canvas *c, const char *path, diag *d);

#endif

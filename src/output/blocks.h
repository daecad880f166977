/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Capsules as lines of text for a terminal: each character is two pixels, one above the other, drawn as half blocks in
 * two colours; without colours as blocks or as ASCII. */
#ifndef SARCINA_OUTPUT_BLOCKS_H
#define SARCINA_OUTPUT_BLOCKS_H

#include "output/capsule.h"

#include <stdbool.h>

typedef enum {
    BLOCKS_ASCII, /* # ' . */
    BLOCKS_PLAIN, /* half blocks without colour; neighbours are kept apart by a gap where there is room */
    BLOCKS_256,   /* the colour cube of xterm */
    BLOCKS_RGB    /* 24 bits */
} blocks_style;

typedef struct blocks_options {
    blocks_style style;
    int columns, rows; /* room in characters, at least 1 */
    double theta, phi; /* where the eye is, rad (camera.h) */
} blocks_options;

/* The picture, each line with its end; the caller frees. *scale: characters along a line a um; everything fits in, and
 * a lone cell does not fill the screen. Without capsules the text is empty and the scale 0. */
char *blocks_draw(const capsule *list, size_t n, const blocks_options *o, double *scale);

/* A mark in a colour (sRGB), for legends; then text goes on in the terminal's own. Writes at most 48 bytes. */
void blocks_mark(blocks_style style, rgb color, char out[48]);

/* A bar of a round length, at most `most` characters long, with its length: "├────┤ 2 um". The caller frees. */
char *blocks_scale_bar(blocks_style style, double scale, int most);

#endif

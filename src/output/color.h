/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Colours: names, #rrggbb, maps from numbers, and a palette for what has no order. Components are sRGB in [0, 1]. */
#ifndef SARCINA_OUTPUT_COLOR_H
#define SARCINA_OUTPUT_COLOR_H

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

typedef struct rgb {
    float r, g, b;
} rgb;

/* What base/color_code.h reads; false when text is no colour. */
bool color_parse(const char *text, rgb *out);

/* Maps from [0, 1], by anchors at equal distances. */
typedef struct color_map {
    const char *name, *summary;
    uint8_t anchors;
    uint32_t anchor[12]; /* 0xrrggbb */
} color_map;
extern const color_map color_maps[];
extern const size_t color_map_count;

int color_map_find(const char *name); /* row; -1 */

/* t outside [0, 1] is clamped; NaN is grey. */
rgb color_of(const color_map *m, double t);

/* The i-th colour of a palette whose colours are easily told apart; they come again after the last. */
rgb color_palette(uint64_t i);

/* Linear light, in which colours are shaded and averaged, and back. */
rgb color_to_linear(rgb c);
rgb color_to_srgb(rgb c);

/* A mixture: a for t = 0, b for t = 1. */
rgb color_mix(rgb a, rgb b, float t);
float color_luminance(rgb c);

#endif

/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The maps viridis, plasma, magma, inferno and cividis are those of matplotlib (N. Smith, S. van der Walt, E. Firing;
 * J. Nunez; CC0), coolwarm that of K. Moreland (2009), all as anchors; the palette is a selection of Tableau 20. */
#include "output/color.h"

#include "base/color_code.h"
#include "base/table.h"

#include <math.h>

const color_map color_maps[] = {
    {"viridis",
     "dark blue, green, yellow; even steps to the eye",
     11,
     {0x440154, 0x482475, 0x414487, 0x355f8d, 0x2a788e, 0x21918c, 0x22a884, 0x44bf70, 0x7ad151, 0xbddf26, 0xfde725}},
    {"plasma",
     "blue, red, yellow",
     11,
     {0x0d0887, 0x41049d, 0x6a00a8, 0x8f0da4, 0xb12a90, 0xcc4778, 0xe16462, 0xf2844b, 0xfca636, 0xfcce25, 0xf0f921}},
    {"magma",
     "black, purple, cream",
     11,
     {0x000004, 0x140e36, 0x3b0f70, 0x641a80, 0x8c2981, 0xb73779, 0xde4968, 0xf7705c, 0xfe9f6d, 0xfecf92, 0xfcfdbf}},
    {"inferno",
     "black, red, pale yellow",
     11,
     {0x000004, 0x160b39, 0x420a68, 0x6a176e, 0x932667, 0xbc3754, 0xdd513a, 0xf37819, 0xfca50a, 0xf6d746, 0xfcffa4}},
    {"cividis",
     "blue, grey, yellow; for colour-blind eyes",
     10,
     {0x00224e, 0x123570, 0x3b496c, 0x575d6d, 0x707173, 0x8a8678, 0xa59c74, 0xc3b369, 0xe1cc55, 0xfee838}},
    {"coolwarm",
     "blue, white, red: for what has a middle",
     8,
     {0x3b4cc0, 0x6788ee, 0x9abbff, 0xc9d7f0, 0xedd1c2, 0xf7a889, 0xe26952, 0xb40426}},
    {"gray", "black to white", 2, {0x000000, 0xffffff}},
};
const size_t color_map_count = TABLE_COUNT(color_maps);

static const uint32_t palette[] = {0x4e79a7, 0xf28e2b, 0x59a14f, 0xe15759, 0x76b7b2, 0xedc948,
                                   0xb07aa1, 0xa0cbe8, 0x8cd17d, 0xffbe7d, 0xff9d9a, 0xd4a6c8};

static rgb from_code(uint32_t code) {
    return (rgb){(float)(code >> 16 & 255) / 255, (float)(code >> 8 & 255) / 255, (float)(code & 255) / 255};
}

bool color_parse(const char *text, rgb *out) {
    uint32_t code;
    if (!color_code_read(text, &code))
        return false;
    *out = from_code(code);
    return true;
}

int color_map_find(const char *name) {
    return (int)table_find(color_maps, color_map_count, sizeof *color_maps, name);
}

rgb color_of(const color_map *m, double t) {
    if (isnan(t))
        return (rgb){0.6f, 0.6f, 0.6f};
    double at = fmin(fmax(t, 0), 1) * (m->anchors - 1);
    int i = (int)fmin(floor(at), m->anchors - 2);
    return color_mix(from_code(m->anchor[i]), from_code(m->anchor[i + 1]), (float)(at - i));
}

rgb color_palette(uint64_t i) {
    return from_code(palette[i % TABLE_COUNT(palette)]);
}

static float decode(float x) {
    return x <= 0.04045f ? x / 12.92f : powf((x + 0.055f) / 1.055f, 2.4f);
}

static float encode(float x) {
    x = fminf(fmaxf(x, 0), 1);
    return x <= 0.0031308f ? 12.92f * x : 1.055f * powf(x, 1 / 2.4f) - 0.055f;
}

rgb color_to_linear(rgb c) {
    return (rgb){decode(c.r), decode(c.g), decode(c.b)};
}

rgb color_to_srgb(rgb c) {
    return (rgb){encode(c.r), encode(c.g), encode(c.b)};
}

rgb color_mix(rgb a, rgb b, float t) {
    return (rgb){a.r + t * (b.r - a.r), a.g + t * (b.g - a.g), a.b + t * (b.b - a.b)};
}

float color_luminance(rgb c) {
    return 0.2126f * c.r + 0.7152f * c.g + 0.0722f * c.b;
}

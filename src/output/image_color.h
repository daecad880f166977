/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Which colour each cell of a picture has, and what the colours mean. */
#ifndef SARCINA_OUTPUT_IMAGE_COLOR_H
#define SARCINA_OUTPUT_IMAGE_COLOR_H

#include "output/image.h"

typedef enum {
    KEY_NONE, /* one colour, or labels that have no amount */
    KEY_MAP,  /* numbers from low to high through a map */
    KEY_NAMES /* texts, each its colour */
} image_key_kind;

enum { KEY_NAMES_MAX = 12 };

/* What a legend shows. */
typedef struct image_key {
    image_key_kind kind;
    const char *title; /* the column's; holds while the frame does */
    dim d;
    double low, high; /* SI */
    int map;
    size_t names; /* how many, at most KEY_NAMES_MAX */
    char name[KEY_NAMES_MAX][64];
    rgb color[KEY_NAMES_MAX];
} image_key;

/* Colours of n rows into out (n), and their meaning. */
int image_color_cells(const dump_frame *f, const image_options *o, const uint32_t *rows, size_t n, rgb *out,
                      image_key *key, diag *d);

#endif

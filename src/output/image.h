/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Pictures of the cells. */
#ifndef SARCINA_OUTPUT_IMAGE_H
#define SARCINA_OUTPUT_IMAGE_H

#include "output/canvas.h"
#include "output/dump.h"

/* Not drawn; coloured by the kind of their link; by strain. In the order of the keyword's words. */
typedef enum { IMAGE_SPRINGS_NONE, IMAGE_SPRINGS_KIND, IMAGE_SPRINGS_STRAIN } image_springs;

typedef struct image_options {
    int width, height;     /* pixels */
    double theta, phi;     /* where the eye is, rad (camera.h) */
    double zoom;           /* 1: everything fits in */
    double scalebar;       /* um; 0: none; negative: a round length that suits the picture */
    image_springs springs; /* lines for the springs of links, seen through the cells */
    bool legend;           /* what the colours mean, where they come from numbers or names */
    int fps;               /* of a movie: frames a second */
    bool axes;             /* directions of x, y and z in a corner */
    int map;               /* row of color_maps */
    double low, high;      /* the ends of the map, SI; NaN: least and largest of the cells shown */
    rgb background;        /* sRGB */
    bool has_color;        /* all cells in this colour instead of by column 0 */
    rgb color;             /* sRGB */
    bool has_floor;        /* the substratum */
    double floor_z;        /* um */
} image_options;

/* The keywords of pictures as records of parameters; the row of `map` is that of color_maps. */
#define IMAGE_PARAMS                                                                                                   \
    {"size=800,600:size", "width and height in pixels"},                                                               \
        {"view=top:view", "top, side, front, iso, or two angles: from z, and about z from x"},                         \
        {"zoom=fit:number(0,)", "fit: everything is in the picture; a number magnifies that"},                         \
        {"scalebar=auto:length[0,)", "length of the scale bar; auto: a round length, 0: none"},                        \
        {"axes=no:flag", "arrows along x, y and z in a corner"},                                                       \
        {"springs=no:{no|yes|strain}", "lines for the springs of links: yes: coloured by kind; strain: blue is "       \
                                       "pressed together, red stretched"},                                             \
        {"legend=yes:flag", "a bar or list that says what colours mean that come from numbers or names"},              \
        {"map=viridis:{viridis|plasma|magma|inferno|cividis|coolwarm|gray}",                                           \
         "colours of numbers, from the least to the largest"},                                                         \
        {"range:range2", "the numbers at the ends of the map; otherwise the least and largest of the cells shown"}, {  \
        "background=white:color", "colour of what is not a cell"                                                       \
    }

/* What a style that draws says where this build cannot; NULL: it can. */
#if SARCINA_HAVE_IMAGE
#define IMAGE_MISSING NULL
#else
#define IMAGE_MISSING "this build has no pictures: install libpng-dev and libembree-dev and build again"
#endif

/* 800 x 600, from above, everything in, viridis, white, a scale bar; no floor. */
image_options image_defaults(void);

/* The picture of a frame; the caller frees it. Column 0 gives the colours: texts and the values generation, founder,
 * parent, id and cluster from a palette (species: each its own colour), other numbers through the map; undefined is
 * grey. */
int image_draw(const dump_frame *f, const image_options *o, canvas **out, diag *d);

#endif

/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Letters as strokes of a pen, after A. V. Hershey's Simplex Roman (U.S. National Bureau of Standards, 1967; free for
 * any use), for pictures. */
#ifndef SARCINA_OUTPUT_GLYPH_H
#define SARCINA_OUTPUT_GLYPH_H

enum { GLYPH_UP = -99, GLYPH_HEIGHT = 21, GLYPH_POINTS = 64, GLYPH_MU = 1 };

/* Strokes as x, y pairs on a grid where digits are 21 high; GLYPH_UP, GLYPH_UP lifts the pen. */
typedef struct glyph {
    char letter; /* GLYPH_MU: the Greek letter */
    signed char width, points, xy[2 * GLYPH_POINTS];
} glyph;

/* The glyph of the first letter of text, which begins at `start`; a letter that is none of ours is drawn as the small
 * one, or not. "um" at the beginning of a word has a mu. */
const glyph *glyph_find(const char *start, const char *text);

#endif

/* SPDX-License-Identifier: GPL-3.0-or-later */
/* What is drawn flat over a picture of cells: springs, the scale bar, axes, what the colours mean. */
#ifndef SARCINA_OUTPUT_IMAGE_OVERLAY_H
#define SARCINA_OUTPUT_IMAGE_OVERLAY_H

#include "output/camera.h"
#include "output/image_color.h"

/* Pixels at the right side of a picture that the legend wants for itself: at most a third of the width. */
double image_overlay_margin(const dump_frame *f, const image_options *o, const image_key *key);

void image_overlay_draw(canvas *c, const dump_frame *f, const camera *eye, const image_options *o,
                        const image_key *key);

#endif

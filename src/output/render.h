/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Capsules, lit, as a picture. */
#ifndef SARCINA_OUTPUT_RENDER_H
#define SARCINA_OUTPUT_RENDER_H

#include "output/camera.h"
#include "output/canvas.h"
#include "output/capsule.h"

/* All that is seen; owned by the caller. */
typedef struct stage {
    const capsule *list;
    size_t count;
    camera eye;
    rgb background; /* linear light */
    bool has_floor; /* a plane of constant z that takes shadows */
    double floor_z;
    vec3 middle;   /* of the capsules, um */
    double radius; /* of a ball around them, um */
} stage;

size_t render_pixel_bytes(void); /* what a pixel takes while it is drawn */

/* Fills the canvas, whose size is that of the stage's camera. The bits do not depend on the number of threads. */
int render_stage(const stage *s, canvas *out, int threads, diag *d);

#endif

/* SPDX-License-Identifier: GPL-3.0-or-later */
/* A picture before it is drawn: coloured capsules, and the camera that looks at them. For what draws them otherwise. */
#ifndef SARCINA_OUTPUT_IMAGE_SCENE_H
#define SARCINA_OUTPUT_IMAGE_SCENE_H

#include "output/image_color.h"
#include "output/render.h"

typedef struct image_scene {
    capsule *list; /* (stage.count) */
    stage stage;
    image_key key;
} image_scene;

/* Free with image_release, also after an error. */
int image_set(const dump_frame *f, const image_options *o, image_scene *out, diag *d);
void image_release(image_scene *s);

#endif

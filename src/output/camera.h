/* SPDX-License-Identifier: GPL-3.0-or-later */
/* A parallel projection: where the eye is, and what of space becomes which pixel. */
#ifndef SARCINA_OUTPUT_CAMERA_H
#define SARCINA_OUTPUT_CAMERA_H

#include "base/vec3.h"

/* The eye looks against `toward` from far away; lengths in um. */
typedef struct camera {
    vec3 right, up, toward; /* unit vectors of the picture */
    vec3 centre;            /* what is in the middle of it */
    int width, height;      /* pixels */
    double scale;           /* pixels per um */
} camera;

/* Angles as LAMMPS's `dump image view`: theta from z (0: from above), phi of the eye about z, from x; radians. z is up
 * in the picture. Named views are top (x right, y up), side (x right, z up), front (y right, z up), iso. */
typedef struct camera_view {
    const char *name, *summary;
    double theta, phi;
} camera_view;
extern const camera_view camera_views[];
extern const int camera_view_count;

/* Looks at the box low..high in the picture's own axes (right, up, toward; see camera_project), filling fill of the
 * picture's width or height, times zoom. */
camera camera_look(double theta, double phi, int width, int height);
void camera_fit(camera *c, vec3 low, vec3 high, double fill, double zoom);

/* Components of a vector along right, up and toward. */
vec3 camera_project(const camera *c, vec3 a);

/* Pixel coordinates (from the upper left corner) and depth (towards the eye, um from the middle) of a point. */
vec3 camera_to_pixel(const camera *c, vec3 p);

/* The point of the middle plane behind a place of the picture. */
vec3 camera_from_pixel(const camera *c, double x, double y);

#endif

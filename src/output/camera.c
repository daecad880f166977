/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "output/camera.h"

#include <math.h>

const camera_view camera_views[] = {
    {"top", "from above: x to the right, y up", 0, -M_PI / 2},
    {"side", "along -x: y to the right, z up", M_PI / 2, 0},
    {"front", "along y: x to the right, z up", M_PI / 2, -M_PI / 2},
    {"iso", "along the space diagonal: all three axes equally long", 0.95531661812450928, -M_PI / 4},
};
const int camera_view_count = sizeof camera_views / sizeof camera_views[0];

camera camera_look(double theta, double phi, int width, int height) {
    double st = sin(theta), ct = cos(theta), sp = sin(phi), cp = cos(phi);
    camera c = {.width = width, .height = height, .scale = 1};
    c.toward = vec3_of(st * cp, st * sp, ct);
    c.right = vec3_of(-sp, cp, 0);
    c.up = vec3_cross(c.toward, c.right);
    return c;
}

void camera_fit(camera *c, vec3 low, vec3 high, double fill, double zoom) {
    vec3 middle = vec3_scale(0.5, vec3_add(low, high));
    c->centre = vec3_axpy(vec3_axpy(vec3_scale(middle.x, c->right), middle.y, c->up), middle.z, c->toward);
    c->scale = zoom * fill * fmin(c->width / (high.x - low.x), c->height / (high.y - low.y));
}

vec3 camera_project(const camera *c, vec3 a) {
    return vec3_of(vec3_dot(a, c->right), vec3_dot(a, c->up), vec3_dot(a, c->toward));
}

vec3 camera_to_pixel(const camera *c, vec3 p) {
    vec3 a = camera_project(c, vec3_sub(p, c->centre));
    return vec3_of(0.5 * c->width + c->scale * a.x, 0.5 * c->height - c->scale * a.y, a.z);
}

vec3 camera_from_pixel(const camera *c, double x, double y) {
    double right = (x - 0.5 * c->width) / c->scale, up = (0.5 * c->height - y) / c->scale;
    return vec3_axpy(vec3_axpy(c->centre, right, c->right), up, c->up);
}

/* SPDX-License-Identifier: GPL-3.0-or-later */
/* One sample a pixel, then nine more where neighbouring pixels show different things or brightness: edges are smooth
 * and the rest is fast. Light: a key light over the viewer's left shoulder with soft shadows, an even sky that
 * neighbours hide from each other (capsule.c), and surfaces that darken where they turn away from the eye, which draws
 * a fine line around each cell. */
#include "output/render.h"

#include "base/alloc.h"
#include "output/trace.h"

#include <math.h>
#include <stdlib.h>

enum { FINE_SAMPLES = 9, LIGHTS = 9, KEY = 4 /* the middle one of the lights */ };

/* What a sample shows. */
typedef struct sample {
    rgb color;      /* linear */
    uint32_t thing; /* owner of the capsule; FLOOR, NOTHING */
} sample;

/* How open the sky is to what has been seen within one pixel: smooth, so that once for each thing is enough. */
typedef struct openness {
    int count;
    uint32_t thing[4];
    double open[4];
} openness;

#define FLOOR (CAPSULE_NO_OWNER - 1)
#define NOTHING CAPSULE_NO_OWNER

typedef struct renderer {
    const stage *s;
    trace *t;
    capsule_shade *shade;
    vec3 light[LIGHTS]; /* directions over the face of the key light */
    vec3 sky;           /* where the sky is brightest */
} renderer;

static vec3 unit(vec3 a) {
    return vec3_scale(1 / vec3_norm(a), a);
}

/* The key light's directions: a disc of 5 degrees, three by three. */
static void place_lights(renderer *r) {
    const camera *e = &r->s->eye;
    vec3 key = unit(vec3_add(vec3_axpy(vec3_scale(-0.55, e->right), 0.65, e->up), vec3_scale(1.0, e->toward)));
    vec3 side = unit(vec3_cross(key, e->up)), over = vec3_cross(side, key);
    for (int i = 0; i < LIGHTS; i++) {
        int column = i % 3 - 1, row = i / 3 - 1;
        r->light[i] = unit(vec3_axpy(vec3_axpy(key, 0.05 * column, side), 0.05 * row, over));
    }
    r->sky = unit(vec3_add(vec3_scale(0.5, e->up), e->toward));
}

/* Is p lit from the i-th direction of the key light? Nothing shades what is well outside of the colony. */
static bool is_lit(const renderer *r, vec3 p, vec3 n, int i) {
    vec3 from_middle = vec3_sub(p, r->s->middle);
    double outside = 1.5 * r->s->radius + 1;
    if (vec3_dot(from_middle, from_middle) > outside * outside)
        return true;
    return vec3_dot(n, r->light[i]) > 0 && !trace_blocked(r->t, vec3_axpy(p, 2e-3, n), r->light[i]);
}

static rgb scaled(rgb c, double s) {
    return (rgb){(float)s * c.r, (float)s * c.g, (float)s * c.b};
}

static double open_at(const renderer *r, vec3 p, vec3 n, uint32_t thing, openness *known) {
    for (int i = 0; i < known->count; i++)
        if (known->thing[i] == thing)
            return known->open[i];
    double open = capsule_shade_open(r->shade, p, n, thing);
    if (known->count < 4) {
        known->thing[known->count] = thing;
        known->open[known->count++] = open;
    }
    return open;
}

static rgb surface_color(const renderer *r, uint32_t row, vec3 p, int light_row, openness *known) {
    const capsule *c = &r->s->list[row];
    vec3 n = unit(vec3_sub(p, capsule_nearest(c, p)));
    double open = open_at(r, p, n, c->owner, known);
    if (r->s->has_floor) /* the floor hides half of the sky from what looks down, but throws light back */
        open *= 1 - 0.25 * (1 - n.z);
    double facing = fmax(0, vec3_dot(n, r->s->eye.toward)), key = fmax(0, vec3_dot(n, r->light[KEY]));
    double light = key > 0 ? key * is_lit(r, p, n, light_row) : 0;
    double sky = (0.62 + 0.38 * vec3_dot(n, r->sky)) * (0.25 + 0.75 * open);
    vec3 half = unit(vec3_add(r->light[KEY], r->s->eye.toward));
    double gloss = light > 0 ? 0.10 * light * pow(fmax(0, vec3_dot(n, half)), 60) : 0;
    double rim = 1 - 0.5 * pow(1 - facing, 2.2);
    rgb color = scaled(c->color, (0.66 * sky + 0.70 * light * (0.4 + 0.6 * open)) * rim);
    return (rgb){color.r + (float)gloss, color.g + (float)gloss, color.b + (float)gloss};
}

/* The floor where shadows fall on it; seen from the side it is a sheet that fades into the background. */
static rgb floor_color(const renderer *r, vec3 p, int light_row, openness *known) {
    const stage *s = r->s;
    const vec3 up = {0, 0, 1};
    double open = open_at(r, p, up, FLOOR, known);
    double far = hypot(p.x - s->middle.x, p.y - s->middle.y) / (1.5 * s->radius);
    double slant = 1 - fabs(s->eye.toward.z), sheet = far < 1 ? slant * (1 - far * far) : 0;
    double light = 0.6 * open + 0.4 * is_lit(r, p, up, light_row);
    return scaled(s->background, (1 - 0.10 * sheet) * pow(light, 0.8));
}

/* Where the ray meets the floor from above. */
static bool meet_floor(const stage *s, vec3 from, vec3 *p) {
    if (!s->has_floor || s->eye.toward.z < 1e-3)
        return false;
    double t = (from.z - s->floor_z) / s->eye.toward.z;
    *p = vec3_axpy(from, -t, s->eye.toward);
    return true;
}

/* What stands at a place of the picture; light_row chooses the direction of the key light. */
static sample look(const renderer *r, double x, double y, int light_row, openness *known) {
    const stage *s = r->s;
    vec3 from = vec3_axpy(camera_from_pixel(&s->eye, x, y), 2 * s->radius + 10, s->eye.toward), p;
    uint32_t row;
    if (trace_hit(r->t, from, vec3_scale(-1, s->eye.toward), &row, &p))
        return (sample){surface_color(r, row, p, light_row, known), s->list[row].owner};
    if (meet_floor(s, from, &p))
        return (sample){floor_color(r, p, light_row, known), FLOOR};
    if (s->has_floor && s->eye.toward.z < 1e-3 && from.z < s->floor_z) /* the floor cut through, seen edge-on */
        return (sample){scaled(s->background, 0.80), FLOOR};
    return (sample){s->background, NOTHING};
}

static bool differ(const sample *a, const sample *b) {
    float x = sqrtf(color_luminance(a->color)), y = sqrtf(color_luminance(b->color)); /* nearly as the eye sees it */
    return a->thing != b->thing || fabsf(x - y) > 0.12f;
}

/* Does a pixel differ from one of its four neighbours? */
static bool is_edge(const sample *all, int width, int height, int x, int y) {
    const sample *here = &all[(size_t)y * (size_t)width + (size_t)x];
    return (x > 0 && differ(here, here - 1)) || (x + 1 < width && differ(here, here + 1)) ||
           (y > 0 && differ(here, here - width)) || (y + 1 < height && differ(here, here + width));
}

/* Takes even places in (0, 1) to places around the middle of a pixel that thin out linearly over its neighbours. */
static double tent(double u) {
    return 0.5 + (u < 0.5 ? sqrt(2 * u) - 1 : 1 - sqrt(2 - 2 * u));
}

/* The mean of nine samples, no two in one row or column, each with its own direction of the light. */
static rgb look_closely(const renderer *r, int x, int y) {
    rgb sum = {0, 0, 0};
    openness known = {0};
    for (int k = 0; k < FINE_SAMPLES; k++) {
        double u = (k + 0.5) / FINE_SAMPLES, v = (4 * k % FINE_SAMPLES + 0.5) / FINE_SAMPLES;
        rgb c = look(r, x + tent(u), y + tent(v), k % LIGHTS, &known).color;
        sum = (rgb){sum.r + c.r, sum.g + c.g, sum.b + c.b};
    }
    return scaled(sum, 1.0 / FINE_SAMPLES);
}

size_t render_pixel_bytes(void) {
    return sizeof(sample) + sizeof(*((canvas *)NULL)->pixels);
}

static void render_pixels(const renderer *r, canvas *out, int threads) {
    int width = out->width, height = out->height;
    sample *all = alloc_zeroed((size_t)width * (size_t)height, sizeof *all);
#pragma omp parallel for schedule(dynamic, 8) num_threads(threads)
    for (int y = 0; y < height; y++)
        for (int x = 0; x < width; x++) {
            openness known = {0};
            all[(size_t)y * (size_t)width + (size_t)x] = look(r, x + 0.5, y + 0.5, KEY, &known);
        }
#pragma omp parallel for schedule(dynamic, 8) num_threads(threads)
    for (int y = 0; y < height; y++)
        for (int x = 0; x < width; x++) {
            size_t i = (size_t)y * (size_t)width + (size_t)x;
            rgb c = is_edge(all, width, height, x, y) ? look_closely(r, x, y) : all[i].color;
            out->pixels[i] = color_to_srgb(c);
        }
    free(all);
}

int render_stage(const stage *s, canvas *out, int threads, diag *d) {
    renderer r = {.s = s, .t = trace_create(s->list, s->count, s->middle, s->eye.toward, d)};
    if (!r.t)
        return SARCINA_ERROR;
    double widest = 0;
    for (size_t i = 0; i < s->count; i++)
        widest = fmax(widest, 2 * s->list[i].r);
    r.shade = capsule_shade_create(s->list, s->count, 1.5 * widest);
    place_lights(&r);
    render_pixels(&r, out, threads > 0 ? threads : 1);
    capsule_shade_free(r.shade);
    trace_free(r.t);
    return SARCINA_OK;
}

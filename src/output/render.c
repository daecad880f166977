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

enum { FINE_SAMPLES = 9, LIGHTS = 9 };

/* What a sample shows. */
typedef struct sample {
    rgb color;      /* linear */
    uint32_t thing; /* owner of the capsule; FLOOR, NOTHING */
} sample;

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

/* Part of the key light's face that is seen from p: of its nine directions those from `first`, every `stride`-th.
 * Nothing shades what is well outside of the colony. */
static double lit(const renderer *r, vec3 p, vec3 n, int first, int stride) {
    vec3 from_middle = vec3_sub(p, r->s->middle);
    double outside = 1.5 * r->s->radius + 1;
    if (vec3_dot(from_middle, from_middle) > outside * outside)
        return 1;
    int seen = 0, asked = 0;
    for (int i = first; i < LIGHTS; i += stride) {
        asked++;
        if (vec3_dot(n, r->light[i]) > 0)
            seen += !trace_blocked(r->t, vec3_axpy(p, 2e-3, n), r->light[i]);
    }
    return (double)seen / asked;
}

static rgb scaled(rgb c, double s) {
    return (rgb){(float)s * c.r, (float)s * c.g, (float)s * c.b};
}

static rgb surface_color(const renderer *r, uint32_t row, vec3 p, int first, int stride) {
    const capsule *c = &r->s->list[row];
    vec3 n = unit(vec3_sub(p, capsule_nearest(c, p)));
    double open = capsule_shade_open(r->shade, p, n, c->owner);
    if (r->s->has_floor) /* the floor hides half of the sky from what looks down, but throws light back */
        open *= 1 - 0.25 * (1 - n.z);
    double facing = fmax(0, vec3_dot(n, r->s->eye.toward)), key = fmax(0, vec3_dot(n, r->light[4]));
    double light = key > 0 ? key * lit(r, p, n, first, stride) : 0;
    double sky = (0.62 + 0.38 * vec3_dot(n, r->sky)) * open;
    vec3 half = unit(vec3_add(r->light[4], r->s->eye.toward));
    double gloss = light > 0 ? 0.10 * light * pow(fmax(0, vec3_dot(n, half)), 60) : 0;
    double rim = 1 - 0.5 * pow(1 - facing, 2.2);
    rgb color = scaled(c->color, (0.66 * sky + 0.70 * light * (0.4 + 0.6 * open)) * rim);
    return (rgb){color.r + (float)gloss, color.g + (float)gloss, color.b + (float)gloss};
}

/* The floor where shadows fall on it; seen from the side it is a sheet that fades into the background. */
static rgb floor_color(const renderer *r, vec3 p, int first, int stride) {
    const stage *s = r->s;
    const vec3 up = {0, 0, 1};
    double open = capsule_shade_open(r->shade, p, up, CAPSULE_NO_OWNER);
    double far = hypot(p.x - s->middle.x, p.y - s->middle.y) / (1.5 * s->radius);
    double slant = 1 - fabs(s->eye.toward.z), sheet = far < 1 ? slant * (1 - far * far) : 0;
    double light = 0.6 * open + 0.4 * lit(r, p, up, first, stride);
    return scaled(s->background, (1 - 0.10 * sheet) * sqrt(light));
}

/* Where the ray meets the floor from above. */
static bool meet_floor(const stage *s, vec3 from, vec3 *p) {
    if (!s->has_floor || s->eye.toward.z < 1e-3)
        return false;
    double t = (from.z - s->floor_z) / s->eye.toward.z;
    *p = vec3_axpy(from, -t, s->eye.toward);
    return true;
}

/* What stands at a place of the picture; `first` and `stride` choose directions of the key light. */
static sample look(const renderer *r, double x, double y, int first, int stride) {
    const stage *s = r->s;
    vec3 from = vec3_axpy(camera_from_pixel(&s->eye, x, y), 2 * s->radius + 10, s->eye.toward), p;
    uint32_t row;
    if (trace_hit(r->t, from, vec3_scale(-1, s->eye.toward), &row, &p))
        return (sample){surface_color(r, row, p, first, stride), s->list[row].owner};
    if (meet_floor(s, from, &p))
        return (sample){floor_color(r, p, first, stride), FLOOR};
    if (s->has_floor && s->eye.toward.z < 1e-3 && from.z < s->floor_z) /* the floor cut through, seen edge-on */
        return (sample){scaled(s->background, 0.80), FLOOR};
    return (sample){s->background, NOTHING};
}

static bool differ(const sample *a, const sample *b) {
    float x = sqrtf(color_luminance(a->color)), y = sqrtf(color_luminance(b->color)); /* nearly as the eye sees it */
    return a->thing != b->thing || fabsf(x - y) > 0.12f;
}

static bool is_edge(const sample *all, int width, int height, int x, int y) {
    const sample *here = &all[(size_t)y * (size_t)width + (size_t)x];
    for (int j = y > 0 ? y - 1 : y; j <= y + 1 && j < height; j++)
        for (int i = x > 0 ? x - 1 : x; i <= x + 1 && i < width; i++)
            if (differ(here, &all[(size_t)j * (size_t)width + (size_t)i]))
                return true;
    return false;
}

/* Takes even places in (0, 1) to places around the middle of a pixel that thin out linearly over its neighbours. */
static double tent(double u) {
    return 0.5 + (u < 0.5 ? sqrt(2 * u) - 1 : 1 - sqrt(2 - 2 * u));
}

/* The mean of nine samples, no two in one row or column, each with its own direction of the light. */
static rgb look_closely(const renderer *r, int x, int y) {
    rgb sum = {0, 0, 0};
    for (int k = 0; k < FINE_SAMPLES; k++) {
        double u = (k + 0.5) / FINE_SAMPLES, v = (4 * k % FINE_SAMPLES + 0.5) / FINE_SAMPLES;
        rgb c = look(r, x + tent(u), y + tent(v), k, LIGHTS).color;
        sum = (rgb){sum.r + c.r, sum.g + c.g, sum.b + c.b};
    }
    return scaled(sum, 1.0 / FINE_SAMPLES);
}

static void render_pixels(const renderer *r, canvas *out, int threads) {
    int width = out->width, height = out->height;
    sample *all = alloc_zeroed((size_t)width * (size_t)height, sizeof *all);
#pragma omp parallel for schedule(dynamic, 8) num_threads(threads)
    for (int y = 0; y < height; y++)
        for (int x = 0; x < width; x++)
            all[(size_t)y * (size_t)width + (size_t)x] = look(r, x + 0.5, y + 0.5, 0, LIGHTS - 1);
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
    r.shade = capsule_shade_create(s->list, s->count, widest);
    place_lights(&r);
    render_pixels(&r, out, threads > 0 ? threads : 1);
    capsule_shade_free(r.shade);
    trace_free(r.t);
    return SARCINA_OK;
}

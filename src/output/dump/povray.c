/* SPDX-License-Identifier: GPL-3.0-or-later */
/* A scene for POV-Ray 3.7: the camera, colours and floor of `dump image`, for those who want other light. A capsule is
 * a union of a cylinder and two spheres; lengths are um. */
#include "output/dump/styles.h"

#include "base/table.h"
#include "output/image_scene.h"

#include <math.h>

static const param params[] = {IMAGE_PARAMS};

static void put_vector(FILE *out, vec3 a) {
    fprintf(out, "<%.9g,%.9g,%.9g>", a.x + 0.0, a.y + 0.0, a.z + 0.0);
}

static void put_color(FILE *out, rgb linear) {
    fprintf(out, "rgb <%.6g,%.6g,%.6g>", (double)linear.r, (double)linear.g, (double)linear.b);
}

/* Parallel rays: the vectors right and up span the picture. */
static void put_camera(const stage *s, FILE *out) {
    const camera *e = &s->eye;
    double away = 3 * s->radius + 100;
    fputs("camera {\n  orthographic\n  location ", out);
    put_vector(out, vec3_axpy(e->centre, away, e->toward));
    fputs("\n  direction ", out);
    put_vector(out, vec3_scale(-1, e->toward));
    fputs("\n  right ", out);
    put_vector(out, vec3_scale(e->width / e->scale, e->right));
    fputs("\n  up ", out);
    put_vector(out, vec3_scale(e->height / e->scale, e->up));
    fputs("\n}\n", out);
}

/* The key light over the viewer's left shoulder, a weak one from the other side, and the sky. */
static void put_light(const stage *s, FILE *out) {
    const camera *e = &s->eye;
    double away = 20 * s->radius + 1000;
    vec3 key = vec3_add(vec3_axpy(vec3_scale(-0.55, e->right), 0.65, e->up), e->toward);
    vec3 fill = vec3_add(vec3_scale(0.8, e->right), e->toward);
    fputs("light_source { ", out);
    put_vector(out, vec3_axpy(s->middle, away, key));
    fprintf(out, " rgb 0.75 parallel point_at ");
    put_vector(out, s->middle);
    fputs(" }\nlight_source { ", out);
    put_vector(out, vec3_axpy(s->middle, away, fill));
    fputs(" rgb 0.3 shadowless parallel point_at ", out);
    put_vector(out, s->middle);
    fputs(" }\nbackground { ", out);
    put_color(out, s->background);
    fputs(" }\n", out);
}

static void put_capsule(const capsule *c, FILE *out) {
    bool ball = c->a.x == c->b.x && c->a.y == c->b.y && c->a.z == c->b.z;
    if (ball) {
        fputs("sphere { ", out);
        put_vector(out, c->a);
        fprintf(out, ", %.9g", c->r);
    } else {
        fputs("union { cylinder { ", out);
        put_vector(out, c->a);
        fputs(", ", out);
        put_vector(out, c->b);
        fprintf(out, ", %.9g } sphere { ", c->r);
        put_vector(out, c->a);
        fprintf(out, ", %.9g } sphere { ", c->r);
        put_vector(out, c->b);
        fprintf(out, ", %.9g }", c->r);
    }
    fputs(" pigment { ", out);
    put_color(out, c->color);
    fputs(" } finish { cell } }\n", out);
}

static int write(const dump_frame *f, FILE *out, diag *d) {
    const image_options *o = f->options;
    image_scene s;
    int status = image_set(f, o, &s, d);
    if (!status) {
        fprintf(out,
                "// povray +I<this file> +W%d +H%d +A0.1\n#version 3.7;\nglobal_settings { assumed_gamma 1.0 }\n"
                "#declare cell = finish { ambient 0.18 diffuse 0.75 phong 0.15 phong_size 60 }\n",
                o->width, o->height);
        put_camera(&s.stage, out);
        put_light(&s.stage, out);
        if (s.stage.has_floor) {
            fprintf(out, "plane { <0,0,1>, %.9g pigment { ", s.stage.floor_z);
            put_color(out, s.stage.background);
            fputs(" } finish { ambient 0.35 diffuse 0.65 } }\n", out);
        }
        for (size_t i = 0; i < s.stage.count; i++)
            put_capsule(&s.list[i], out);
    }
    image_release(&s);
    return status;
}

const dump_style dump_povray = {
    .name = "povray",
    .summary = "a scene for the ray tracer POV-Ray, with the camera and colours of image",
    .details = "Render it with: povray +IFILE +W800 +H600 +A0.1. Lengths are in um. What image draws flat over the "
               "picture (scale bar, axes, springs, legend) is not in it.",
    .example =
        "dump scene all povray 10 colony.*.pov species size 400 300 view iso zoom 1.2 scalebar 0 axes no springs "
        "no legend no map plasma range 0 8 background black",
    .now_example = "write_dump all povray colony.pov z size 400 300 view 60degree 30degree zoom 1.2 scalebar 0 axes no "
                   "springs no legend no map cividis range 0 2um background '#102030'",
    .takes = DUMP_COLOR,
    .params = params,
    .nparams = TABLE_COUNT(params),
    .write = write,
};

/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Rods are Embree's round linear curves (a segment swept by a ball), balls its sphere points. Rays along the axis of a
 * curve miss it, so a rod that the eye sees nearly end-on has balls at its ends as well. Embree computes in single
 * precision: coordinates are taken from the scene's middle, and places are put back on the surface in double. */
#include "output/trace.h"

#include "base/alloc.h"

#include <math.h>
#include <stdlib.h>

#if SARCINA_HAVE_IMAGE

#include <embree3/rtcore.h>
#include <fenv.h>

struct trace {
    const capsule *list;
    vec3 origin;
    RTCDevice device;
    RTCScene scene;
    uint32_t *rows[2]; /* capsule of each primitive, by kind */
    unsigned ids[2];   /* Embree's name of each kind */
};

enum { RODS, BALLS };

/* A primitive: the row of its capsule, and which of its ends is the first vertex. */
typedef struct part {
    uint32_t row;
    bool from_b;
} part;

static bool is_ball(const capsule *c) {
    vec3 d = vec3_sub(c->b, c->a);
    return vec3_dot(d, d) <= 1e-12 * c->r * c->r;
}

static bool is_end_on(const capsule *c, vec3 eye) {
    vec3 d = vec3_sub(c->b, c->a);
    return fabs(vec3_dot(d, eye)) > 0.95 * vec3_norm(d);
}

/* The primitives of one kind, into parts (2 n of room); returns how many. */
static size_t list_parts(const trace *t, size_t n, int kind, vec3 eye, part *parts) {
    size_t count = 0;
    for (uint32_t i = 0; i < n; i++) {
        bool ball = is_ball(&t->list[i]), ends = !ball && kind == BALLS && is_end_on(&t->list[i], eye);
        if (ball == (kind == BALLS) || ends)
            parts[count++] = (part){i, false};
        if (ends)
            parts[count++] = (part){i, true};
    }
    return count;
}

static void put_vertex(float *v, vec3 p, vec3 origin, double r) {
    v[0] = (float)(p.x - origin.x);
    v[1] = (float)(p.y - origin.y);
    v[2] = (float)(p.z - origin.z);
    v[3] = (float)r;
}

static RTCGeometry make_balls(const trace *t, const part *parts, size_t count) {
    RTCGeometry g = rtcNewGeometry(t->device, RTC_GEOMETRY_TYPE_SPHERE_POINT);
    float *v = rtcSetNewGeometryBuffer(g, RTC_BUFFER_TYPE_VERTEX, 0, RTC_FORMAT_FLOAT4, 4 * sizeof *v, count);
    for (size_t i = 0; i < count; i++) {
        const capsule *c = &t->list[parts[i].row];
        put_vertex(v + 4 * i, parts[i].from_b ? c->b : c->a, t->origin, c->r);
    }
    return g;
}

static RTCGeometry make_rods(const trace *t, const part *parts, size_t count) {
    RTCGeometry g = rtcNewGeometry(t->device, RTC_GEOMETRY_TYPE_ROUND_LINEAR_CURVE);
    float *v = rtcSetNewGeometryBuffer(g, RTC_BUFFER_TYPE_VERTEX, 0, RTC_FORMAT_FLOAT4, 4 * sizeof *v, 2 * count);
    unsigned *index = rtcSetNewGeometryBuffer(g, RTC_BUFFER_TYPE_INDEX, 0, RTC_FORMAT_UINT, sizeof *index, count);
    for (size_t i = 0; i < count; i++) {
        const capsule *c = &t->list[parts[i].row];
        put_vertex(v + 8 * i, c->a, t->origin, c->r);
        put_vertex(v + 8 * i + 4, c->b, t->origin, c->r);
        index[i] = (unsigned)(2 * i);
    }
    return g;
}

static void add_kind(trace *t, size_t n, int kind, vec3 eye) {
    part *parts = alloc_zeroed(2 * n, sizeof *parts);
    size_t count = list_parts(t, n, kind, eye, parts);
    t->ids[kind] = RTC_INVALID_GEOMETRY_ID;
    t->rows[kind] = alloc_zeroed(count, sizeof(uint32_t));
    for (size_t i = 0; i < count; i++)
        t->rows[kind][i] = parts[i].row;
    if (count) {
        RTCGeometry g = kind == BALLS ? make_balls(t, parts, count) : make_rods(t, parts, count);
        rtcCommitGeometry(g);
        t->ids[kind] = rtcAttachGeometry(t->scene, g);
        rtcReleaseGeometry(g);
    }
    free(parts);
}

trace *trace_create(const capsule *list, size_t n, vec3 origin, vec3 eye, diag *d) {
    /* pictures must not change the mode in which the mechanics compute */
    fenv_t mode;
    fegetenv(&mode);
    trace *t = alloc_zeroed(1, sizeof *t);
    t->list = list;
    t->origin = origin;
    t->device = rtcNewDevice("threads=1");
    if (t->device) {
        t->scene = rtcNewScene(t->device);
        rtcSetSceneFlags(t->scene, RTC_SCENE_FLAG_ROBUST);
        add_kind(t, n, RODS, eye);
        add_kind(t, n, BALLS, eye);
        rtcCommitScene(t->scene);
    }
    bool failed = !t->device || rtcGetDeviceError(t->device) != RTC_ERROR_NONE;
    fesetenv(&mode);
    if (!failed)
        return t;
    trace_free(t);
    diag_error(d, "Embree cannot build the picture");
    return NULL;
}

void trace_free(trace *t) {
    if (!t)
        return;
    if (t->scene)
        rtcReleaseScene(t->scene);
    if (t->device)
        rtcReleaseDevice(t->device);
    free(t->rows[RODS]);
    free(t->rows[BALLS]);
    free(t);
}

static struct RTCRay make_ray(const trace *t, vec3 from, vec3 direction) {
    vec3 o = vec3_sub(from, t->origin);
    return (struct RTCRay){.org_x = (float)o.x,
                           .org_y = (float)o.y,
                           .org_z = (float)o.z,
                           .dir_x = (float)direction.x,
                           .dir_y = (float)direction.y,
                           .dir_z = (float)direction.z,
                           .tfar = INFINITY,
                           .mask = ~0u};
}

bool trace_hit(const trace *t, vec3 from, vec3 direction, uint32_t *row, vec3 *place) {
    struct RTCIntersectContext context;
    rtcInitIntersectContext(&context);
    struct RTCRayHit ray = {.ray = make_ray(t, from, direction)};
    ray.hit.geomID = RTC_INVALID_GEOMETRY_ID;
    rtcIntersect1(t->scene, &context, &ray);
    if (ray.hit.geomID == RTC_INVALID_GEOMETRY_ID)
        return false;
    *row = t->rows[ray.hit.geomID == t->ids[BALLS] ? BALLS : RODS][ray.hit.primID];
    const capsule *c = &t->list[*row];
    vec3 p = vec3_axpy(from, (double)ray.ray.tfar, direction), core = capsule_nearest(c, p), out = vec3_sub(p, core);
    *place = vec3_axpy(core, c->r / vec3_norm(out), out);
    return true;
}

bool trace_blocked(const trace *t, vec3 from, vec3 direction) {
    struct RTCIntersectContext context;
    rtcInitIntersectContext(&context);
    struct RTCRay ray = make_ray(t, from, direction);
    rtcOccluded1(t->scene, &context, &ray);
    return ray.tfar < 0;
}

#else

trace *trace_create(const capsule *list, size_t n, vec3 origin, vec3 eye, diag *d) {
    (void)list, (void)n, (void)origin, (void)eye;
    diag_error(d, "this build has no pictures: install libpng-dev and libembree-dev and build again");
    return NULL;
}

void trace_free(trace *t) {
    (void)t;
}

bool trace_hit(const trace *t, vec3 from, vec3 direction, uint32_t *row, vec3 *place) {
    (void)t, (void)from, (void)direction, (void)row, (void)place;
    return false;
}

bool trace_blocked(const trace *t, vec3 from, vec3 direction) {
    (void)t, (void)from, (void)direction;
    return false;
}

#endif

/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The record of a force term: everything the program knows about it, in one place. The script's commands, help and
 * manual, the generic tests and the evaluation all read these records.
 *
 * The owner computes: a term adds to the force of a body's particles everything that acts on them, in an order that
 * depends on ids only, and writes nowhere else. Terms are pure: integrators evaluate them at states they later reject.
 */
#ifndef SARCINA_MECHANICS_FORCE_STYLE_H
#define SARCINA_MECHANICS_FORCE_STYLE_H

#include "base/diag.h"
#include "base/param.h"
#include "mechanics/body.h"
#include "mechanics/force.h"
#include "model/colony.h"
#include "model/species.h"

struct neighbor;
struct spring_index;
struct contact_kernel;

/* A state to evaluate, read only. */
typedef struct force_frame {
    const body *bodies; /* (nbodies), by slot */
    size_t nbodies;
    const double *x, *v; /* (nparticles x dimensions), um, um/s; v NULL where damping is left out */
    const double *mass;  /* (nparticles), pg */
    /* (nbodies + CAPSULES_NOWHERE), of x, the last of no body: capsule, or flat_capsule if flat; NULL without collision
     */
    const void *capsules;
    const struct neighbor *neighbor;    /* NULL without collision */
    const struct spring_index *springs; /* NULL without springs */
    const struct contact_kernel *kernel;
    bool cocci;          /* no body has more than one particle */
    bool flat;           /* two dimensions: x, v and f have no z */
    const chain *chains; /* (nchains), flexible cells in the order of ids */
    size_t nchains;
    double *shares; /* (nparticles x 3): what a segment's contacts do to its last particle, for its owner to add */
    const force_set *forces;
    uint64_t seed; /* of fallback directions */
} force_frame;

/* A spring as the stiffness of the system sees it: energy k/2 (sum of g . displacement of a particle)^2. In the plane
 * the third number of each g is 0. */
typedef struct stiff_spring {
    uint32_t particle[4];
    double g[4][3];
    double k;       /* pg/s2; of an angle 1e-27 J, and g in 1/um */
    uint32_t count; /* particles it touches */
    uint32_t of;    /* place of its body among those that were asked for; of a chain 0 */
    double pull;    /* of one between two points (g = u, -u) that is stretched: tension over length, pg/s2; else 0 */
} stiff_spring;

typedef struct stiff_list {
    bool curved; /* terms add what is positive in the rest of their second derivatives, as springs of its own */
    size_t count, capacity;
    stiff_spring *list;
} stiff_list;

/* The next spring of the list: of that body, of this constant, without ends and pull. */
stiff_spring *force_spring_add(stiff_list *list, size_t of, double k);

/* One more particle of a spring: g = weight x direction. */
static inline void force_spring_end(stiff_spring *s, uint32_t particle, double weight, const double direction[3]) {
    s->particle[s->count] = particle;
    for (int k = 0; k < 3; k++)
        s->g[s->count][k] = weight * direction[k];
    s->count++;
}

/* A spring between a particle and something far below or above it. */
static inline void force_spring_along_z(stiff_list *list, size_t of, double k, uint32_t particle) {
    static const double up[3] = {0, 0, 1};
    force_spring_end(force_spring_add(list, of, k), particle, 1, up);
}

/* stiff_spring.pull of a spring of this length. */
static inline double force_spring_pull(double k, double rest, double length) {
    return length > rest ? k * (1 - rest / length) : 0;
}

/* What prepare may look at. */
typedef struct force_scene {
    const colony *colony;
    const species_table *species;
    const force_set *forces;
} force_scene;

enum {
    FORCE_CONSERVATIVE = 1, /* F = -grad E */
    FORCE_BALANCED = 2,     /* total force is 0 (springs to anchors apart) */
    FORCE_CENTRAL = 4,      /* and total torque too */
    FORCE_NEEDS_PAIRS = 8,  /* neighbour list and capsules */
    FORCE_READS_VELOCITY = 16,
    FORCE_READS_SPRINGS = 32,
    FORCE_ALONG_Z = 128,     /* along z and nothing else: not in two dimensions */
    FORCE_WITHIN_CHAINS = 64 /* acts within single chains by add_chain: may be integrated chain by chain */
};

typedef struct force_style {
    const char *name;    /* in scripts and messages */
    const char *command; /* "force": of `force NAME ...`; a command of its own; NULL: on by what the scene holds */
    const char *summary; /* one line */
    const char *formula; /* law and energy */
    const char *source;  /* where the law comes from */
    const char *example; /* a script line */
    const param *params; /* keywords, in the order of force_settings.p */
    size_t nparams;
    unsigned caps;
    /* Is the scene consistent? Once a binding; optional. */
    int (*prepare)(const double *p, const force_scene *scene, diag *d);
    /* f (nparticles x dimensions) += force on the particles that bodies begin ... end - 1 own; required but for terms
     * of chains alone. */
    void (*add)(const double *p, const force_frame *at, size_t begin, size_t end, double *f);
    /* f += force on the particles of chains begin ... end - 1, after all bodies are done; optional. */
    void (*add_chain)(const double *p, const force_frame *at, size_t begin, size_t end, double *f);
    /* Energy of one body; of a pair: with the body of lower id. And of one chain. One of them if conservative. */
    double (*energy)(const double *p, const force_frame *at, size_t slot);
    double (*energy_chain)(const double *p, const force_frame *at, size_t i);
    /* Linear drag, pg/s; then add is left out by integrators that damp exactly. Optional. */
    double (*drag)(const double *p);
    /* Appends the springs that act on n bodies at this state, those of one after those of the other; of a pair: with
     * the body of lower id. Optional. */
    void (*stiffness)(const double *p, const force_frame *at, const uint32_t *slots, size_t n, stiff_list *out);
    void (*stiffness_chain)(const double *p, const force_frame *at, size_t i, stiff_list *out);
    /* Spring constant (pg/s2) that a particle may meet at any time, whether or not it does now; optional. */
    double (*contact_stiffness)(const double *p);
} force_style;

/* The records, in the order of force_kind. */
extern const force_style *const force_styles[FORCE_COUNT];

/* The direction of what has none: a unit vector from the seed and two keys, the opposite for the keys exchanged. */
void force_direction(const force_frame *at, uint64_t key_a, uint64_t key_b, double u[3]);

/* 3, or 2 in the plane. */
static inline int force_dimensions(const force_frame *at) {
    return at->flat ? 2 : 3;
}

/* Height of the substratum; only with the substratum on. */
static inline double force_floor(const force_frame *at) {
    return at->forces->term[FORCE_SUBSTRATUM].p[SUBSTRATUM_Z];
}

#endif

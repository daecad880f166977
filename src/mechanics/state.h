/* SPDX-License-Identifier: GPL-3.0-or-later */
/* What the files of the mechanics share: the binding to a colony. Private to this folder. */
#ifndef SARCINA_MECHANICS_STATE_H
#define SARCINA_MECHANICS_STATE_H

#include "mechanics/force_style.h"
#include "mechanics/kernel.h"
#include "mechanics/mechanics.h"
#include "mechanics/neighbor.h"
#include "mechanics/spring.h"

/* Bytes that say what the binding was made from; equal images need no new binding. */
typedef struct state_image {
    unsigned char *bytes;
    size_t count, capacity;
} state_image;

struct mechanics {
    /* computed by mechanics_prepare */
    colony *colony;
    const species_table *species;
    force_set forces; /* a copy: parameters cannot change under a binding */
    neighbor_settings settings;
    uint64_t seed;
    int threads; /* as asked */
    bool bound;
    state_image image, next_image;
    size_t ncells, nbodies, nparticles;
    body *bodies, *spare; /* (nbodies), by slot */
    uint32_t *by_id;      /* slots in the order of ranks (nbodies) */
    chain *chains;        /* (nchains), flexible cells in the order of ids */
    size_t nchains, chain_capacity;
    double *shares;        /* (nparticles x 3), only with chains */
    uint32_t *owner;       /* slot of each particle (nparticles) */
    uint32_t *order;       /* particle rows in the order of ids (nparticles) */
    bool ordered;          /* rows stand in that order */
    double *mass, *radius; /* (nparticles) */
    spring_index springs;
    const link_rules *rules; /* NULL: links stay as they are */
    double time;             /* growth time, s */
    bool sticks, anchors;    /* such links may form */
    bool breaks;             /* there are links, which may break */
    double margin;           /* the list reaches this much further than contacts do, um: where cells stick */
    double touch;            /* cells within touch (r_A + r_B) count as contacts */
    double reach;            /* pairs within reach (r_A + r_B) may touch */
    double skin;             /* um */
    bool wants_pairs;        /* a term reads the neighbour list */
    bool cocci;              /* no body has more than one particle */
    bool flat;               /* two dimensions: all lies in the plane z = 0 */

    bool packed; /* the colony's x and v are a state of two dimensions for now */

    /* computed by evaluations */
    void *capsules; /* (nbodies + CAPSULES_NOWHERE), by slot, the last of no body: capsule, or flat_capsule in the plane
                     */
    double *built_at; /* (nbodies x 2 dimensions) both ends when the list was built, by slot */
    neighbor neighbor;
    bool listed; /* the list holds for built_at */
    const contact_kernel *kernel;
    double *scratch; /* (nparticles x dimensions) */
    stiff_list stiff;
    double *start; /* (nparticles x dimensions) of the search for the stiffest mode; drawn when first wanted */
    size_t start_capacity;
    bool started;
    size_t body_capacity, particle_capacity, capsule_capacity, share_capacity;
    mechanics_stats stats;
};

enum { STATE_CHUNK = NEIGHBOR_WINDOW }; /* bodies that a thread takes at once, all terms one after another */

/* Makes capsules and, where needed, the list hold at x; false when x is not finite. */
bool state_refresh(mechanics *m, const double *x);

/* The same for the pairs of a measure, whether or not a term needs them. */
bool state_refresh_pairs(mechanics *m, const double *x);

/* 3, or 2 in the plane. */
static inline int state_dimensions(const mechanics *m) {
    return m->flat ? 2 : 3;
}

/* Numbers of a state: nparticles x dimensions. */
static inline size_t state_components(const mechanics *m) {
    return (size_t)state_dimensions(m) * m->nparticles;
}

/* In the plane the colony's x and v stand packed, (nparticles x 2), in the place of their own rows while they are a
 * state. state_pack packs them where they are not, and says whether it did; state_unpack sets them apart again. */
bool state_pack(mechanics *m);
void state_unpack(mechanics *m);

force_frame state_frame(const mechanics *m, const double *x, const double *v);

/* Threads worth starting for this many bodies. */
int state_threads(const mechanics *m);

/* The springs of all active terms at x, with or without those within chains, in the order of ids; after
 * state_refresh. */
void state_springs(const mechanics *m, const double *x, bool chains, stiff_list *out);

/* Sets the slots' inverse maps after bodies have been put in another order. */
void state_index(mechanics *m);

#endif

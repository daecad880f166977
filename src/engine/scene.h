/* SPDX-License-Identifier: GPL-3.0-or-later */
/* A scene: everything a simulation is made of, owned in one place, and the calls that change it. No function here
 * knows scripts, prints or exits. Each checks everything before it changes anything: a call that fails leaves the
 * scene as it was, to the bit. Units: um, pg, s. */
#ifndef SARCINA_ENGINE_SCENE_H
#define SARCINA_ENGINE_SCENE_H

#include "analysis/view.h"
#include "analysis/view_cache.h"
#include "base/diag.h"
#include "base/rng.h"
#include "mechanics/mechanics.h"
#include "model/colony.h"
#include "model/group.h"
#include "model/link_rules.h"
#include "model/region.h"
#include "model/species.h"
#include "relax/relax.h"

#include <signal.h>

/* Where and how new cells are put. */
typedef enum { ORIENT_X, ORIENT_Y, ORIENT_Z, ORIENT_XY, ORIENT_RANDOM, ORIENT_VECTOR } orient_kind;

typedef struct placement {
    int species;
    orient_kind orient;
    double axis[3]; /* ORIENT_VECTOR */
    spread mass;    /* pg */
    double gap;     /* lowest surface this far above the substratum, um; NaN: the given z counts */
    bool overlap;   /* may it overlap what is there (and what is created with it)? */
    int filament;   /* a straight chain of this many cells, linked filially, takes the place of each; 0, 1: one */
    int maxtry;     /* draws of a place before giving up */
    bool may_fail;  /* that there is no room for cells at random places is no error: none is created */
} placement;

/* Cells of a species that arrive in a region at a rate. */
typedef struct attachment {
    placement placement; /* gap: NaN */
    bool mass_is_part;   /* the mass is one of that at division */
    region where;        /* a copy: the region stands while something attaches in it */
    double rate;         /* 1/s */
    uint64_t serial;     /* of its random streams */
} attachment;

typedef struct attachment_table {
    attachment *list;
    size_t count, capacity;
    uint64_t serials;          /* given out */
    uint64_t arrived, crowded; /* cells that did, and those that found no place */
} attachment_table;

/* Seconds of wall time by stage; force, build and remodel are parts of relax; output is added by who writes it. */
typedef struct scene_timing {
    double grow, divide, relax, force, build, remodel, output, total;
    double term[FORCE_COUNT], upkeep; /* of some of the evaluations: how the time of force is shared */
} scene_timing;

/* What the relaxations of a scene took. */
typedef struct scene_tally {
    uint64_t by_time, by_force, stalled; /* relaxations, by why they ended */
    uint64_t stalled_cell;               /* of the last that stalled: whose force was largest */
    force_kind stalled_term;             /* the term whose part in it was largest */
    double stalled_force;                /* and that force, 1e-21 N */
    uint64_t steps, rejected, evaluations;
    uint64_t cell_evaluations;       /* evaluations, each times the cells it was of */
    uint64_t builds;                 /* of the neighbour list */
    double least_step, largest_step; /* s; whoever wants those of a stretch sets them to infinity and 0 before it */
} scene_tally;

typedef struct scene {
    colony *colony;
    species_table species;
    region_table regions;
    link_rules links;
    group_table groups;
    attachment_table attachments;
    lineage *dead; /* mothers of the cells that are no longer there */
    force_set forces;
    int dimension; /* 3; 2: a monolayer in the plane z = 0 (engine/flat.h) */
    neighbor_settings neighbor;
    relax_settings relax;
    int accuracy; /* row in accuracy_presets */
    int threads;
    rng *rng;
    uint64_t step;                  /* cycles done */
    uint64_t growth_steps;          /* grow calls done: the step of the random streams */
    uint64_t deletions;             /* draws of delete_cells: the step of its random streams */
    double time, relaxed;           /* s */
    double time_rest, relaxed_rest; /* of these sums, what rounding has left out so far */
    mechanics *mechanics;
    struct view_cache *cache; /* of the views that scene_view makes, kept while the state below is the same */
    struct {
        uint64_t version;
        double relaxed;
        force_set forces;
    } cached;
    scene_timing timing;
    scene_tally tally;
    const volatile sig_atomic_t *interrupt; /* set by a signal handler; NULL */
} scene;

/* Wall time in seconds, from any beginning. */
double scene_clock(void);

scene *scene_create(void);
void scene_free(scene *s);

/* Takes everything out; the clock, seed and settings are as at the beginning. Callbacks and threads stay. */
void scene_clear(scene *s);

/* Binds the mechanics to the scene as it stands (cheap when nothing changed): an error where its parts do not fit. */
int scene_prepare(scene *s, diag *d);

/* Shows the scene to measures. Where it cannot be prepared, its mechanics are NULL and what they measure is NaN. */
view scene_view(scene *s);

/* Grows every cell for dt and divides those that are due, as one step, in the order of their ids; then come the cells
 * that attach in that time. */
int scene_grow(scene *s, double dt, diag *d);

/* Relaxes for time, or until the largest net force is below force (> 0). */
int scene_relax(scene *s, double time, double force, relax_result *result, diag *d);

/* One atomic cycle: grow dt (0: no growth) then relax (time 0: none). On failure or interruption the scene is as
 * before it. */
int scene_cycle(scene *s, double dt, double relax_time, double relax_force, diag *d);

/* Puts `changed` in place of a species, if its rules and the scene allow it: sizes and division limits of its cells
 * follow. On an error the scene is as it was. */
int scene_change_species(scene *s, int row, const species *changed, diag *d);

/* After a change of rules for links, or of sizes: stiffness and rest lengths of the links follow. */
void scene_refresh_links(scene *s);

/* Sticks, at once, the cells that are near enough to do so; *formed: how many links. */
int scene_stick(scene *s, size_t *formed, diag *d);

/* A cell read from a file or given whole; axis 0 0 0 and mass/diameter NaN: drawn as for the others. */
typedef struct cell_row {
    int species;
    double centre[3], axis[3];
    double mass, diameter;
    /* as it was elsewhere, to the bit; 0: nothing is known of it */
    double aspect;
    uint32_t nparticles;
    double *particles;            /* (nparticles x 6): x y z vx vy vz, in the place of centre and axis; owned */
    uint64_t id, parent, founder; /* id 0: the next one, and a founder */
    double generation, age;
    double frame[4]; /* of the next division; 0: not drawn yet */
    uint64_t groups; /* bits of the group table */
    bool on_plane;   /* it rests on the substratum, whatever its z */
} cell_row;

/* An error when places cannot be drawn from a region: it has no bounds. */
int scene_check_region(const region *where, diag *d);

/* All of them or none. *created: how many. */
int scene_create_single(scene *s, const placement *p, const double centre[3], size_t *created, diag *d);
int scene_create_random(scene *s, const placement *p, size_t n, const region *where, double spacing, size_t *created,
                        diag *d); /* centres this far apart, um; 0: as they come */
int scene_create_rows(scene *s, const placement *p, const cell_row *rows, size_t n, size_t *created, diag *d);

/* One cell from the streams (RNG_ATTACH, id, step) and (RNG_ATTACH, id + 1, step); false: no place was found, and
 * nothing has changed. */
bool scene_create_arrival(scene *s, const placement *p, const region *where, uint64_t id, uint64_t step);

/* The attachment of a species in a region, a new one with nothing set where there is none; and the end of all of a
 * species. */
attachment *scene_attach(scene *s, int species_row, const region *where);
void scene_attach_off(scene *s, int species_row);

/* Deletes the cells whose flag is set (by cell row), with their links. */
void scene_delete(scene *s, const bool *doomed);

#endif

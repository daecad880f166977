/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Evaluation of the active terms, and upkeep of what they read: capsules at every state, the neighbour list when a
 * particle has moved by more than half the skin since it was built. */
#include "mechanics/state.h"

#include "base/alloc.h"

#include <math.h>
#include <omp.h>
#include <stdlib.h>
#include <string.h>

/* Beyond this from the origin (um) a state counts as lost: bins and distances would lose their meaning. */
static const double farthest = 1e15;

int state_threads(const mechanics *m) {
    size_t useful = 1 + m->nbodies / 256;
    return (size_t)m->threads < useful ? m->threads : (int)useful;
}

/* Capsules of slots begin ... end - 1 at x; whether a particle of theirs has left its leeway (or is not a number),
 * where they are listed. Without axes no body has a second end. */
DIMENSIONS_INLINE bool set_range(mechanics *m, const double *x, size_t begin, size_t end, bool listed, bool axes,
                                 int dimensions) {
    const body *bodies = m->bodies;
    const size_t width = (size_t)dimensions;
    const double *then = m->built_at + 2 * width * begin;
    void *capsules = m->capsules;
    bool left = false;
    for (size_t slot = begin; slot < end; slot++, then += 2 * width) {
        const body *b = &bodies[slot];
        const double *first = x + width * b->first, *last = axes ? first + width * (b->count - 1) : first;
        capsule_set(capsules, slot, dimensions, first, last, b->radius, b->rest);
        if (!listed)
            continue;
        const double limit = (double)b->leeway * (double)b->leeway;
        if (!(dimensions_apart(first, then, dimensions) <= limit))
            left = true;
        if (axes && !(dimensions_apart(last, then + width, dimensions) <= limit))
            left = true;
    }
    return left;
}

static bool set_some(mechanics *m, const double *x, size_t begin, size_t end, bool listed) {
    if (m->flat)
        return m->cocci ? set_range(m, x, begin, end, listed, false, 2) : set_range(m, x, begin, end, listed, true, 2);
    return m->cocci ? set_range(m, x, begin, end, listed, false, 3) : set_range(m, x, begin, end, listed, true, 3);
}

/* The same for all. */
static bool set_capsules(mechanics *m, const double *x) {
    const bool listed = m->listed && m->neighbor.method == NEIGHBOR_CELLS;
    const size_t chunks = (m->nbodies + STATE_CHUNK - 1) / STATE_CHUNK;
    bool left = false;
#pragma omp parallel for num_threads(state_threads(m)) schedule(static) reduction(|| : left)
    for (size_t chunk = 0; chunk < chunks; chunk++) {
        size_t begin = chunk * STATE_CHUNK, end = begin + STATE_CHUNK < m->nbodies ? begin + STATE_CHUNK : m->nbodies;
        bool away = set_some(m, x, begin, end, listed);
        left = left || away;
    }
    return left;
}

static bool is_finite(const mechanics *m, const double *x) {
    for (size_t i = 0; i < state_components(m); i++)
        if (!(fabs(x[i]) < farthest))
            return false;
    return true;
}

/* Puts bodies near in space near in memory. */
static void sort_bodies(mechanics *m, const double *x) {
    uint32_t *order = alloc_zeroed(m->nbodies, sizeof *order);
    neighbor_sort(&m->neighbor, m->capsules, m->nbodies, order);
    for (size_t slot = 0; slot < m->nbodies; slot++)
        m->spare[slot] = m->bodies[order[slot]];
    free(order);
    body *swap = m->bodies;
    m->bodies = m->spare;
    m->spare = swap;
    state_index(m);
    set_capsules(m, x);
}

/* How far bodies may move before the next list: half the skin, and the few that moved most since the last one thrice as
 * far as they did: at most four skins, for a state further off will not come again. Else a few fast ones would have all
 * rows built anew, and a method whose trial stages throw some out of the skin and call them back twice a step. */
static void give_leeway(mechanics *m, const double *x) {
    const double usual = 0.5 * m->skin, most = 4 * m->skin;
    const int dimensions = state_dimensions(m);
    const size_t width = (size_t)dimensions;
    for (size_t slot = 0; slot < m->nbodies; slot++) {
        body *b = &m->bodies[slot];
        double wanted = 0;
        if (m->listed) {
            const double *first = x + width * b->first, *then = m->built_at + 2 * width * slot;
            wanted = 3 * sqrt(fmax(dimensions_apart(first, then, dimensions),
                                   dimensions_apart(first + width * (b->count - 1), then + width, dimensions)));
        }
        b->leeway = (float)(wanted > usual && wanted <= most ? wanted : usual);
    }
}

static void build(mechanics *m, const double *x) {
    double begin = omp_get_wtime();
    m->neighbor.method = m->settings.method;
    m->neighbor.chained = m->nchains > 0;
    m->neighbor.spheres = m->cocci;
    m->neighbor.flat = m->flat;
    m->neighbor.margin = m->margin;
    give_leeway(m, x);
    sort_bodies(m, x);
    neighbor_build(&m->neighbor, m->bodies, m->capsules, m->reach, state_threads(m), m->kernel);
    const size_t width = (size_t)state_dimensions(m);
    for (size_t slot = 0; slot < m->nbodies; slot++) {
        const body *b = &m->bodies[slot];
        memcpy(m->built_at + 2 * width * slot, x + width * b->first, width * sizeof *x);
        memcpy(m->built_at + (2 * slot + 1) * width, x + width * (b->first + b->count - 1), width * sizeof *x);
    }
    m->listed = true;
    m->stats.builds++;
    m->stats.build_seconds += omp_get_wtime() - begin;
}

bool state_refresh_pairs(mechanics *m, const double *x) {
    if (m->nbodies + CAPSULES_NOWHERE > m->capsule_capacity) {
        m->capsule_capacity = m->nbodies + CAPSULES_NOWHERE + m->nbodies / 2;
        free(m->capsules);
        m->capsules = alloc_aligned(m->capsule_capacity, capsule_size(m->flat), _Alignof(capsule));
        m->built_at =
            alloc_resize(m->built_at, 2 * (size_t)state_dimensions(m) * m->capsule_capacity, sizeof *m->built_at);
    }
    capsule_set_nowhere(m->capsules, m->nbodies, m->flat ? 2 : 3);
    bool left = set_capsules(m, x);
    if (m->listed && !left)
        return true;
    if (!is_finite(m, x))
        return false;
    build(m, x);
    return true;
}

bool state_refresh(mechanics *m, const double *x) {
    return !m->wants_pairs || state_refresh_pairs(m, x);
}

force_frame state_frame(const mechanics *m, const double *x, const double *v) {
    return (force_frame){
        .bodies = m->bodies,
        .nbodies = m->nbodies,
        .x = x,
        .v = v,
        .mass = m->mass,
        .capsules = m->capsules,
        .neighbor = &m->neighbor,
        .springs = &m->springs,
        .kernel = m->kernel,
        .cocci = m->cocci,
        .flat = m->flat,
        .chains = m->chains,
        .nchains = m->nchains,
        .shares = m->shares,
        .forces = &m->forces,
        .seed = m->seed,
    };
}

/* A body owns one particle or two. */
DIMENSIONS_INLINE void clear_in(const mechanics *m, size_t begin, size_t end, double *f, int dimensions) {
    for (size_t slot = begin; slot < end; slot++) {
        const body *b = &m->bodies[slot];
        double *own = f + (size_t)dimensions * b->first;
        for (int k = 0; k < dimensions; k++)
            own[k] = 0;
        if (b->owned > 1)
            for (int k = 0; k < dimensions; k++)
                own[dimensions + k] = 0;
    }
}

static void clear_chunk(const mechanics *m, size_t begin, size_t end, double *f) {
    if (m->flat)
        clear_in(m, begin, end, f, 2);
    else
        clear_in(m, begin, end, f, 3);
}

/* What acts within chains, and what their segments left for their owners: each chain by one thread. */
static void evaluate_chains(mechanics *m, unsigned which, unsigned within, const force_frame *at, double *f) {
#pragma omp parallel for num_threads(state_threads(m)) schedule(static)
    for (size_t c = 0; c < m->nchains; c++)
        for (int i = 0; i < FORCE_COUNT; i++)
            if (which >> i & 1 && m->forces.term[i].on && force_styles[i]->add_chain &&
                (within >> i & 1 || !(force_styles[i]->caps & FORCE_WITHIN_CHAINS)))
                force_styles[i]->add_chain(m->forces.term[i].p, at, c, c + 1, f);
}

/* Every so many evaluations the terms are timed: a clock at each chunk would cost more than the cheap ones. */
enum { EVALUATIONS_BETWEEN_CLOCKS = 64 };

/* Adds the terms of `which` on bodies begin ... end - 1, in the table's order; seconds (FORCE_COUNT) NULL: untimed. */
static void add_terms(const mechanics *m, unsigned which, const force_frame *at, size_t begin, size_t end, double *f,
                      double *seconds) {
    double before = seconds ? omp_get_wtime() : 0;
    for (int i = 0; i < FORCE_COUNT; i++) {
        if (!(which >> i & 1 && m->forces.term[i].on && force_styles[i]->add))
            continue;
        force_styles[i]->add(m->forces.term[i].p, at, begin, end, f);
        if (seconds) {
            double now = omp_get_wtime();
            seconds[i] += now - before;
            before = now;
        }
    }
}

/* The terms of `which` (bit i: row i of the table) on all bodies, chunk by chunk. */
static void evaluate_bodies(mechanics *m, unsigned which, const force_frame *at, bool timed, double *f) {
    const size_t chunks = (m->nbodies + STATE_CHUNK - 1) / STATE_CHUNK;
#pragma omp parallel num_threads(state_threads(m))
    {
        double seconds[FORCE_COUNT] = {0};
#pragma omp for schedule(static)
        for (size_t chunk = 0; chunk < chunks; chunk++) {
            size_t first = chunk * STATE_CHUNK, last = first + STATE_CHUNK;
            last = last < m->nbodies ? last : m->nbodies;
            clear_chunk(m, first, last, f);
            add_terms(m, which, at, first, last, f, timed ? seconds : NULL);
        }
        for (int i = 0; timed && i < FORCE_COUNT; i++)
#pragma omp atomic
            m->stats.term_seconds[i] += seconds[i];
    }
}

/* The same for chains, term by term, each timed. */
static void time_chains(mechanics *m, unsigned which, unsigned within, const force_frame *at, double *f) {
    for (int i = 0; i < FORCE_COUNT; i++) {
        double before = omp_get_wtime();
        if (which >> i & 1)
            evaluate_chains(m, 1u << i, within, at, f);
        m->stats.term_seconds[i] += which >> i & 1 && m->forces.term[i].on ? omp_get_wtime() - before : 0;
    }
}

/* The terms of `which`; those that act within chains act there only where they are in `within`, too. */
static void evaluate(mechanics *m, unsigned which, unsigned within, const double *x, const double *v, double *f) {
    double begin = omp_get_wtime(), built = m->stats.build_seconds;
    bool timed = m->stats.evaluations % EVALUATIONS_BETWEEN_CLOCKS == 1; /* not the first, which builds */
    if (!state_refresh(m, x)) {
        for (size_t i = 0; i < state_components(m); i++)
            f[i] = NAN;
        return;
    }
    if (timed)
        m->stats.upkeep_seconds += omp_get_wtime() - begin - (m->stats.build_seconds - built);
    const force_frame at = state_frame(m, x, v);
    evaluate_bodies(m, which, &at, timed, f);
    if (SARCINA_FLEXIBLE && m->nchains && timed)
        time_chains(m, which, within, &at, f);
    else if (SARCINA_FLEXIBLE && m->nchains)
        evaluate_chains(m, which, within, &at, f);
    m->stats.evaluations++;
    m->stats.cell_evaluations += m->ncells;
    m->stats.force_seconds += omp_get_wtime() - begin - (m->stats.build_seconds - built);
}

void mechanics_force(mechanics *m, const double *x, const double *v, double *f) {
    evaluate(m, ~0u, ~0u, x, v, f);
}

void mechanics_force_undamped(mechanics *m, const double *x, double *f) {
    evaluate(m, ~(1u << FORCE_DAMPING), ~0u, x, NULL, f);
}

void mechanics_force_outside(mechanics *m, const double *x, double *f) {
    evaluate(m, ~(1u << FORCE_DAMPING), 0, x, NULL, f);
}

void mechanics_force_of(mechanics *m, force_kind term, const double *x, const double *v, double *f) {
    evaluate(m, 1u << term, ~0u, x, v, f);
}

/* SPDX-License-Identifier: GPL-3.0-or-later */
/* What can be read off the mechanics: energies, net forces, contacts, and who is to blame. Sums go in the order of ids.
 */
#include "mechanics/state.h"

#include "base/alloc.h"
#include "mechanics/contact.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

/* Work at the colony's own state lies between these two. */
static const double *begin(mechanics *m, bool *packed) {
    *packed = state_pack(m);
    return m->colony->particle.x;
}

static void end(mechanics *m, bool packed) {
    if (packed)
        state_unpack(m);
}

static double energy_at(mechanics *m, force_kind term, const double *x) {
    const force_style *style = force_styles[term];
    const force_settings *settings = &m->forces.term[term];
    if (!settings->on || !(style->caps & FORCE_CONSERVATIVE))
        return 0;
    if (!state_refresh(m, x))
        return NAN;
    const force_frame at = state_frame(m, x, NULL);
    double sum = 0;
    for (size_t rank = 0; rank < m->nbodies; rank++)
        sum += style->energy ? style->energy(settings->p, &at, m->by_id[rank]) : 0;
    for (size_t i = 0; i < m->nchains && style->energy_chain; i++)
        sum += style->energy_chain(settings->p, &at, i);
    return sum;
}

double mechanics_energy(mechanics *m, force_kind term, const double *x) {
    bool packed = false;
    double energy = energy_at(m, term, x ? x : begin(m, &packed));
    end(m, packed);
    return energy;
}

double mechanics_kinetic(mechanics *m) {
    bool packed;
    const int dimensions = state_dimensions(m);
    double sum = 0;
    begin(m, &packed);
    for (size_t i = 0; i < m->nparticles; i++) {
        size_t p = m->order[i];
        const double *v = m->colony->particle.v + (size_t)dimensions * p;
        sum += 0.5 * m->mass[p] * dimensions_square(v, dimensions);
    }
    end(m, packed);
    return sum;
}

size_t mechanics_clamped(const mechanics *m) {
    const force_settings *dlvo = &m->forces.term[FORCE_DLVO];
    double floor = m->forces.term[FORCE_SUBSTRATUM].p[SUBSTRATUM_Z];
    size_t count = 0;
    for (size_t p = 0; dlvo->on && p < m->nparticles; p++)
        count += m->colony->particle.x[3 * p + 2] - floor - m->radius[p] < dlvo->p[DLVO_CLAMP] / dlvo->p[DLVO_KAPPA];
    return count;
}

double mechanics_fmax(mechanics *m) {
    bool packed;
    const int dimensions = state_dimensions(m);
    double most = 0;
    mechanics_force_undamped(m, begin(m, &packed), m->scratch);
    for (size_t p = 0; p < m->nparticles; p++) {
        double square = dimensions_square(m->scratch + (size_t)dimensions * p, dimensions);
        most = square > most ? square : most;
    }
    end(m, packed);
    return sqrt(most);
}

/* Distance between the axes of two bodies. */
static double axis_distance(const mechanics *m, size_t slot, uint32_t partner) {
    capsule room[2];
    const capsule *a = capsule_get(m->capsules, slot, m->flat, &room[0]);
    const capsule *b = capsule_get(m->capsules, partner, m->flat, &room[1]);
    contact_pair pair = {.radii = a->radius + b->radius};
    for (int k = 0; k < 3; k++) {
        pair.r[k] = a->x[k] - b->x[k];
        pair.d1[k] = a->d[k];
        pair.d2[k] = b->d[k];
    }
    contact_law_values law = {1, 1, 0};
    return sqrt(contact_compute(law, pair).square);
}

/* What one cell touches: its bodies come one after another in the order of ranks. */
typedef struct touching {
    double overlap;
    uint32_t *cells; /* rows of those within reach, some more than once */
    size_t count, capacity;
} touching;

/* Contacts and deepest overlap of one body with the partners of its row that are of other cells. */
static void measure_row(const mechanics *m, size_t slot, const uint32_t *partners, size_t n, touching *t) {
    t->cells = alloc_grow(t->cells, &t->capacity, t->count + n, sizeof *t->cells);
    for (size_t i = 0; i < n; i++) {
        const body *partner = &m->bodies[partners[i]];
        double radii = m->bodies[slot].radius + partner->radius, distance = axis_distance(m, slot, partners[i]);
        if (partner->row == m->bodies[slot].row)
            continue;
        if (distance < m->touch * radii)
            t->cells[t->count++] = partner->row;
        t->overlap = radii - distance > t->overlap ? radii - distance : t->overlap;
    }
}

static int compare_rows(const void *a, const void *b) {
    uint32_t p = *(const uint32_t *)a, q = *(const uint32_t *)b;
    return (p > q) - (p < q);
}

double mechanics_touch(const mechanics *m) {
    return m->touch;
}

/* How many cells are touched: a chain touches one by several segments. */
static uint32_t count_cells(touching *t) {
    uint32_t count = 0;
    qsort(t->cells, t->count, sizeof *t->cells, compare_rows);
    for (size_t i = 0; i < t->count; i++)
        count += i == 0 || t->cells[i] != t->cells[i - 1];
    return count;
}

static void sum_force(const mechanics *m, double *force) {
    const size_t width = (size_t)state_dimensions(m);
    memset(force, 0, 3 * m->ncells * sizeof *force);
    for (size_t rank = 0; rank < m->nbodies; rank++) {
        const body *b = &m->bodies[m->by_id[rank]];
        double *out = force + 3 * (size_t)b->row;
        for (size_t p = b->first; p < b->first + b->owned; p++)
            for (size_t k = 0; k < width; k++)
                out[k] += m->scratch[width * p + k];
    }
}

/* Contacts and overlaps of all cells, at the state that the list was last refreshed for. */
static void measure_contacts(const mechanics *m, double *overlap, uint32_t *contacts) {
    touching t = {0};
    for (size_t rank = 0; rank < m->nbodies; rank++) {
        size_t slot = m->by_id[rank];
        const body *b = &m->bodies[slot];
        neighbor_row row = neighbor_get(&m->neighbor, m->bodies, slot);
        measure_row(m, slot, row.lower, row.nlower, &t);
        measure_row(m, slot, row.upper, row.nupper, &t);
        if (b->chained && b->owned == 1)
            continue; /* more of the cell to come */
        if (overlap)
            overlap[b->row] = t.overlap;
        if (contacts)
            contacts[b->row] = m->nchains ? count_cells(&t) : (uint32_t)t.count;
        t.overlap = 0;
        t.count = 0;
    }
    free(t.cells);
}

void mechanics_contacts(mechanics *m, double *overlap, uint32_t *contacts, double *force) {
    bool packed;
    const double *x = begin(m, &packed);
    if (force) {
        mechanics_force_undamped(m, x, m->scratch);
        sum_force(m, force);
    }
    if ((overlap || contacts) && state_refresh_pairs(m, x))
        measure_contacts(m, overlap, contacts);
    end(m, packed);
}

/* The stiffest spring of a term that acts on the particle, if it beats what was found. */
static void find_stiffest(mechanics *m, const double *x, force_kind term, size_t particle, mechanics_culprit *found) {
    const force_frame at = state_frame(m, x, NULL);
    m->stiff.count = 0;
    const force_style *style = force_styles[term];
    if (style->stiffness)
        style->stiffness(m->forces.term[term].p, &at, m->by_id, m->nbodies, &m->stiff);
    for (size_t i = 0; i < m->nchains && style->stiffness_chain; i++)
        style->stiffness_chain(m->forces.term[term].p, &at, i, &m->stiff);
    for (size_t i = 0; i < m->stiff.count; i++) {
        const stiff_spring *s = &m->stiff.list[i];
        for (uint32_t j = 0; j < s->count; j++) {
            /* what resists an angle has its lever in g */
            const double *g = s->g[j], lever = g[0] * g[0] + g[1] * g[1] + g[2] * g[2];
            double k = style->caps & FORCE_WITHIN_CHAINS ? s->k * lever : s->k;
            if (s->particle[j] == particle && k > found->k) {
                found->k = k;
                found->stiffest = term;
            }
        }
    }
}

mechanics_culprit mechanics_blame(mechanics *m, const double *x, size_t particle) {
    mechanics_culprit found = {m->bodies[m->owner[particle]].id, FORCE_COUNT, FORCE_COUNT, 0, m->mass[particle]};
    const int dimensions = state_dimensions(m);
    double most = -1;
    for (int term = 0; term < FORCE_COUNT; term++) {
        if (!m->forces.term[term].on || term == FORCE_DAMPING)
            continue;
        mechanics_force_of(m, (force_kind)term, x, NULL, m->scratch);
        double square = dimensions_square(m->scratch + (size_t)dimensions * particle, dimensions);
        if (!(square <= most)) {
            most = isnan(square) ? (double)INFINITY : square;
            found.strongest = (force_kind)term;
        }
        if ((force_styles[term]->stiffness || force_styles[term]->stiffness_chain) && state_refresh(m, x))
            find_stiffest(m, x, (force_kind)term, particle, &found);
    }
    return found;
}

/* SPDX-License-Identifier: GPL-3.0-or-later */
/* What can be read off the mechanics: energies, net forces, contacts, and who is to blame. Sums go in the order of ids.
 */
#include "mechanics/state.h"

#include "mechanics/contact.h"

#include <math.h>
#include <string.h>

double mechanics_energy(mechanics *m, force_kind term, const double *x) {
    const force_style *style = force_styles[term];
    const force_settings *settings = &m->forces.term[term];
    if (!settings->on || !style->energy)
        return 0;
    if (!state_refresh(m, x))
        return NAN;
    const force_frame at = state_frame(m, x, NULL);
    double sum = 0;
    for (size_t rank = 0; rank < m->nbodies; rank++)
        sum += style->energy(settings->p, &at, m->by_id[rank]);
    return sum;
}

double mechanics_kinetic(mechanics *m, const double *v) {
    double sum = 0;
    for (size_t i = 0; i < m->nparticles; i++) {
        size_t p = m->order[i];
        sum += 0.5 * m->mass[p] * (v[3 * p] * v[3 * p] + v[3 * p + 1] * v[3 * p + 1] + v[3 * p + 2] * v[3 * p + 2]);
    }
    return sum;
}

double mechanics_fmax(mechanics *m) {
    double most = 0;
    mechanics_force_undamped(m, m->colony->particle.x, m->scratch);
    for (size_t p = 0; p < m->nparticles; p++) {
        const double *f = m->scratch + 3 * p;
        double square = f[0] * f[0] + f[1] * f[1] + f[2] * f[2];
        most = square > most ? square : most;
    }
    return sqrt(most);
}

/* Distance between the axes of two bodies. */
static double axis_distance(const mechanics *m, size_t slot, uint32_t partner) {
    const capsule *a = &m->capsules[slot], *b = &m->capsules[partner];
    contact_pair pair = {.radii = a->radius + b->radius};
    for (int k = 0; k < 3; k++) {
        pair.r[k] = a->x[k] - b->x[k];
        pair.d1[k] = a->d[k];
        pair.d2[k] = b->d[k];
    }
    contact_law_values law = {1, 1, 0};
    return sqrt(contact_compute(law, pair).square);
}

/* Contacts and deepest overlap of one body with the partners of its row. */
static void measure_row(const mechanics *m, size_t slot, const uint32_t *partners, size_t n, double *overlap,
                        uint32_t *contacts) {
    for (size_t i = 0; i < n; i++) {
        double radii = m->bodies[slot].radius + m->bodies[partners[i]].radius;
        double distance = axis_distance(m, slot, partners[i]);
        *contacts += distance < m->touch * radii;
        *overlap = radii - distance > *overlap ? radii - distance : *overlap;
    }
}

static void sum_force(const mechanics *m, double *force) {
    for (size_t slot = 0; slot < m->nbodies; slot++) {
        const body *b = &m->bodies[slot];
        double *out = force + 3 * (size_t)b->row;
        memset(out, 0, 3 * sizeof *out);
        for (size_t p = b->first; p < b->first + b->count; p++)
            for (size_t k = 0; k < 3; k++)
                out[k] += m->scratch[3 * p + k];
    }
}

void mechanics_contacts(mechanics *m, double *overlap, uint32_t *contacts, double *force) {
    const double *x = m->colony->particle.x;
    if (force) {
        mechanics_force_undamped(m, x, m->scratch);
        sum_force(m, force);
    }
    if ((!overlap && !contacts) || !state_refresh_pairs(m, x))
        return;
    for (size_t slot = 0; slot < m->nbodies; slot++) {
        neighbor_row row = neighbor_get(&m->neighbor, m->bodies, slot);
        double deepest = 0;
        uint32_t count = 0;
        measure_row(m, slot, row.lower, row.nlower, &deepest, &count);
        measure_row(m, slot, row.upper, row.nupper, &deepest, &count);
        if (overlap)
            overlap[m->bodies[slot].row] = deepest;
        if (contacts)
            contacts[m->bodies[slot].row] = count;
    }
}

/* The stiffest spring of a term that acts on the particle, if it beats what was found. */
static void find_stiffest(mechanics *m, const double *x, force_kind term, size_t particle, mechanics_culprit *found) {
    const force_frame at = state_frame(m, x, NULL);
    m->stiff.count = 0;
    for (size_t slot = 0; slot < m->nbodies; slot++)
        force_styles[term]->stiffness(m->forces.term[term].p, &at, slot, &m->stiff);
    for (size_t i = 0; i < m->stiff.count; i++) {
        const stiff_spring *s = &m->stiff.list[i];
        for (uint32_t j = 0; j < s->count; j++)
            if (s->particle[j] == particle && s->k > found->k) {
                found->k = s->k;
                found->stiffest = term;
            }
    }
}

mechanics_culprit mechanics_blame(mechanics *m, const double *x, size_t particle) {
    mechanics_culprit found = {m->bodies[m->owner[particle]].id, FORCE_COUNT, FORCE_COUNT, 0, m->mass[particle]};
    double most = -1;
    for (int term = 0; term < FORCE_COUNT; term++) {
        if (!m->forces.term[term].on || term == FORCE_DAMPING)
            continue;
        mechanics_force_of(m, (force_kind)term, x, NULL, m->scratch);
        const double *f = m->scratch + 3 * particle;
        double square = f[0] * f[0] + f[1] * f[1] + f[2] * f[2];
        if (!(square <= most)) {
            most = isnan(square) ? (double)INFINITY : square;
            found.strongest = (force_kind)term;
        }
        if (force_styles[term]->stiffness && state_refresh(m, x))
            find_stiffest(m, x, (force_kind)term, particle, &found);
    }
    return found;
}

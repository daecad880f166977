/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The colony's x and v as a state. In space they are one as they stand. In the plane they are packed in place, two
 * numbers a particle, for as long as they are: no copy is held, and nothing goes over z. */
#include "mechanics/state.h"

static void pack(double *rows, size_t n) {
    for (size_t i = 0; i < n; i++) {
        rows[2 * i] = rows[3 * i];
        rows[2 * i + 1] = rows[3 * i + 1];
    }
}

static void unpack(double *rows, size_t n) {
    for (size_t i = n; i-- > 0;) {
        rows[3 * i + 2] = 0;
        rows[3 * i + 1] = rows[2 * i + 1];
        rows[3 * i] = rows[2 * i];
    }
}

bool state_pack(mechanics *m) {
    if (!m->flat || m->packed)
        return false;
    pack(m->colony->particle.x, m->nparticles);
    pack(m->colony->particle.v, m->nparticles);
    m->packed = true;
    return true;
}

void state_unpack(mechanics *m) {
    if (!m->packed)
        return;
    unpack(m->colony->particle.x, m->nparticles);
    unpack(m->colony->particle.v, m->nparticles);
    m->packed = false;
}

void mechanics_take_state(mechanics *m, double **x, double **v) {
    state_pack(m);
    *x = m->colony->particle.x;
    *v = m->colony->particle.v;
}

void mechanics_return_state(mechanics *m) {
    state_unpack(m);
}

/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "analysis/state.h"

#define UNUSED(x) ((void)(x))

int state_step(const view *v, const bool *members, double *out, diag *d) {
    UNUSED(members), UNUSED(d);
    out[0] = (double)v->step;
    return SARCINA_OK;
}

int state_time(const view *v, const bool *members, double *out, diag *d) {
    UNUSED(members), UNUSED(d);
    out[0] = v->time;
    return SARCINA_OK;
}

int state_relaxed(const view *v, const bool *members, double *out, diag *d) {
    UNUSED(members), UNUSED(d);
    out[0] = v->relaxed;
    return SARCINA_OK;
}

int state_wall(const view *v, const bool *members, double *out, diag *d) {
    UNUSED(members), UNUSED(d);
    out[0] = v->wall;
    return SARCINA_OK;
}

int state_cells(const view *v, const bool *members, double *out, diag *d) {
    UNUSED(d);
    out[0] = 0;
    for (size_t row = 0; row < v->colony->cell.count; row++)
        out[0] += !members || members[row];
    return SARCINA_OK;
}

int state_particles(const view *v, const bool *members, double *out, diag *d) {
    UNUSED(d);
    out[0] = 0;
    for (size_t row = 0; row < v->colony->cell.count; row++)
        out[0] += !members || members[row] ? v->colony->cell.nparticles[row] : 0;
    return SARCINA_OK;
}

static bool is_member(colony *c, const bool *members, uint64_t id) {
    uint32_t row = colony_row(c, id);
    return !members || (row != COLONY_NO_ROW && members[row]);
}

/* Fields: internal (springs inside cells), bend, twist, then links by kind, then formed and broken since the start. */
int state_links(const view *v, const bool *members, double *out, diag *d) {
    UNUSED(d);
    enum { ALL, INTERNAL, BEND, TWIST, FILIAL, STICK, ANCHOR, FORMED, BROKEN, FIELDS };
    static const int field_of[] = {
        [LINK_FILIAL] = FILIAL, [LINK_STICK] = STICK, [LINK_ANCHOR] = ANCHOR, [LINK_SPRING] = ALL};
    colony *c = v->colony;
    for (int i = 0; i < FIELDS; i++)
        out[i] = 0;
    for (size_t row = 0; row < c->cell.count; row++) {
        uint32_t n = !members || members[row] ? c->cell.nparticles[row] : 0;
        out[INTERNAL] += n > 1 ? n - 1 : 0;
        out[BEND] += n > 2 ? n - 2 : 0;
        out[TWIST] += n > 3 ? n - 3 : 0;
    }
    for (size_t l = 0; l < c->link.count; l++) {
        if (!is_member(c, members, c->link.cell_a[l]) ||
            (c->link.cell_b[l] && !is_member(c, members, c->link.cell_b[l])))
            continue;
        out[ALL] += 1;
        if (field_of[c->link.kind[l]] != ALL)
            out[field_of[c->link.kind[l]]] += 1;
    }
    out[FORMED] = (double)v->links_formed;
    out[BROKEN] = (double)v->links_broken;
    return SARCINA_OK;
}

/* Fields in the order of cap_kind; the bare value is their sum. */
int state_caps(const view *v, const bool *members, double *out, diag *d) {
    UNUSED(members), UNUSED(d);
    out[0] = 0;
    for (int i = 0; i < CAP_COUNT; i++) {
        out[i + 1] = (double)v->colony->caps[i];
        out[0] += out[i + 1];
    }
    return SARCINA_OK;
}

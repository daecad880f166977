/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "output/spring_list.h"

#include "base/alloc.h"

#include <stdlib.h>

typedef struct maker {
    const dump_frame *f;
    spring_item *list;
    size_t n, capacity;
} maker;

const char *spring_list_kind(int kind) {
    static const char *const kinds[] = {
        [LINK_FILIAL] = "filial", [LINK_STICK] = "stick", [LINK_ANCHOR] = "anchor", [LINK_SPRING] = "spring"};
    return kind == SPRING_INTERNAL ? "internal" : kinds[kind];
}

static void add(maker *m, const spring_item *item) {
    m->list = alloc_grow(m->list, &m->capacity, m->n + 1, sizeof *m->list);
    spring_item *s = &m->list[m->n++];
    *s = *item;
    s->strain = s->rest > 0 ? (s->length - s->rest) / s->rest : (double)NAN;
}

/* The springs inside a cell. */
static void add_internal(maker *m, uint32_t row) {
    const colony *c = m->f->view->colony;
    uint32_t n = c->cell.nparticles[row];
    double k = species_stiffness(&m->f->view->species->list[c->cell.species[row]], c, row);
    const double *x = c->particle.x + 3 * (size_t)c->cell.first[row];
    for (uint32_t p = 0; p + 1 < n && k > 0; p++, x += 3) {
        vec3 from = vec3_load(x), to = vec3_load(x + 3);
        add(m, &(spring_item){.kind = SPRING_INTERNAL,
                              .cell_a = c->cell.id[row],
                              .cell_b = c->cell.id[row],
                              .particle_a = p,
                              .particle_b = p + 1,
                              .k = k,
                              .rest = c->cell.rest[row] / (n - 1),
                              .length = vec3_norm(vec3_sub(to, from)),
                              .age = NAN,
                              .from = from,
                              .to = to});
    }
}

/* The cell whose particle this is, of the two of a link. */
static uint32_t owner(const colony *c, uint32_t particle, uint32_t row_a, uint32_t row_b) {
    uint32_t first = c->cell.first[row_a];
    return particle >= first && particle < first + c->cell.nparticles[row_a] ? row_a : row_b;
}

/* Where an anchoring spring ends: its point, or what follows below the particle. */
static vec3 anchored_end(const colony *c, uint32_t s, vec3 from) {
    vec3 point = vec3_load(c->spring.anchor + 3 * (size_t)s);
    return c->spring.glides[s] ? vec3_of(from.x, from.y, point.z) : point;
}

static void add_spring(maker *m, uint32_t link, uint32_t s, uint32_t row_a, uint32_t row_b) {
    const colony *c = m->f->view->colony;
    bool anchored = c->spring.b[s] == SPRING_ANCHOR;
    uint32_t a = owner(c, c->spring.a[s], row_a, row_b), b = anchored ? a : owner(c, c->spring.b[s], row_a, row_b);
    vec3 from = vec3_load(c->particle.x + 3 * (size_t)c->spring.a[s]);
    add(m, &(spring_item){.link = c->link.id[link],
                          .kind = c->link.kind[link],
                          .cell_a = c->cell.id[a],
                          .particle_a = c->spring.a[s] - c->cell.first[a],
                          .cell_b = anchored ? 0 : c->cell.id[b],
                          .particle_b = anchored ? 0 : c->spring.b[s] - c->cell.first[b],
                          .k = c->spring.k[s],
                          .rest = c->spring.rest[s],
                          .length = colony_spring_length(c, s),
                          .age = m->f->view->time - c->link.birth[link],
                          .from = from,
                          .to = anchored ? anchored_end(c, s, from)
                                         : vec3_load(c->particle.x + 3 * (size_t)c->spring.b[s]),
                          .anchored = anchored,
                          .anchor = anchored ? c->spring.anchor + 3 * (size_t)s : NULL,
                          .glides = c->spring.glides[s] != 0});
}

static void add_link(maker *m, uint32_t link) {
    colony *c = m->f->view->colony;
    const bool *members = m->f->members;
    uint32_t a = colony_row(c, c->link.cell_a[link]);
    uint32_t b = c->link.cell_b[link] ? colony_row(c, c->link.cell_b[link]) : a;
    if (members && !(members[a] && members[b]))
        return;
    for (uint32_t i = 0; i < c->link.nsprings[link]; i++)
        add_spring(m, link, c->link.first[link] + i, a, b);
}

spring_item *spring_list_make(const dump_frame *f, size_t *n) {
    maker m = {.f = f};
    size_t cells;
    uint32_t *rows = dump_rows(f, &cells), *links = colony_links_by_id(f->view->colony);
    for (size_t i = 0; i < cells; i++)
        add_internal(&m, rows[i]);
    for (size_t i = 0; i < f->view->colony->link.count; i++)
        add_link(&m, links[i]);
    free(rows);
    free(links);
    *n = m.n;
    return m.list;
}

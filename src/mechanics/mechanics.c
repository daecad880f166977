/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Binding to a colony: which terms act, and the bodies, masses and indices they read. */
#include "mechanics/mechanics.h"

#include "base/alloc.h"
#include "mechanics/state.h"

#include <math.h>
#include <sleef.h>
#include <stdlib.h>
#include <string.h>

mechanics *mechanics_create(void) {
    mechanics *m = alloc_zeroed(1, sizeof *m);
    m->kernel = kernel_best();
    return m;
}

void mechanics_free(mechanics *m) {
    if (!m)
        return;
    free(m->image.bytes);
    free(m->next_image.bytes);
    free(m->bodies);
    free(m->spare);
    free(m->by_id);
    free(m->chains);
    free(m->shares);
    free(m->owner);
    free(m->order);
    free(m->mass);
    free(m->radius);
    spring_index_free(&m->springs);
    free(m->capsules);
    free(m->built_at);
    neighbor_free(&m->neighbor);
    free(m->scratch);
    free(m->stiff.list);
    free(m->start);
    free(m);
}

/* Anchors need something to hold on to. */
static int check_links(const mechanics_input *in, diag *d) {
    if (!in->links || in->forces->term[FORCE_SUBSTRATUM].on || !link_rules_any(in->links, LINK_ANCHOR))
        return SARCINA_OK;
    diag_error(d, "link anchor holds cells to a substratum, and the scene has none");
    return diag_help(d, "substratum plane z 0 k 1e-10N/m");
}

int mechanics_check(const mechanics_input *in, diag *d) {
    const force_scene scene = {in->colony, in->species, in->forces};
    /* a rod without its spring is found by the term that is off for want of it */
    for (int i = 0; i < FORCE_COUNT; i++) {
        const force_style *style = force_styles[i];
        if (!style->prepare || (i != FORCE_INTERNAL && !in->forces->term[i].on))
            continue;
        int status = style->prepare(in->forces->term[i].p, &scene, d);
        if (status)
            return status;
    }
    return check_links(in, d);
}

static void image_add(state_image *image, const void *data, size_t bytes) {
    if (!bytes)
        return;
    image->bytes = alloc_grow(image->bytes, &image->capacity, image->count + bytes, 1);
    memcpy(image->bytes + image->count, data, bytes);
    image->count += bytes;
}

/* Everything a binding depends on, but for x and v. */
static void take_image(state_image *image, const mechanics_input *in) {
    const colony *c = in->colony;
    image->count = 0;
    image_add(image, &in->colony, sizeof(void *));
    image_add(image, &c->version, sizeof c->version);
    image_add(image, &in->links, sizeof in->links);
    image_add(image, &in->seed, sizeof in->seed);
    image_add(image, &in->flat, sizeof in->flat);
    image_add(image, &in->neighbor.skin, sizeof in->neighbor.skin);
    image_add(image, &in->neighbor.method, sizeof in->neighbor.method);
    for (int i = 0; i < FORCE_COUNT; i++) {
        image_add(image, &in->forces->term[i].on, sizeof in->forces->term[i].on);
        image_add(image, in->forces->term[i].p, sizeof in->forces->term[i].p);
    }
    for (size_t i = 0; i < in->species->count; i++) {
        image_add(image, &in->species->list[i].internal_k, sizeof(double));
        image_add(image, &in->species->list[i].density, sizeof(double));
        image_add(image, &in->species->list[i].bend_k, sizeof(double));
        image_add(image, &in->species->list[i].twist_k, sizeof(double));
        image_add(image, &in->species->list[i].bend_angle, sizeof(double));
        image_add(image, &in->species->list[i].twist_angle, sizeof(double));
        image_add(image, &in->species->list[i].coil.radius, sizeof(double));
        image_add(image, &in->species->list[i].coil.pitch, sizeof(double));
        image_add(image, &in->species->list[i].coil.left, sizeof(bool));
    }
    image_add(image, c->cell.species, c->cell.count * sizeof *c->cell.species);
    image_add(image, c->cell.mass, c->cell.count * sizeof *c->cell.mass);
    image_add(image, c->cell.stiffness, c->cell.count * sizeof *c->cell.stiffness);
    image_add(image, c->cell.diameter, c->cell.count * sizeof *c->cell.diameter);
    image_add(image, c->cell.rest, c->cell.count * sizeof *c->cell.rest);
    image_add(image, c->spring.a, c->spring.count * sizeof *c->spring.a);
    image_add(image, c->spring.b, c->spring.count * sizeof *c->spring.b);
    image_add(image, c->spring.k, c->spring.count * sizeof *c->spring.k);
    image_add(image, c->spring.rest, c->spring.count * sizeof *c->spring.rest);
    image_add(image, c->spring.anchor, c->spring.count * 3 * sizeof *c->spring.anchor);
    image_add(image, c->spring.glides, c->spring.count * sizeof *c->spring.glides);
}

/* Whether the scene is as it was bound; in any case its image is the present one afterwards. */
static bool is_unchanged(mechanics *m, const mechanics_input *in) {
    take_image(&m->next_image, in);
    bool same = m->bound && m->image.count == m->next_image.count &&
                memcmp(m->image.bytes, m->next_image.bytes, m->image.count) == 0;
    state_image swap = m->image;
    m->image = m->next_image;
    m->next_image = swap;
    return same;
}

static void reserve(mechanics *m) {
    if (m->nbodies > m->body_capacity) {
        m->body_capacity = m->nbodies + m->nbodies / 2;
        m->bodies = alloc_resize(m->bodies, m->body_capacity, sizeof *m->bodies);
        m->spare = alloc_resize(m->spare, m->body_capacity, sizeof *m->spare);
        m->by_id = alloc_resize(m->by_id, m->body_capacity, sizeof *m->by_id);
    }
    if (m->nparticles > m->particle_capacity) {
        m->particle_capacity = m->nparticles + m->nparticles / 2;
        m->owner = alloc_resize(m->owner, m->particle_capacity, sizeof *m->owner);
        m->order = alloc_resize(m->order, m->particle_capacity, sizeof *m->order);
        m->mass = alloc_resize(m->mass, m->particle_capacity, sizeof *m->mass);
        m->radius = alloc_resize(m->radius, m->particle_capacity, sizeof *m->radius);
        m->scratch = alloc_resize(m->scratch, (size_t)state_dimensions(m) * m->particle_capacity, sizeof *m->scratch);
    }
}

/* Bodies of a cell: one, or each segment of a chain. */
static uint32_t bodies_of(const colony *c, uint32_t row) {
    return c->cell.nparticles[row] > 2 ? c->cell.nparticles[row] - 1 : 1;
}

/* Writes the bodies of a cell from `rank` on. */
static void bind_cell(mechanics *m, uint32_t row, uint32_t rank) {
    const colony *c = m->colony;
    const species *s = &m->species->list[c->cell.species[row]];
    uint32_t count = bodies_of(c, row), n = c->cell.nparticles[row];
    for (uint32_t i = 0; i < count; i++)
        m->bodies[rank + i] = (body){.id = c->cell.id[row],
                                     .row = row,
                                     .first = c->cell.first[row] + i,
                                     .count = n < 2 ? 1 : 2,
                                     .rank = rank + i,
                                     .segment = (uint16_t)i,
                                     .owned = i + 1 < count ? 1
                                              : n < 2       ? 1
                                                            : 2,
                                     .chained = n > 2,
                                     .radius = 0.5 * c->cell.diameter[row],
                                     .rest = n > 2 ? species_segment(s, c->cell.rest[row]) : c->cell.rest[row],
                                     .internal_k = n > 2 ? 0 : species_stiffness(s, c, row),
                                     .density = s->density};
}

/* What holds a flexible cell in shape. */
static void bind_chain(mechanics *m, uint32_t row) {
    const colony *c = m->colony;
    const species *s = &m->species->list[c->cell.species[row]];
    m->chains = alloc_grow(m->chains, &m->chain_capacity, m->nchains + 1, sizeof *m->chains);
    chain *ch = &m->chains[m->nchains++];
    *ch = (chain){.id = c->cell.id[row],
                  .row = row,
                  .first = c->cell.first[row],
                  .count = c->cell.nparticles[row],
                  .radius = 0.5 * c->cell.diameter[row],
                  .rest = species_segment(s, c->cell.rest[row]),
                  .internal_k = species_stiffness(s, c, row),
                  .bend_k = s->bend_k,
                  .twist_k = s->twist_k};
    species_rest_angles(s, c->cell.rest[row], &ch->theta, &ch->cos_phi, &ch->sin_phi);
    double sine = Sleef_cinz_sind1_u10purec(ch->theta);
    ch->straight = sine > 1e-6 ? 0.5 * sine : 0.1;
}

/* Bodies in the order of ids; masses and radii of their particles. */
static void bind_bodies(mechanics *m) {
    colony *c = m->colony;
    const uint32_t *by_id = colony_by_id(c);
    m->ordered = true;
    m->nchains = 0;
    size_t filled = 0;
    uint32_t rank = 0;
    for (size_t cell = 0; cell < m->ncells; cell++) {
        uint32_t row = by_id[cell];
        bind_cell(m, row, rank);
        rank += bodies_of(c, row);
        if (c->cell.nparticles[row] > 2)
            bind_chain(m, row);
        for (uint32_t i = 0; i < c->cell.nparticles[row]; i++) {
            uint32_t p = c->cell.first[row] + i;
            m->ordered = m->ordered && p == filled;
            m->order[filled++] = p;
            m->mass[p] = body_share(c->cell.nparticles[row], i) * c->cell.mass[row];
            m->radius[p] = 0.5 * c->cell.diameter[row];
        }
    }
    if (m->nchains)
        m->shares = alloc_grow(m->shares, &m->share_capacity, 3 * m->nparticles, sizeof *m->shares);
}

void state_index(mechanics *m) {
    for (uint32_t slot = 0; slot < m->nbodies; slot++) {
        const body *b = &m->bodies[slot];
        m->by_id[b->rank] = slot;
        for (uint32_t i = 0; i < b->owned; i++)
            m->owner[b->first + i] = slot;
    }
}

/* Smallest, mean and largest numbers decide the skin: a third of the mean diameter. */
static double choose_skin(const mechanics *m) {
    if (m->settings.skin >= 0)
        return m->settings.skin;
    double sum = 0;
    for (size_t rank = 0; rank < m->nbodies; rank++)
        sum += 2 * m->bodies[m->by_id[rank]].radius;
    return m->nbodies ? 0.4 * sum / (double)m->nbodies : 0;
}

/* Which links may form: between species that have cells here. */
static void bind_rules(mechanics *m) {
    m->sticks = m->anchors = false;
    m->margin = 0;
    m->breaks = m->colony->link.count > 0;
    if (!m->rules || m->ncells == 0)
        return;
    size_t n = m->species->count;
    bool *present = alloc_zeroed(n, sizeof *present);
    for (size_t i = 0; i < m->ncells; i++)
        present[m->colony->cell.species[i]] = true;
    for (int a = 0; a < (int)n; a++) {
        m->anchors = m->anchors || (present[a] && link_rules_find(m->rules, LINK_ANCHOR, a, a));
        for (int b = 0; b <= a && present[a]; b++) {
            const link_rule *rule = present[b] ? link_rules_find(m->rules, LINK_STICK, a, b) : NULL;
            if (!rule)
                continue;
            m->sticks = true;
            m->margin = fmax(m->margin, rule->p[STICK_FORM]);
        }
    }
    free(present);
}

/* What was made for the other number of dimensions has rows of another width. */
static void forget_other_dimensions(mechanics *m, bool flat) {
    if (m->flat == flat)
        return;
    free(m->capsules);
    m->capsules = NULL;
    m->capsule_capacity = m->particle_capacity = 0; /* all that they count is made anew */
    m->flat = flat;
}

static void bind(mechanics *m, const mechanics_input *in) {
    forget_other_dimensions(m, in->flat);
    m->colony = in->colony;
    m->species = in->species;
    m->forces = *in->forces;
    m->settings = in->neighbor;
    m->seed = in->seed;
    m->ncells = in->colony->cell.count;
    m->nbodies = 0;
    for (uint32_t row = 0; row < m->ncells; row++)
        m->nbodies += bodies_of(in->colony, row);
    m->nparticles = in->colony->particle.count;
    reserve(m);
    bind_bodies(m);
    state_index(m);

    /* rods' own springs act where their species has one, links' where there are any */
    m->forces.term[FORCE_INTERNAL].on = false;
    for (size_t i = 0; i < m->nbodies; i++)
        if (m->bodies[i].count > 1 && m->bodies[i].internal_k > 0)
            m->forces.term[FORCE_INTERNAL].on = true;
    m->forces.term[FORCE_BEND].on = m->forces.term[FORCE_TWIST].on = false;
    for (size_t i = 0; i < m->nchains; i++) {
        m->forces.term[FORCE_INTERNAL].on |= m->chains[i].internal_k > 0;
        m->forces.term[FORCE_BEND].on |= m->chains[i].bend_k > 0;
        m->forces.term[FORCE_TWIST].on |= m->chains[i].twist_k > 0;
    }
    m->forces.term[FORCE_SPRINGS].on = in->colony->spring.count > 0;
    if (m->forces.term[FORCE_SPRINGS].on)
        spring_index_build(&m->springs, in->colony, m->owner, m->bodies);
    bind_rules(m);

    /* the regularised law reaches a little further than the axes' distance says */
    const force_settings *collision = &m->forces.term[FORCE_COLLISION];
    bool regularised = (contact_law)collision->p[COLLISION_CONTACT] == CONTACT_REGULARISED;
    m->wants_pairs = collision->on;
    m->cocci = m->nparticles == m->nbodies;
    m->touch = m->reach = collision->on ? collision->p[COLLISION_REACH] : 1;
    if (collision->on && regularised)
        m->reach *= sqrt(1 + 0.25 * collision->p[COLLISION_EPSILON]);
    m->skin = choose_skin(m);
    m->listed = false;
    m->started = false;
}

int mechanics_prepare(mechanics *m, const mechanics_input *in, diag *d) {
    int status = in->lenient ? SARCINA_OK : mechanics_check(in, d);
    if (status) {
        m->bound = false;
        return status;
    }
    m->threads = in->threads > 0 ? in->threads : 1;
    m->rules = in->links;
    m->time = in->time;
    if (!is_unchanged(m, in))
        bind(m, in);
    m->bound = true;
    return SARCINA_OK;
}

double mechanics_drag(const mechanics *m) {
    const force_settings *damping = &m->forces.term[FORCE_DAMPING];
    return damping->on ? force_styles[FORCE_DAMPING]->drag(damping->p) : 0;
}

const double *mechanics_mass(const mechanics *m) {
    return m->mass;
}

const double *mechanics_radius(const mechanics *m) {
    return m->radius;
}

size_t mechanics_particles(const mechanics *m) {
    return m->nparticles;
}

int mechanics_dimensions(const mechanics *m) {
    return state_dimensions(m);
}

bool mechanics_has_chains(const mechanics *m) {
    return m->nchains > 0;
}

bool mechanics_is_chained(const mechanics *m, size_t particle) {
    return m->bodies[m->owner[particle]].chained;
}

const uint32_t *mechanics_order(const mechanics *m) {
    return m->ordered ? NULL : m->order;
}

const contact_kernel *mechanics_loops(const mechanics *m) {
    return m->kernel;
}

bool mechanics_kernel(mechanics *m, const char *name) {
    const contact_kernel *kernel = kernel_find(name);
    if (kernel)
        m->kernel = kernel;
    return kernel != NULL;
}

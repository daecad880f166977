/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Cells to a CSV file, with all their columns: read back to the bit. */
#include "command/cell_file.h"

#include "base/path.h"

#include <inttypes.h>
#include <stdio.h>

/* Columns that not every scene needs. */
typedef struct extent {
    uint32_t particles; /* of the longest cell */
    bool aspect, groups, frame;
} extent;

static extent find_extent(const cell_columns *c) {
    extent e = {.particles = 1};
    for (size_t i = 0; i < c->count; i++) {
        const double *frame = c->frame + 4 * i;
        e.particles = c->nparticles[i] > e.particles ? c->nparticles[i] : e.particles;
        e.aspect = e.aspect || c->aspect[i] > 0;
        e.groups = e.groups || c->groups[i];
        e.frame = e.frame || frame[0] != 0 || frame[1] != 0 || frame[2] != 0 || frame[3] != 0;
    }
    return e;
}

static void write_header(FILE *f, const scene *s, const extent *e) {
    uint32_t particles = e->particles;
    fprintf(f, "# sarcina cells: step %" PRIu64 ", time %.17g s\n", s->step, s->time);
    fprintf(f, "species,id,parent,founder,generation,age[s],mass[pg],diameter[um]%s%s%s", e->aspect ? ",aspect" : "",
            e->groups ? ",groups" : "", e->frame ? ",fi,fj,fk,fw" : "");
    for (uint32_t i = 1; i <= particles; i++)
        fprintf(f, ",x%u[um],y%u[um],z%u[um]", i, i, i);
    for (uint32_t i = 1; i <= particles; i++)
        fprintf(f, ",vx%u[um/s],vy%u[um/s],vz%u[um/s]", i, i, i);
    fputc('\n', f);
}

/* Three numbers a particle; a cell with fewer of them leaves columns empty. */
static void write_vectors(FILE *f, const double *v, uint32_t n, uint32_t particles) {
    for (uint32_t i = 0; i < 3 * particles; i++)
        if (i < 3 * n)
            fprintf(f, ",%.17g", v[i]);
        else
            fputc(',', f);
}

static void write_groups(FILE *f, const scene *s, uint64_t groups) {
    const char *before = ",";
    if (!groups)
        fputc(',', f);
    for (int bit = 0; bit < GROUP_MAX; bit++)
        if (groups >> bit & 1) {
            fprintf(f, "%s%s", before, s->groups.name[bit]);
            before = " ";
        }
}

static void write_cell(FILE *f, const scene *s, uint32_t row, const extent *e) {
    const cell_columns *c = &s->colony->cell;
    uint32_t particles = e->particles;
    const double *frame = c->frame + 4 * (size_t)row;
    fprintf(f, "%s,%" PRIu64 ",%" PRIu64 ",%" PRIu64 ",%d,%.17g,%.17g,%.17g", s->species.list[c->species[row]].name,
            c->id[row], c->parent[row], c->founder[row], c->generation[row], s->time - c->birth[row], c->mass[row],
            c->diameter[row]);
    if (e->aspect)
        fprintf(f, ",%.17g", c->aspect[row]);
    if (e->groups)
        write_groups(f, s, c->groups[row]);
    if (e->frame)
        fprintf(f, ",%.17g,%.17g,%.17g,%.17g", frame[0], frame[1], frame[2], frame[3]);
    write_vectors(f, s->colony->particle.x + 3 * (size_t)c->first[row], c->nparticles[row], particles);
    write_vectors(f, s->colony->particle.v + 3 * (size_t)c->first[row], c->nparticles[row], particles);
    fputc('\n', f);
}

int cell_file_write(interp *in, const char *path, diag *d) {
    const scene *s = interp_scene(in);
    const cell_columns *c = &s->colony->cell;
    const extent e = find_extent(c);
    FILE *f = path_open(path, "w", d);
    if (!f)
        return SARCINA_ERROR;
    write_header(f, s, &e);
    const uint32_t *order = colony_by_id(s->colony);
    for (size_t i = 0; i < c->count; i++)
        write_cell(f, s, order[i], &e);
    link_file_write(f, s);
    return path_close(f, path, d);
}

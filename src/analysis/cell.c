/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Spherocylinders for OVITO (manual, "Non-spherical particle shapes"; its reader of LAMMPS dumps halves shapex, shapey
 * and shapez): radius = shapex/2, distance of the caps' centres = shapez/2, natural direction z, turned by
 * (quati, quatj, quatk, quatw). */
#include "analysis/cell.h"

#include "analysis/view_cache.h"
#include "base/vec3.h"

#include <math.h>

/* Columns as they stand. */
#define COLUMN_VALUE(name, column)                                                                                     \
    double cell_##name(const view *v, uint32_t row) {                                                                  \
        return (double)v->colony->cell.column[row];                                                                    \
    }
COLUMN_VALUE(id, id)
COLUMN_VALUE(parent, parent)
COLUMN_VALUE(founder, founder)
COLUMN_VALUE(generation, generation)
COLUMN_VALUE(mass, mass)
COLUMN_VALUE(rate, rate)
COLUMN_VALUE(diameter, diameter)
COLUMN_VALUE(shapex, diameter)
COLUMN_VALUE(shapey, diameter)

/* Components of vectors. */
#define COMPONENT_VALUE(name, vector, k)                                                                               \
    double cell_##name(const view *v, uint32_t row) {                                                                  \
        double a[3];                                                                                                   \
        vector(v, row, a);                                                                                             \
        return a[k];                                                                                                   \
    }

static void centre_of(const view *v, uint32_t row, double a[3]) {
    colony_centre(v->colony, row, a);
}
COMPONENT_VALUE(x, centre_of, 0)
COMPONENT_VALUE(y, centre_of, 1)
COMPONENT_VALUE(z, centre_of, 2)

static void axis_of(const view *v, uint32_t row, double a[3]) {
    colony_axis(v->colony, row, a);
}
COMPONENT_VALUE(ux, axis_of, 0)
COMPONENT_VALUE(uy, axis_of, 1)
COMPONENT_VALUE(uz, axis_of, 2)

static void velocity_of(const view *v, uint32_t row, double a[3]) {
    colony_mean(v->colony, row, v->colony->particle.v, a);
}
COMPONENT_VALUE(vx, velocity_of, 0)
COMPONENT_VALUE(vy, velocity_of, 1)
COMPONENT_VALUE(vz, velocity_of, 2)

double cell_speed(const view *v, uint32_t row) {
    double a[3];
    velocity_of(v, row, a);
    return vec3_norm(vec3_load(a));
}

static void force_of(const view *v, uint32_t row, double a[3]) {
    vec3_store(a, vec3_load(view_cache_contacts(v).force + 3 * (size_t)row));
}
COMPONENT_VALUE(fx, force_of, 0)
COMPONENT_VALUE(fy, force_of, 1)
COMPONENT_VALUE(fz, force_of, 2)

void cell_quaternion(const double u[3], double q[4]) {
    double sign = u[2] < 0 ? -1 : 1;
    double w = u[0] == 0 && u[1] == 0 ? 1 : sqrt(0.5 * (1 + sign * u[2]));
    q[0] = -sign * u[1] / (2 * w) + 0.0; /* no -0 */
    q[1] = sign * u[0] / (2 * w) + 0.0;
    q[2] = 0;
    q[3] = w;
}

static void quaternion_of(const view *v, uint32_t row, double q[4]) {
    double u[3];
    colony_axis(v->colony, row, u);
    cell_quaternion(u, q);
}
#define QUATERNION_VALUE(name, i)                                                                                      \
    double cell_##name(const view *v, uint32_t row) {                                                                  \
        double q[4];                                                                                                   \
        quaternion_of(v, row, q);                                                                                      \
        return q[i];                                                                                                   \
    }
QUATERNION_VALUE(quati, 0)
QUATERNION_VALUE(quatj, 1)
QUATERNION_VALUE(quatk, 2)
QUATERNION_VALUE(quatw, 3)

double cell_age(const view *v, uint32_t row) {
    return v->time - v->colony->cell.birth[row];
}

double cell_stage(const view *v, uint32_t row) {
    return v->colony->cell.mass[row] / v->colony->cell.limit[row];
}

double cell_volume(const view *v, uint32_t row) {
    return v->colony->cell.mass[row] / v->species->list[v->colony->cell.species[row]].density;
}

static const double *particles_of(const view *v, uint32_t row) {
    return v->colony->particle.x + 3 * (size_t)v->colony->cell.first[row];
}

double cell_zmin(const view *v, uint32_t row) {
    const double *x = particles_of(v, row);
    double z = x[2];
    for (size_t p = 1; p < v->colony->cell.nparticles[row]; p++)
        z = fmin(z, x[3 * p + 2]);
    return z;
}

double cell_zmax(const view *v, uint32_t row) {
    const double *x = particles_of(v, row);
    double z = x[2];
    for (size_t p = 1; p < v->colony->cell.nparticles[row]; p++)
        z = fmax(z, x[3 * p + 2]);
    return z;
}

static double length_between_caps(const view *v, uint32_t row) {
    const double *x = particles_of(v, row);
    double length = 0;
    for (size_t p = 1; p < v->colony->cell.nparticles[row]; p++)
        length += vec3_norm(vec3_sub(vec3_load(x + 3 * p), vec3_load(x + 3 * (p - 1))));
    return length;
}

double cell_length(const view *v, uint32_t row) {
    return length_between_caps(v, row) + v->colony->cell.diameter[row];
}

double cell_straightness(const view *v, uint32_t row) {
    const double *x = particles_of(v, row), *last = x + 3 * ((size_t)v->colony->cell.nparticles[row] - 1);
    double length = length_between_caps(v, row);
    return length > 0 ? vec3_norm(vec3_sub(vec3_load(last), vec3_load(x))) / length : 1;
}

double cell_shapez(const view *v, uint32_t row) {
    return 2 * length_between_caps(v, row);
}

double cell_contacts(const view *v, uint32_t row) {
    return view_cache_contacts(v).contacts[row];
}

double cell_overlap(const view *v, uint32_t row) {
    return view_cache_contacts(v).overlap[row];
}

/* What the cache holds of links. */
#define LINK_VALUE(name)                                                                                               \
    double cell_##name(const view *v, uint32_t row) {                                                                  \
        return view_cache_links(v).name[row];                                                                          \
    }
LINK_VALUE(filial)
LINK_VALUE(stuck)
LINK_VALUE(anchored)
LINK_VALUE(stretch)
LINK_VALUE(strain)

double cell_cluster(const view *v, uint32_t row) {
    return (double)v->colony->cell.id[view_cache_links(v).root[row]];
}

const char *cell_species(const view *v, uint32_t row) {
    return v->species->list[v->colony->cell.species[row]].name;
}

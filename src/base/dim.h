/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Physical dimensions, and the engine's units.
 *
 * Scripts and tables speak SI (or `bio`); the engine computes in um, pg, s, in which its numbers are near 1:
 * force 1e-21 N, stiffness 1e-15 N/m, drag 1e-15 N s/m, energy 1e-27 J. Conversion happens at the script's edge. */
#ifndef SARCINA_BASE_DIM_H
#define SARCINA_BASE_DIM_H

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

/* Exponents of metre, kilogram and second in twelfths, so that roots stay exact. */
typedef struct dim {
    int16_t length, mass, time;
} dim;

#define DIM(l, m, t) ((dim){12 * (l), 12 * (m), 12 * (t)})
#define DIM_NONE DIM(0, 0, 0)
#define DIM_LENGTH DIM(1, 0, 0)
#define DIM_AREA DIM(2, 0, 0)
#define DIM_VOLUME DIM(3, 0, 0)
#define DIM_MASS DIM(0, 1, 0)
#define DIM_TIME DIM(0, 0, 1)
#define DIM_RATE DIM(0, 0, -1)
#define DIM_VELOCITY DIM(1, 0, -1)
#define DIM_DENSITY DIM(-3, 1, 0)
#define DIM_STIFFNESS DIM(0, 1, -2)
#define DIM_FORCE DIM(1, 1, -2)
#define DIM_ENERGY DIM(2, 1, -2)

static inline bool dim_equal(dim a, dim b) {
    return a.length == b.length && a.mass == b.mass && a.time == b.time;
}
static inline bool dim_is_none(dim a) {
    return dim_equal(a, DIM_NONE);
}

/* The dimension a parameter kind or value table calls by this name ("length", "stiffness" ...);
 * false when there is none of that name. */
bool dim_by_name(const char *name, dim *out);

/* The i-th of these names, with its dimension; NULL when there are fewer. */
const char *dim_listed(size_t i, dim *out);

/* What an error calls the dimension: "length", "rate", "pure number", or "m2 kg s-1" where no name is known.
 * The text is in buffer or constant. */
const char *dim_name(dim d, char buffer[48]);

/* The dimension in SI as a suffix of a number ("m", "kg/m3", "N/m", ""), as scripts read it back. */
const char *dim_suffix(dim d, char buffer[48]);

/* A value in SI base units to the engine's units and back: one rounding for powers of ten up to 1e22, two beyond
 * (energies). */
double dim_to_engine(double si, dim d);
double dim_from_engine(double engine, dim d);

#endif

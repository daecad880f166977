/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The division rules, one file each in this folder, and what they share. A new one: its file, a line here and a line in
 * biology/division.c. */
#ifndef SARCINA_BIOLOGY_DIVISION_RULES_H
#define SARCINA_BIOLOGY_DIVISION_RULES_H

#include "base/vec3.h"
#include "biology/division.h"

extern const division_style division_midpoint;
extern const division_style division_random;
extern const division_style division_planes;

/* Parameters that every rule has behind its two sizes. */
#define RULES_JITTER_PARAMS                                                                                            \
    {"jitter=10nm:length[0,)",                                                                                         \
     "displacement of one new particle, without which exactly aligned daughters stay aligned"},                        \
    {                                                                                                                  \
        "axis=auto:{auto|x|y|z}", "its direction; auto: drawn, horizontal on a substratum"                             \
    }

#define RULES_PAIRS_PARAM                                                                                              \
    { "pairs=no:flag", "a mother's older filial links break when she divides: cells stay in pairs (diplo-)" }

/* Place and velocity of a cell's i-th particle; not past the next cell added. */
double *division_place(const colony *c, uint32_t cell, uint32_t i);
double *division_velocity(const colony *c, uint32_t cell, uint32_t i);

/* The displacement that breaks the symmetry of the daughters (model: "jitter"); id is the daughter's. */
vec3 division_jitter(const division_context *x, const style_choice *rule, uint64_t id);

/* Puts a particle that has come to lie in the substratum onto it. */
void division_lift(const division_context *x, uint32_t cell, uint32_t i);

/* Puts a coccus and its daughter half a diameter to both sides of the mother's place, along the unit vector u. */
void division_part(const division_context *x, uint32_t mother, uint32_t daughter, vec3 u);

/* Divides a flexible cell, of half her mass already, at half its length. */
void division_halve(const division_context *x, uint32_t mother, uint32_t daughter);

#endif

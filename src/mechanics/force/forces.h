/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The force terms, one file each in this folder. A new one: its file, a line here, a row of force_kind and a line in
 * mechanics/force.c. */
#ifndef SARCINA_MECHANICS_FORCE_FORCES_H
#define SARCINA_MECHANICS_FORCE_FORCES_H

#include "mechanics/force_style.h"

extern const force_style force_internal;
extern const force_style force_bend;
extern const force_style force_twist;
extern const force_style force_springs;
extern const force_style force_collision;
extern const force_style force_substratum;
extern const force_style force_dlvo;
extern const force_style force_damping;
extern const force_style force_gravity;

#endif

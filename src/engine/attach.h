/* SPDX-License-Identifier: GPL-3.0-or-later */
/* What a growth step asks of the scene's attachments. */
#ifndef SARCINA_ENGINE_ATTACH_H
#define SARCINA_ENGINE_ATTACH_H

#include "engine/scene.h"

/* Can what attaches in a step of length dt be created? Nothing has changed when it cannot. */
int attach_check(const scene *s, double dt, diag *d);

/* Creates it, as number `step` of the random streams. A cell that finds no place is left out and counted. */
void attach_step(scene *s, uint64_t step, double dt);

#endif

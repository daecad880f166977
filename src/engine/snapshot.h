/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The state of a scene at one moment: the colony's columns and the clock. What the script declared (species, forces,
 * settings) is not in it: that changes by commands only, and restart files keep the commands. */
#ifndef SARCINA_ENGINE_SNAPSHOT_H
#define SARCINA_ENGINE_SNAPSHOT_H

#include "engine/archive.h"
#include "engine/scene.h"

typedef struct snapshot snapshot;

/* A copy in memory; free with snapshot_free, which takes NULL. */
snapshot *snapshot_take(const scene *s);
void snapshot_free(snapshot *p);

/* Puts the state back, to the bit. */
void snapshot_restore(scene *s, const snapshot *p);

/* The same as sections of a file: "clock", and one a column. snapshot_load checks everything before it changes
 * anything: a file that is not whole or fits no such scene is an error. */
void snapshot_save(scene *s, archive *a);
int snapshot_load(scene *s, const archive *a, diag *d);

#endif
